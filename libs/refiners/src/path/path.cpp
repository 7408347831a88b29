// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/path.hpp"

#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {

Outcome<Path> refine(const PathQuery& query, const Setting& setting) {
  if (setting.paths != nullptr) return setting.paths->plan(query, setting);
  return VoxelPathPlanner().plan(query, setting);
}

}  // namespace skein::refiners
