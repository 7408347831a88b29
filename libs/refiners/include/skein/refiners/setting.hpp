// SPDX-License-Identifier: Apache-2.0
// What a service is given beside its query.
#pragma once

#include <cstdint>

#include "skein/refiners/budget.hpp"
#include "skein/world/world.hpp"

namespace skein::refiners {

class PathPlanner;

/// The same query in the same setting gives the same answer, unless the clock of the budget cuts.
/// Lifetime: the world and the planner must outlive the call. Every service is one function
///
///   Outcome<Task> refine(const TaskQuery& query, const Setting& setting);
///
/// safe to call from any thread, since nothing is shared but the world, which is only read.
struct Setting {
  const world::World& world;
  Budget budget;
  std::uint64_t seed = 1;
  /// How services that need ways find them; null: on the voxels (voxel_path_planner.hpp).
  const PathPlanner* paths = nullptr;
};

}  // namespace skein::refiners
