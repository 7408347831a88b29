// SPDX-License-Identifier: Apache-2.0
#include "skein/terrain_tool/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <ostream>
#include <utility>

#include "skein/cartography/map.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/geodata/raster_reader.hpp"
#include "skein/world/terrain_file.hpp"
#include "skein/world/world_builder.hpp"

namespace skein::terrain_tool {
namespace {

using world::MeasuredTerrain;
using world::TerrainSpec;

int refuse(const Diagnostics& problems, std::ostream& err) {
  err << to_text(problems);
  return kExitBadInput;
}

bool write(const std::string& path, const std::string& text, std::ostream& err) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return true;
  err << path << ": cannot be written\n";
  return false;
}

/// What is wrong with the options as a whole.
Diagnostics problems_of(const MakeOptions& options) {
  Diagnostics problems;
  const auto wrong = [&](const char* option, std::string message) {
    problems.add({"", 0, 0, option, std::move(message), "", ""});
  };
  if (const auto& sides = options.extent; sides.size() == 4) {
    if (sides[2] <= sides[0]) wrong("--extent", "east must be greater than west");
    if (sides[3] <= sides[1]) wrong("--extent", "north must be greater than south");
  }
  if (const auto& origin = options.origin; origin.size() == 3) {
    if (!(origin[0] >= -90 && origin[0] <= 90)) wrong("--origin", "no latitude in [-90, 90]");
    if (!(origin[1] >= -180 && origin[1] <= 180)) wrong("--origin", "no longitude in [-180, 180]");
  }
  return problems;
}

geodata::ElevationOptions elevation_options(const MakeOptions& options) {
  geodata::ElevationOptions wanted;
  if (const auto& at = options.origin; at.size() == 3)
    wanted.origin = world::GeodeticOrigin{at[0], at[1], at[2]};
  if (const auto& sides = options.extent; sides.size() == 4)
    wanted.extent = world::Extent{sides[0], sides[1], sides[2], sides[3]};
  wanted.cell = options.cell;
  wanted.no_data = options.no_data;
  wanted.crs = options.crs;
  wanted.above_posts = true;
  return wanted;
}

std::string source_of(const MakeOptions& options) {
  const std::string name = std::filesystem::path(options.raster).filename().string();
  return options.crs.empty() ? name : name + ", " + options.crs;
}

/// The greatest slope at the middle of a cell [rad].
double steepest(const world::Terrain& terrain) {
  const TerrainSpec& spec = terrain.spec();
  const world::TerrainCorners corners = world::corners_of(spec);
  double slope = 0;
  for (std::size_t row = 0; row + 1 < corners.rows; ++row)
    for (std::size_t column = 0; column + 1 < corners.columns; ++column)
      slope =
          std::max(slope, terrain.slope(spec.west + (static_cast<double>(column) + 0.5) * spec.cell,
                                        spec.south + (static_cast<double>(row) + 0.5) * spec.cell));
  return slope;
}

void describe(const MeasuredTerrain& measured, const world::Terrain& terrain, std::ostream& out) {
  const TerrainSpec& spec = terrain.spec();
  const world::TerrainCorners corners = world::corners_of(spec);
  out << fmt::format("  from {}\n", measured.source.empty() ? "?" : measured.source)
      << fmt::format("  origin {:.6f}, {:.6f} (WGS 84), {:g} m\n", measured.origin.latitude_degrees,
                     measured.origin.longitude_degrees, measured.origin.altitude)
      << fmt::format("  x {:g} to {:g} m, y {:g} to {:g} m, {} × {} corners, {:g} m apart\n",
                     spec.west, spec.east, spec.south, spec.north, corners.columns, corners.rows,
                     spec.cell)
      << fmt::format("  {:.1f} to {:.1f} m over the origin, slopes up to {:.0f}°\n",
                     terrain.lowest(), terrain.highest(),
                     steepest(terrain) * 180 / std::numbers::pi);
}

std::string picture(const MeasuredTerrain& measured, const std::string& name) {
  world::WorldFile file;
  file.origin = measured.origin;
  file.terrain = measured.terrain;
  const auto world = world::build_world(std::move(file));
  if (!world) return "";
  const TerrainSpec& spec = measured.terrain;
  return cartography::Map(*world, {spec.west, spec.south, spec.east, spec.north})
      .finish(name, {measured.source});
}

}  // namespace

int make_terrain(const MakeOptions& options, std::ostream& out, std::ostream& err) {
  if (const Diagnostics problems = problems_of(options); !problems.empty())
    return refuse(problems, err);
  auto read = geodata::read_elevation(options.raster, elevation_options(options));
  if (!read) return refuse(read.error(), err);
  const MeasuredTerrain measured{read->origin, source_of(options), std::move(read->terrain)};
  if (!write(options.out, world::terrain_file_text(measured), err)) return kExitSystem;
  out << options.out << '\n';
  describe(measured, world::Terrain(measured.terrain), out);
  out << fmt::format(
      "  raised by up to {:.1f} m ({:.1f} m in the mean) so that no post stands out\n",
      read->raised_most, read->raised_mean);
  if (read->decimated > 1)
    out << fmt::format("  of {} × {} posts the highest was taken\n", read->decimated,
                       read->decimated);
  return kExitOk;
}

int show_terrain(const ShowOptions& options, std::ostream& out, std::ostream& err) {
  std::ifstream in(options.file, std::ios::binary);
  if (!std::filesystem::is_regular_file(options.file) || !in) {
    err << options.file << ": cannot be read\n";
    return kExitBadInput;
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto measured = world::read_terrain_file(text, options.file);
  if (!measured) return refuse(measured.error(), err);
  out << options.file << '\n';
  describe(*measured, world::Terrain(measured->terrain), out);
  if (options.svg.empty()) return kExitOk;
  const std::string name = std::filesystem::path(options.file).filename().string();
  return write(options.svg, picture(*measured, name), err) ? kExitOk : kExitSystem;
}

}  // namespace skein::terrain_tool
