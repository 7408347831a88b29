// SPDX-License-Identifier: Apache-2.0
// Whether to wait for closed air to open: compares setting out now with setting out later.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "refinery/patrols.hpp"
#include "refinery/sweeps.hpp"
#include "refinery/ways.hpp"

namespace skein::supervisor {

class Outlook {
 public:
  Outlook(TimedAir& air, Ways& ways, Patrols& patrols, Sweeps& sweeps)
      : air_(air), ways_(ways), patrols_(patrols), sweeps_(sweeps) {}

  /// Expected result of setting out; less is better, `unseen` first.
  struct Prospect {
    double unseen = 0;  ///< part of a zone, if any
    double seconds = std::numeric_limits<double>::infinity();
    bool beats(const Prospect& other) const;
  };
  using Venture = std::function<Prospect(const Departure&)>;
  /// How long to wait at `from`, in the air or on the ground, until temporarily closed air is open
  /// again, if that gives a better prospect than setting out at once [s]; absent: it does not, or
  /// waiting there is impossible.
  std::optional<double> worth_waiting(const world::Vector3& from, const Departure& when,
                                      const Venture& venture) const;
  /// The prospect of flying to `to`, from the ground after a takeoff, and staying for `stay` [s].
  Prospect of_way(const world::Vector3& from, const world::Vector3& to, double stay,
                  const Departure& when);
  /// The prospects of flying to a patrol over the zone, to a sweep, and to the rest of a sweep, and
  /// carrying it out.
  Prospect of_patrol(const world::Vector3& from, const world::Vector3& to, const world::Zone& zone,
                     const world::SensorModel& device, double seconds, const Departure& when);
  Prospect of_sweep(const world::Vector3& from, const world::Zone& zone,
                    const world::SensorModel& device, const Departure& when);
  Prospect of_rest(const world::Vector3& from, const refiners::Way& way,
                   const world::SensorModel& device, const world::SensorModel& before,
                   const Departure& when);

 private:
  struct Arrival {
    Departure then;
    double seconds = 0;  ///< expected, since setting out
  };
  /// The flight to `to`, after a takeoff if the vehicle is on the ground; absent: there is no way
  /// then.
  std::optional<Arrival> arrival(const world::Vector3& from, const world::Vector3& to,
                                 const Departure& when);
  /// The prospect of flying to the beginning of a motion over a zone and carrying it out.
  Prospect of_pattern(const world::Vector3& from, const Answer<Motion>& motion,
                      const Departure& when);

  TimedAir& air_;
  Ways& ways_;
  Patrols& patrols_;
  Sweeps& sweeps_;
};

}  // namespace skein::supervisor
