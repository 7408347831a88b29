// SPDX-License-Identifier: Apache-2.0
// What UAVs said that they knew of those whom they are to meet.
#include "meetings/meeting_words.hpp"

#include "line.hpp"

namespace skein::report {

namespace {

MeetingWord word_of(const Line& line) {
  const auto is = [&](const char* key) {
    return line.keys.contains(key) && line.keys[key] == true;
  };
  const auto instant = [&](const char* key) {
    return line.keys.contains(key) ? std::optional(line.number(key)) : std::nullopt;
  };
  return {line.t,
          is("known"),
          is("there"),
          is("order"),
          line.text("last"),
          instant("soonest"),
          instant("slowest"),
          instant("needed"),
          line.text("needed_by")};
}

}  // namespace

MeetingRows meeting_rows_of(const Journal& journal, const Chronology& story) {
  MeetingRows rows;
  for (const OtherRecord& record : journal.others) {
    if (record.kind != "meeting") continue;
    const auto line = line_of(record);
    if (!line) continue;
    const auto uav = story.uav_index(line->text("uav"));
    const auto id = line->whole("id");
    if (uav && id) rows[{*uav, *id}].push_back(word_of(*line));
  }
  return rows;
}

}  // namespace skein::report
