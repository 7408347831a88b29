// SPDX-License-Identifier: Apache-2.0
#include "skein/world/world_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::world {
namespace {

constexpr double kDefaultGroundCell = 50;  ///< [m]

/// Adds what is wrong at a place of the file.
class Report {
 public:
  explicit Report(std::string file) : file_(std::move(file)) {}
  void operator()(const Mark& mark, std::string message, std::string expected = "") {
    diagnostics_.add({file_, mark.line, 0, mark.path, std::move(message), std::move(expected), ""});
  }
  const Diagnostics& all() const { return diagnostics_; }

 private:
  std::string file_;
  Diagnostics diagnostics_;
};

std::int32_t voxels_along(double extent, double voxel) {
  const double count = std::ceil(extent / voxel - 1e-9);
  return static_cast<std::int32_t>(std::clamp(count, 0.0, 2e9));
}

double default_voxel(const Vector3& extent) {
  const double volume = extent.cwiseMax(1.0).prod();
  double voxel = std::max(1.0, std::ceil(std::cbrt(volume / static_cast<double>(kDefaultVoxels))));
  const auto count = [&] { return (extent / voxel).array().ceil().max(1.0).prod(); };
  while (count() > static_cast<double>(kDefaultVoxels)) voxel += 1;
  return voxel;
}

AirspaceGrid airspace_over(const Terrain& terrain, const AirspaceRequest& request, Report& report) {
  const TerrainSpec& ground = terrain.spec();
  const Vector3 low(request.west.value_or(ground.west), request.south.value_or(ground.south),
                    request.floor.value_or(terrain.lowest()));
  const Vector3 high(request.east.value_or(ground.east), request.north.value_or(ground.north),
                     request.ceiling.value_or(terrain.highest() + kDefaultAir));
  AirspaceGrid grid;
  grid.origin = low;
  const Vector3 extent = high - low;
  if (!(extent.array() > 0).all()) {
    report(request.mark, "the airspace has no extent",
           "west < east, south < north, floor < ceiling, here [" + std::to_string(low.x()) + ", " +
               std::to_string(low.y()) + ", " + std::to_string(low.z()) + "] to [" +
               std::to_string(high.x()) + ", " + std::to_string(high.y()) + ", " +
               std::to_string(high.z()) + "]");
    return grid;
  }
  grid.voxel = request.voxel ? *request.voxel : default_voxel(extent);
  for (int axis = 0; axis < 3; ++axis)
    grid.size[static_cast<std::size_t>(axis)] = voxels_along(extent[axis], grid.voxel);
  for (const std::string& problem : problems_of(grid)) report(request.mark, problem);
  return grid;
}

/// The cells whose middles may be in [low, high] along an axis: first, and one after the last.
std::pair<std::size_t, std::size_t> cells_between(double low, double high, double origin,
                                                  double cell, std::size_t count) {
  const auto index = [&](double at) {
    const double along = std::floor((at - origin) / cell);
    return static_cast<std::size_t>(std::clamp(along, 0.0, static_cast<double>(count)));
  };
  return {index(low), std::max(index(low), index(high + cell))};
}

void raise(const RiskPeak& peak, double base, const Grid& grid, std::vector<double>& risk) {
  const auto [west, east] = cells_between(peak.at.x() - peak.radius, peak.at.x() + peak.radius,
                                          grid.west, grid.cell, grid.columns);
  const auto [south, north] = cells_between(peak.at.y() - peak.radius, peak.at.y() + peak.radius,
                                            grid.south, grid.cell, grid.rows);
  for (std::size_t row = south; row < north; ++row)
    for (std::size_t column = west; column < east; ++column) {
      const std::size_t cell = grid.index(column, row);
      const double distance = (grid.centre(cell) - peak.at).norm();
      if (distance >= peak.radius) continue;
      const double bump = (1 + std::cos(std::numbers::pi * distance / peak.radius)) / 2;
      risk[cell] = std::max(risk[cell], base + (peak.risk - base) * bump);
    }
}

std::vector<double> risk_cells(const GroundRequest& request, const Grid& grid, Report& report) {
  return std::visit(Overloaded{[&](double risk) {
                                 return risk == 0.5 ? std::vector<double>()
                                                    : std::vector<double>(grid.size(), risk);
                               },
                               [&](const RiskPeaks& peaks) {
                                 std::vector<double> cells(grid.size(), peaks.base);
                                 for (const RiskPeak& peak : peaks.peaks)
                                   raise(peak, peaks.base, grid, cells);
                                 return cells;
                               },
                               [&](const RasterSource& raster) {
                                 report(raster.mark, "the risk raster was not read");
                                 return std::vector<double>();
                               },
                               [&](const RiskCells& cells) {
                                 SKEIN_EXPECTS(cells.size() == grid.size());
                                 return cells;
                               }},
                    request.risk);
}

void mark_cells(const std::vector<Vector2>& points, CellState state, GroundState& ground,
                const Mark& mark, Report& report) {
  if (!points.empty()) ground.state.resize(ground.grid.size(), CellState::kQuiet);
  for (const Vector2& point : points) {
    const auto cell = ground.grid.at(point);
    if (cell)
      ground.state[*cell] = state;
    else
      report(mark, "an alarm or a fire at [" + std::to_string(point.x()) + ", " +
                       std::to_string(point.y()) + "] is off the ground");
  }
}

/// Marks the cells of one row whose middles are in a polygon: those between its 1st and 2nd
/// crossing with the row's middle line, its 3rd and 4th, and so on.
void fill_row(const Polygon& polygon, const Grid& grid, std::size_t row,
              std::vector<double>& crossings, std::vector<bool>& mapped) {
  const double y = grid.south + (static_cast<double>(row) + 0.5) * grid.cell;
  crossings.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > y) != (b.y() > y))
      crossings.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const auto [west, east] =
        cells_between(crossings[i], crossings[i + 1], grid.west, grid.cell, grid.columns);
    for (std::size_t column = west; column < east; ++column) {
      const std::size_t cell = grid.index(column, row);
      const double x = grid.centre(cell).x();
      if (x >= crossings[i] && x <= crossings[i + 1]) mapped[cell] = true;
    }
  }
}

std::vector<bool> mapped_cells(const std::vector<Polygon>& polygons, const Grid& grid) {
  if (polygons.empty()) return {};
  std::vector<bool> mapped(grid.size());
  std::vector<double> crossings;
  for (const Polygon& polygon : polygons)
    for (std::size_t row = 0; row < grid.rows; ++row)
      fill_row(polygon, grid, row, crossings, mapped);
  return mapped;
}

GroundState ground_of(const GroundRequest& request, const TerrainSpec& terrain, Report& report) {
  GroundState ground;
  ground.grid = ground_grid(request, terrain);
  if (static_cast<double>(ground.grid.columns) * static_cast<double>(ground.grid.rows) >
      kMostGroundCells) {
    report(request.mark, "more than 4 million cells of ground", "a larger cell");
    return ground;
  }
  ground.risk = risk_cells(request, ground.grid, report);
  ground.mapped = mapped_cells(request.mapped, ground.grid);
  mark_cells(request.alarms, CellState::kAlarm, ground, request.mark, report);
  mark_cells(request.fires, CellState::kFire, ground, request.mark, report);
  return ground;
}

std::map<std::string, Vector3, std::less<>> local_places(const WorldFile& file, Report& report) {
  std::map<std::string, Vector3, std::less<>> places;
  for (const auto& [name, place] : file.places) {
    if (const auto* local = std::get_if<Vector3>(&place.at))
      places.emplace(name, *local);
    else
      report(place.mark, "the place on Earth was not found in the local frame");
  }
  return places;
}

}  // namespace

Grid ground_grid(const GroundRequest& ground, const TerrainSpec& terrain) {
  const double width = terrain.east - terrain.west, depth = terrain.north - terrain.south;
  Grid grid;
  grid.west = terrain.west;
  grid.south = terrain.south;
  grid.cell =
      ground.cell.value_or(std::max(kDefaultGroundCell, std::ceil(std::sqrt(width * depth / 1e6))));
  const auto cells = [&](double extent) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(extent / grid.cell - 1e-9)));
  };
  grid.columns = cells(width);
  grid.rows = cells(depth);
  return grid;
}

Result<World, Diagnostics> build_world(WorldFile file) {
  Report report(file.file);
  if (const auto* raster = std::get_if<RasterTerrain>(&file.terrain)) {
    report(raster->raster.mark, "the terrain raster was not read");
    return tl::make_unexpected(report.all());
  }
  TerrainSpec& spec = std::get<TerrainSpec>(file.terrain);
  for (const std::string& problem : problems_of(spec)) report({0, "terrain"}, problem);
  if (!report.all().empty()) return tl::make_unexpected(report.all());
  Terrain terrain(std::move(spec));
  const AirspaceGrid airspace = airspace_over(terrain, file.airspace, report);
  GroundState ground = ground_of(file.ground, terrain.spec(), report);
  auto places = local_places(file, report);
  if (!report.all().empty()) return tl::make_unexpected(report.all());
  return World{file.origin.value_or(GeodeticOrigin()),
               std::move(terrain),
               file.wind,
               airspace,
               std::move(file.volumes),
               std::move(ground),
               file.radio,
               std::move(file.zones),
               std::move(places)};
}

}  // namespace skein::world
