// SPDX-License-Identifier: Apache-2.0
// Who waited for the air of a way, for whom, and who had it when: a row for each UAV. Source:
// spec 6.4.
#include <algorithm>

#include "line.hpp"
#include "text.hpp"
#include "timeline.hpp"

namespace skein::report {

namespace {

constexpr double kBand = 15.0, kGap = 4.0;

/// A motion that waits for its air, or has it.
struct Use {
  Span span;
  std::string state, what, why;
};

/// When the task is over, or the log.
double end_of(const Chronology& story, std::size_t uav, std::int64_t task) {
  for (const TaskBar& bar : story.tasks) {
    if (bar.uav == uav && bar.id == static_cast<std::uint64_t>(task)) return bar.span.to;
  }
  return story.time.to;
}

std::vector<Use> uses_of(const Run& run, std::size_t uav) {
  std::vector<Use> uses;
  for (const OtherRecord& record : run.journal.others) {
    if (record.kind != "air") continue;
    const auto line = line_of(record);
    if (!line || line->text("uav") != run.story.uavs[uav].name) continue;
    if (!uses.empty()) uses.back().span.to = std::min(uses.back().span.to, line->t);
    const auto task = line->whole("task").value_or(0);
    const double raised = line->number("raised");
    uses.push_back({{line->t, std::max(line->t, end_of(run.story, uav, task))},
                    line->text("state"),
                    std::to_string(task) + " " + line->text("type"),
                    raised > 0 ? short_number(raised, 0) + " m higher" : line->text("for")});
  }
  return uses;
}

std::string style_of(const std::string& state) {
  if (state == "waits") return "joint-loading";
  return state == "unasked" ? "violated" : "joint-running";
}

void draw_use(Sheet& sheet, std::size_t uav, const Use& one) {
  sheet.plot.open("g", {{"class", "joint " + colour_class(uav)}});
  sheet.plot.title(one.what + ": " + one.state + (one.why.empty() ? "" : ", " + one.why) + "\n" +
                   clock_text(one.span.from) + " to " + clock_text(one.span.to));
  sheet.bar(one.span, sheet.y, kBand - 2, style_of(one.state));
  sheet.plot.close();
}

}  // namespace

void draw_air_rows(Sheet& sheet) {
  bool first = true;
  for (std::size_t uav = 0; uav < sheet.run.story.uavs.size(); ++uav) {
    const std::vector<Use> uses = uses_of(sheet.run, uav);
    if (uses.empty()) continue;
    if (std::exchange(first, false)) sheet.heading("Air of ways: waited for, had");
    sheet.labels.element("text", {{"class", "under"}, {"x", 10}, {"y", sheet.y + kBand - 4}},
                         shortened(sheet.run.story.uavs[uav].name, 22));
    for (const Use& one : uses) draw_use(sheet, uav, one);
    sheet.y += kBand + kGap;
  }
}

}  // namespace skein::report
