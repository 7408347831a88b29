// SPDX-License-Identifier: Apache-2.0
#include "skein/world/environment_reader.hpp"

#include <limits>
#include <numbers>
#include <optional>

#include "skein/world/polygon_rings.hpp"

namespace skein::world {

using config::Reader;

namespace {

/// A list of exactly `Count` coordinates; nothing when it is not, which has been reported.
template <int Count>
std::optional<Eigen::Matrix<double, Count, 1>> coordinates(const Reader& reader) {
  if (!reader.present()) return std::nullopt;
  const std::string expected = Count == 2 ? "[x, y] in metres" : "[x, y, z] in metres";
  const auto items = reader.is_sequence() ? reader.items() : std::vector<Reader>();
  if (items.size() != Count) {
    reader.error("this is not a point", expected);
    return std::nullopt;
  }
  Eigen::Matrix<double, Count, 1> point;
  for (int i = 0; i < Count; ++i) {
    const Reader& item = items[static_cast<std::size_t>(i)];
    if (!item.present()) item.error("nothing in a point", expected);
    point[i] = item.number(std::numeric_limits<double>::quiet_NaN(), kCoordinate);
  }
  if (!point.allFinite()) return std::nullopt;
  return point;
}

}  // namespace

GeodeticPoint read_geodetic(const Reader& reader) {
  if (!reader.keys({"latitude", "longitude", "altitude"})) return {};
  return {reader.required("latitude").number(0, {-90, 90, "degrees"}),
          reader.required("longitude").number(0, {-180, 180, "degrees"}),
          reader.required("altitude").number(0, {-1000, 100'000, "m"})};
}

std::vector<HillSpec> read_hills(const Reader& reader) {
  std::vector<HillSpec> hills;
  for (const Reader& hill : items_of(reader)) {
    if (!hill.keys({"at", "height", "radius"})) continue;
    hills.push_back({read_point_2d(hill.required("at")),
                     hill.required("height").number(0, {-5000, 5000, "m"}),
                     hill.required("radius").number(1, {1, kFarthest, "m"})});
  }
  return hills;
}

TerrainSpec read_terrain(const Reader& reader) {
  TerrainSpec terrain;
  terrain.west = terrain.south = -1000;
  terrain.east = terrain.north = 1000;
  if (!reader.keys({"west", "south", "east", "north", "cell", "base", "hills"})) return terrain;
  terrain.west = reader.required("west").number(-1000, kCoordinate);
  terrain.south = reader.required("south").number(-1000, kCoordinate);
  terrain.east = reader.required("east").number(1000, kCoordinate);
  terrain.north = reader.required("north").number(1000, kCoordinate);
  terrain.cell = reader.optional("cell").number(20, {0.1, 10'000, "m"});
  terrain.base = reader.optional("base").number(0, {-10'000, 10'000, "m"});
  terrain.hills = read_hills(reader.optional("hills"));
  for (const std::string& problem : problems_of(terrain)) reader.error(problem);
  return terrain;
}

Wind read_wind(const Reader& reader) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (!reader.keys({"toward", "speed", "gusts"})) return {};
  return {reader.optional("toward").number(0, {-kTurn, kTurn, "rad"}),
          reader.optional("speed").number(0, {0, 50, "m/s"}),
          reader.optional("gusts").number(0, {0, 20, "m/s"})};
}

std::vector<Zone> read_zones(const Reader& reader) {
  std::vector<Zone> zones;
  for (const auto& [name, zone] : entries_of(reader)) zones.push_back({name, read_polygon(zone)});
  return zones;
}

Vector2 read_point_2d(const Reader& reader) {
  return coordinates<2>(reader).value_or(Vector2::Zero());
}

Vector3 read_point(const Reader& reader) {
  return coordinates<3>(reader).value_or(Vector3::Zero());
}

Polygon read_polygon(const Reader& reader) {
  Polygon polygon;
  bool right = reader.is_sequence();
  for (const Reader& item : reader.items()) {
    if (!item.present()) item.error("nothing in a list", "a corner [x, y]");
    const auto corner = coordinates<2>(item);
    if (corner) polygon.push_back(*corner);
    right = right && corner;
  }
  polygon = without_closing_corner(std::move(polygon));
  if (!right) return polygon;
  if (const auto problem = problem_of(polygon))
    reader.error(*problem, "the corners [x, y] of a simple polygon in order");
  return polygon;
}

MissionTime read_instant(const Reader& reader, MissionTime otherwise) {
  if (!reader.present()) return otherwise;
  return MissionTime::seconds(reader.number(0, {0, 1e7, "s"}));
}

Volume read_volume(const std::string& name, const Reader& reader) {
  constexpr config::Range kLevel{-10'000, 100'000, "m"};
  Volume volume;
  volume.name = name;
  volume.polygon = read_polygon(reader.required("polygon"));
  const Reader floor = reader.optional("floor"), ceiling = reader.optional("ceiling");
  if (floor.present()) volume.floor = floor.number(0, kLevel);
  if (ceiling.present()) volume.ceiling = ceiling.number(0, kLevel);
  volume.when.from = read_instant(reader.optional("from"));
  volume.when.until = read_instant(reader.optional("until"), MissionTime::max());
  if (volume.ceiling <= volume.floor) reader.error("the ceiling is not above the floor");
  if (volume.when.until <= volume.when.from) {
    reader.error("it ends before it begins", "until greater than from");
  }
  return volume;
}

std::vector<Reader> items_of(const Reader& reader) {
  std::vector<Reader> items = reader.items();
  std::erase_if(items, [](const Reader& item) {
    if (!item.present()) item.error("nothing in a list");
    return !item.present();
  });
  return items;
}

std::vector<std::pair<std::string, Reader>> entries_of(const Reader& reader) {
  auto entries = reader.entries();
  std::erase_if(entries, [](const auto& entry) {
    const auto& [name, value] = entry;
    if (name.empty())
      value.error("an empty name");
    else if (!value.present())
      value.error("nothing is said of '" + name + "'");
    return name.empty() || !value.present();
  });
  return entries;
}

}  // namespace skein::world
