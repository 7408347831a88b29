// SPDX-License-Identifier: Apache-2.0
// Places: to look from, beside others, in the order of a tour.
#pragma once

#include <vector>

#include "refinery/timed_air.hpp"
#include "skein/refiners/viewpoint.hpp"

namespace skein::supervisor {

class Views {
 public:
  explicit Views(TimedAir& air) : air_(air) {}

  using Constraints = std::vector<refiners::PlaceConstraint>;
  /// Where that sensor sees the place best, from so many sides, when it sets out then and stays for
  /// so many seconds; at places that keep the constraints.
  Answer<std::vector<world::Vector3>> of(const world::Vector3& place,
                                         const world::SensorModel& device, std::size_t count,
                                         const Departure& when = {}, double seconds = 0,
                                         const Constraints& constraints = {});
  Answer<std::vector<world::Vector3>> tour(const world::Vector3& from,
                                           const std::vector<world::Vector3>& places);

 private:
  /// What a view from the ground is to keep to.
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
                                                         const std::vector<world::Vector3>& places,
                                                         const world::Airspace& map) const;
  const Gazetteer& gazetteer() const { return air_.gazetteer(); }
  const world::World& world() const { return air_.world(); }
  const world::VehicleModel& vehicle() const { return air_.vehicle(); }

  TimedAir& air_;
};

}  // namespace skein::supervisor
