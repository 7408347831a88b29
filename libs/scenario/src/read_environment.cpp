// SPDX-License-Identifier: Apache-2.0
// The part of a scenario about the world: in the scenario itself, in a file that it includes, or
// some of it here and some of it there.
#include <filesystem>
#include <set>
#include <sstream>

#include "reading.hpp"
#include "skein/config/parse.hpp"
#include "skein/mission/home.hpp"
#include "skein/world/terrain_file.hpp"

namespace skein::scenario {

namespace {

using config::Reader;

std::string beside(const Reader& reader, const std::string& file) {
  return (std::filesystem::path(reader.file()).parent_path() / file).lexically_normal().string();
}

std::optional<world::FireSpread> read_spread(const Reader& reader) {
  if (!reader.present() || !reader.keys({"rate", "gain"})) return std::nullopt;
  world::FireSpread spread;
  spread.rate = reader.required("rate").number(0, {0.0001, 10, "m/s"});
  spread.gain = reader.optional("gain").number(0, {0, 100, "s/m"});
  return spread;
}

world::WorldObject read_object(const std::string& name, const Reader& reader) {
  world::WorldObject object;
  object.name = name;
  reader.keys({"kind", "position", "height", "radius", "appears", "disappears", "waypoints",
               "speed", "spread"});
  object.kind = reader.required("kind").text();
  object.position = read_point_2d(reader.required("position"));
  object.height = reader.optional("height").number(0, {0, 1000, "m"});
  object.radius = reader.optional("radius").number(1, {0, 1000, "m"});
  object.appears = read_instant(reader.optional("appears"));
  object.disappears = read_instant(reader.optional("disappears"), MissionTime::max());
  for (const Reader& point : items_of(reader.optional("waypoints"))) {
    object.waypoints.push_back(read_point_2d(point));
  }
  object.speed = reader.optional("speed").number(0, {0, 200, "m/s"});
  object.spread = read_spread(reader.optional("spread"));
  if (object.spread && object.speed > 0)
    reader.optional("speed").error("what spreads does not go along a way", "no speed");
  return object;
}

/// {grid: FILE, hills: [...]}: measured ground, perhaps with hills on it.
void read_grid(const Reader& reader, Diagnostics& diagnostics, WorldSpec& world) {
  if (!reader.keys({"grid", "hills"})) return;
  const Reader grid = reader.required("grid");
  const std::string path = beside(reader, grid.text());
  const auto text = read_text_of(grid, "terrain file", path);
  if (!text) return;
  auto measured = world::read_terrain_file(*text, path);
  if (!measured) {
    diagnostics.append(measured.error());
    return;
  }
  world.origin = measured->origin;
  world.terrain = std::move(measured->terrain);
  world.terrain.hills = world::read_hills(reader.optional("hills"));
  for (const std::string& problem : world::problems_of(world.terrain)) reader.error(problem);
}

/// What the scenario says itself, and what the file says that it includes.
struct Sources {
  Reader own;
  std::optional<Reader> included;

  /// What is one of a kind: the scenario's own counts before the included.
  Reader one(const char* key) const {
    const Reader here = own.optional(key);
    return here.present() || !included ? here : included->optional(key);
  }
  /// What has names: from both, and no name twice.
  std::vector<std::pair<std::string, Reader>> named(const char* key) const {
    auto entries = entries_of(own.optional(key));
    if (!included) return entries;
    std::set<std::string> names;
    for (const auto& [name, value] : entries) names.insert(name);
    for (auto& [name, value] : entries_of(included->optional(key))) {
      if (names.contains(name))
        own.optional(key).optional(name).error("'" + name + "' is in " + included->file() + " too",
                                               "a name of its own");
      entries.emplace_back(name, std::move(value));
    }
    return entries;
  }
};

constexpr std::initializer_list<const char*> kKeys = {"origin",  "terrain", "wind",   "zones",
                                                      "volumes", "places",  "objects"};

void read_ground_of(const Sources& sources, Diagnostics& diagnostics, WorldSpec& world) {
  const Reader terrain = sources.one("terrain"), origin = sources.one("origin");
  if (!terrain.present()) {
    sources.own.required("terrain");
  } else if (terrain.is_map() && terrain.optional("grid").present()) {
    read_grid(terrain, diagnostics, world);
    if (origin.present()) origin.error("the terrain file says it", "no origin beside a grid");
    return;
  } else {
    world.terrain = world::read_terrain(terrain);
  }
  world.origin = world::read_geodetic(origin.present() ? origin : sources.own.required("origin"));
}

/// [x, y, z], or [x, y]: on the ground there.
world::Vector3 read_place(const Reader& reader, const std::optional<world::Terrain>& terrain) {
  if (!reader.is_sequence() || reader.items().size() != 2 || !terrain) return read_point(reader);
  const world::Vector2 at = read_point_2d(reader);
  return {at.x(), at.y(), terrain->elevation(at.x(), at.y())};
}

void read_places(const Sources& sources, WorldSpec& world) {
  const auto places = sources.named("places");
  std::optional<world::Terrain> terrain;
  if (!places.empty() && world::problems_of(world.terrain).empty()) terrain.emplace(world.terrain);
  for (const auto& [name, place] : places) {
    if (mission::means_home(name))
      place.error("'" + name + "' is each UAV's own home", "another name for the place");
    world.places.emplace(name, read_place(place, terrain));
  }
}

void read_parts(const Sources& sources, Diagnostics& diagnostics, WorldSpec& world) {
  read_ground_of(sources, diagnostics, world);
  world.wind = world::read_wind(sources.one("wind"));
  for (const auto& [name, zone] : sources.named("zones"))
    world.zones.push_back({name, world::read_polygon(zone)});
  for (const auto& [name, volume] : sources.named("volumes")) {
    if (volume.keys({"polygon", "floor", "ceiling", "from", "until"}))
      world.volumes.push_back(world::read_volume(name, volume));
  }
  read_places(sources, world);
  for (const auto& [name, object] : sources.named("objects")) {
    world.objects.push_back(read_object(name, object));
    check_over_ground(object.optional("position"), world.objects.back().position, world.terrain);
  }
}

}  // namespace

void check_over_ground(const Reader& reader, const world::Vector2& point,
                       const world::TerrainSpec& terrain) {
  const auto within = [](double x, double least, double most) { return x >= least && x <= most; };
  if (!reader.present() || !world::problems_of(terrain).empty()) return;
  if (within(point.x(), terrain.west, terrain.east) &&
      within(point.y(), terrain.south, terrain.north))
    return;
  std::ostringstream extent;
  extent << terrain.west << " to " << terrain.east << " m east and " << terrain.south << " to "
         << terrain.north << " m north of the origin";
  reader.error("outside the terrain", extent.str());
}

void read_world(const Reader& reader, Diagnostics& diagnostics, WorldSpec& world) {
  if (!reader.keys(
          {"include", "origin", "terrain", "wind", "zones", "volumes", "places", "objects"}))
    return;
  const Reader include = reader.optional("include");
  if (!include.present()) return read_parts({reader, std::nullopt}, diagnostics, world);
  const std::string path = beside(reader, include.text());
  const auto text = read_text_of(include, "world", path);
  if (!text) return;
  const auto document = config::parse_yaml(*text, path);
  if (!document) return diagnostics.append(document.error());
  const Reader included(*document, path, diagnostics);
  if (included.keys(kKeys)) read_parts({reader, included}, diagnostics, world);
}

}  // namespace skein::scenario
