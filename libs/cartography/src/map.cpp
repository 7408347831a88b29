// SPDX-License-Identifier: Apache-2.0
#include "skein/cartography/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing.hpp"
#include "palette.hpp"

namespace skein::cartography {
namespace {

using world::Vector2;
using world::Vector3;

/// Between two arrows on a way, and on a thin one [px].
constexpr double kArrowEvery = 90, kRareArrowEvery = 240;
constexpr const char* kClosedColour = "#b3202c";

template <class Points>
std::vector<Spot> spots_of(const Points& points, const Scale& scale) {
  std::vector<Spot> spots;
  for (const auto& at : points) spots.push_back(scale(at));
  return spots;
}

std::string arrow(const Spot& at, double angle, const std::string& colour) {
  return fmt::format(
      R"svg(<path d="M-5,-4L5,0L-5,4L-2.5,0Z" fill="{}" stroke="#ffffff" stroke-width="0.7" transform="translate({} {}) rotate({})"/>)svg"
      "\n",
      colour, px(at.x), px(at.y), px(angle * 180 / std::numbers::pi));
}

/// Arrows at even distances along a way.
std::string arrows(const std::vector<Spot>& spots, const std::string& colour, double every) {
  std::string out;
  double next = every / 2, flown = 0;
  for (std::size_t i = 1; i < spots.size(); ++i) {
    const double dx = spots[i].x - spots[i - 1].x, dy = spots[i].y - spots[i - 1].y;
    const double length = std::hypot(dx, dy);
    for (; length > 0 && next <= flown + length; next += every) {
      const double part = (next - flown) / length;
      out += arrow({spots[i - 1].x + part * dx, spots[i - 1].y + part * dy}, std::atan2(dy, dx),
                   colour);
    }
    flown += length;
  }
  return out;
}

std::string level(double z) { return std::isfinite(z) ? fmt::format("{:.0f}", z) : "…"; }

std::string words_of(const world::Volume& volume) {
  std::string words = volume.name;
  if (std::isfinite(volume.floor) || std::isfinite(volume.ceiling))
    words += " " + level(volume.floor) + "–" + level(volume.ceiling) + " m";
  if (volume.when.from > MissionTime() || volume.when.until < MissionTime::max()) {
    words += fmt::format(" from {:.0f} s", volume.when.from.to_seconds());
    if (volume.when.until < MissionTime::max())
      words += fmt::format(" to {:.0f} s", volume.when.until.to_seconds());
  }
  return words;
}

bool shows(const Frame& frame, const Vector2& at) {
  return at.x() >= frame.west && at.x() <= frame.east && at.y() >= frame.south &&
         at.y() <= frame.north;
}

Vector2 middle_of(const world::Polygon& polygon) {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& corner : polygon) sum += corner;
  return polygon.empty() ? sum : Vector2(sum / static_cast<double>(polygon.size()));
}

}  // namespace

void FrameBuilder::add(const Vector2& point) {
  if (!point.allFinite()) return;
  if (empty_) box_ = {point.x(), point.y(), point.x(), point.y()};
  empty_ = false;
  box_.west = std::min(box_.west, point.x());
  box_.east = std::max(box_.east, point.x());
  box_.south = std::min(box_.south, point.y());
  box_.north = std::max(box_.north, point.y());
}

Frame FrameBuilder::frame(const world::Terrain& terrain) const {
  const world::TerrainSpec& spec = terrain.spec();
  const Frame whole{spec.west, spec.south, spec.east, spec.north};
  if (empty_) return whole;
  const double width = box_.east - box_.west, depth = box_.north - box_.south;
  const double room = 0.12 * std::max({width, depth, 100.0});
  const double wide = std::max({width + 2 * room, depth / 2, 100.0});
  const double deep = std::max({depth + 2 * room, wide / 3, 100.0});
  const double x = (box_.west + box_.east) / 2, y = (box_.south + box_.north) / 2;
  const Frame close{x - wide / 2, y - deep / 2, x + wide / 2, y + deep / 2};
  const bool inside = box_.west >= whole.west && box_.east <= whole.east &&
                      box_.south >= whole.south && box_.north <= whole.north;
  const bool near =
      (whole.east - whole.west) < 1.7 * wide && (whole.north - whole.south) < 1.7 * deep;
  return inside && near ? whole : close;
}

Map::Map(const world::World& world, const Frame& frame)
    : drawing_(std::make_unique<Drawing>(world, frame)) {
  Drawing& d = *drawing_;
  d.layers += fmt::format(R"(<image width="{}" height="{}" preserveAspectRatio="none" href="{}"/>)"
                          "\n",
                          px(d.scale.width()), px(d.scale.height()),
                          png_uri(hill_shade(world.terrain, d.scale, d.relief)));
  d.layers += contours(world.terrain, d.scale, d.relief);
}

Map::~Map() = default;

void Map::heat(const world::Grid& grid, const std::vector<double>& values, const HeatScale& scale) {
  Pixels pixels(grid.columns, grid.rows);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    pixels.set(i % grid.columns, grid.rows - 1 - i / grid.columns,
               heat_tint((values[i] - scale.low) / (scale.high - scale.low)));
  }
  const double depth = static_cast<double>(grid.rows) * grid.cell;
  const Spot corner = drawing_->scale(Vector2(grid.west, grid.south + depth));
  drawing_->layers += fmt::format(
      R"(<image x="{}" y="{}" width="{}" height="{}" opacity="{:.2f}" preserveAspectRatio="none" image-rendering="optimizeSpeed" style="image-rendering:pixelated" href="{}"/>)"
      "\n",
      px(corner.x), px(corner.y),
      px(drawing_->scale.pixels(static_cast<double>(grid.columns) * grid.cell)),
      px(drawing_->scale.pixels(depth)), scale.opacity, png_uri(pixels));
  drawing_->heats.push_back(scale);
}

void Map::area(const world::Polygon& polygon, const AreaStyle& style) {
  drawing_->layers += fmt::format(
      R"(<polygon points="{}" fill="{}" fill-opacity="{:.2f}" stroke="{}" stroke-width="1.4"{}/>)"
      "\n",
      points(spots_of(polygon, drawing_->scale)), style.colour, style.opacity, style.colour,
      style.dashed ? R"( stroke-dasharray="6 4")" : "");
  if (!style.label.empty() && shows(drawing_->scale.frame(), middle_of(polygon)))
    drawing_->labels.push_back(
        {drawing_->scale(middle_of(polygon)), style.label, "#404040", false});
}

void Map::closed(const std::vector<world::Volume>& volumes) {
  for (const world::Volume& volume : volumes) {
    drawing_->layers += fmt::format(
        R"svg(<polygon points="{}" fill="url(#closed)" stroke="{}" stroke-width="1.3"/>)svg"
        "\n",
        points(spots_of(volume.polygon, drawing_->scale)), kClosedColour);
    if (shows(drawing_->scale.frame(), middle_of(volume.polygon)))
      drawing_->labels.push_back(
          {drawing_->scale(middle_of(volume.polygon)), words_of(volume), kClosedColour, false});
    drawing_->closed.push_back(volume);
  }
}

void Map::strip(const Vector2& from, const Vector2& to, double swath, const std::string& colour) {
  const Spot a = drawing_->scale(from), b = drawing_->scale(to);
  drawing_->layers +=
      fmt::format(R"(<path d="M{} {}L{} {}" stroke="{}" stroke-opacity="0.16" stroke-width="{}"/>)"
                  "\n",
                  px(a.x), px(a.y), px(b.x), px(b.y), colour, px(drawing_->scale.pixels(swath)));
}

void Map::way(const refiners::Way& way, const std::string& colour, double width) {
  const std::vector<Spot> spots = spots_of(way, drawing_->scale);
  const std::string line = points(spots);
  const auto drawn = [&](const std::string& paint, double wide, double opacity) {
    return fmt::format(
        R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="{}" stroke-opacity="{}" stroke-linejoin="round" stroke-linecap="round"/>)"
        "\n",
        line, paint, px(wide), px(opacity));
  };
  drawing_->layers += drawn("#ffffff", width + 2, 0.7) + drawn(colour, width, 1);
  drawing_->layers += arrows(spots, colour, width < 1.5 ? kRareArrowEvery : kArrowEvery);
}

void Map::cone(const Vector3& from, const Vector3& to, double aperture, const std::string& colour) {
  const Spot a = drawing_->scale(from), b = drawing_->scale(to);
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double wide = std::tan(std::min(aperture, 1.4));
  const std::vector<Spot> corners = {
      a, {b.x - wide * dy, b.y + wide * dx}, {b.x + wide * dy, b.y - wide * dx}};
  drawing_->layers += fmt::format(
      R"(<polygon points="{}" fill="{}" fill-opacity="0.18" stroke="{}" stroke-opacity="0.6" stroke-width="0.8"/>)"
      R"(<path d="M{} {}L{} {}" stroke="{}" stroke-width="1" stroke-dasharray="3 3"/>)"
      "\n",
      points(corners), colour, colour, px(a.x), px(a.y), px(b.x), px(b.y), colour);
}

void Map::link(const Vector3& a, const Vector3& b, const std::string& colour,
               const std::string& label) {
  const Spot from = drawing_->scale(a), to = drawing_->scale(b);
  drawing_->layers += fmt::format(
      R"(<path d="M{} {}L{} {}" stroke="#ffffff" stroke-width="4" stroke-opacity="0.6"/>)"
      R"(<path d="M{} {}L{} {}" stroke="{}" stroke-width="1.8" stroke-dasharray="8 4"/>)"
      "\n",
      px(from.x), px(from.y), px(to.x), px(to.y), px(from.x), px(from.y), px(to.x), px(to.y),
      colour);
  if (!label.empty())
    drawing_->labels.push_back(
        {{(from.x + to.x) / 2, (from.y + to.y) / 2}, label, "#202020", false});
}

void Map::marker(const Vector2& at, const std::string& colour, const std::string& label) {
  const Spot spot = drawing_->scale(at);
  drawing_->layers +=
      fmt::format(R"(<circle cx="{}" cy="{}" r="4" fill="{}" stroke="#ffffff" stroke-width="1.3"/>)"
                  "\n",
                  px(spot.x), px(spot.y), colour);
  if (!label.empty()) drawing_->labels.push_back({spot, label});
}

void Map::profile(const refiners::Way& way, const std::string& colour) {
  if (way.size() > 1) drawing_->profiles.push_back(profile_of(*drawing_, way, colour));
}

void Map::legend(const std::string& colour, const std::string& words) {
  drawing_->legend.push_back({colour, words});
}

}  // namespace skein::cartography
