// SPDX-License-Identifier: Apache-2.0
// Sweeps that see all of a zone, verified by simulated flights.
#pragma once

#include "refinery/ways.hpp"
#include "skein/refiners/coverage.hpp"

namespace skein::supervisor {

/// Distance between two lanes [m] for a device that sees `footprint` [m] to each side, so that the
/// vehicle's tracking error leaves no gap; `overlap`: number of its standard deviations.
double swath_of(double footprint, const world::VehicleModel& vehicle, double overlap = 1);
/// The inverse of swath_of().
double footprint_of(double swath, const world::VehicleModel& vehicle, double overlap);
/// Overlap for parts of a shared area: with less, gaps usually remain, and more lanes are flown
/// than the partition assumed.
inline constexpr double kSharedOverlap = 3;

class Sweeps {
 public:
  Sweeps(TimedAir& air, const Ways& ways) : air_(air), ways_(ways) {}

  /// For parts of a shared area, whose lanes are agreed: a vehicle that hovers gets extra way-points
  /// that lead it back on a lane after it swung out only where much would not be seen without them.
  void let_swing() { swings_ = true; }

  /// The sweep from its first lane on, including the turn into that lane, but not the way to it;
  /// `when` is the departure from `from`. In simulated flight all of the zone is seen, except what
  /// lies in air that is closed then.
  Answer<Motion> over(const world::Vector3& from, const world::Zone& zone,
                      const world::SensorModel& device, const Departure& when = {}) const;
  /// The remaining way of a sweep, for `device`, which must see at least as much as `before`, the
  /// device that the lanes were made for.
  Answer<Motion> rest(const world::Vector3& from, const refiners::Way& way,
                      const world::SensorModel& device, const world::SensorModel& before,
                      const Departure& when = {});

  /// A sweep divided at the turn nearest to `share` of its length: the first motion, and the
  /// way-points from there on. Absent: it has no inner way-points.
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
    double seen = 0;  ///< part of the zone seen, the least over all initial poses
  };
  /// `overlap`: as in swath_of(); `joins`: a vehicle that hovers is led back on each lane; `share`:
  /// of the distance between two lanes with that overlap.
  struct Care {
    double overlap = 1;
    bool joins = false;
    double share = 1;
  };
  void fly_along(refiners::Way& way, const world::Vector3& to, bool joins) const;
  refiners::Way lanes_flown(const refiners::Coverage& task, const world::World& world,
                            bool joins) const;
  Answer<Lanes> planned(const world::World& world, const world::Vector3& from,
                        const world::Zone& zone, const world::SensorModel& device,
                        const Care& care) const;
  Answer<Lanes> best(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                     const world::SensorModel& device, double margin) const;
  /// With lanes so near to each other that hills, turns and short run-ins leave no gaps, where
  /// those of `wide` leave some; else `wide`.
  Lanes narrowed(Lanes wide, const world::World& world, const world::Vector3& from,
                 const world::Zone& zone, const world::SensorModel& device) const;
  Answer<Motion> over_in(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                         const world::SensorModel& device) const;
  Answer<Motion> rest_in(const Counted& air, const refiners::Way& way,
                         const world::SensorModel& device, const world::SensorModel& before);

  TimedAir& air_;
  const Ways& ways_;
  bool swings_ = false;
};

}  // namespace skein::supervisor
