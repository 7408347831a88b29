// SPDX-License-Identifier: Apache-2.0
#include "airspace.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>

#include "skein/world/polygon_check.hpp"

namespace skein::import_tool {
namespace {

using mission_files::Area;
using mission_files::Circle;
using mission_files::Contents;
using mission_files::Fence;
using mission_files::LatLon;
using world::Polygon;
using world::Vector2;
using world::Volume;

constexpr int kCircleCorners = 32;
/// So that whatever flies can be held against all of it.
constexpr std::size_t kMostClosed = 500;
/// Of all areas together: scenarios have no more room.
constexpr std::size_t kMostCornersInAll = 200'000;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

double signed_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

class Reader {
 public:
  Reader(const Site& site, const Sides& sides, Names& names, Log& log)
      : site_(site), sides_(sides), names_(names), log_(log) {}

  void close_names(const std::vector<std::string>& closed) {
    closed_names_ = {"closed air", "closed-air", "no-fly",   "no fly",    "no-fly zone",
                     "fence",      "fences",     "geofence", "geofences", "exclusion"};
    for (const std::string& name : closed) closed_names_.insert(lower(name));
  }

  void area(const Area& area) {
    corners_ += area.ring.size();
    if (corners_ > kMostCornersInAll) {
      if (corners_ - area.ring.size() <= kMostCornersInAll)
        log_.wrong(area.mark, "more than " + std::to_string(kMostCornersInAll) + " corners");
      return;
    }
    const Polygon polygon = ring(area.ring);
    if (!is_simple(polygon, area.mark)) return;
    if (!is_closed(area)) {
      made_.zones.push_back({names_.make(area.name, "zone"), polygon});
      return;
    }
    if (!has_room(area.mark)) return;
    Volume volume;
    volume.name = names_.make(area.name, "closed");
    volume.polygon = polygon;
    if (area.top && !close_below(*area.top, area, volume)) return;
    made_.closed.push_back(std::move(volume));
  }

  void fences(const std::vector<Fence>& fences) {
    const auto inclusions = std::count_if(fences.begin(), fences.end(),
                                          [](const Fence& fence) { return fence.inclusion; });
    for (const Fence& fence : fences) {
      if (fence.inclusion && inclusions > 1)
        log_.leave_out(fence.mark,
                       "one of several areas to stay in: autopilots differ in whether "
                       "one must be kept or all");
      else
        take(fence);
    }
  }

  Airspace result() { return std::move(made_); }

 private:
  Polygon ring(const std::vector<LatLon>& corners) const {
    Polygon polygon;
    for (const LatLon& corner : corners) polygon.push_back(site_.on_ground(corner));
    return polygon;
  }

  bool is_simple(const Polygon& polygon, const mission_files::Mark& mark) {
    const auto problem = world::problem_of(polygon);
    if (problem) log_.wrong(mark, *problem, "a simple polygon");
    return !problem;
  }

  bool has_room(const mission_files::Mark& mark) {
    if (made_.closed.size() == kMostClosed && !full_)
      log_.wrong(mark, "more than " + std::to_string(kMostClosed) + " pieces of closed air");
    full_ = made_.closed.size() >= kMostClosed;
    return !full_;
  }

  bool is_closed(const Area& area) const {
    const auto counts = [&](const std::string& name) {
      return closed_names_.contains(lower(name));
    };
    return counts(area.name) || std::any_of(area.folders.begin(), area.folders.end(), counts);
  }

  /// Up to that height over its highest ground.
  bool close_below(const mission_files::Height& top, const Area& area, Volume& volume) {
    double ceiling = -1e9;
    for (const LatLon& corner : area.ring) {
      const auto at = site_.at(corner, top);
      if (!at) {
        log_.wrong(area.mark, "its height counts from sea level",
                   "--geoid METRES, how high the sea is over the ellipsoid there");
        return false;
      }
      ceiling = std::max(ceiling, at->z());
    }
    if (top.over == mission_files::HeightOver::kGround)
      ceiling = std::max(ceiling, highest_ground(volume.polygon) + top.metres);
    volume.ceiling = ceiling;
    return true;
  }

  double highest_ground(const Polygon& polygon) const {
    const world::TerrainSpec& spec = site_.terrain().spec();
    const world::TerrainCorners corners = world::corners_of(spec);
    const Sides around = sides_of(polygon);
    const auto index = [&](double at, double begin, std::size_t count) {
      return static_cast<std::size_t>(
          std::clamp((at - begin) / spec.cell, 0.0, static_cast<double>(count)));
    };
    double highest = -1e9;
    for (std::size_t row = index(around.south, spec.south, corners.rows);
         row < index(around.north + spec.cell, spec.south, corners.rows); ++row)
      for (std::size_t column = index(around.west, spec.west, corners.columns);
           column < index(around.east + spec.cell, spec.west, corners.columns); ++column)
        if (world::contains(polygon, {spec.west + static_cast<double>(column) * spec.cell,
                                      spec.south + static_cast<double>(row) * spec.cell}))
          highest = std::max(highest, site_.terrain().corner(column, row));
    return highest;
  }

  void take(const Fence& fence) {
    const auto* circle = std::get_if<Circle>(&fence.shape);
    const Polygon polygon = circle != nullptr ? circle_polygon(site_.on_ground(circle->centre),
                                                               circle->radius, !fence.inclusion)
                                              : ring(std::get<std::vector<LatLon>>(fence.shape));
    if (!is_simple(polygon, fence.mark) || !has_room(fence.mark)) return;
    if (!fence.inclusion) return close(names_.make("fence", "fence"), polygon);
    const std::string name = names_.make("outside", "outside");
    const auto parts = outside_of(polygon, sides_);
    close(names_.make(name + "-south", name), parts[0]);
    close(names_.make(name + "-north", name), parts[1]);
  }

  void close(const std::string& name, const Polygon& polygon) {
    Volume volume;
    volume.name = name;
    volume.polygon = polygon;
    made_.closed.push_back(std::move(volume));
  }

  const Site& site_;
  const Sides& sides_;
  Names& names_;
  Log& log_;
  std::set<std::string> closed_names_;
  Airspace made_;
  std::size_t corners_ = 0;
  bool full_ = false;
};

}  // namespace

Polygon circle_polygon(const Vector2& centre, double radius, bool around) {
  const double half = std::numbers::pi / kCircleCorners;
  const double to_corner = around ? radius / std::cos(half) : radius;
  Polygon polygon;
  for (int i = 0; i < kCircleCorners; ++i)
    polygon.emplace_back(centre.x() + to_corner * std::cos(2 * half * i),
                         centre.y() + to_corner * std::sin(2 * half * i));
  return polygon;
}

std::vector<Polygon> outside_of(Polygon polygon, const Sides& sides) {
  if (signed_area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  const auto by_x = [](const Vector2& a, const Vector2& b) { return a.x() < b.x(); };
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), by_x),
              polygon.end());
  const auto east_end = std::max_element(polygon.begin(), polygon.end(), by_x);
  // Counter-clockwise from its western end: below it to the eastern end, and back above it.
  // Straight lines from both ends to the sides part the rest in two.
  const Vector2 west_end = polygon.front();
  Polygon south{{sides.west, sides.south}, {sides.east, sides.south}, {sides.east, east_end->y()}};
  south.insert(south.end(), std::make_reverse_iterator(std::next(east_end)), polygon.rend());
  south.emplace_back(sides.west, west_end.y());
  Polygon north{
      {sides.east, sides.north}, {sides.west, sides.north}, {sides.west, west_end.y()}, west_end};
  north.insert(north.end(), polygon.rbegin(), std::make_reverse_iterator(east_end));
  north.emplace_back(sides.east, east_end->y());
  return {south, north};
}

Airspace airspace_of(const Contents& contents, const std::vector<std::string>& closed,
                     const Site& site, const Sides& sides, Names& names, Log& log) {
  Reader reader(site, sides, names, log);
  reader.close_names(closed);
  for (const Area& area : contents.areas) reader.area(area);
  reader.fences(contents.fences);
  return reader.result();
}

}  // namespace skein::import_tool
