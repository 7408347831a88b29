// SPDX-License-Identifier: Apache-2.0
// When a UAV was foretold that others come to meet it, or leave the air for which it waits: a row
// for each meeting and each that waits, in which what it knew is drawn from the top downwards as it
// came. Source: spec 5.3; M figure 7.
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "meetings/meeting_words.hpp"
#include "text.hpp"
#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr double kLine = 3.0, kLeast = 12.0, kMost = 42.0, kGap = 5.0;

/// To the end of the log where no figure bounds it.
Span span_of(const MeetingWord& word, const Span& all) {
  return {word.soonest.value_or(all.from), word.slowest.value_or(all.to)};
}

std::string told(const MeetingWord& word, const Span& when, bool bounded) {
  std::string text = word.last.empty() ? "waits for nobody"
                     : word.there      ? word.last + " is there, the last"
                                       : word.last + (word.air ? " leaves " : " comes ") +
                                        (bounded ? "between " : "from ") + clock_text(when.from);
  if (!word.last.empty() && !word.there) text += bounded ? " and " + clock_text(when.to) : " on";
  if (!word.needed) return text;
  return text + "\n" + word.needed_by + " needs it there by " + clock_text(*word.needed);
}

void draw_row(Sheet& sheet, const std::vector<MeetingWord>& words) {
  const double height = std::clamp(kLine * static_cast<double>(words.size()), kLeast, kMost);
  const double step = height / static_cast<double>(words.size());
  const Span all = sheet.run.story.time;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const MeetingWord& word = words[i];
    const double until = i + 1 < words.size() ? words[i + 1].t : all.to;
    if (!word.known) continue;
    const Span when = span_of(word, all);
    const bool bounded = when.to < all.to;
    const auto other = sheet.run.story.uav_index(word.last);  // in whose colour it is
    sheet.plot.open("g", {{"class", "joint air meeting" +
                                        (other ? " " + colour_class(*other) : std::string())}});
    sheet.plot.title("known at " + clock_text(word.t) + ": " + told(word, when, bounded));
    // The word, then what it says.
    sheet.bar({word.t, word.t}, sheet.y, height, "word");
    if (word.there)
      sheet.bar({word.t, until}, sheet.y, height, "joint-running");
    else if (!word.last.empty() && when.from <= all.to)
      sheet.bar({std::max(when.from, all.from), std::min(when.to, all.to)},
                sheet.y + step * static_cast<double>(i), std::min(step, kLine) - 0.6,
                "joint-leaving");
    sheet.plot.close();
  }
  sheet.y += height + kGap;
}

}  // namespace

void draw_meeting_rows(Sheet& sheet) {
  const MeetingRows rows = meeting_rows_of(sheet.run.journal, sheet.run.story);
  if (rows.empty()) return;
  sheet.heading("Meetings: foretold, word by word");
  for (const auto& [row, words] : rows) {
    const std::string& uav = sheet.run.story.uavs[row.first].name;
    const bool air = words.front().air;
    sheet.row_name(sheet.y + kLeast - 2, uav + (air ? " air" : " " + std::to_string(row.second)));
    draw_row(sheet, words);
  }
}

}  // namespace skein::report
