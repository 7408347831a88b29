// SPDX-License-Identifier: Apache-2.0
// Which tasks in an order of high-level tasks may be reordered.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "insertion/judge.hpp"
#include "skein/refiners/tour.hpp"

namespace skein::supervisor {

/// Constraint of a high-level task on its position in the order.
enum class Role : std::uint8_t {
  kFree,
  kTakesOff,  ///< in the air its plan is empty or a takeoff: goes first
  kWaits,     ///< lasts until orders come: goes after all free tasks
  kLands      ///< ends on the ground: goes last
};

/// Finds roles by planning each task alone, so that a domain may name its tasks freely. Each task
/// name is planned at most three times.
class Roles {
 public:
  explicit Roles(const Judge& judge) : judge_(judge) {}
  Role of(const mission::HighLevelTask& goal);

 private:
  struct Known {
    Role role = Role::kFree;
    int failures = 0;
    bool sure = false;
  };
  const Judge& judge_;
  std::map<std::string, Known, std::less<>> by_name_;
};

/// A task with a place, and the tasks without a place that follow it in the order asked for: they
/// stay behind it. Tasks before the first one with a place form a block of their own.
struct Block {
  Goals goals;
  std::vector<refiners::Gate> gates;  ///< of the task with a place; empty: no task has one
  /// Keeps its rank among the shared blocks of its list: tasks done with other UAVs, which may have
  /// them in the same order, and parts of a mapping.
  bool shared = false;
  bool added = false;
};
using Blocks = std::vector<Block>;

/// High-level tasks sorted by their roles.
struct Movable {
  Goals takeoffs, waits, landings;
  Blocks planned, added;  ///< the free tasks

  bool none_is_free() const { return planned.empty() && added.empty() && waits.empty(); }
};
Movable movable_of(const Goals& planned, const Goals& added, Roles& roles,
                   const PlanningRequest& base);

/// Takeoffs, blocks, waits, landings.
Goals order_of(const Movable& movable, const Blocks& blocks);
/// Permutes the shared blocks of `list` in `order` among their positions, so that they come in the
/// sequence that they have in `list`.
void keep_shared(Blocks& order, const Blocks& list);
/// The planned blocks, then the added ones.
Blocks all_blocks(const Movable& movable);

}  // namespace skein::supervisor
