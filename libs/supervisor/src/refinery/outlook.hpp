// SPDX-License-Identifier: Apache-2.0
// What setting out at a moment leads to, and whether waiting leads further.
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

  /// Least is best.
  struct Prospect {
    double unseen = 0;  ///< part of a zone, if any
    double seconds = std::numeric_limits<double>::infinity();
    bool beats(const Prospect& other) const;
  };
  using Venture = std::function<Prospect(const Departure&)>;
  /// How long to wait in place before setting out, so that air which is closed for a time is open
  /// again [s]; nothing when setting out at once is possible and leads no less far, or waiting is
  /// not. `from` on the ground: there.
  std::optional<double> worth_waiting(const world::Vector3& from, const Departure& when,
                                      const Venture& venture) const;
  /// To fly there, from the ground after a takeoff, and stay for some seconds.
  Prospect of_way(const world::Vector3& from, const world::Vector3& to, double stay,
                  const Departure& when);
  /// To fly there and have the zone in sight; and to fly to a sweep, or what is left of one.
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
  /// After a takeoff when it is on the ground; nothing when there is no way then.
  std::optional<Arrival> arrival(const world::Vector3& from, const world::Vector3& to,
                                 const Departure& when);
  /// To fly to where a motion over a zone begins, and that.
  Prospect of_pattern(const world::Vector3& from, const Answer<Motion>& motion,
                      const Departure& when);

  TimedAir& air_;
  Ways& ways_;
  Patrols& patrols_;
  Sweeps& sweeps_;
};

}  // namespace skein::supervisor
