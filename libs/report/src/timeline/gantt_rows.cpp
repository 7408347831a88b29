// SPDX-License-Identifier: Apache-2.0
// The rows of the ground station and of each UAV.
#include <algorithm>
#include <array>
#include <cstdint>

#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr double kRail = 15.0;
constexpr std::size_t kManyLanes = 90;
constexpr std::size_t kMostMarks = 3000;
constexpr std::array<const char*, 6> kStateNames{"scheduled", "started", "running",
                                                 "aborting",  "ended",   "aborted"};

const char* name_of(TaskState state) { return kStateNames[static_cast<std::size_t>(state)]; }

double label_width(const TaskBar& bar) { return text_width(bar_label(bar), kBarFont) + 7; }

enum class LabelPlace { kInside, kAfter, kBefore };

// Inside the bar when it is long enough, else over the time it waited, else after it.
LabelPlace label_place(const TaskBar& bar, const Axis& x) {
  const Span active = bar.active().value_or(Span{bar.span.to, bar.span.to});
  const double need = label_width(bar);
  if (x(active.to) - x(active.from) >= need) return LabelPlace::kInside;
  const bool room_before = x(active.from) - x(bar.span.from) >= need;
  const bool room_after = x(active.to) + need < x.high;
  return room_before || !room_after ? LabelPlace::kBefore : LabelPlace::kAfter;
}

std::string bar_title(const std::string& uav, const TaskBar& bar) {
  std::string text = uav + ": task " + bar_label(bar);
  if (!bar.componel.empty()) text += " (" + std::to_string(bar.id) + ")";
  for (const TaskSegment& s : bar.segments) {
    text += "\n" + std::string(name_of(s.state)) + " " + clock_text(s.span.from);
  }
  if (bar.outcome) {
    text += "\n" + std::string(name_of(*bar.outcome)) + " " + clock_text(bar.span.to);
  }
  if (!bar.reason.empty()) text += "\n" + bar.reason;
  return text;
}

void draw_label(Sheet& sheet, const TaskBar& bar, double top, double height) {
  const Span active = bar.active().value_or(Span{bar.span.to, bar.span.to});
  const double from = sheet.x(active.from), to = sheet.x(active.to);
  const LabelPlace place = label_place(bar, sheet.x);
  const bool running = place == LabelPlace::kInside;
  const bool before = place == LabelPlace::kBefore;
  sheet.plot.element("text",
                     {{"class", running ? "inside" : "outside"},
                      {"x", running || before ? from : to},
                      {"dx", before    ? -6
                             : running ? 4
                                       : 7},
                      {"y", top + height / 2 + 3.5},
                      {"text-anchor", before ? "end" : "start"},
                      {"data-from", from},
                      {"data-to", to},
                      {"data-need", label_width(bar)}},
                     bar_label(bar));
}

// Ended: a solid cap. Aborted: a cross. Alive: an open arrow.
void draw_outcome(Sheet& sheet, const TaskBar& bar, double top, double height) {
  const double half = height / 2;
  sheet.open_mark(bar.span.to, top + half, "outcome");
  if (bar.outcome == TaskState::kEnded) {
    sheet.plot.leaf(
        "rect",
        {{"class", "cap"}, {"x", -1.5}, {"y", -half - 0.5}, {"width", 2}, {"height", height + 1}});
  } else if (bar.outcome == TaskState::kAborted) {
    sheet.plot.leaf("path", {{"class", "cross"}, {"d", "M-3.5 -3.5L3.5 3.5M-3.5 3.5L3.5 -3.5"}});
  } else {
    sheet.plot.leaf("path", {{"class", "alive"}, {"d", "M-5 -4L0 0L-5 4"}});
  }
  sheet.plot.close();
}

// The dates that the temporal network promised when the task started, as a band along the bar: from
// the earliest start to the latest end it may be under way, from the latest start to the earliest
// end it must be.
void draw_promise(Sheet& sheet, const TaskBar& bar, double top, double height) {
  const auto found = sheet.run.plans.promises.find({sheet.run.story.uavs[bar.uav].name, bar.id});
  if (found == sheet.run.plans.promises.end()) return;
  const PlannedRecord& p = *found->second.planned;
  const double end = p.latest_end.value_or(std::max(p.earliest_end, sheet.run.story.time.to));
  sheet.bar({p.earliest_start, end}, top + height, 3, p.latest_end ? "promise" : "promise open");
  const double must = p.latest_start.value_or(p.earliest_end);
  if (must < p.earliest_end) sheet.bar({must, p.earliest_end}, top + height, 3, "certain");
}

std::string promise_title(const Sheet& sheet, const TaskBar& bar) {
  const auto found = sheet.run.plans.promises.find({sheet.run.story.uavs[bar.uav].name, bar.id});
  if (found == sheet.run.plans.promises.end()) return {};
  const PlannedRecord& p = *found->second.planned;
  const auto until = [](const std::optional<double>& t) {
    return t ? clock_text(*t) : std::string("any time");
  };
  return "\nplanned to start " + clock_text(p.earliest_start) + " to " + until(p.latest_start) +
         ", to end " + clock_text(p.earliest_end) + " to " + until(p.latest_end) +
         "\nfor high-level task " + std::to_string(p.goal) +
         (p.methods.empty() ? "" : " by " + p.methods);
}

void draw_bar(Sheet& sheet, const TaskBar& bar, double top, double height, bool with_scheduled) {
  sheet.plot.open("g", {{"class", "bar " + colour_class(bar.uav)}});
  sheet.plot.title(bar_title(sheet.run.story.uavs[bar.uav].name, bar) + promise_title(sheet, bar));
  for (const TaskSegment& s : bar.segments) {
    if (s.state == TaskState::kScheduled && !with_scheduled) continue;
    sheet.bar(s.span, top, height, name_of(s.state));
    if (s.state == TaskState::kAborting) sheet.bar(s.span, top, height, "hatched");
  }
  draw_promise(sheet, bar, top, height);
  draw_outcome(sheet, bar, top, height);
  draw_label(sheet, bar, top, height);
  sheet.plot.close();
}

void draw_rail(Sheet& sheet, const std::string& node) {
  const double y = sheet.y + kRail / 2;
  sheet.rails[node] = y;
  sheet.plot.leaf(
      "line",
      {{"class", "rail"}, {"x1", Sheet::kLeft}, {"x2", Sheet::kRight}, {"y1", y}, {"y2", y}});
}

bool belongs_to(const std::string& process, const std::string& uav) {
  return !uav.empty() && process.find(uav) != std::string::npos;
}

// Deaths and returns of processes, on the rail of the node they serve.
void draw_processes(Sheet& sheet, double rail, const std::string* uav) {
  for (const ProcessRecord& r : sheet.run.journal.processes) {
    if (r.state == "started" || r.state == "ready") continue;
    const auto& uavs = sheet.run.story.uavs;
    const bool of_any = std::any_of(uavs.begin(), uavs.end(),
                                    [&](const UavStory& u) { return belongs_to(r.name, u.name); });
    if (uav != nullptr ? !belongs_to(r.name, *uav) : of_any) continue;
    const bool back = r.state == "restarted";
    sheet.open_mark(seconds(r.stamp), rail, back ? "process back" : "process");
    sheet.plot.title(clock_text(seconds(r.stamp)) + " " + r.name + " " + r.state +
                     (r.why.empty() ? "" : ": " + r.why));
    sheet.plot.leaf("path", {{"d", back ? "M-4 3L0 -4L4 3Z" : "M-4 -4L4 4M-4 4L4 -4"}}).close();
  }
}

void draw_degrees(Sheet& sheet, const UavStory& uav, double rail) {
  for (const auto& [t, degree] : uav.degrees) {
    sheet.open_mark(t, rail, "degree");
    sheet.plot.title(clock_text(t) + " " + uav.name + ": autonomy degree " +
                     std::to_string(degree));
    sheet.plot.leaf("rect", {{"x", -7}, {"y", -6.5}, {"width", 14}, {"height", 13}, {"rx", 3}});
    sheet.plot.element("text", {{"y", 3.6}, {"text-anchor", "middle"}}, std::to_string(degree));
    sheet.plot.close();
  }
}

// What was refused, lost, expired or dropped at a node.
void draw_troubles(Sheet& sheet, double rail, const std::string& node) {
  std::size_t count = 0;
  for (const UndeliveredRecord& r : sheet.run.journal.undelivered) {
    if (r.stamp.node != node || ++count > kMostMarks) continue;
    sheet.open_mark(seconds(r.stamp), rail, "trouble");
    sheet.plot.title(clock_text(seconds(r.stamp)) + " " + r.slot + " to " + r.to +
                     (r.expired ? " expired" : " lost"));
    sheet.plot.leaf("path", {{"d", "M-3 -3L3 3M-3 3L3 -3"}}).close();
  }
  for (const DroppedRecord& r : sheet.run.journal.dropped) {
    if (r.stamp.node != node || ++count > kMostMarks) continue;
    sheet.open_mark(seconds(r.stamp), rail, "trouble");
    sheet.plot.title(clock_text(seconds(r.stamp)) + " " + r.slot + " from " + r.origin +
                     " dropped: " + r.field + " " + r.why);
    sheet.plot.leaf("path", {{"d", "M0 -4L4 0L0 4L-4 0Z"}}).close();
  }
}

std::vector<const TaskBar*> bars_of(const Chronology& story, std::size_t uav) {
  std::vector<const TaskBar*> bars;
  for (const TaskBar& bar : story.tasks) {
    if (bar.uav == uav) bars.push_back(&bar);
  }
  return bars;
}

std::size_t lane_count(const std::vector<PlacedBar>& placed) {
  std::size_t lanes = 1;
  for (const PlacedBar& p : placed) lanes = std::max(lanes, p.lane + 1);
  return lanes;
}

void draw_uav(Sheet& sheet, std::size_t index, const std::vector<PlacedBar>& placed,
              bool with_scheduled) {
  const UavStory& uav = sheet.run.story.uavs[index];
  const bool planned = sheet.run.plans.promises.lower_bound({uav.name, 0}) !=
                       sheet.run.plans.promises.upper_bound({uav.name, UINT64_MAX});
  const double promise = planned ? 4.0 : 0.0;  // room for the band under each bar
  const double lane = (with_scheduled ? 15.0 : 13.0) + promise;
  const double height = kRail + lane * static_cast<double>(lane_count(placed)) + 5;
  sheet.labels.leaf("rect", {{"class", "swatch " + colour_class(index)},
                             {"y", sheet.y + 2},
                             {"width", 4},
                             {"height", height - 7}});
  sheet.labels.element("text", {{"class", "row"}, {"x", 10}, {"y", sheet.y + 12}},
                       shortened(uav.name, 15));
  std::string under = shortened(uav.model, 12);
  if (uav.degree) under += (under.empty() ? "" : " · ") + ("degree " + std::to_string(*uav.degree));
  sheet.labels.element("text", {{"class", "under"}, {"x", 10}, {"y", sheet.y + 25}},
                       shortened(under, 24));
  draw_rail(sheet, uav.name);
  const double rail = sheet.rails[uav.name];
  for (const PlacedBar& p : placed) {
    const double top = sheet.y + kRail + lane * static_cast<double>(p.lane) + 1;
    draw_bar(sheet, *p.bar, top, lane - 3 - promise, with_scheduled);
  }
  draw_degrees(sheet, uav, rail);
  draw_processes(sheet, rail, &uav.name);
  draw_troubles(sheet, rail, uav.name);
  sheet.y += height;
  sheet.labels.leaf("line", {{"class", "divider"},
                             {"x1", 0},
                             {"x2", Sheet::kRight},
                             {"y1", sheet.y - 1},
                             {"y2", sheet.y - 1}});
}

void draw_request(Sheet& sheet, double t, double y, const std::string& style,
                  const std::string& title, bool refused) {
  sheet.open_mark(t, y, style);
  sheet.plot.title(clock_text(t) + " " + title);
  sheet.plot.leaf("path", {{"d", refused ? "M-3 -3L3 3M-3 3L3 -3" : "M-2.6 -4H2.6L0 3Z"}}).close();
}

std::string uav_style(const Sheet& sheet, const std::string& uav, bool refused) {
  if (refused) return "request refused";
  const std::optional<std::size_t> index = sheet.run.story.uav_index(uav);
  return index ? "request " + colour_class(*index) : "request";
}

}  // namespace

std::string bar_label(const TaskBar& bar) {
  const std::string name = bar.componel.empty() ? std::to_string(bar.id) : bar.componel;
  return name + " " + shortened(bar.type, 22);
}

std::vector<PlacedBar> pack(const std::vector<const TaskBar*>& bars, const Axis& x,
                            bool active_only) {
  constexpr double kGap = 5.0;
  std::vector<PlacedBar> placed;
  std::vector<std::vector<Span>> lanes;
  for (const TaskBar* bar : bars) {
    Span room = active_only ? bar->active().value_or(Span{bar->span.to, bar->span.to}) : bar->span;
    room = {x(room.from), x(room.to)};
    const LabelPlace place = label_place(*bar, x);
    if (place == LabelPlace::kAfter) room.to += label_width(*bar);
    if (place == LabelPlace::kBefore) {
      const double from = x(bar->active().value_or(Span{bar->span.to, bar->span.to}).from);
      room.from = std::min(room.from, from - label_width(*bar));
    }
    std::size_t lane = 0;
    const auto touches = [&](const Span& s) {
      return s.from < room.to + kGap && room.from < s.to + kGap;
    };
    while (lane < lanes.size() && std::any_of(lanes[lane].begin(), lanes[lane].end(), touches)) {
      ++lane;
    }
    if (lane == lanes.size()) lanes.emplace_back();
    lanes[lane].push_back(room);
    placed.push_back({bar, lane});
  }
  return placed;
}

void draw_ground_row(Sheet& sheet) {
  const double rail_middle = sheet.y + kRail / 2;
  sheet.labels.element("text", {{"class", "row"}, {"x", 10}, {"y", sheet.y + 12}}, "ground");
  sheet.labels.element("text", {{"class", "under"}, {"x", 10}, {"y", sheet.y + 25}},
                       "requests, commands");
  draw_rail(sheet, "ground");
  const double y = sheet.y + kRail + 7;
  std::size_t count = 0;
  for (const RequestRecord& r : sheet.run.journal.requests) {
    if (++count > kMostMarks) break;
    const std::string task = r.task ? " " + std::to_string(*r.task) : "";
    draw_request(sheet, seconds(r.stamp), y, uav_style(sheet, r.uav, !r.accepted),
                 r.uav + ": " + r.request + task + " " + r.mode +
                     (r.accepted ? " accepted" : " refused: " + r.why),
                 !r.accepted);
  }
  for (const CommandRecord& r : sheet.run.journal.commands) {
    const bool shown =
        r.state != CommandState::kAcknowledged && r.state != CommandState::kDelivered;
    if (!shown || ++count > kMostMarks) continue;
    const bool bad = r.state != CommandState::kIssued;
    draw_request(sheet, seconds(r.stamp), y, uav_style(sheet, r.uav, bad),
                 r.uav + ": command " + std::to_string(r.command) + " " + r.what + " " + r.why,
                 bad);
  }
  draw_processes(sheet, rail_middle, nullptr);
  draw_troubles(sheet, rail_middle, "ground");
  sheet.y += kRail + 18;
  sheet.labels.leaf("line", {{"class", "divider"},
                             {"x1", 0},
                             {"x2", Sheet::kRight},
                             {"y1", sheet.y - 1},
                             {"y2", sheet.y - 1}});
}

void draw_uav_rows(Sheet& sheet) {
  const Chronology& story = sheet.run.story;
  std::vector<std::vector<PlacedBar>> groups;
  std::size_t lanes = 0;
  for (std::size_t i = 0; i < story.uavs.size(); ++i) {
    groups.push_back(pack(bars_of(story, i), sheet.x, false));
    lanes += lane_count(groups.back());
  }
  const bool with_scheduled = lanes <= kManyLanes;
  for (std::size_t i = 0; i < story.uavs.size(); ++i) {
    if (!with_scheduled) groups[i] = pack(bars_of(story, i), sheet.x, true);
    draw_uav(sheet, i, groups[i], with_scheduled);
  }
}

}  // namespace skein::report
