// SPDX-License-Identifier: Apache-2.0
#include "skein/world/airspace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ground_below.hpp"
#include "skein/foundation/contract.hpp"
#include "voxel_walk.hpp"
#include "work_clock.hpp"

namespace skein::world {
namespace {

/// What Terrain takes for grazing, and no hit, is above the ground here too [m].
constexpr double kGrazing = 5e-10;

/// So many columns of voxels are closed at a time, at most so many side by side.
constexpr std::size_t kTile = 1U << 16U;
constexpr std::int32_t kTileWidth = 4096;
/// So many voxels are made, or closed, in about a nanosecond.
constexpr std::size_t kMade = 2, kClosed = 8;
/// About what it takes to find which layers of a column are open [ns].
constexpr std::size_t kColumn = 10;

/// The first layer of which something is true that is so of all above it too; about at a height.
template <class IsTrue>
std::int32_t first_layer(const AirspaceGrid& grid, double height, const IsTrue& is_true) {
  const double about = std::floor((height - grid.origin.z()) / grid.voxel);
  auto layer = static_cast<std::int32_t>(std::clamp(about, 0.0, 1.0 * grid.size[2]));
  while (layer > 0 && is_true(layer - 1)) --layer;
  while (layer < grid.size[2] && !is_true(layer)) ++layer;
  return layer;
}

/// Which layers of each column of a tile stay open: [from, until).
struct OpenLayers {
  std::vector<std::int32_t> from, until;
};

void close_where(std::uint8_t* voxels, const std::int32_t* from, const std::int32_t* until,
                 std::size_t count, std::int32_t z) {
  static_assert(Airspace::kBlocked == 0);
  // Without branches, so that many are done at a time.
  for (std::size_t i = 0; i < count; ++i)
    voxels[i] = static_cast<std::uint8_t>(voxels[i] & (z >= from[i] && z < until[i] ? 0xff : 0));
}

/// Closes the voxels of a tile that are not open: below all figures and above them a layer is
/// alike. False once the clock is up.
bool close_all_but(const OpenLayers& open, const AirspaceGrid& grid, const ColumnTile& tile,
                   std::vector<std::uint8_t>& voxels, WorkClock& clock) {
  const auto [from, last_from] = std::minmax_element(open.from.begin(), open.from.end());
  const auto [until, last_until] = std::minmax_element(open.until.begin(), open.until.end());
  // Rows that follow on one another are closed as one.
  const bool whole = tile.columns == grid.size[0];
  const std::size_t length = whole ? tile.count() : static_cast<std::size_t>(tile.columns);
  const std::int32_t runs = whole ? 1 : tile.rows;
  for (std::int32_t z = 0; z < grid.size[2]; ++z) {
    if (z >= *last_from && z < *until) continue;
    const bool alike = z < *from || z >= *last_until;
    for (std::int32_t run = 0; run < runs; ++run) {
      std::uint8_t* row = &voxels[grid.index(tile.x, tile.y + run, z)];
      const std::size_t first = static_cast<std::size_t>(run) * length;
      if (alike)
        std::fill_n(row, length, Airspace::kBlocked);
      else
        close_where(row, &open.from[first], &open.until[first], length, z);
    }
    if (clock.is_up_after(tile.count() / kClosed)) return false;
  }
  return true;
}

/// Calls `close(tile)` for all columns of a grid until it says false; true when it never did.
template <class Close>
bool for_each_tile(const AirspaceGrid& grid, const Close& close) {
  const std::int32_t width = std::min(grid.size[0], kTileWidth);
  const auto depth = static_cast<std::int32_t>(kTile / static_cast<std::size_t>(width));
  for (std::int32_t x = 0; x < grid.size[0]; x += width)
    for (std::int32_t y = 0; y < grid.size[1]; y += depth)
      if (!close({x, y, std::min(width, grid.size[0] - x), std::min(depth, grid.size[1] - y)}))
        return false;
  return true;
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
    : Airspace(std::move(*in_time(spec, terrain, volumes, {}))) {}

std::optional<Airspace> Airspace::in_time(const AirspaceSpec& spec, const Terrain& terrain,
                                          const std::vector<Volume>& volumes,
                                          const std::function<bool()>& time_is_up) {
  SKEIN_EXPECTS(problems_of(spec.grid).empty());
  SKEIN_EXPECTS(spec.clearance >= 0 && spec.body_radius >= 0);
  WorkClock clock(time_is_up);
  std::optional<Airspace> air = Airspace(spec.grid, nullptr, clock);
  const double none = std::numeric_limits<double>::infinity();
  if (!air->stand_on(terrain, {spec.clearance, spec.ceiling, 0}, clock)) return std::nullopt;
  if (spec.body_radius > 0 &&
      !air->stand_on(terrain, {spec.body_radius, none, spec.body_radius}, clock))
    return std::nullopt;
  for (const Volume& volume : volumes)
    if (volume.when.overlaps(spec.when) && !air->block(volume, spec.body_radius, time_is_up))
      return std::nullopt;
  return air;
}

Airspace::Airspace(const AirspaceGrid& grid, const std::uint8_t* voxels, WorkClock& clock)
    : grid_(grid) {
  constexpr std::size_t kPiece = 1U << 20U;
  voxels_.reserve(grid.count());  // which does not touch the memory
  while (voxels_.size() < grid.count() && !clock.is_up_after(kPiece / kMade)) {
    const std::size_t begin = voxels_.size(), piece = std::min(kPiece, grid.count() - begin);
    if (voxels != nullptr)
      voxels_.insert(voxels_.end(), voxels + begin, voxels + begin + piece);
    else
      voxels_.insert(voxels_.end(), piece, kPlain);
  }
}

std::optional<Airspace> Airspace::copied(const std::function<bool()>& time_is_up) const {
  WorkClock clock(time_is_up);
  std::optional<Airspace> copy = Airspace(grid_, voxels_.data(), clock);
  if (copy->voxels_.size() < voxels_.size()) return std::nullopt;
  copy->least_cost_ = least_cost_;
  copy->greatest_cost_ = greatest_cost_;
  return copy;
}

/// Blocks what is less than the clearance over the ground within the margin of its footprint, or
/// above the ceiling. False once the clock is up.
bool Airspace::stand_on(const Terrain& terrain, const Heights& heights, WorkClock& clock) {
  const auto is_low = [&](std::int32_t z, const Ground& ground) {
    return grid_.origin.z() + z * grid_.voxel - heights.clearance + kGrazing < ground.highest;
  };
  const auto is_high = [&](std::int32_t z, const Ground& ground) {
    return grid_.origin.z() + (z + 1) * grid_.voxel - heights.ceiling - kGrazing > ground.lowest;
  };
  const bool has_ceiling = std::isfinite(heights.ceiling);
  GroundBelow below(grid_, terrain, heights.margin);
  OpenLayers open;
  return voxels_.size() == grid_.count() && for_each_tile(grid_, [&](const ColumnTile& tile) {
           open.from.clear();
           open.until.assign(tile.count(), grid_.size[2]);
           for (const Ground& ground : below.of(tile, clock)) {
             open.from.push_back(first_layer(grid_, ground.highest + heights.clearance,
                                             [&](std::int32_t z) { return !is_low(z, ground); }));
             if (has_ceiling)
               open.until[open.from.size() - 1] =
                   first_layer(grid_, ground.lowest + heights.ceiling,
                               [&](std::int32_t z) { return is_high(z, ground); });
           }
           return !clock.is_up_after(tile.count() * kColumn) &&
                  close_all_but(open, grid_, tile, voxels_, clock);
         });
}

std::optional<Voxel> voxel_at(const AirspaceGrid& grid, const Vector3& point) {
  Voxel voxel{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double along = (point[k] - grid.origin[k]) / grid.voxel;
    if (!(along >= -Airspace::kSnap && along <= grid.size[i] + Airspace::kSnap))
      return std::nullopt;
    const auto index = static_cast<std::int32_t>(std::floor(along + Airspace::kSnap));
    voxel[i] = std::clamp(index, 0, grid.size[i] - 1);
  }
  return voxel;
}

bool Airspace::is_free(std::int32_t x, std::int32_t y, std::int32_t z) const {
  if (x < 0 || y < 0 || z < 0 || x >= grid_.size[0] || y >= grid_.size[1] || z >= grid_.size[2])
    return false;
  return voxels_[grid_.index(x, y, z)] != kBlocked;
}

Vector3 Airspace::centre(const Voxel& voxel) const {
  return grid_.origin + grid_.voxel * Vector3(voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5);
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
