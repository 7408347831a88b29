// SPDX-License-Identifier: Apache-2.0
// What `skein plan --world --vehicle` brings: the refiners of a planning domain of missions.
#pragma once

#include <iosfwd>
#include <memory>

#include "skein/foundation/diagnostics.hpp"
#include "skein/plan_tool/plan.hpp"
#include "skein/supervisor/planner_host.hpp"

namespace skein::plan_tool {

/// The knowledge that its files give. Null without --world and --vehicle, and, with the reasons in
/// `errors`, where a file is wrong.
std::shared_ptr<const supervisor::Knowledge> knowledge_of(const MissionFiles& files,
                                                          std::istream& in, Diagnostics& errors);
/// Likewise. Worlds whose terrain or risk is a raster file are not read here.
std::shared_ptr<const world::World> world_of(const MissionFiles& files, std::istream& in,
                                             Diagnostics& errors);

}  // namespace skein::plan_tool
