// SPDX-License-Identifier: Apache-2.0
// When a UAV was foretold that others come to meet it, or leave the air for which it waits: a row
// for each meeting and each that waits, in which what it knew is drawn from the top downwards as it
// came. Source: spec 5.3; M figure 7.
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "chronology.hpp"
#include "line.hpp"
#include "text.hpp"
#include "timeline.hpp"

namespace skein::report {

namespace {

constexpr double kLine = 3.0, kLeast = 12.0, kMost = 42.0, kGap = 5.0;

/// What was known from an instant on.
struct Word {
  double t = 0;
  bool known = false, there = false;
  std::string last;
  Span comes;  ///< to the end of the log where no figure bounds it
  std::string needed;
  bool air = false;  ///< others are to leave it
};

using Row = std::pair<std::size_t, std::int64_t>;  ///< UAV and meeting
using Rows = std::map<Row, std::vector<Word>>;

Rows rows_of(const Journal& journal, const Chronology& story) {
  Rows rows;
  for (const OtherRecord& record : journal.others) {
    if (record.kind != "meeting") continue;
    const auto line = line_of(record);
    if (!line) continue;
    const auto uav = story.uav_index(line->text("uav"));
    const auto id = line->whole("id");
    if (!uav || !id) continue;
    const auto has = [&](const char* key) { return line->keys.contains(key); };
    const auto is = [&](const char* key) { return has(key) && line->keys[key] == true; };
    Word word{line->t, is("known"), is("there"), line->text("last"), story.time, ""};
    if (has("soonest")) word.comes.from = line->number("soonest");
    if (has("slowest")) word.comes.to = line->number("slowest");
    if (has("needed"))
      word.needed =
          line->text("needed_by") + " needs it there by " + clock_text(line->number("needed"));
    word.air = is("order");
    rows[{*uav, *id}].push_back(std::move(word));
  }
  return rows;
}

std::string told(const Word& word, bool bounded) {
  std::string text = word.last.empty() ? "waits for nobody"
                     : word.there
                         ? word.last + " is there, the last"
                         : word.last + (word.air ? " leaves " : " comes ") +
                               (bounded ? "between " : "from ") + clock_text(word.comes.from);
  if (!word.last.empty() && !word.there)
    text += bounded ? " and " + clock_text(word.comes.to) : " on";
  return text + (word.needed.empty() ? "" : "\n" + word.needed);
}

void draw_row(Sheet& sheet, const std::vector<Word>& words) {
  const double height = std::clamp(kLine * static_cast<double>(words.size()), kLeast, kMost);
  const double step = height / static_cast<double>(words.size());
  const Span all = sheet.run.story.time;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Word& word = words[i];
    const double until = i + 1 < words.size() ? words[i + 1].t : all.to;
    if (!word.known) continue;
    const bool bounded = word.comes.to < all.to;
    const auto other = sheet.run.story.uav_index(word.last);  // in whose colour it is
    sheet.plot.open("g", {{"class", "joint air meeting" +
                                        (other ? " " + colour_class(*other) : std::string())}});
    sheet.plot.title("known at " + clock_text(word.t) + ": " + told(word, bounded));
    // The word, then what it says.
    sheet.bar({word.t, word.t}, sheet.y, height, "word");
    if (word.there)
      sheet.bar({word.t, until}, sheet.y, height, "joint-running");
    else if (!word.last.empty() && word.comes.from <= all.to)
      sheet.bar({std::max(word.comes.from, all.from), std::min(word.comes.to, all.to)},
                sheet.y + step * static_cast<double>(i), std::min(step, kLine) - 0.6,
                "joint-leaving");
    sheet.plot.close();
  }
  sheet.y += height + kGap;
}

}  // namespace

void draw_meeting_rows(Sheet& sheet) {
  const Rows rows = rows_of(sheet.run.journal, sheet.run.story);
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
