// SPDX-License-Identifier: Apache-2.0
// Ways that a UAV flies on its own decision while there is no plan.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

struct WayOut {
  std::string volume;  ///< the volume to leave: closed, or about to close within a minute
  world::Vector3 to;   ///< the place to fly to [m, ENU], in free air
};
/// The way out of closed air for a UAV that holds at `at`; absent: that place is free, or there is
/// no free place near. Cost: O(volumes); if the place is not free, that of building an airspace.
std::optional<WayOut> way_out(const std::shared_ptr<const Knowledge>& knowledge,
                              const std::shared_ptr<const world::World>& world, MissionTime now,
                              const world::Vector3& at);

/// The volumes around a UAV that stays at `at`: closed, or about to close within a minute.
/// Cost: O(volumes).
std::vector<std::string> closed_around(const Knowledge& knowledge, const world::World& world,
                                       MissionTime now, const world::Vector3& at);

/// A way from one place in the air to another, clear of closed air and of the ground; if there is
/// none, the straight line, or where the ground is in it, straight up, over and down for who
/// hovers. Begins with `from` [m, ENU]. Cost: that of planning a way.
std::vector<world::Vector3> own_way(const std::shared_ptr<const Knowledge>& knowledge,
                                    const std::shared_ptr<const world::World>& world,
                                    MissionTime now, const world::Vector3& from,
                                    const world::Vector3& to);

/// Where a UAV that comes home on its own from `from` ends its flight: at `home`, over the pad, or
/// where no vehicle lands on the pad because it is too steep or the air over it is closed, over the
/// nearest ground that serves, at the same height [m, ENU]. Cost: that of some thousand looks at
/// the ground at most.
world::Vector3 over_landing_place(const Knowledge& knowledge, const world::World& world,
                                  MissionTime now, const world::Vector3& from,
                                  const world::Vector3& home);

/// The volume that the rest of `way` leads through, which is closed, or will be while the UAV flies
/// it: from the leg that is nearest to `at`, where the UAV is; not one that is around it already.
/// Cost: O(volumes × points).
std::optional<std::string> closed_ahead(const Knowledge& knowledge, const world::World& world,
                                        MissionTime now, const world::Vector3& at,
                                        const std::vector<world::Vector3>& way);

}  // namespace skein::supervisor
