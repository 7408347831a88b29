// SPDX-License-Identifier: Apache-2.0
#include "skein/world/world_reader.hpp"

#include <utility>

#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/world/environment_reader.hpp"
#include "skein/world/radio_reader.hpp"

namespace skein::world {
namespace {

using config::Range;
using config::Reader;

constexpr Range kFraction{0, 1, ""};
constexpr Range kCell{0.1, 10'000, "m"};
constexpr Range kLevel{-10'000, 100'000, "m"};
/// So that making the ground state stays quick.
constexpr std::size_t kMostParts = 1000;

Mark mark_of(const Reader& reader) { return {reader.line(), reader.path()}; }

std::optional<double> optional_number(const Reader& reader, Range range) {
  if (!reader.present()) return std::nullopt;
  return reader.number(range.low, range);
}

/// False is reported: more than can be worked through in a moment.
bool few(const Reader& reader, std::size_t count) {
  if (count <= kMostParts) return true;
  reader.error(std::to_string(count) + " of them", "at most " + std::to_string(kMostParts));
  return false;
}

/// The keys that say which raster and how it is read; others are the caller's.
RasterSource read_raster(const Reader& reader, Range values) {
  const Reader file = reader.required("raster");
  RasterSource source{file.text(), reader.optional("crs").text(), std::nullopt, mark_of(file)};
  if (file.is_scalar() && source.file.empty()) file.error("an empty name", "the name of a file");
  if (const Reader crs = reader.optional("crs"); crs.is_scalar() && source.crs.empty())
    crs.error("an empty name", "a coordinate reference system: EPSG:4326");
  source.no_data = optional_number(reader.optional("nodata"), values);
  return source;
}

/// All four sides or none.
std::optional<Extent> read_extent(const Reader& reader) {
  bool any = false;
  for (const char* side : {"west", "south", "east", "north"})
    any = any || reader.optional(side).present();
  if (!any) return std::nullopt;
  const Extent extent{reader.required("west").number(0, kCoordinate),
                      reader.required("south").number(0, kCoordinate),
                      reader.required("east").number(1, kCoordinate),
                      reader.required("north").number(1, kCoordinate)};
  if (extent.east <= extent.west) reader.error("east must be greater than west");
  if (extent.north <= extent.south) reader.error("north must be greater than south");
  return extent;
}

std::variant<TerrainSpec, RasterTerrain> read_ground(const Reader& reader) {
  if (!reader.optional("raster").present()) return read_terrain(reader);
  reader.keys({"raster", "crs", "nodata", "cell", "west", "south", "east", "north"});
  return RasterTerrain{read_raster(reader, kLevel), optional_number(reader.optional("cell"), kCell),
                       read_extent(reader)};
}

AirspaceRequest read_airspace(const Reader& reader) {
  AirspaceRequest airspace;
  airspace.mark = mark_of(reader);
  if (!reader.keys({"west", "south", "east", "north", "floor", "ceiling", "voxel"}))
    return airspace;
  airspace.west = optional_number(reader.optional("west"), kCoordinate);
  airspace.south = optional_number(reader.optional("south"), kCoordinate);
  airspace.east = optional_number(reader.optional("east"), kCoordinate);
  airspace.north = optional_number(reader.optional("north"), kCoordinate);
  airspace.floor = optional_number(reader.optional("floor"), kLevel);
  airspace.ceiling = optional_number(reader.optional("ceiling"), kLevel);
  airspace.voxel = optional_number(reader.optional("voxel"), kCell);
  return airspace;
}

Volume read_no_fly(const std::string& name, const Reader& reader) {
  if (reader.keys({"polygon", "floor", "ceiling", "from", "until"}))
    return read_volume(name, reader);
  Volume volume;
  volume.name = name;
  return volume;
}

RiskPeaks read_peaks(const Reader& reader) {
  RiskPeaks peaks;
  if (!reader.keys({"peaks", "base"})) return peaks;
  peaks.base = reader.optional("base").number(0, kFraction);
  const auto items = items_of(reader.required("peaks"));
  if (!few(reader.optional("peaks"), items.size())) return peaks;
  for (const Reader& item : items) {
    if (!item.keys({"at", "risk", "radius"})) continue;
    peaks.peaks.push_back({read_point_2d(item.required("at")),
                           item.required("risk").number(0, kFraction),
                           item.required("radius").number(1, {1, kFarthest, "m"})});
  }
  return peaks;
}

std::variant<double, RiskPeaks, RasterSource, RiskCells> read_risk(const Reader& reader) {
  if (!reader.present()) return 0.5;
  if (!reader.is_map()) return reader.number(0.5, kFraction);
  if (!reader.optional("raster").present()) return read_peaks(reader);
  reader.keys({"raster", "crs", "nodata"});
  return read_raster(reader, kFraction);
}

std::vector<Vector2> read_points(const Reader& reader) {
  std::vector<Vector2> points;
  for (const Reader& item : items_of(reader)) points.push_back(read_point_2d(item));
  return points;
}

GroundRequest read_ground_state(const Reader& reader) {
  GroundRequest ground;
  ground.mark = mark_of(reader);
  if (!reader.keys({"cell", "risk", "mapped", "alarms", "fires"})) return ground;
  ground.cell = optional_number(reader.optional("cell"), kCell);
  ground.risk = read_risk(reader.optional("risk"));
  const auto mapped = items_of(reader.optional("mapped"));
  if (few(reader.optional("mapped"), mapped.size()))
    for (const Reader& polygon : mapped) ground.mapped.push_back(read_polygon(polygon));
  ground.alarms = read_points(reader.optional("alarms"));
  ground.fires = read_points(reader.optional("fires"));
  return ground;
}

void read_places(const Reader& reader, WorldFile& world) {
  for (const auto& [name, place] : entries_of(reader)) {
    if (place.is_map())
      world.places[name] = {read_geodetic(place), mark_of(place)};
    else
      world.places[name] = {read_point(place), mark_of(place)};
  }
}

}  // namespace

WorldFile read_world_file(const Reader& reader) {
  WorldFile world;
  world.file = reader.file();
  reader.keys(
      {"origin", "terrain", "wind", "airspace", "no_fly", "zones", "places", "ground", "radio"});
  const Reader terrain = reader.required("terrain"), origin = reader.optional("origin");
  world.terrain = read_ground(terrain);
  if (origin.present()) world.origin = read_geodetic(origin);
  if (!origin.present() && std::holds_alternative<TerrainSpec>(world.terrain))
    origin.error("missing", "where on Earth the hills stand; only a raster knows it by itself");
  world.wind = read_wind(reader.optional("wind"));
  world.airspace = read_airspace(reader.optional("airspace"));
  for (const auto& [name, volume] : entries_of(reader.optional("no_fly")))
    world.volumes.push_back(read_no_fly(name, volume));
  world.zones = read_zones(reader.optional("zones"));
  read_places(reader.optional("places"), world);
  world.ground = read_ground_state(reader.optional("ground"));
  world.radio = read_radio(reader.optional("radio"));
  return world;
}

Result<WorldFile, Diagnostics> read_world_file(std::string_view text, const std::string& file) {
  const auto document = config::parse_yaml(text, file);
  if (!document) return tl::make_unexpected(document.error());
  Diagnostics diagnostics;
  const Reader reader(*document, file, diagnostics);
  if (!reader.is_map()) {
    reader.error("this is not a world", "a map with origin and terrain");
    return tl::make_unexpected(diagnostics);
  }
  WorldFile world = read_world_file(reader);
  if (!diagnostics.empty()) return tl::make_unexpected(diagnostics);
  return world;
}

}  // namespace skein::world
