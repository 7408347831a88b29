// SPDX-License-Identifier: Apache-2.0
// What UAVs said that they knew of those whom they are to meet (records of the kind "meeting").
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// What was known from an instant on; all instants [s].
struct MeetingWord {
  double t = 0;
  bool known = false;                      ///< false: nothing any more
  bool there = false;                      ///< all have come, or have left
  bool air = false;                        ///< others are to leave it, not to come
  std::string last;                        ///< who comes, or leaves, last
  std::optional<double> soonest, slowest;  ///< between when; none: no figure bounds it
  std::optional<double> needed;            ///< by when another needs it there
  std::string needed_by;
};

/// By UAV (its index into Chronology::uavs) and number of the meeting, in the order of time.
using MeetingRow = std::pair<std::size_t, std::uint64_t>;
using MeetingRows = std::map<MeetingRow, std::vector<MeetingWord>>;

MeetingRows meeting_rows_of(const Journal& journal, const Chronology& story);

}  // namespace skein::report
