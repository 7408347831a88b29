// SPDX-License-Identifier: Apache-2.0
// Altitude, energy and separation over time.
#include <algorithm>
#include <functional>

#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kMostPoints = 1500;
constexpr std::size_t kSeparationSamples = 540;

struct Line {
  std::string style;
  std::vector<std::pair<double, double>> values;  // time, value
  std::string title;
};

struct Panel {
  const char* name;
  const char* unit;
  double height;
  std::function<std::string(double)> text;
};

Axis value_axis(const std::vector<Line>& lines, const Panel& panel, double top) {
  double low = 0.0, high = 0.0;
  for (const Line& line : lines) {
    for (const auto& [t, value] : line.values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (high - low < 1e-9) high = low + 1.0;
  high += (high - low) * 0.06;
  return {low, high, top + panel.height, top};
}

void draw_grid(Sheet& sheet, const Panel& panel, const Axis& y) {
  const double rows = std::max(2.0, panel.height / 32.0);
  for (const double value : ticks(y.from, y.to, round_step((y.to - y.from) / rows))) {
    sheet.plot.leaf("line", {{"class", "grid"},
                             {"x1", Sheet::kLeft},
                             {"x2", Sheet::kRight},
                             {"y1", y(value)},
                             {"y2", y(value)}});
    sheet.gutter(y(value) + 3.5, panel.text(value), "value");
  }
}

void draw_panel(Sheet& sheet, const Panel& panel, const std::vector<Line>& lines,
                std::size_t most) {
  sheet.heading(panel.name);
  sheet.labels.element("text", {{"class", "under"}, {"x", 0}, {"y", sheet.y + 5}}, panel.unit);
  const Axis y = value_axis(lines, panel, sheet.y);
  draw_grid(sheet, panel, y);
  sheet.plot.open("g", {{"class", "stretch"}});
  for (const Line& line : lines) {
    std::vector<Point> points;
    for (const auto& [t, value] : line.values) points.push_back({sheet.x(t), y(value)});
    if (points.size() < 2) continue;
    sheet.plot.open("path",
                    {{"class", line.style}, {"d", path_data(simplified(points, 0.3, most))}});
    sheet.plot.title(line.title).close();
  }
  sheet.plot.close();
  sheet.y += panel.height + 6;
}

std::vector<Line> lines_of(const Chronology& story,
                           const std::function<double(const TrackPoint&)>& value) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < story.uavs.size(); ++i) {
    Line line{
        "profile " + colour_class(i) + (i >= kUavColours ? " dashed" : ""), {}, story.uavs[i].name};
    for (const TrackPoint& p : story.uavs[i].track) line.values.emplace_back(p.t, value(p));
    lines.push_back(std::move(line));
  }
  return lines;
}

// One line per stretch of time with at least two UAVs in the air.
std::vector<Line> separation_lines(const Chronology& story) {
  const double step = (story.time.to - story.time.from) / (kSeparationSamples - 1.0);
  std::vector<Line> lines;
  for (const auto& [t, metres] : separation_series(story, kSeparationSamples)) {
    if (lines.empty() || t - lines.back().values.back().first > 1.5 * step) {
      lines.push_back({"profile separation", {}, "least distance between two UAVs in the air"});
    }
    lines.back().values.emplace_back(t, metres);
  }
  return lines;
}

bool has_tracks(const Chronology& story) {
  return std::any_of(story.uavs.begin(), story.uavs.end(),
                     [](const UavStory& u) { return !u.track.empty(); });
}

}  // namespace

void draw_profiles(Sheet& sheet) {
  const Chronology& story = sheet.run.story;
  if (!has_tracks(story)) return;
  const std::size_t most = std::max<std::size_t>(100, kMostPoints * 6 / (story.uavs.size() + 5));
  const auto whole = [](double v) { return short_number(v); };
  draw_panel(sheet, {"Altitude", "m ENU", 130, whole},
             lines_of(story, [](const TrackPoint& p) { return p.position.z; }), most);
  draw_panel(sheet,
             {"Energy left", "share", 72, [](double v) { return short_number(v * 100, 0) + " %"; }},
             lines_of(story, [](const TrackPoint& p) { return p.energy; }), most);
  const std::vector<Line> separation = separation_lines(story);
  if (separation.empty()) return;
  draw_panel(sheet, {"Separation", "m, closest pair", 72, whole}, separation, most);
}

}  // namespace skein::report
