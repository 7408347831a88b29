// SPDX-License-Identifier: Apache-2.0
// What may be moved in an order of high-level tasks, and what may not.
#include "insertion/blocks.hpp"

#include <algorithm>
#include <set>

#include "insertion/places.hpp"

namespace skein::supervisor {
namespace {

using functional::Leaves;
using functional::Motion;

/// A task of that name that cannot be planned says nothing; after so many its name counts as free.
constexpr int kMostFailures = 3;
/// Far from any place that the vehicle might waver about [m].
const world::Vector3 kElsewhere(200, 0, 0);

Role role_in(const mission::ElementaryPlan& plan) {
  Role role = plan.tasks.empty() ? Role::kTakesOff : Role::kFree;
  for (const mission::ElementaryTask& task : plan.tasks) {
    const functional::TaskType& type = mission::type_of(task);
    const bool flies = type.motion == Motion::kMoves && type.leaves == Leaves::kAsItWas;
    if (type.leaves == Leaves::kInTheAir && role == Role::kFree) role = Role::kTakesOff;
    if (flies && role == Role::kTakesOff) role = Role::kFree;
    if (task.open_ended) role = Role::kWaits;
    if (type.leaves == Leaves::kOnTheGround) return Role::kLands;
  }
  return role;
}

void append(Goals& goals, const Goals& more) {
  goals.insert(goals.end(), more.begin(), more.end());
}

/// Cuts the free tasks of one list into blocks.
class Cutter {
 public:
  Cutter(const PlanningRequest& base, bool added, const Goals& goals) : base_(base), added_(added) {
    for (const mission::HighLevelTask& goal : goals)
      if (const auto whole = whole_of(goal)) parted_.insert({goal.id, *whole});
  }

  void add(const mission::HighLevelTask& goal) {
    auto gates = gates_of(goal, base_);
    const bool placed = !gates.empty();
    if (blocks_.empty() || (placed && !blocks_.back().gates.empty()))
      blocks_.push_back({.goals = {}, .gates = {}, .shared = false, .added = added_});
    Block& block = blocks_.back();
    block.goals.push_back(goal);
    if (placed) block.gates = std::move(gates);
    block.shared =
        block.shared || parted_.count(goal.id) != 0 || is_shared(goal, base_.knowledge->vocabulary);
  }
  Blocks take() { return std::move(blocks_); }

 private:
  const PlanningRequest& base_;
  bool added_;
  std::set<mission::GoalId> parted_;  ///< mappings in parts, and the parts
  Blocks blocks_;
};

}  // namespace

Role Roles::of(const mission::HighLevelTask& goal) {
  if (goal.name == kLeaveClosedAir) return Role::kTakesOff;
  if (goal.name == kMapPart) return Role::kFree;
  Known& known = by_name_[goal.name];
  if (known.sure || known.failures == kMostFailures) return known.role;
  auto plan = judge_.sketch_in_the_air(goal);
  // What is nothing to do here because the vehicle is there already is something elsewhere.
  if (plan && plan->tasks.empty()) plan = judge_.sketch_in_the_air(goal, kElsewhere);
  if (plan) {
    known.role = role_in(*plan);
    known.sure = true;
  } else {
    ++known.failures;
  }
  return known.role;
}

Movable movable_of(const Goals& planned, const Goals& added, Roles& roles,
                   const PlanningRequest& base) {
  Movable movable;
  const auto sort = [&](const Goals& goals, bool are_added) {
    Cutter cutter(base, are_added, goals);
    for (const mission::HighLevelTask& goal : goals) {
      switch (roles.of(goal)) {
        case Role::kTakesOff:
          movable.takeoffs.push_back(goal);
          break;
        case Role::kWaits:
          movable.waits.push_back(goal);
          break;
        case Role::kLands:
          movable.landings.push_back(goal);
          break;
        case Role::kFree:
          cutter.add(goal);
          break;
      }
    }
    return cutter.take();
  };
  movable.planned = sort(planned, false);
  movable.added = sort(added, true);
  return movable;
}

Goals order_of(const Movable& movable, const Blocks& blocks) {
  Goals order = movable.takeoffs;
  for (const Block& block : blocks) append(order, block.goals);
  append(order, movable.waits);
  append(order, movable.landings);
  return order;
}

void keep_shared(Blocks& order, const Blocks& list) {
  std::set<mission::GoalId> there;
  for (const Block& block : order) there.insert(block.goals.front().id);
  auto next = list.begin();
  for (Block& block : order) {
    if (!block.shared || list.empty() || block.added != list.front().added) continue;
    next = std::find_if(next, list.end(), [&](const Block& one) {
      return one.shared && there.count(one.goals.front().id) != 0;
    });
    block = *next++;
  }
}

Blocks all_blocks(const Movable& movable) {
  Blocks all = movable.planned;
  all.insert(all.end(), movable.added.begin(), movable.added.end());
  return all;
}

}  // namespace skein::supervisor
