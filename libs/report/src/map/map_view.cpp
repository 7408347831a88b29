// SPDX-License-Identifier: Apache-2.0
// The map: ground, zones, trajectories; the marks on it are in map_marks.cpp.
#include <algorithm>
#include <cmath>

#include "map/map_marks.hpp"
#include "map/relief.hpp"
#include "page/views.hpp"

namespace skein::report {

namespace {

constexpr double kImageScale = 0.8;  // relief pixels per map pixel
constexpr std::size_t kMostPointsInAll = 60'000;
constexpr std::size_t kMostPointsOfOne = 4'000;

void write_ground(Markup& out, const Run& run, const MapFrame& f) {
  out.leaf("rect", {{"class", "ground"}, {"width", f.width}, {"height", f.height}});
  if (!run.info.terrain || !is_usable(*run.info.terrain)) return;
  const drawing::Pixels image =
      shaded_relief(*run.info.terrain, f.view, static_cast<std::size_t>(f.width * kImageScale),
                    static_cast<std::size_t>(f.height * kImageScale));
  out.leaf("image", {{"class", "relief"},
                     {"width", f.width},
                     {"height", f.height},
                     {"preserveAspectRatio", "none"},
                     {"href", png_uri(image)}});
  for (const Contour& contour : contours(*run.info.terrain)) {
    std::string data;
    for (const auto& [a, b] : contour.segments) {
      data += path_data(std::vector<Point>{f(a.x, a.y), f(b.x, b.y)});
    }
    out.open("path", {{"class", "contour"}, {"d", data}});
    out.title(short_number(contour.height, 1) + " m").close();
  }
}

void write_grid(Markup& out, const MapFrame& f) {
  const double step = round_step(110.0 / f.scale);
  for (const double x : ticks(f.view.west, f.view.east, step)) {
    const double px = f(x, 0).x;
    out.leaf("line", {{"class", "graticule"}, {"x1", px}, {"x2", px}, {"y2", f.height}});
    if (px < 60 || px > f.width - 90) continue;
    out.element("text", {{"class", "graticule"}, {"x", px + 3}, {"y", f.height - 5}},
                short_number(x, 0));
  }
  for (const double y : ticks(f.view.south, f.view.north, step)) {
    const double py = f(0, y).y;
    out.leaf("line", {{"class", "graticule"}, {"y1", py}, {"y2", py}, {"x2", f.width}});
    if (py < 24 || py > f.height - 40) continue;
    out.element("text", {{"class", "graticule"}, {"x", 4}, {"y", py - 3}}, short_number(y, 0));
  }
}

void write_zones(Markup& out, const Run& run, const MapFrame& f) {
  for (const Zone& zone : run.info.zones) {
    std::vector<Point> points;
    for (const GroundPoint& p : zone.polygon) points.push_back(f(p.x, p.y));
    if (points.size() < 3) continue;
    out.open("path", {{"class", "zone"}, {"d", path_data(points) + "Z"}});
    out.title("zone " + zone.name).close();
    const Point corner = *std::min_element(points.begin(), points.end(),
                                           [](Point a, Point b) { return a.x + a.y < b.x + b.y; });
    out.element("text", {{"class", "zone-name"}, {"x", corner.x + 7}, {"y", corner.y + 17}},
                shortened(zone.name, 24));
  }
}

// The pieces of a track that are all in the air or all on the ground; of what keeps to the ground,
// all of it.
void write_track(Markup& out, const UavStory& uav, std::size_t index, std::size_t most,
                 const MapFrame& f) {
  const std::string dash = index >= kUavColours ? " dashed" : "";
  out.open("g", {{"class", "track " + colour_class(index) + dash}});
  out.title(uav.name);
  std::vector<Point> piece;
  const bool drives = uav.keeps_to_ground();
  const auto flush = [&](bool airborne) {
    const bool on_its_way = airborne || drives;
    if (piece.size() > 1) {
      const std::string data = path_data(simplified(piece, 0.35, most));
      if (on_its_way) out.leaf("path", {{"class", "halo"}, {"d", data}});
      out.leaf("path", {{"class", on_its_way ? "air" : "land"}, {"d", data}});
    }
    piece.clear();
  };
  for (std::size_t i = 0; i < uav.track.size(); ++i) {
    const TrackPoint& p = uav.track[i];
    piece.push_back(f(p.position));
    if (i + 1 < uav.track.size() && uav.track[i + 1].airborne != p.airborne) {
      flush(p.airborne);
      piece.push_back(f(p.position));
    }
  }
  if (!uav.track.empty()) flush(uav.track.back().airborne);
  out.close().line_break();
}

void write_scale_and_north(Markup& out, const MapFrame& f) {
  const double metres = round_step(60.0 / f.scale);
  const double length = metres * f.scale, x = f.width - length - 16, y = f.height - 16;
  out.open("g", {{"class", "furniture"}});
  out.leaf("rect", {{"class", "plate"},
                    {"x", x - 9},
                    {"y", y - 19},
                    {"width", length + 18},
                    {"height", 28},
                    {"rx", 4}});
  out.leaf("path", {{"d", path_data(std::vector<Point>{
                              {x, y - 5}, {x, y}, {x + length, y}, {x + length, y - 5}})}});
  out.element("text", {{"x", x + length / 2}, {"y", y - 6}, {"text-anchor", "middle"}},
              metres >= 1000 ? short_number(metres / 1000) + " km" : short_number(metres) + " m");
  const double nx = f.width - 25;
  out.leaf("circle", {{"class", "plate"}, {"cx", nx}, {"cy", 27}, {"r", 17}});
  out.leaf(
      "path",
      {{"class", "needle"},
       {"d",
        path_data(std::vector<Point>{{nx, 12}, {nx + 5.5, 30}, {nx, 26}, {nx - 5.5, 30}}) + "Z"}});
  out.element("text", {{"x", nx}, {"y", 41}, {"text-anchor", "middle"}}, "N");
  out.close();
}

void write_live_markers(Markup& out, const Run& run, const MapFrame& f) {
  for (std::size_t i = 0; i < run.story.uavs.size(); ++i) {
    const UavStory& uav = run.story.uavs[i];
    if (uav.track.empty()) continue;
    const Point p = f(uav.track.back().position);
    const std::string place = "translate(" + short_number(p.x) + " " + short_number(p.y) + ")";
    out.open("g", {{"class", "live " + colour_class(i)}, {"data-uav", i}, {"transform", place}});
    out.leaf("circle", {{"r", 7}}).leaf("path", {{"d", "M11 0L3 -4.5V4.5Z"}}).close();
  }
}

}  // namespace

std::string colour_class(std::size_t uav) { return "u" + std::to_string(uav % kUavColours); }

void write_map(Markup& out, const Run& run, const MapFrame& f) {
  out.open("svg", {{"id", "map"},
                   {"viewBox", "0 0 " + short_number(f.width) + " " + short_number(f.height)},
                   {"role", "img"},
                   {"aria-label", "Map of the trajectories"}});
  write_ground(out, run, f);
  write_grid(out, f);
  write_zones(out, run, f);
  const std::size_t most = std::clamp<std::size_t>(
      kMostPointsInAll / std::max<std::size_t>(run.story.uavs.size(), 1), 50, kMostPointsOfOne);
  write_air_map(out, run, f);
  write_planned_ways(out, run, f);
  for (std::size_t i = 0; i < run.story.uavs.size(); ++i) {
    write_track(out, run.story.uavs[i], i, most, f);
  }
  write_joint_map(out, run, f);
  write_map_marks(out, run, f);
  write_scale_and_north(out, f);
  write_live_markers(out, run, f);
  out.leaf("rect", {{"class", "frame"}, {"width", f.width}, {"height", f.height}});
  out.close().line_break();
}

}  // namespace skein::report
