// SPDX-License-Identifier: Apache-2.0
// What planning gets from the refiners, and when it may begin.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "flight/flight_times.hpp"
#include "skein/foundation/result.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::supervisor {

/// A motion with all that a task is made of.
struct Motion {
  refiners::Way way;  ///< where it begins and all that is flown to
  Times times;
  double energy = 0;                  ///< expected, as a fraction of what is held when full
  std::optional<world::Vector3> aim;  ///< what its device is to be aimed at meanwhile
  double seen = 1;                    ///< of a sweep, least part of the zone
};

/// When a motion may begin, after the plan's origin [s]; `most` may be infinite.
struct Departure {
  double least = 0, most = std::numeric_limits<double>::infinity();
  /// At one of these moments that suits, which is found later: only air that is closed during all
  /// of them counts.
  bool suited = false;

  /// Of what begins when something else, begun then, is over.
  Departure after(const Times& times) const {
    return {least + times.least, most + times.most, suited};
  }
  Departure after(double seconds) const { return {least + seconds, most + seconds, suited}; }
};

/// Where somebody waits, and how near to that nobody else comes [m].
struct Spot {
  world::Vector3 at = world::Vector3::Zero();
  double room = 0;
};

/// Sentences say why not.
template <class Value>
using Answer = Result<Value, std::string>;

inline tl::unexpected<std::string> no(std::string why) {
  return tl::unexpected<std::string>(std::move(why));
}

}  // namespace skein::supervisor
