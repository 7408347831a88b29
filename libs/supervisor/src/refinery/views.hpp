// SPDX-License-Identifier: Apache-2.0
// Viewpoints, and tours over places.
#pragma once

#include <vector>

#include "refinery/timed_air.hpp"
#include "skein/refiners/viewpoint.hpp"

namespace skein::supervisor {

class Views {
 public:
  explicit Views(TimedAir& air) : air_(air) {}

  using Constraints = std::vector<refiners::PlaceConstraint>;
  /// The `count` best viewpoints of the device on `place`, from different sides, that satisfy the
  /// constraints and where the vehicle may stay for `seconds` with this departure.
  Answer<std::vector<world::Vector3>> of(const world::Vector3& place,
                                         const world::SensorModel& device, std::size_t count,
                                         const Departure& when = {}, double seconds = 0,
                                         const Constraints& constraints = {});
  struct Stop {
    std::string name;  ///< in refusals
    world::Vector3 at;
  };
  /// The stops in the order in which the way over all of them is shortest. Air that is closed for
  /// a time does not count.
  Answer<std::vector<world::Vector3>> tour(const world::Vector3& from,
                                           const std::vector<Stop>& stops);

 private:
  /// Requirements on viewpoints on the ground.
  struct Stands {
    std::size_t count;
    const world::Airspace& map;
    const TimedAir::Volumes& volumes;
    const Constraints& constraints;
  };
  Answer<std::vector<world::Vector3>> from_the_ground(const world::Vector3& place,
                                                      const world::SensorModel& device,
                                                      const Stands& stands) const;
  Answer<std::vector<world::Vector3>> tour_on_the_ground(const world::Vector3& from,
                                                         const std::vector<Stop>& stops,
                                                         const world::Airspace& map) const;
  const Gazetteer& gazetteer() const { return air_.gazetteer(); }
  const world::World& world() const { return air_.world(); }
  const world::VehicleModel& vehicle() const { return air_.vehicle(); }

  TimedAir& air_;
};

}  // namespace skein::supervisor
