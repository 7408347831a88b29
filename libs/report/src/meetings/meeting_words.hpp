// SPDX-License-Identifier: Apache-2.0
// Estimated arrival dates of the partners of a meeting, as known to a waiting UAV (records of the
// kind "meeting").
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// What a UAV knew of a meeting from `t` on; all instants [s] of mission time.
struct MeetingWord {
  double t = 0;
  bool known = false;                      ///< false: nothing is known any more
  bool there = false;                      ///< all partners have arrived, or have left
  bool air = false;                        ///< partners have to leave air, instead of arriving
  std::string last;                        ///< the partner that arrives, or leaves, last
  std::optional<double> soonest, slowest;  ///< bounds of that arrival; none: unbounded
  std::optional<double> needed;            ///< date by which `needed_by` needs this UAV there
  std::string needed_by;
};

/// Key: the UAV (index into Chronology::uavs) and the number of its meeting. Words in time order.
using MeetingRow = std::pair<std::size_t, std::uint64_t>;
using MeetingRows = std::map<MeetingRow, std::vector<MeetingWord>>;

MeetingRows meeting_rows_of(const Journal& journal, const Chronology& story);

}  // namespace skein::report
