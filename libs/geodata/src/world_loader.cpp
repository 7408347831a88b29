// SPDX-License-Identifier: Apache-2.0
#include "skein/geodata/world_loader.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "skein/geodata/raster_reader.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/world/world_builder.hpp"
#include "skein/world/world_reader.hpp"

namespace skein::geodata {

using world::RasterSource;
using world::TerrainSpec;
using world::WorldFile;

namespace {

std::string in_folder(const std::string& folder, const std::string& file) {
  return (std::filesystem::path(folder) / file).lexically_normal().string();
}

/// What is wrong with a raster, said of the line that names it.
Diagnostics at(const Diagnostics& problems, const WorldFile& file, const world::Mark& mark) {
  Diagnostics marked;
  for (const Diagnostic& problem : problems.all())
    marked.add({file.file, mark.line, 0, mark.path, problem.file + ": " + problem.message,
                problem.expected, problem.nearest});
  return marked;
}

Result<void, Diagnostics> resolve_terrain(WorldFile& file, const std::string& folder) {
  const auto* raster = std::get_if<world::RasterTerrain>(&file.terrain);
  if (raster == nullptr) return {};
  auto elevation = read_elevation(in_folder(folder, raster->raster.file),
                                  {file.origin, raster->cell, raster->extent,
                                   raster->raster.no_data, raster->raster.crs, true});
  if (!elevation) return tl::make_unexpected(at(elevation.error(), file, raster->raster.mark));
  file.origin = elevation->origin;
  file.terrain = std::move(elevation->terrain);
  return {};
}

Result<void, Diagnostics> resolve_risk(WorldFile& file, const std::string& folder) {
  const auto* raster = std::get_if<RasterSource>(&file.ground.risk);
  if (raster == nullptr) return {};
  const world::Grid grid = world::ground_grid(file.ground, std::get<TerrainSpec>(file.terrain));
  if (static_cast<double>(grid.size()) > world::kMostGroundCells) return {};  // refused later
  auto risk = read_risk(in_folder(folder, raster->file), grid, *file.origin,
                        {raster->no_data, raster->crs});
  if (!risk) return tl::make_unexpected(at(risk.error(), file, raster->mark));
  file.ground.risk = std::move(*risk);
  return {};
}

void resolve_places(WorldFile& file) {
  const geodesy::GeodeticFrame frame(*file.origin);
  for (auto& [name, place] : file.places)
    if (const auto* point = std::get_if<world::GeodeticPoint>(&place.at))
      place.at = frame.to_local(*point);
}

}  // namespace

Result<world::World, Diagnostics> load_world(WorldFile file, const std::string& folder) {
  if (auto done = resolve_terrain(file, folder); !done) return tl::make_unexpected(done.error());
  if (!file.origin) file.origin.emplace();
  if (auto done = resolve_risk(file, folder); !done) return tl::make_unexpected(done.error());
  resolve_places(file);
  return world::build_world(std::move(file));
}

Result<world::World, Diagnostics> read_world(const std::string& path) {
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, error) || !in) {
    Diagnostics diagnostics;
    diagnostics.add({path, 0, 0, "", "the world file cannot be read", "", ""});
    return tl::make_unexpected(diagnostics);
  }
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  auto file = world::read_world_file(text, path);
  if (!file) return tl::make_unexpected(file.error());
  return load_world(std::move(*file), std::filesystem::path(path).parent_path().string());
}

}  // namespace skein::geodata
