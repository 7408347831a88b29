// SPDX-License-Identifier: Apache-2.0
#include "insertion/parts.hpp"

#include <algorithm>
#include <set>

#include "insertion/orders.hpp"

namespace skein::supervisor {
namespace {

using mission::GoalId;
using mission::HighLevelTask;

/// Calls `visit` with every goal that is free to move.
template <class Visit>
void for_each_free(const Movable& movable, const Visit& visit) {
  for (const Blocks* blocks : {&movable.planned, &movable.added})
    for (const Block& block : *blocks)
      for (const HighLevelTask& goal : block.goals) visit(goal);
}

Goals::const_iterator find(const Goals& goals, GoalId id) {
  return std::find_if(goals.begin(), goals.end(),
                      [&](const HighLevelTask& one) { return one.id == id; });
}

Blocks with_part(const Blocks& blocks, const HighLevelTask& part) {
  Blocks result;
  for (const Block& block : blocks) {
    const auto mapping = find(block.goals, *whole_of(part));
    if (mapping == block.goals.end()) {
      result.push_back(block);
      continue;
    }
    // What comes before the mapping in its block has no place of its own.
    Block before = block, after = block;
    before.goals.assign(block.goals.begin(), mapping);
    before.goals.push_back(part);
    after.goals.assign(mapping, block.goals.end());
    before.shared = after.shared = true;
    result.push_back(std::move(before));
    result.push_back(std::move(after));
  }
  return result;
}

}  // namespace

std::optional<GoalId> whole_of(const HighLevelTask& task) {
  if (task.name != kMapPart || task.arguments.size() != 3) return std::nullopt;
  const auto* number = std::get_if<double>(&task.arguments[2]);
  if (number == nullptr || !(*number >= 1 && *number < 1e15)) return std::nullopt;
  return GoalId(static_cast<std::uint64_t>(*number));
}

std::optional<double> share_of(const HighLevelTask& task) {
  const auto* share = whole_of(task) ? std::get_if<double>(&task.arguments[1]) : nullptr;
  return share == nullptr ? std::nullopt : std::optional(*share);
}

HighLevelTask part_of(const HighLevelTask& mapping, GoalId id, double share) {
  HighLevelTask part{id, std::string(kMapPart), mapping.arguments, {}};
  part.arguments.resize(1);
  part.arguments.emplace_back(share);
  part.arguments.emplace_back(static_cast<double>(mapping.id.value()));
  part.time.start_after = mapping.time.start_after;
  for (const mission::GoalBound& bound : mapping.after)
    if (!bound.on_end) part.after.push_back(bound);
  return part;
}

Goals whole_mappings(const Movable& movable) {
  std::set<GoalId> parted;
  for_each_free(movable, [&](const HighLevelTask& goal) {
    if (const auto whole = whole_of(goal)) parted.insert(*whole);
  });
  Goals result;
  for_each_free(movable, [&](const HighLevelTask& goal) {
    const bool maps = goal.name == kMapping && goal.arguments.size() == 1;
    if (maps && parted.count(goal.id) == 0) result.push_back(goal);
  });
  return result;
}

Movable with_part(const Movable& movable, const HighLevelTask& part) {
  Movable result = movable;
  result.planned = with_part(movable.planned, part);
  result.added = with_part(movable.added, part);
  return result;
}

Blocks rest_behind_dates(const Blocks& blocks, const HighLevelTask& part) {
  Blocks order = blocks;
  const auto rest = std::find_if(order.begin(), order.end(), [&](const Block& block) {
    return find(block.goals, *whole_of(part)) != block.goals.end();
  });
  if (rest == order.end()) return order;
  auto behind = rest + 1;
  for (auto block = behind; block != order.end(); ++block)
    if (bounded_in_time(block->goals)) behind = block + 1;
  std::rotate(rest, rest + 1, behind);
  return order;
}

bool parts_stand_apart(const Goals& order, const HighLevelTask& part) {
  const auto first = find(order, part.id), rest = find(order, *whole_of(part));
  return first != order.end() && rest != order.end() && rest - first > 1;
}

}  // namespace skein::supervisor
