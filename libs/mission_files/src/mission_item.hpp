// SPDX-License-Identifier: Apache-2.0
// From items of MAVLink missions to steps.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "findings.hpp"
#include "skein/mission_files/contents.hpp"

namespace skein::mission_files {

inline constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

/// As files have it: MISSION_ITEM. Parameters 5 to 7 are latitude, longitude and height where the
/// command has a place.
struct MissionItem {
  std::int64_t command = 0;        ///< MAV_CMD
  std::int64_t frame = 0;          ///< MAV_FRAME
  std::array<double, 7> params{};  ///< kNotGiven where the file says nothing
  bool goes_on = true;             ///< autocontinue
  Mark mark;
};

/// Appends what it asks for, or says why not.
void take(const MissionItem& item, Contents& contents, Findings& findings);

/// "NAV_WAYPOINT (16)"; the number alone when it has no name here.
std::string command_text(std::int64_t command);

}  // namespace skein::mission_files
