// SPDX-License-Identifier: Apache-2.0
// Reports of UAVs that wait for air, from the event log.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/world/geometry.hpp"

namespace skein::journal {
struct Written;
namespace lines {
struct Air;
}
}  // namespace skein::journal

namespace skein::laws {

/// A piece of wanted air, seen from above: what is within `radius` [m] of a line.
struct WantedPiece {
  world::Vector2 from = world::Vector2::Zero(), to = world::Vector2::Zero();
  double radius = 0;
};

/// From `at` on [s], the UAV waits until `for_others` leave the air that it wants. Empty: it waits
/// for nobody, since it has the air, gave its motion up, or waits for answers.
struct AirWait {
  double at = 0;
  std::string uav;
  std::set<std::string> for_others;
  std::set<std::string> to_leave;       ///< of these, who has the air
  std::vector<WantedPiece> wants = {};  ///< empty: it is not known
};

/// At that time [s] it begins a flight higher than it was asked for, over those in its way.
struct RaisedFlight {
  double at = 0;
  std::string uav;
};

/// In the order of time.
struct AirHistory {
  std::vector<AirWait> waits;
  std::vector<RaisedFlight> raised;

  /// Takes a record, if it is of this kind. False: it is of this kind and cannot be read.
  bool see(const journal::Record& record);
  void hear(const journal::lines::Air& line, const journal::Written& when);
};

}  // namespace skein::laws
