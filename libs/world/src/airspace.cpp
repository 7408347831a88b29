// SPDX-License-Identifier: Apache-2.0
#include "skein/world/airspace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skein/foundation/contract.hpp"
#include "voxel_walk.hpp"

namespace skein::world {
namespace {

/// What Terrain takes for grazing, and no hit, is above the ground here too [m].
constexpr double kGrazing = 5e-10;

/// The two ends of [from, until], held within [low, high], and the lines of a grid in between: the
/// places where a surface that is linear between those lines can be highest.
std::vector<double> corners_along(double from, double until, double low, double high, double cell) {
  const double a = std::clamp(from, low, high), b = std::clamp(until, low, high);
  std::vector<double> corners = {a};
  const auto first = static_cast<std::int64_t>(std::floor((a - low) / cell));
  const auto last = static_cast<std::int64_t>(std::ceil((b - low) / cell));
  for (std::int64_t i = first; i <= last; ++i) {
    const double line = low + static_cast<double>(i) * cell;
    if (line > a && line < b) corners.push_back(line);
  }
  if (b > a) corners.push_back(b);
  return corners;
}

/// Which corners of the terrain's cells lie in each of the rows (or columns) of voxels.
std::vector<std::vector<double>> corners_of_voxels(double origin, double voxel, std::int32_t count,
                                                   double margin,
                                                   const std::array<double, 3>& ground) {
  std::vector<std::vector<double>> corners;
  corners.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i) {
    const double from = origin + i * voxel;
    corners.push_back(
        corners_along(from - margin, from + voxel + margin, ground[0], ground[1], ground[2]));
  }
  return corners;
}

/// What is under a column of voxels.
struct Ground {
  double lowest, highest;  // [m]
};

/// The same places along one axis for all rows (or columns) of voxels, each once; and which of them
/// are of which row: [first, end).
struct Corners {
  std::vector<double> places;
  std::vector<std::pair<std::size_t, std::size_t>> of_voxels;
};

Corners each_once(const std::vector<std::vector<double>>& of_voxels) {
  Corners corners;
  for (const std::vector<double>& places : of_voxels)
    corners.places.insert(corners.places.end(), places.begin(), places.end());
  std::sort(corners.places.begin(), corners.places.end());
  corners.places.erase(std::unique(corners.places.begin(), corners.places.end()),
                       corners.places.end());
  const auto index_of = [&](double place) {
    const auto found = std::lower_bound(corners.places.begin(), corners.places.end(), place);
    return static_cast<std::size_t>(found - corners.places.begin());
  };
  // What else lies between the first and the last of a voxel is below the surface of these.
  for (const std::vector<double>& places : of_voxels)
    corners.of_voxels.emplace_back(index_of(places.front()), index_of(places.back()) + 1);
  return corners;
}

/// The ground under each column of voxels, whose footprint is grown by `margin` [m].
std::vector<Ground> ground_below(const AirspaceGrid& grid, const Terrain& terrain, double margin) {
  const TerrainSpec& spec = terrain.spec();
  const Corners xs = each_once(corners_of_voxels(grid.origin.x(), grid.voxel, grid.size[0], margin,
                                                 {spec.west, spec.east, spec.cell}));
  const Corners ys = each_once(corners_of_voxels(grid.origin.y(), grid.voxel, grid.size[1], margin,
                                                 {spec.south, spec.north, spec.cell}));
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const std::size_t columns = xs.of_voxels.size();
  std::vector<Ground> grounds(columns * ys.of_voxels.size(), Ground{kFar, -kFar});
  std::vector<double> heights(xs.places.size());
  std::vector<Ground> line(columns);  // along one line from west to east
  std::size_t first_row = 0;
  for (std::size_t k = 0; k < ys.places.size(); ++k) {
    for (std::size_t i = 0; i < heights.size(); ++i)
      heights[i] = terrain.elevation(xs.places[i], ys.places[k]);
    for (std::size_t i = 0; i < columns; ++i) {
      const auto [first, end] = xs.of_voxels[i];
      line[i] = {kFar, -kFar};
      for (std::size_t at = first; at < end; ++at)
        line[i] = {std::min(line[i].lowest, heights[at]), std::max(line[i].highest, heights[at])};
    }
    while (first_row < ys.of_voxels.size() && ys.of_voxels[first_row].second <= k) ++first_row;
    for (std::size_t row = first_row; row < ys.of_voxels.size() && ys.of_voxels[row].first <= k;
         ++row)
      for (std::size_t i = 0; i < columns; ++i) {
        Ground& ground = grounds[row * columns + i];
        ground = {std::min(ground.lowest, line[i].lowest),
                  std::max(ground.highest, line[i].highest)};
      }
  }
  return grounds;
}

/// The first layer of which something is true that is so of all above it too; about at a height.
template <class IsTrue>
std::int32_t first_layer(const AirspaceGrid& grid, double height, const IsTrue& is_true) {
  const double about = std::floor((height - grid.origin.z()) / grid.voxel);
  auto layer = static_cast<std::int32_t>(std::clamp(about, 0.0, 1.0 * grid.size[2]));
  while (layer > 0 && is_true(layer - 1)) --layer;
  while (layer < grid.size[2] && !is_true(layer)) ++layer;
  return layer;
}

/// Closes the voxels of which `is_blocked(layer, figure of the column)`, which compares the two:
/// below all figures and above them a layer is alike; elsewhere without branches, so that many are
/// done at a time.
template <class IsBlocked>
void block_where(const AirspaceGrid& grid, const std::vector<std::int32_t>& columns,
                 std::vector<std::uint8_t>& voxels, const IsBlocked& is_blocked) {
  static_assert(Airspace::kBlocked == 0);
  const auto [least, most] = std::minmax_element(columns.begin(), columns.end());
  for (std::int32_t z = 0; z < grid.size[2]; ++z) {
    std::uint8_t* layer = &voxels[grid.index(0, 0, z)];
    if (z < *least || z >= *most) {
      if (is_blocked(z, *least)) std::fill_n(layer, columns.size(), Airspace::kBlocked);
      continue;
    }
    for (std::size_t i = 0; i < columns.size(); ++i)
      layer[i] = static_cast<std::uint8_t>(layer[i] & (is_blocked(z, columns[i]) ? 0 : 0xff));
  }
}

}  // namespace

std::vector<std::string> problems_of(const AirspaceGrid& grid) {
  std::vector<std::string> problems;
  if (!grid.origin.allFinite()) problems.emplace_back("airspace: the origin must be finite");
  if (!(grid.voxel > 0) || !std::isfinite(grid.voxel))
    problems.emplace_back("airspace: the side of a voxel must be greater than 0");
  double count = 1;
  for (const std::int32_t size : grid.size) {
    if (size < 1) problems.emplace_back("airspace: each size must be at least 1");
    if (size > kMostVoxelsAlong)
      problems.emplace_back("airspace: more than 1048576 voxels along one axis");
    count *= std::max(1, size);
  }
  if (count > static_cast<double>(kMostVoxels))
    problems.emplace_back("airspace: more than 536870912 voxels; use larger ones");
  return problems;
}

Airspace::Airspace(const AirspaceGrid& grid) : grid_(grid) {
  SKEIN_EXPECTS(problems_of(grid).empty());
  voxels_.assign(grid.count(), kPlain);
}

Airspace::Airspace(const AirspaceGrid& grid, std::vector<std::uint8_t> voxels)
    : grid_(grid), voxels_(std::move(voxels)) {
  SKEIN_EXPECTS(problems_of(grid).empty());
  SKEIN_EXPECTS(voxels_.size() == grid.count());
  std::array<bool, 256> there{};
  for (const std::uint8_t voxel : voxels_) there[voxel] = true;
  SKEIN_EXPECTS(std::none_of(&there[1], &there[kPlain], [](bool found) { return found; }));
  least_cost_ = greatest_cost_ = kPlain;
  for (unsigned cost = 255; cost >= kPlain; --cost)
    if (there[cost]) least_cost_ = static_cast<std::uint8_t>(cost);
  for (unsigned cost = kPlain; cost <= 255; ++cost)
    if (there[cost]) greatest_cost_ = static_cast<std::uint8_t>(cost);
}

Airspace::Airspace(const AirspaceSpec& spec, const Terrain& terrain,
                   const std::vector<Volume>& volumes)
    : Airspace(spec.grid) {
  SKEIN_EXPECTS(spec.clearance >= 0 && spec.body_radius >= 0);
  stand_on(terrain, spec.clearance, 0);
  if (spec.body_radius > 0) stand_on(terrain, spec.body_radius, spec.body_radius);
  if (std::isfinite(spec.ceiling)) stay_below(terrain, spec.ceiling);
  for (const Volume& volume : volumes)
    if (volume.when.overlaps(spec.when)) block(volume, spec.body_radius);
}

/// Blocks what is less than `clearance` over the ground within `margin` of its footprint.
void Airspace::stand_on(const Terrain& terrain, double clearance, double margin) {
  const auto is_low = [&](std::int32_t z, const Ground& ground) {
    return grid_.origin.z() + z * grid_.voxel - clearance + kGrazing < ground.highest;
  };
  std::vector<std::int32_t> layers;  // that are too low, of each column
  for (const Ground& ground : ground_below(grid_, terrain, margin))
    layers.push_back(first_layer(grid_, ground.highest + clearance,
                                 [&](std::int32_t z) { return !is_low(z, ground); }));
  block_where(grid_, layers, voxels_, [](std::int32_t z, std::int32_t first) { return z < first; });
}

void Airspace::stay_below(const Terrain& terrain, double ceiling) {
  const auto is_high = [&](std::int32_t z, const Ground& ground) {
    return grid_.origin.z() + (z + 1) * grid_.voxel - ceiling - kGrazing > ground.lowest;
  };
  std::vector<std::int32_t> layers;  // the first that is too high
  for (const Ground& ground : ground_below(grid_, terrain, 0))
    layers.push_back(first_layer(grid_, ground.lowest + ceiling,
                                 [&](std::int32_t z) { return is_high(z, ground); }));
  block_where(grid_, layers, voxels_,
              [](std::int32_t z, std::int32_t first) { return z >= first; });
}

bool Airspace::is_free(std::int32_t x, std::int32_t y, std::int32_t z) const {
  if (x < 0 || y < 0 || z < 0 || x >= grid_.size[0] || y >= grid_.size[1] || z >= grid_.size[2])
    return false;
  return voxels_[grid_.index(x, y, z)] != kBlocked;
}

Vector3 Airspace::centre(const Voxel& voxel) const {
  return grid_.origin + grid_.voxel * Vector3(voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5);
}

std::optional<Voxel> Airspace::voxel_at(const Vector3& point) const {
  Voxel voxel{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double along = (point[k] - grid_.origin[k]) / grid_.voxel;
    if (!(along >= -kSnap && along <= grid_.size[i] + kSnap)) return std::nullopt;
    const auto index = static_cast<std::int32_t>(std::floor(along + kSnap));
    voxel[i] = std::clamp(index, 0, grid_.size[i] - 1);
  }
  return voxel;
}

std::optional<Voxel> Airspace::free_voxel_at(const Vector3& point) const {
  const VoxelWalk walk(grid_, point, point);
  std::size_t found = 0;
  for (unsigned side = 0; side < walk.sides(); ++side)
    if (walk.along(side, [&](std::size_t index, double, double) {
          found = index;
          return voxels_[index] != kBlocked;
        })) {
      const auto width = static_cast<std::size_t>(grid_.size[0]);
      const auto depth = static_cast<std::size_t>(grid_.size[1]);
      return Voxel{static_cast<std::int32_t>(found % width),
                   static_cast<std::int32_t>(found / width % depth),
                   static_cast<std::int32_t>(found / width / depth)};
    }
  return std::nullopt;
}

bool Airspace::is_free(const Vector3& from, const Vector3& to) const {
  const VoxelWalk walk(grid_, from, to);
  for (unsigned side = 0; side < walk.sides(); ++side)
    if (walk.along(side,
                   [&](std::size_t index, double, double) { return voxels_[index] != kBlocked; }))
      return true;
  return false;
}

std::optional<double> Airspace::cost(const Vector3& from, const Vector3& to) const {
  const VoxelWalk walk(grid_, from, to);
  std::optional<double> least;
  for (unsigned side = 0; side < walk.sides(); ++side) {
    double sum = 0;
    if (walk.along(side, [&](std::size_t index, double since, double until) {
          sum += (until - since) * voxels_[index];
          return voxels_[index] != kBlocked;
        }))
      least = std::min(least.value_or(sum), sum);
  }
  if (!least) return std::nullopt;
  return *least * kCostStep * (to - from).norm();
}

}  // namespace skein::world
