// SPDX-License-Identifier: Apache-2.0
// Patrols that keep a zone in view for a given time, verified by simulated flights.
#pragma once

#include <optional>
#include <vector>

#include "refinery/ways.hpp"

namespace skein::supervisor {

class Patrols {
 public:
  Patrols(TimedAir& air, const Ways& ways) : air_(air), ways_(ways) {}

  /// A motion from `from` to the zone and over it, at the height of `from`, until the device has
  /// had the zone in view for `seconds`. A device that can be aimed is aimed at the middle of a
  /// zone that is too small to be seen ahead.
  Answer<Motion> over(const world::Vector3& from, const world::Zone& zone,
                      const world::SensorModel& device, double seconds, const Departure& when = {});

 private:
  using Counted = TimedAir::Counted;
  const Gazetteer& gazetteer() const { return air_.gazetteer(); }
  const world::World& world() const { return air_.world(); }
  const world::VehicleModel& vehicle() const { return air_.vehicle(); }
  /// What a device sees from a height: a disc on the ground, `ahead` of the vehicle [m]; or `aim`,
  /// from within `reach` [m].
  struct Look {
    double ahead = 0, reach = 0;
    std::optional<world::Vector2> aim;
    double width = 0;  ///< of the area that is in view at once [m]
  };
  class Sight;
  class Filling;
  static Look look_of(const world::SensorModel& device, double height, double footprint);
  Answer<Motion> over_in(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                         const world::SensorModel& device, double seconds);
  Answer<Motion> flown_over(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                            const Look& look, double seconds);
  Answer<Motion> in_lanes(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                          const Look& look, double seconds, double margin) const;
  Answer<Motion> in_rounds(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                           const Look& look, double seconds);
  Answer<refiners::Way> planned(const world::World& world, const world::Vector3& from,
                                const world::Zone& zone, double footprint, double seconds) const;
  std::optional<refiners::Way> filled(const refiners::Way& way, const world::Zone& zone,
                                      const Look& look, double seconds, double& longer) const;
  /// Closed ways over the middle of a zone that is too small for lanes, to be repeated: a circle,
  /// or to and fro for a vehicle that hovers where a circle has no room.
  std::vector<refiners::Way> rounds(const world::Vector3& from, const world::Zone& zone,
                                    double footprint, const Counted& air) const;
  std::optional<refiners::Way> again_and_again(const world::Vector3& from,
                                               const refiners::Way& round, double seconds,
                                               const Counted& air);

  TimedAir& air_;
  const Ways& ways_;
};

}  // namespace skein::supervisor
