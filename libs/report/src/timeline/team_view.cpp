// SPDX-License-Identifier: Apache-2.0
// Who owned each task of the team when: a row for each task, a band for each owner. Source:
// spec 6.3.
#include <algorithm>
#include <map>

#include "text.hpp"
#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr double kTeamBand = 15.0, kTeamGap = 4.0;

/// A task with one owner, or none, for a while.
struct Holding {
  Span span;
  std::string stage, owners, why;
};
struct TeamRow {
  std::string statement;
  std::vector<Holding> holdings;
};

// By the number of the task, from what the ground station said of the team's book.
std::map<std::uint64_t, TeamRow> rows_of(const Journal& journal, double until) {
  std::map<std::uint64_t, TeamRow> rows;
  for (const auto& [stamp, line] : journal.owners) {
    const double at = seconds(stamp);
    TeamRow& row = rows[line.task];
    row.statement = line.statement;
    if (!row.holdings.empty()) row.holdings.back().span.to = at;
    row.holdings.push_back({{at, until}, line.stage, line.owners, line.why});
  }
  return rows;
}

// That of its first owner.
std::string colour_of(const Sheet& sheet, const std::string& owners) {
  const std::string first = owners.substr(0, owners.find(", "));
  const auto& uavs = sheet.run.story.uavs;
  for (std::size_t i = 0; i < uavs.size(); ++i) {
    if (uavs[i].name == first) return colour_class(i);
  }
  return "";
}

void draw_holding(Sheet& sheet, std::uint64_t task, const TeamRow& row, const Holding& one) {
  if (one.stage == "done") return;
  sheet.plot.open("g", {{"class", "joint " + colour_of(sheet, one.owners)}});
  sheet.plot.title("task " + std::to_string(task) + " " + row.statement + "\n" + one.stage +
                   (one.owners.empty() ? "" : " " + one.owners) + "\n" + one.why + "\n" +
                   clock_text(one.span.from) + " to " + clock_text(one.span.to));
  const bool granted = one.stage == "granted", owned = one.stage == "owned";
  sheet.bar(one.span, sheet.y, kTeamBand - 2,
            granted ? "joint-running"
            : owned ? "joint-loading"
                    : "violated");
  const double from = sheet.x(one.span.from), to = sheet.x(one.span.to);
  const std::string text = one.owners.empty() ? one.stage : one.owners;
  const double need = text_width(text, 10) + 6;
  const std::string style = granted ? "inside" : "outside";
  sheet.plot.element("text",
                     {{"class", need < to - from ? style : style + " off"},
                      {"x", from},
                      {"dx", 4},
                      {"y", sheet.y + kTeamBand - 5},
                      {"data-from", from},
                      {"data-to", to},
                      {"data-need", need}},
                     text);
  sheet.plot.close();
}

}  // namespace

void draw_team_rows(Sheet& sheet) {
  const auto rows = rows_of(sheet.run.journal, sheet.run.story.time.to);
  if (rows.empty()) return;
  sheet.heading("Tasks of the team");
  for (const auto& [task, row] : rows) {
    sheet.row_name(sheet.y + kTeamBand - 4, std::to_string(task) + " " + row.statement);
    for (const Holding& one : row.holdings) draw_holding(sheet, task, row, one);
    sheet.y += kTeamBand + kTeamGap;
  }
}

}  // namespace skein::report
