// SPDX-License-Identifier: Apache-2.0
// The context of a query: world, budget, path planner.
#pragma once

#include <cstdint>

#include "skein/refiners/budget.hpp"
#include "skein/world/world.hpp"

namespace skein::refiners {

class PathPlanner;

/// The same query in the same setting gives the same result, unless the clock of the budget ends
/// the search. Lifetime: world and planner must outlive the call. Every service is one function
///
///   Outcome<Task> refine(const TaskQuery& query, const Setting& setting);
///
/// safe to call from any thread: only the world is shared, and it is only read.
struct Setting {
  const world::World& world;
  Budget budget;
  std::uint64_t seed = 1;
  /// Planner for services that need paths; null: VoxelPathPlanner.
  const PathPlanner* paths = nullptr;
};

}  // namespace skein::refiners
