// SPDX-License-Identifier: Apache-2.0
// (b): by temporal compatibility with absolute constraints.
#include <algorithm>
#include <array>
#include <tuple>

#include "insertion/orders.hpp"
#include "insertion/places.hpp"

namespace skein::supervisor {
namespace {

using world::Vector3;

enum Side : std::uint8_t { kPlanned, kAdded, kSides };

/// The best way of having done so many planned and so many added blocks, the last of one side.
struct Progress {
  bool reached = false;
  double late = 0;  ///< sum of what bounds are missed by [s]
  double time = 0;  ///< mission time [s]
  Vector3 at = Vector3::Zero();
  Side before = kPlanned;  ///< which side the block before the last was of

  bool better_than(const Progress& other) const {
    if (!reached || !other.reached) return reached && !other.reached;
    return std::tie(late, time) < std::tie(other.late, other.time);
  }
};

class Merger {
 public:
  Merger(const Movable& movable, const Sketch& sketch)
      : movable_(movable),
        sketch_(sketch),
        rows_(movable.planned.size() + 1),
        columns_(movable.added.size() + 1),
        table_(rows_ * columns_ * kSides) {}

  Blocks merge(const PlanningRequest& base) {
    Progress& start = at(0, 0, kPlanned);
    start.reached = true;
    start.at = in_the_air(base);
    start.time = base.situation.origin.to_seconds() + base.situation.motion.free.least.to_seconds();
    for (const mission::HighLevelTask& takeoff : movable_.takeoffs) do_goal(takeoff, start);
    for (std::size_t i = 0; i < rows_; ++i)
      for (std::size_t j = 0; j < columns_; ++j) reach(i, j);
    return trace();
  }

 private:
  Progress& at(std::size_t i, std::size_t j, Side side) {
    return table_[(i * columns_ + j) * kSides + side];
  }

  void reach(std::size_t i, std::size_t j) {
    if (i > 0) at(i, j, kPlanned) = step(i - 1, j, movable_.planned[i - 1]);
    if (j > 0) at(i, j, kAdded) = step(i, j - 1, movable_.added[j - 1]);
  }

  /// That block done after the better of the two ways to come so far.
  Progress step(std::size_t i, std::size_t j, const Block& block) {
    Progress best;
    for (const Side side : {kAdded, kPlanned}) {
      Progress next = at(i, j, side);
      if (!next.reached) continue;
      next.before = side;
      for (const mission::HighLevelTask& goal : block.goals) do_goal(goal, next);
      if (next.better_than(best)) best = next;
    }
    return best;
  }

  /// Constraints hold for every elementary task of it.
  void do_goal(const mission::HighLevelTask& goal, Progress& progress) const {
    const Stay stay = sketch_.of(goal.id);
    const mission::TimeConstraints& bounds = goal.time;
    double begin = progress.time;
    if (bounds.start_after) begin = std::max(begin, bounds.start_after->to_seconds());
    if (bounds.end_after) begin = std::max(begin, bounds.end_after->to_seconds() - stay.first_end);
    const double there = begin + (stay.moves ? sketch_.travel(progress.at, stay.entry) : 0);
    const double end = there + stay.inside;
    if (bounds.start_before)
      progress.late += std::max(there + stay.last_start - bounds.start_before->to_seconds(), 0.0);
    if (bounds.end_before) progress.late += std::max(end - bounds.end_before->to_seconds(), 0.0);
    progress.time = end;
    if (stay.moves) progress.at = stay.exit;
  }

  Blocks trace() {
    std::size_t i = rows_ - 1, j = columns_ - 1;
    Side side = at(i, j, kPlanned).better_than(at(i, j, kAdded)) ? kPlanned : kAdded;
    Blocks blocks;
    while (i + j > 0) {
      const Side before = at(i, j, side).before;
      blocks.push_back(side == kPlanned ? movable_.planned[--i] : movable_.added[--j]);
      side = before;
    }
    std::reverse(blocks.begin(), blocks.end());
    return blocks;
  }

  const Movable& movable_;
  const Sketch& sketch_;
  std::size_t rows_, columns_;
  std::vector<Progress> table_;
};

/// The date by which it must be done; what must not be early comes when it may.
MissionTime bound_of(const Block& block) {
  MissionTime bound = MissionTime::max();
  for (const mission::HighLevelTask& goal : block.goals) {
    const auto& [start_before, start_after, end_before, end_after] = goal.time;
    for (const auto& upper : {start_before, end_before})
      bound = std::min(bound, upper.value_or(MissionTime::max()));
    if (start_before || end_before) continue;
    for (const auto& lower : {start_after, end_after})
      bound = std::min(bound, lower.value_or(MissionTime::max()));
  }
  return bound;
}

}  // namespace

Blocks merge_in_time(const Movable& movable, const Sketch& sketch, const PlanningRequest& base) {
  return Merger(movable, sketch).merge(base);
}

Blocks urgent_in_time(const Movable& movable, const Sketch& sketch, const PlanningRequest& base) {
  Movable split = movable;
  split.planned.clear();
  split.added.clear();
  for (const Block& block : all_blocks(movable))
    (bounded_in_time(block.goals) ? split.added : split.planned).push_back(block);
  std::stable_sort(split.added.begin(), split.added.end(),
                   [](const Block& a, const Block& b) { return bound_of(a) < bound_of(b); });
  Blocks order = merge_in_time(split, sketch, base);
  for (const Blocks* list : {&movable.planned, &movable.added}) keep_shared(order, *list);
  return order;
}

bool bounded_in_time(const Goals& goals) {
  return std::any_of(goals.begin(), goals.end(),
                     [](const mission::HighLevelTask& goal) { return goal.time.any(); });
}

}  // namespace skein::supervisor
