// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "map/relief.hpp"
#include "markup.hpp"
#include "page/views.hpp"
#include "plot.hpp"
#include "skein/report/figures.hpp"
#include "story/encounters.hpp"

namespace skein::report {

namespace {

constexpr double kFont = 11, kKeyRow = 16, kKeyWidth = 110, kTolerance = 0.4;
constexpr std::size_t kMostPoints = 4000;

struct Map {
  Markup out;
  const Chronology& story;
  MapFrame frame;
  LabelPlacer labels;

  void label(Point at, double radius, const std::string& text, const char* colour) {
    const auto placed = labels.place(at, radius, text, kFont);
    if (!placed) return;
    out.element(
        "text",
        {{"x", placed->x}, {"y", placed->y}, {"text-anchor", placed->anchor}, {"fill", colour}},
        text);
  }
};

void draw_contours(Map& map, const RunInfo& info) {
  if (!info.terrain || !is_usable(*info.terrain)) return;
  for (const Contour& contour : contours(*info.terrain)) {
    std::string data;
    for (const auto& [from, to] : contour.segments)
      data += path_data(std::vector<Point>{map.frame(from.x, from.y), map.frame(to.x, to.y)});
    map.out.leaf("path",
                 {{"d", data}, {"fill", "none"}, {"stroke", "#d9cdb0"}, {"stroke-width", 0.7}});
  }
}

void draw_places(Map& map, const RunInfo& info) {
  for (const Place& place : info.places) {
    const Point at = map.frame(place.position);
    map.out.leaf("path",
                 {{"d", "M" + short_number(at.x - 3) + " " + short_number(at.y) + "h6m-3 -3v6"},
                  {"stroke", "#777"}});
    map.labels.block({at.x - 4, at.y - 4, at.x + 4, at.y + 4});
  }
  for (const Place& place : info.places)
    map.label(map.frame(place.position), 4, place.name, "#777");
}

void draw_tracks(Map& map) {
  for (std::size_t i = 0; i < map.story.uavs.size(); ++i) {
    const UavStory& uav = map.story.uavs[i];
    std::vector<Point> line;
    for (const TrackPoint& point : uav.track) line.push_back(map.frame(point.position));
    if (line.empty()) continue;
    const bool flies = !uav.keeps_to_ground();
    map.out.leaf("path", {{"d", path_data(simplified(line, kTolerance, kMostPoints))},
                          {"fill", "none"},
                          {"stroke", figure_colour(i)},
                          {"stroke-width", flies ? 1.2 : 1.8},
                          {"stroke-dasharray", flies ? "5 3" : "none"}});
    map.out.leaf("rect", {{"x", line.front().x - 3},
                          {"y", line.front().y - 3},
                          {"width", 6},
                          {"height", 6},
                          {"fill", figure_colour(i)}});
  }
}

/// Where each was when it was through with it, in the colours of both.
void draw_encounters(Map& map) {
  for (const Encounter& one : encounters_of(map.story)) {
    const auto a = at(map.story.uavs[one.one].track, one.one_through);
    const auto b = at(map.story.uavs[one.other].track, one.other_through);
    if (!a || !b) continue;
    const Point p = map.frame(a->position), q = map.frame(b->position);
    map.out.leaf(
        "path",
        {{"d", path_data(std::vector<Point>{p, q})}, {"stroke", "#111"}, {"stroke-width", 1.4}});
    for (const auto& [end, row] : {std::pair{p, one.one}, std::pair{q, one.other}})
      map.out.leaf("circle", {{"cx", end.x},
                              {"cy", end.y},
                              {"r", 4.5},
                              {"fill", "#fff"},
                              {"stroke", figure_colour(row)},
                              {"stroke-width", 2}});
    const Point middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    map.label(middle, 6 + std::hypot(p.x - q.x, p.y - q.y) / 2, one.id, "#111");
  }
}

void draw_scale(Map& map) {
  const double metres = round_step(60 / map.frame.scale);
  const double y = map.frame.height - 12, right = map.frame.width - 14;
  const double left = right - metres * map.frame.scale;
  map.out.leaf("path", {{"d", path_data(std::vector<Point>{{left, y}, {right, y}})},
                        {"stroke", "#111"},
                        {"stroke-width", 2}});
  map.out.element("text", {{"x", (left + right) / 2}, {"y", y - 5}, {"text-anchor", "middle"}},
                  length_text(metres));
}

void draw_key(Map& map, double columns) {
  for (std::size_t i = 0; i < map.story.uavs.size(); ++i) {
    const double x = 14 + kKeyWidth * static_cast<double>(i % static_cast<std::size_t>(columns));
    const double y =
        map.frame.height + kKeyRow * (1 + std::floor(static_cast<double>(i) / columns));
    map.out.leaf("path", {{"d", path_data(std::vector<Point>{{x, y - 4}, {x + 18, y - 4}})},
                          {"stroke", figure_colour(i)},
                          {"stroke-width", 3}});
    map.out.element("text", {{"x", x + 23}, {"y", y}}, map.story.uavs[i].name);
  }
}

}  // namespace

std::string trajectories_svg(const RunInfo& info, const Journal& journal) {
  const Chronology story = tell(info, journal);
  const MapFrame frame = frame_map(info, story);
  Map map{{}, story, frame, LabelPlacer({0, 0, frame.width, frame.height})};
  const double columns = std::max(1.0, std::floor((frame.width - 20) / kKeyWidth));
  const double rows = std::ceil(static_cast<double>(story.uavs.size()) / columns);
  const double height = frame.height + kKeyRow * rows + 10;
  map.out.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                       {"xmlns:xlink", "http://www.w3.org/1999/xlink"},
                       {"width", frame.width},
                       {"height", height},
                       {"viewBox", "0 0 " + short_number(frame.width) + " " + short_number(height)},
                       {"font-family", "sans-serif"},
                       {"font-size", kFont}});
  map.out.leaf("rect", {{"width", frame.width}, {"height", height}, {"fill", "#fff"}});
  draw_contours(map, info);
  draw_places(map, info);
  draw_tracks(map);
  draw_encounters(map);
  draw_scale(map);
  draw_key(map, columns);
  map.out.close();
  return map.out.take();
}

}  // namespace skein::report
