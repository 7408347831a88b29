// SPDX-License-Identifier: Apache-2.0
// A refined motion, and the interval in which it may begin.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "flight/flight_times.hpp"
#include "skein/foundation/result.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::supervisor {

/// A motion, with the data of its elementary task.
struct Motion {
  refiners::Way way;  ///< starting position and way-points
  Times times;
  double energy = 0;                  ///< expected, as a fraction of the full capacity
  std::optional<world::Vector3> aim;  ///< target at which its device is to be aimed meanwhile
  double seen = 1;                    ///< for a sweep: least part of the zone that is seen, [0, 1]
};

/// When a motion may begin, after the plan's origin [s]; `most` may be infinite.
struct Departure {
  double least = 0, most = std::numeric_limits<double>::infinity();
  /// The departure will be chosen within the interval later: only volumes that are closed during
  /// all of it count.
  bool suited = false;

  /// The departure of a motion that follows one of duration `times` with this departure.
  Departure after(const Times& times) const {
    return {least + times.least, most + times.most, suited};
  }
  Departure after(double seconds) const { return {least + seconds, most + seconds, suited}; }
};

/// A waiting place of a UAV, and the radius around it that others keep out of [m].
struct Spot {
  world::Vector3 at = world::Vector3::Zero();
  double room = 0;
};

/// The error is a sentence.
template <class Value>
using Answer = Result<Value, std::string>;

inline tl::unexpected<std::string> no(std::string why) {
  return tl::unexpected<std::string>(std::move(why));
}

}  // namespace skein::supervisor
