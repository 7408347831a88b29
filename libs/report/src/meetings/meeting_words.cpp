// SPDX-License-Identifier: Apache-2.0
// What UAVs said that they knew of those whom they are to meet.
#include "meetings/meeting_words.hpp"

namespace skein::report {

MeetingRows meeting_rows_of(const Journal& journal, const Chronology& story) {
  MeetingRows rows;
  for (const auto& [stamp, line] : journal.meetings) {
    const auto uav = story.uav_index(line.uav);
    if (!uav) continue;
    rows[{*uav, line.id}].push_back({seconds(stamp), line.known, line.there.value_or(false),
                                     line.order.value_or(false), line.last, line.soonest,
                                     line.slowest, line.needed, line.needed_by});
  }
  return rows;
}

}  // namespace skein::report
