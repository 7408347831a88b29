// SPDX-License-Identifier: Apache-2.0
// Having a zone in sight for some time, judged by how the autopilot will fly it.
#pragma once

#include <optional>
#include <vector>

#include "refinery/ways.hpp"

namespace skein::supervisor {

class Patrols {
 public:
  Patrols(TimedAir& air, const Ways& ways) : air_(air), ways_(ways) {}

  /// As long as it takes to come there from where it is and, after that, to have the zone in sight
  /// for so many seconds; at that height. A head that can be aimed is aimed at the middle of a zone
  /// that is too small to be seen ahead.
  Answer<Motion> over(const world::Vector3& from, const world::Zone& zone,
                      const world::SensorModel& device, double seconds, const Departure& when = {});

 private:
  using Counted = TimedAir::Counted;
  const Gazetteer& gazetteer() const { return air_.gazetteer(); }
  const world::World& world() const { return air_.world(); }
  const world::VehicleModel& vehicle() const { return air_.vehicle(); }
  /// Where a device looks from a height: a disc on the ground, some metres ahead [m]; or what it is
  /// aimed at, from within `reach`.
  struct Look {
    double ahead = 0, reach = 0;
    std::optional<world::Vector2> aim;
    double width = 0;  ///< of what is seen from that height at once
  };
  class Sight;
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
  /// What is flown again and again over the middle of a zone too small for lanes: a circle, or for
  /// one that hovers, where a circle has no room, to and fro.
  std::vector<refiners::Way> rounds(const world::Vector3& from, const world::Zone& zone,
                                    double footprint, const Counted& air) const;
  std::optional<refiners::Way> again_and_again(const world::Vector3& from,
                                               const refiners::Way& round, double seconds,
                                               const Counted& air);

  TimedAir& air_;
  const Ways& ways_;
};

}  // namespace skein::supervisor
