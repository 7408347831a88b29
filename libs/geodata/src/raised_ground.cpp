// SPDX-License-Identifier: Apache-2.0
#include "raised_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "raster_sampler.hpp"

namespace skein::geodata {
namespace {

using world::GeodeticPoint;
using world::TerrainSpec;
using world::Vector2;
using world::Vector3;

/// Posts between two whose place is computed exactly: as straight as the Earth is there.
constexpr int kStride = 4;
constexpr double kHigh = 1000;    // [m], the second height at which those are
constexpr double kEnough = 1e-6;  // [m]

/// Where the posts of one row are in the local frame; NaN without data.
class PostRow {
 public:
  PostRow(const RasterSampler& sampler, const Raster& raster, const geodesy::GeodeticFrame& frame)
      : sampler_(sampler), raster_(raster), frame_(frame) {}

  std::vector<Vector3> at(int row) const {
    const int pieces = (sampler_.columns() + kStride - 1) / kStride;
    std::vector<Vector2> places;
    for (int k = 0; k <= pieces; ++k) places.push_back(sampler_.place(k * kStride, row));
    std::vector<GeodeticPoint> points = raster_.points_at(places);
    std::vector<Vector3> low, high;
    for (GeodeticPoint& point : points) {
      point.altitude = 0;
      low.push_back(frame_.to_local(point));
      point.altitude = kHigh;
      high.push_back(frame_.to_local(point));
    }
    std::vector<Vector3> posts;
    for (int i = 0; i < sampler_.columns(); ++i) {
      const auto k = static_cast<std::size_t>(i / kStride);
      const double part = static_cast<double>(i % kStride) / kStride;
      const double height = sampler_.post(i, row) / kHigh;
      const Vector3 ground = low[k] + part * (low[k + 1] - low[k]);
      const Vector3 above = high[k] + part * (high[k + 1] - high[k]);
      posts.emplace_back(ground + height * (above - ground));
    }
    return posts;
  }

 private:
  const RasterSampler& sampler_;
  const Raster& raster_;
  const geodesy::GeodeticFrame& frame_;
};

class Raiser {
 public:
  explicit Raiser(TerrainSpec& terrain)
      : terrain_(terrain),
        corners_(world::corners_of(terrain)),
        low_(terrain.west, terrain.south) {}

  void above(const Vector3& post) {
    if (!post.allFinite()) return;
    const double u = (post.x() - low_.x()) / terrain_.cell,
                 v = (post.y() - low_.y()) / terrain_.cell;
    const auto columns = static_cast<double>(corners_.columns - 1);
    const auto rows = static_cast<double>(corners_.rows - 1);
    if (!(u >= 0 && v >= 0 && u <= columns && v <= rows)) return;
    const double column = std::min(std::floor(u), columns - 1);
    const double row = std::min(std::floor(v), rows - 1);
    const double east = u - column, north = v - row;
    const std::array<double, 4> weights = {(1 - east) * (1 - north), east * (1 - north),
                                           (1 - east) * north, east * north};
    const std::size_t first =
        static_cast<std::size_t>(row) * corners_.columns + static_cast<std::size_t>(column);
    const std::array<std::size_t, 4> around = {first, first + 1, first + corners_.columns,
                                               first + corners_.columns + 1};
    double missing = post.z(), squares = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      missing -= weights[i] * terrain_.elevations[around[i]];
      squares += weights[i] * weights[i];
    }
    if (missing <= kEnough) return;
    for (std::size_t i = 0; i < 4; ++i)
      terrain_.elevations[around[i]] += missing * weights[i] / squares;
  }

  /// Where the line between two posts crosses the lines of the grid.
  void above(const Vector3& a, const Vector3& b) {
    if (!a.allFinite() || !b.allFinite()) return;
    for (const Eigen::Index axis : {0, 1}) {
      const double from = (a[axis] - low_[axis]) / terrain_.cell;
      const double to = (b[axis] - low_[axis]) / terrain_.cell;
      const double last = std::floor(std::max(from, to));
      for (double line = std::ceil(std::min(from, to)); line <= last && from != to; ++line)
        above(a + (line - from) / (to - from) * (b - a));
    }
  }

 private:
  TerrainSpec& terrain_;
  world::TerrainCorners corners_;
  Vector2 low_;
};

}  // namespace

Raised raise_above(TerrainSpec& terrain, const RasterSampler& sampler, const Raster& raster,
                   const geodesy::GeodeticFrame& frame) {
  const std::vector<double> sampled = terrain.elevations;
  const PostRow row(sampler, raster, frame);
  Raiser raiser(terrain);
  std::vector<Vector3> before;
  for (int r = 0; r < sampler.rows(); ++r) {
    const std::vector<Vector3> posts = row.at(r);
    for (std::size_t c = 0; c < posts.size(); ++c) {
      raiser.above(posts[c]);
      if (c > 0) raiser.above(posts[c - 1], posts[c]);
      if (!before.empty()) raiser.above(before[c], posts[c]);
    }
    before = posts;
  }
  Raised raised;
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    const double by = terrain.elevations[i] - sampled[i];
    raised.most = std::max(raised.most, by);
    raised.mean += by / static_cast<double>(sampled.size());
  }
  return raised;
}

}  // namespace skein::geodata
