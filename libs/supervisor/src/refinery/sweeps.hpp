// SPDX-License-Identifier: Apache-2.0
// Seeing all of a zone, judged by how the autopilot will fly it.
#pragma once

#include "refinery/ways.hpp"
#include "skein/refiners/coverage.hpp"

namespace skein::supervisor {

/// Between two lanes of a vehicle whose device sees so far to each side, so that what lies between
/// is seen in spite of what it strays [m]; `overlap`: for how many deviations.
double swath_of(double footprint, const world::VehicleModel& vehicle, double overlap = 1);
/// The footprint for which it is that.
double footprint_of(double swath, const world::VehicleModel& vehicle, double overlap);
/// Of parts of a shared area: by less, gaps are left as a rule, and a lane more is flown than the
/// division reckoned with.
inline constexpr double kSharedOverlap = 3;

class Sweeps {
 public:
  Sweeps(TimedAir& air, const Ways& ways) : air_(air), ways_(ways) {}

  /// One that hovers is not brought back on its lanes where it swings out: parts of an area that is
  /// shared, of which who flies where is agreed.
  void let_swing() { swings_ = true; }

  /// From its first lane on, and where it turns into that; the way there is not part of it, but it
  /// is set out on `when`. As it will be flown all of the zone is seen, but for what lies in air
  /// that is closed then.
  Answer<Motion> over(const world::Vector3& from, const world::Zone& zone,
                      const world::SensorModel& device, const Departure& when = {}) const;
  /// What is left of such a way: `device` sees at least as much from it as `before` did.
  Answer<Motion> rest(const world::Vector3& from, const refiners::Way& way,
                      const world::SensorModel& device, const world::SensorModel& before,
                      const Departure& when = {});

  /// Such a motion in two: what is flown first, to where it turns next to that share of its length,
  /// and the way-points from there on. Nothing when it has no inner way-points to be parted at.
  struct Parts {
    Motion first;
    refiners::Way beyond;
  };
  std::optional<Parts> parted(const refiners::Way& way, double share) const;

 private:
  using Counted = TimedAir::Counted;
  const Gazetteer& gazetteer() const { return air_.gazetteer(); }
  const world::VehicleModel& vehicle() const { return air_.vehicle(); }
  struct Lanes {
    refiners::Way way;
    double seen = 0;  ///< least part of the zone, of all poses it may begin in
  };
  /// `overlap`: of lanes, in deviations; `joins`: one that hovers is brought back on each lane.
  struct Care {
    double overlap = 1;
    bool joins = false;
  };
  void fly_along(refiners::Way& way, const world::Vector3& to, bool joins) const;
  refiners::Way lanes_flown(const refiners::Coverage& task, const world::World& world,
                            bool joins) const;
  Answer<Lanes> planned(const world::World& world, const world::Vector3& from,
                        const world::Zone& zone, const world::SensorModel& device,
                        const Care& care) const;
  Answer<Lanes> best(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                     const world::SensorModel& device, double margin) const;
  Answer<Motion> over_in(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                         const world::SensorModel& device) const;
  Answer<Motion> rest_in(const Counted& air, const refiners::Way& way,
                         const world::SensorModel& device, const world::SensorModel& before);

  TimedAir& air_;
  const Ways& ways_;
  bool swings_ = false;
};

}  // namespace skein::supervisor
