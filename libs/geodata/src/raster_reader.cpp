// SPDX-License-Identifier: Apache-2.0
#include "skein/geodata/raster_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "raised_ground.hpp"
#include "raster.hpp"
#include "raster_sampler.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/world/world_builder.hpp"

namespace skein::geodata {

using world::Extent;
using world::GeodeticOrigin;
using world::GeodeticPoint;
using world::TerrainSpec;
using world::Vector2;
using world::Vector3;

namespace {

tl::unexpected<Diagnostics> refused(const std::string& path, const RasterProblem& problem) {
  Diagnostics diagnostics;
  diagnostics.add({path, 0, 0, "", problem.message, problem.expected, ""});
  return tl::make_unexpected(diagnostics);
}

/// The middles of the cells along one side of a raster, in the local frame.
std::vector<Vector3> along(const Raster& raster, const geodesy::GeodeticFrame& frame, Vector2 from,
                           Vector2 to) {
  constexpr int kSteps = 64;
  std::vector<Vector2> places;
  for (int i = 0; i <= kSteps; ++i) places.push_back(from + (to - from) * i / kSteps);
  std::vector<Vector3> local;
  for (GeodeticPoint& point : raster.points_at(places)) {
    point.altitude = frame.origin().altitude;
    local.push_back(frame.to_local(point));
  }
  return local;
}

/// The rectangle between the sides: whichever side of the raster is which, each bounds the
/// direction in which it lies from the middle.
Extent covered_extent(const Raster& raster, const geodesy::GeodeticFrame& frame) {
  const double right = raster.columns() - 1, bottom = raster.rows() - 1;
  const Vector2 nw(0, 0), ne(right, 0), sw(0, bottom), se(right, bottom);
  const Vector3 middle = along(raster, frame, Vector2(right / 2, bottom / 2), nw).front();
  Extent extent{-1e9, -1e9, 1e9, 1e9};
  for (const auto& [from, to] :
       {std::pair{nw, ne}, std::pair{ne, se}, std::pair{se, sw}, std::pair{sw, nw}}) {
    const auto side = along(raster, frame, from, to);
    const Vector3 offset = side[side.size() / 2] - middle;
    const bool across = std::abs(offset.x()) > std::abs(offset.y());
    for (const Vector3& p : side) {
      if (across && offset.x() > 0) extent.east = std::min(extent.east, p.x());
      if (across && offset.x() <= 0) extent.west = std::max(extent.west, p.x());
      if (!across && offset.y() > 0) extent.north = std::min(extent.north, p.y());
      if (!across && offset.y() <= 0) extent.south = std::max(extent.south, p.y());
    }
  }
  return extent;
}

/// The mean distance of neighbours in the middle of the raster, in whole metres where that is near.
double natural_cell(const Raster& raster, const geodesy::GeodeticFrame& frame) {
  const Vector2 middle(raster.columns() / 2.0 - 0.5, raster.rows() / 2.0 - 0.5);
  const auto east = along(raster, frame, middle, middle + Vector2(1, 0));
  const auto south = along(raster, frame, middle, middle + Vector2(0, 1));
  const double cell =
      std::sqrt((east.back() - east.front()).norm() * (south.back() - south.front()).norm());
  return cell > 10 ? std::round(cell) : cell;
}

/// An origin in the middle, at altitude 0 until the elevations are known.
GeodeticOrigin middle_of(const Raster& raster) {
  GeodeticOrigin origin =
      raster.points_at({Vector2(raster.columns() / 2.0 - 0.5, raster.rows() / 2.0 - 0.5)})[0];
  origin.altitude = 0;
  return origin;
}

/// Elevations of one row of corners: the height over the ellipsoid at which a vertical of the local
/// frame meets the ground of the raster, by iteration from `z`, which becomes the answer.
void settle_row(const Raster& raster, RasterSampler& sampler, const geodesy::GeodeticFrame& frame,
                std::vector<Vector3>& corners) {
  constexpr int kMostRounds = 12;
  constexpr double kSettled = 1e-5;  // [m]
  std::vector<GeodeticPoint> points(corners.size());
  double moved = 1;
  for (int round = 0; round < kMostRounds && moved > kSettled; ++round) {
    for (std::size_t i = 0; i < corners.size(); ++i) points[i] = frame.to_geodetic(corners[i]);
    const auto places = raster.places_of(points);
    moved = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double step = sampler.at(places[i]) - points[i].altitude;
      if (!(std::abs(step) < 1e6)) continue;  // without data, or no elevation at all
      corners[i].z() += step;
      moved = std::max(moved, std::abs(step));
    }
  }
}

std::vector<double> elevations(const Raster& raster, RasterSampler& sampler,
                               const geodesy::GeodeticFrame& frame, const TerrainSpec& terrain) {
  const world::TerrainCorners count = world::corners_of(terrain);
  std::vector<double> all;
  all.reserve(count.count());
  std::vector<Vector3> row(count.columns, Vector3::Zero());
  for (std::size_t j = 0; j < count.rows; ++j) {
    for (std::size_t i = 0; i < count.columns; ++i) {
      row[i].x() = terrain.west + static_cast<double>(i) * terrain.cell;
      row[i].y() = terrain.south + static_cast<double>(j) * terrain.cell;
    }
    settle_row(raster, sampler, frame, row);
    for (const Vector3& corner : row) all.push_back(corner.z());
  }
  return all;
}

/// In whole metres, so that there are no more corners than a terrain may have.
double coarse_enough(double cell, const Extent& extent) {
  const auto corners = [&](double side) {
    return ((extent.east - extent.west) / side + 1) * ((extent.north - extent.south) / side + 1);
  };
  if (corners(cell) <= world::kMostGroundCells) return cell;
  cell = std::ceil(cell * std::sqrt(corners(cell) / world::kMostGroundCells));
  while (corners(cell) > world::kMostGroundCells) ++cell;
  return cell;
}

/// Without an extent given, corners lie at whole multiples of the cell from the origin.
Result<TerrainSpec, RasterProblem> shape_of(const Raster& raster,
                                            const geodesy::GeodeticFrame& frame,
                                            const ElevationOptions& options) {
  TerrainSpec terrain;
  Extent extent = options.extent ? *options.extent : covered_extent(raster, frame);
  terrain.cell = options.cell ? *options.cell : coarse_enough(natural_cell(raster, frame), extent);
  if (!options.extent) {
    extent.west = std::ceil(extent.west / terrain.cell) * terrain.cell;
    extent.south = std::ceil(extent.south / terrain.cell) * terrain.cell;
    extent.east = std::floor(extent.east / terrain.cell) * terrain.cell;
    extent.north = std::floor(extent.north / terrain.cell) * terrain.cell;
    if (extent.west >= extent.east || extent.south >= extent.north)
      return tl::make_unexpected(RasterProblem{"it does not cover one cell of the terrain",
                                               "a larger raster, or a smaller cell"});
  }
  terrain.west = extent.west;
  terrain.south = extent.south;
  terrain.east = extent.east;
  terrain.north = extent.north;
  const auto problems = world::problems_of(terrain);
  if (!problems.empty()) return tl::make_unexpected(RasterProblem{problems.front(), ""});
  return terrain;
}

/// A file or options beyond all measure must not reach arithmetic on integers.
std::optional<RasterProblem> problem_of(const ElevationOptions& options) {
  const bool right_origin =
      !options.origin || (std::abs(options.origin->latitude_degrees) <= 90 &&
                          std::abs(options.origin->longitude_degrees) <= 180 &&
                          std::abs(options.origin->altitude) <= 1e6);
  if (!right_origin) return RasterProblem{"the origin is no place on Earth", ""};
  if (options.cell && !(*options.cell > 0))
    return RasterProblem{"the cell must be greater than 0", ""};
  if (options.extent) {
    const Extent& e = *options.extent;
    for (const double side : {e.west, e.south, e.east, e.north})
      if (!(std::abs(side) <= 1e6))
        return RasterProblem{"the extent is farther than 1000 km from the origin", ""};
  }
  if (options.no_data && !std::isfinite(*options.no_data))
    return RasterProblem{"the value for cells without data must be finite", ""};
  return std::nullopt;
}

Result<Elevation, RasterProblem> elevation_of(const std::string& path,
                                              const ElevationOptions& options) {
  if (const auto problem = problem_of(options)) return tl::make_unexpected(*problem);
  GdalSession session;
  const auto raster = Raster::open(path, options.crs, session);
  if (!raster) return tl::make_unexpected(raster.error());
  GeodeticOrigin origin = options.origin ? *options.origin : middle_of(*raster);
  const geodesy::GeodeticFrame level(origin);
  auto terrain = shape_of(*raster, level, options);
  if (!terrain) return tl::make_unexpected(terrain.error());
  const Extent extent{terrain->west, terrain->south, terrain->east, terrain->north};
  auto sampler =
      RasterSampler::over(*raster, level, extent, {true, options.no_data, options.most_posts});
  if (!sampler) return tl::make_unexpected(sampler.error());
  if (!options.origin && std::isfinite(sampler->lowest())) origin.altitude = sampler->lowest();
  terrain->elevations = elevations(*raster, *sampler, geodesy::GeodeticFrame(origin), *terrain);
  if (const auto absent = sampler->absences()) return tl::make_unexpected(*absent);
  Raised raised;
  if (options.above_posts)
    raised = raise_above(*terrain, *sampler, *raster, geodesy::GeodeticFrame(origin));
  const auto problems = world::problems_of(*terrain);
  if (!problems.empty()) return tl::make_unexpected(RasterProblem{problems.front(), ""});
  return Elevation{std::move(*terrain), origin, raised.most, raised.mean, sampler->factor()};
}

Result<std::vector<double>, RasterProblem> risk_of(const std::string& path, const world::Grid& grid,
                                                   const GeodeticOrigin& origin,
                                                   const RiskOptions& options) {
  GdalSession session;
  const auto raster = Raster::open(path, options.crs, session);
  if (!raster) return tl::make_unexpected(raster.error());
  const geodesy::GeodeticFrame frame(origin);
  const Vector2 last = grid.centre(grid.size() - 1);
  const Extent extent{grid.west + grid.cell / 2, grid.south + grid.cell / 2, last.x(), last.y()};
  auto sampler = RasterSampler::over(*raster, frame, extent, {false, options.no_data});
  if (!sampler) return tl::make_unexpected(sampler.error());
  std::vector<double> risk;
  risk.reserve(grid.size());
  std::vector<GeodeticPoint> row(grid.columns);
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const Vector2 at = grid.centre(grid.index(i, j));
      row[i] = frame.to_geodetic({at.x(), at.y(), 0});
    }
    for (const Vector2& place : raster->places_of(row)) risk.push_back(sampler->at(place));
  }
  if (const auto absent = sampler->absences()) return tl::make_unexpected(*absent);
  const auto wrong =
      std::find_if_not(risk.begin(), risk.end(), [](double r) { return r >= 0 && r <= 1; });
  if (wrong != risk.end()) {
    const Vector2 at = grid.centre(static_cast<std::size_t>(wrong - risk.begin()));
    return tl::make_unexpected(RasterProblem{"a risk of " + std::to_string(*wrong) + " at [" +
                                                 std::to_string(at.x()) + ", " +
                                                 std::to_string(at.y()) + "]",
                                             "values from 0 to 1"});
  }
  return risk;
}

}  // namespace

Result<Elevation, Diagnostics> read_elevation(const std::string& path,
                                              const ElevationOptions& options) {
  auto elevation = elevation_of(path, options);
  if (!elevation) return refused(path, elevation.error());
  return std::move(*elevation);
}

Result<std::vector<double>, Diagnostics> read_risk(const std::string& path, const world::Grid& grid,
                                                   const GeodeticOrigin& origin,
                                                   const RiskOptions& options) {
  auto risk = risk_of(path, grid, origin, options);
  if (!risk) return refused(path, risk.error());
  return std::move(*risk);
}

}  // namespace skein::geodata
