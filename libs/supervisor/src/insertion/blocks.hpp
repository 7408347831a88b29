// SPDX-License-Identifier: Apache-2.0
// What may be moved in an order of high-level tasks, and what may not.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "insertion/judge.hpp"
#include "skein/refiners/tour.hpp"

namespace skein::supervisor {

/// What a high-level task means for the order of all.
enum class Role : std::uint8_t {
  kFree,
  kTakesOff,  ///< makes nothing, or takes off, when asked for in the air: goes first
  kWaits,     ///< lasts until orders come: goes after all that is free
  kLands      ///< ends on the ground: goes last
};

/// Tells roles by what plans are made of, so that a domain may name its tasks as it likes. Each
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

/// A task with a place and those without one that were asked for after it: they stay behind it.
/// Those that come before the first place of all stay before that.
struct Block {
  Goals goals;
  std::vector<refiners::Gate> gates;  ///< of the one with a place; empty: none has
  /// Done with other UAVs, which may be asked for the same in the same order: keeps its turn among
  /// those of its list; parts of a mapping do, too.
  bool shared = false;
  bool added = false;
};
using Blocks = std::vector<Block>;

/// High-level tasks sorted by what may be moved.
struct Movable {
  Goals takeoffs, waits, landings;
  Blocks planned, added;  ///< free

  bool none_is_free() const { return planned.empty() && added.empty() && waits.empty(); }
};
Movable movable_of(const Goals& planned, const Goals& added, Roles& roles,
                   const PlanningRequest& base);

/// Takeoffs, blocks, waits, landings.
Goals order_of(const Movable& movable, const Blocks& blocks);
/// Those of one list that are shared take the turns that an order gave them in their own order.
void keep_shared(Blocks& order, const Blocks& list);
/// The planned ones, then those added.
Blocks all_blocks(const Movable& movable);

}  // namespace skein::supervisor
