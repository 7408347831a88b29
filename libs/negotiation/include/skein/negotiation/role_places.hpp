// SPDX-License-Identifier: Apache-2.0
// What `best-view` and `relay-position` compute, by the refiners and under spatial constraints.
#pragma once

#include <string>
#include <vector>

#include "skein/interaction/valid_position.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::interaction {

/// Where a role is to go.
struct RolePlaceQuery {
  world::VehicleModel vehicle;
  Position from{};              ///< where the UAV is
  double clearance = 20;        ///< least height over the ground [m]
  MissionTime at;               ///< volumes with a time window count from then on
  std::vector<ActiveScm> scms;  ///< that are to hold there
  ScmLimits limits;
};

/// Where a target is perceived best by a device of the vehicle, of the places where the SCMs hold:
/// the viewpoint refiner's. Refused: as it refuses; an SCM of which some place is unknown.
Result<Position, Failure> best_view(const RolePlaceQuery& query, const std::string& device,
                                    const Position& target, const Observer& observer,
                                    const refiners::Setting& setting);

/// Where both ends are heard, over the real ground and in line of sight if the radio needs it, with
/// `least_margin` [dB], and the SCMs hold: nearest to the relay refiner's best place. Refused: no
/// such place was found; an SCM of which some place is unknown.
Result<Position, Failure> relay_position(const RolePlaceQuery& query, const Position& one,
                                         const Position& other, double least_margin,
                                         const Observer& observer,
                                         const refiners::Setting& setting);

}  // namespace skein::interaction
