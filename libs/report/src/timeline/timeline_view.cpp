// SPDX-License-Identifier: Apache-2.0
// Puts the panels of the time axis together, with what crosses all of them.
#include <algorithm>
#include <array>

#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr double kPhaseHeight = 20.0;
constexpr double kFlagHeight = 14.0;
constexpr double kRulerHeight = 18.0;
constexpr double kFont = 10.5;
constexpr std::size_t kMostFlagRows = 4;
constexpr std::size_t kMostFlags = 400;

// Something that concerns the whole team at one instant.
struct Flag {
  double t = 0.0;
  std::string text;
  const char* style;
};

const char* state_name(AlarmState state) {
  constexpr std::array<const char*, 3> kNames{"raised", "confirmed", "infirmed"};
  return kNames[static_cast<std::size_t>(state)];
}

std::vector<Flag> collect_flags(const Run& run) {
  std::vector<Flag> flags;
  for (const AlarmStory& alarm : run.story.alarms) {
    for (const auto& [t, state] : alarm.steps) {
      flags.push_back(
          {t, "alarm " + std::to_string(alarm.id) + " " + state_name(state), "flag alarm-flag"});
    }
  }
  for (const OperatorRecord& r : run.journal.operators) {
    flags.push_back({seconds(r.stamp), "operator: " + r.does, "flag operator-flag"});
  }
  for (const FaultRecord& r : run.journal.faults) {
    flags.push_back({seconds(r.stamp), r.what + " " + r.target, "flag fault-flag"});
  }
  std::stable_sort(flags.begin(), flags.end(),
                   [](const Flag& a, const Flag& b) { return a.t < b.t; });
  if (flags.size() > kMostFlags) flags.resize(kMostFlags);
  return flags;
}

// The first row where the flag's text has room; the last when none has.
std::size_t flag_row(std::vector<double>& ends, double from, double to) {
  for (std::size_t row = 0; row < kMostFlagRows; ++row) {
    if (row == ends.size()) ends.push_back(0.0);
    if (ends[row] > from) continue;
    ends[row] = to;
    return row;
  }
  return kMostFlagRows;
}

class FlagRows {
 public:
  FlagRows(std::vector<Flag> flags, const Axis& x) : flags_(std::move(flags)) {
    std::vector<double> ends;
    for (const Flag& flag : flags_) {
      const double width = text_width(shortened(flag.text, 40), kFont) + 8;
      // Near the right edge the text stands left of its line.
      const bool left = x(flag.t) + width > x.high;
      const double from = left ? x(flag.t) - width : x(flag.t);
      places_.push_back({flag_row(ends, from, from + width), left});
    }
    rows_ = ends.size();
  }

  double height() const { return static_cast<double>(rows_) * kFlagHeight; }

  void draw(Sheet& sheet, double top, double bottom) const {
    Markup lines, texts;  // no line crosses a text
    for (std::size_t i = 0; i < flags_.size(); ++i) {
      const Flag& flag = flags_[i];
      const auto [row, left] = places_[i];
      const double x = sheet.x(flag.t), y = top + static_cast<double>(row) * kFlagHeight;
      lines.open("g", {{"class", flag.style}});
      lines.title(clock_text(flag.t) + " " + flag.text);
      lines.leaf("line",
                 {{"x1", x}, {"x2", x}, {"y1", std::min(y, top + height())}, {"y2", bottom}});
      lines.close();
      if (row == kMostFlagRows) continue;
      texts.open("g", {{"class", flag.style}});
      texts.element("text",
                    {{"x", x},
                     {"dx", left ? -4 : 4},
                     {"y", y + 10.5},
                     {"text-anchor", left ? "end" : "start"}},
                    shortened(flag.text, 40));
      texts.close();
    }
    sheet.plot.raw(lines.take()).raw(texts.take());
  }

 private:
  struct Place {
    std::size_t row;
    bool left;
  };
  std::vector<Flag> flags_;
  std::vector<Place> places_;
  std::size_t rows_ = 0;
};

// Phases as bands behind everything, their names at the top.
void draw_phases(Sheet& sheet, double bottom) {
  std::size_t index = 0;
  for (const NamedSpan& phase : sheet.run.story.phases) {
    const double from = sheet.x(phase.span.from), to = sheet.x(phase.span.to);
    sheet.plot.open("g", {{"class", index++ % 2 == 0 ? "phase even" : "phase odd"}});
    sheet.plot.title("phase " + phase.name + ", " + clock_text(phase.span.from) + " to " +
                     clock_text(phase.span.to));
    sheet.plot.leaf(
        "rect",
        {{"class", "band"}, {"x", from}, {"width", std::max(to - from, 0.0)}, {"height", bottom}});
    sheet.plot.leaf("rect", {{"class", "tab"},
                             {"x", from},
                             {"width", std::max(to - from, 0.0)},
                             {"height", kPhaseHeight}});
    const bool fits = text_width(phase.name, kFont) + 10 < to - from;
    sheet.plot.element("text",
                       {{"class", fits ? "inside" : "inside off"},
                        {"x", from},
                        {"dx", 5},
                        {"y", 14},
                        {"data-from", from},
                        {"data-to", to},
                        {"data-need", text_width(phase.name, kFont) + 10}},
                       phase.name);
    sheet.plot.close();
  }
}

void draw_ruler(Sheet& sheet, double base_line) {
  const Span& time = sheet.run.story.time;
  for (const double t : ticks(time.from, time.to, round_time_step((time.to - time.from) / 14.0))) {
    if (sheet.x(t) > Sheet::kRight - 10) continue;
    sheet.plot.element("text",
                       {{"class", "tick"},
                        {"x", sheet.x(t)},
                        {"y", base_line},
                        {"text-anchor", sheet.x(t) < Sheet::kLeft + 14 ? "start" : "middle"}},
                       clock_text(t));
  }
}

void draw_ticks(Sheet& sheet, double top, double bottom) {
  const Span& time = sheet.run.story.time;
  for (const double t : ticks(time.from, time.to, round_time_step((time.to - time.from) / 14.0))) {
    const double x = sheet.x(t);
    sheet.plot.leaf("line", {{"class", "tick"}, {"x1", x}, {"x2", x}, {"y1", top}, {"y2", bottom}});
  }
}

void write_definitions(Markup& out, double height) {
  out.open("defs");
  out.open("clipPath", {{"id", "plot-clip"}});
  out.leaf("rect",
           {{"x", Sheet::kLeft}, {"width", Sheet::kRight - Sheet::kLeft + 1}, {"height", height}});
  out.close();
  out.open("pattern", {{"id", "hatch"},
                       {"width", 5},
                       {"height", 5},
                       {"patternUnits", "userSpaceOnUse"},
                       {"patternTransform", "rotate(45)"}});
  out.leaf("rect", {{"width", 2}, {"height", 5}, {"class", "hatch-line"}}).close();
  for (const char* kind : {"sync", "message"}) {
    out.open("marker", {{"id", std::string(kind) + "-head"},
                        {"viewBox", "0 0 8 8"},
                        {"refX", 7.2},
                        {"refY", 4},
                        {"markerWidth", kind == std::string_view("sync") ? 7.5 : 5},
                        {"markerHeight", kind == std::string_view("sync") ? 7.5 : 5},
                        {"markerUnits", "userSpaceOnUse"},
                        {"orient", "auto"}});
    out.leaf("path", {{"d", "M0 .8L8 4L0 7.2Z"}, {"class", std::string(kind) + "-head"}}).close();
  }
  out.close();
}

}  // namespace

void Sheet::heading(std::string_view text) {
  y += 24;
  labels.element("text", {{"class", "panel"}, {"x", 0}, {"y", y - 8}}, text);
}

void Sheet::row_name(double base_line, const std::string& text) {
  labels.element("text", {{"class", "under"}, {"x", 10}, {"y", base_line}}, shortened(text, 22));
}

void Sheet::gutter(double base_line, std::string_view text, std::string_view style) {
  labels.element(
      "text", {{"class", style}, {"x", kLeft - 8}, {"y", base_line}, {"text-anchor", "end"}}, text);
}

void Sheet::bar(const Span& span, double top, double height, std::string_view style) {
  plot.leaf("rect", {{"class", style},
                     {"x", x(span.from)},
                     {"y", top},
                     {"width", std::max(x(span.to) - x(span.from), 0.6)},
                     {"height", height}});
}

void Sheet::open_mark(double t, double height, std::string_view style) {
  plot.open("g", {{"class", "at " + std::string(style)},
                  {"transform",
                   "translate(" + short_number(x(t), 2) + " " + short_number(height, 1) + ")"}});
}

void write_timeline(Markup& out, const Run& run) {
  Sheet sheet(run);
  const FlagRows flags(collect_flags(run), sheet.x);
  const double flags_top = kPhaseHeight + 2;
  const double ruler_top = flags_top + flags.height();
  sheet.y = ruler_top + kRulerHeight;
  draw_ground_row(sheet);
  draw_uav_rows(sheet);
  const double rows_bottom = sheet.y;
  draw_temporal_messages(sheet);
  draw_external_arcs(sheet);
  draw_arrows(sheet);
  draw_joint_rows(sheet);
  draw_team_rows(sheet);
  draw_air_rows(sheet);
  draw_meeting_rows(sheet);
  draw_links(sheet);
  draw_profiles(sheet);
  const double bottom = sheet.y;

  Sheet back(run), front(run);
  draw_phases(back, bottom);
  draw_ticks(back, ruler_top + kRulerHeight - 4, bottom);
  draw_ruler(front, ruler_top + 12);
  draw_ruler(front, bottom + 13);
  flags.draw(front, flags_top, rows_bottom);

  const double height = bottom + kRulerHeight;
  out.open("svg", {{"id", "timeline"},
                   {"class", hides_messages(run.story) ? "no-messages" : ""},
                   {"viewBox", "0 0 " + short_number(Sheet::kWidth) + " " + short_number(height)},
                   {"role", "img"},
                   {"aria-label", "Tasks, links and profiles over mission time"},
                   {"data-left", Sheet::kLeft},
                   {"data-right", Sheet::kRight},
                   {"data-from", run.story.time.from},
                   {"data-to", run.story.time.to},
                   {"data-tick-top", ruler_top + kRulerHeight - 4},
                   {"data-ruler", ruler_top + 12},
                   {"data-bottom", bottom}});
  write_definitions(out, height);
  out.open("g", {{"clip-path", "url(#plot-clip)"}, {"class", "plot"}});
  out.raw(back.plot.take())
      .raw(sheet.under.take())
      .raw(sheet.plot.take())
      .raw(front.plot.take())
      .close();
  out.raw(sheet.labels.take());
  out.leaf("line", {{"id", "cursor"}, {"y1", ruler_top}, {"y2", bottom}, {"x1", -9}, {"x2", -9}});
  out.close().line_break();
}

}  // namespace skein::report
