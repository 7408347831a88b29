// SPDX-License-Identifier: Apache-2.0
// Ways that a UAV flies by itself while nobody plans for it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

struct WayOut {
  std::string volume;  ///< which is closed, or will be within a minute
  world::Vector3 to;   ///< where it may stay
};
/// Of one that holds there in the air; absent: it may stay there, or nothing near is free. Cost:
/// O(volumes); when air is closed around it, that of an airspace.
std::optional<WayOut> way_out(const std::shared_ptr<const Knowledge>& knowledge,
                              const std::shared_ptr<const world::World>& world, MissionTime now,
                              const world::Vector3& at);

/// From a place in the air to another, clear of closed air; straight where there is no such way.
/// Begins with `from`. Cost: that of planning a way.
std::vector<world::Vector3> own_way(const std::shared_ptr<const Knowledge>& knowledge,
                                    const std::shared_ptr<const world::World>& world,
                                    MissionTime now, const world::Vector3& from,
                                    const world::Vector3& to);

}  // namespace skein::supervisor
