// SPDX-License-Identifier: Apache-2.0
// Random airspaces and an independent search on their way-point graph, for tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners::testing {

inline world::AirspaceGrid cube(std::int32_t side, double voxel = 1) {
  world::AirspaceGrid grid;
  grid.voxel = voxel;
  grid.size = {side, side, side};
  return grid;
}

/// Of how the voxels of a random world are blocked and what the others cost.
struct Mixture {
  double blocked = 0.35;   ///< of single voxels
  int boxes = 0;           ///< of blocked voxels besides
  double dear = 0;         ///< of the free ones that cost more than 1
  unsigned dearest = 255;  ///< in sixteenths
};

inline world::Airspace random_world(Random& random, const world::AirspaceGrid& grid,
                                    const Mixture& mixture) {
  std::vector<std::uint8_t> voxels(grid.count(), world::Airspace::kPlain);
  for (std::uint8_t& voxel : voxels) {
    if (random.chance(mixture.dear))
      voxel = static_cast<std::uint8_t>(16 + random.below(mixture.dearest - 15));
    if (random.chance(mixture.blocked)) voxel = world::Airspace::kBlocked;
  }
  for (int i = 0; i < mixture.boxes; ++i) {
    world::Voxel low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(grid.size[k])));
      high[k] = std::min(grid.size[k], low[k] + 1 + static_cast<std::int32_t>(random.below(8)));
    }
    for (std::int32_t z = low[2]; z < high[2]; ++z)
      for (std::int32_t y = low[1]; y < high[1]; ++y)
        for (std::int32_t x = low[0]; x < high[0]; ++x)
          voxels[grid.index(x, y, z)] = world::Airspace::kBlocked;
  }
  return {grid, std::move(voxels)};
}

inline world::Voxel free_voxel(const world::Airspace& airspace, Random& random) {
  world::Voxel voxel{};
  do {
    for (std::size_t i = 0; i < 3; ++i)
      voxel[i] = static_cast<std::int32_t>(
          random.below(static_cast<std::uint64_t>(airspace.grid().size[i])));
  } while (!airspace.is_free(voxel));
  return voxel;
}

/// Dijkstra's search over the centres of facets, as the definition has it: each facet is a point in
/// half voxels; two of one voxel are joined at their distance times its crossing cost, and so are
/// the centres of the first and the last voxel with their facets. In floating point, with all ten
/// neighbours, no heuristic.
class PlainDijkstra {
 public:
  explicit PlainDijkstra(const world::Airspace& airspace) : airspace_(airspace) {
    for (std::size_t i = 0; i < 3; ++i)
      span_[i] = 2 * static_cast<std::size_t>(airspace.grid().size[i]) + 1;
  }

  /// [m × cost]
  std::optional<double> cost(const world::Voxel& from, const world::Voxel& to) {
    costs_.assign(span_[0] * span_[1] * span_[2], kFar);
    reach(centre(from), 0);
    while (!open_.empty()) {
      const auto [cost, point] = open_.top();
      open_.pop();
      if (cost > costs_[index(point)]) continue;
      if (point == centre(to)) {
        open_ = {};
        return cost;
      }
      for (const world::Voxel& voxel : voxels_of(point)) relax(point, voxel, to, cost);
    }
    return std::nullopt;
  }

 private:
  using Point = std::array<std::int32_t, 3>;
  static constexpr double kFar = 1e300;

  static Point centre(const world::Voxel& voxel) {
    return {2 * voxel[0] + 1, 2 * voxel[1] + 1, 2 * voxel[2] + 1};
  }
  std::size_t index(const Point& point) const {
    return (static_cast<std::size_t>(point[2]) * span_[1] + static_cast<std::size_t>(point[1])) *
               span_[0] +
           static_cast<std::size_t>(point[0]);
  }

  /// The one or two free voxels that a point is in or on.
  std::vector<world::Voxel> voxels_of(const Point& point) const {
    std::vector<world::Voxel> voxels;
    for (const int side : {0, 1}) {
      world::Voxel voxel{};
      bool facet = false;
      for (std::size_t i = 0; i < 3; ++i) {
        facet = facet || point[i] % 2 == 0;
        voxel[i] = point[i] % 2 == 0 ? point[i] / 2 - side : (point[i] - 1) / 2;
      }
      if ((facet || side == 0) && airspace_.is_free(voxel)) voxels.push_back(voxel);
    }
    return voxels;
  }

  void relax(const Point& point, const world::Voxel& voxel, const world::Voxel& to, double cost) {
    const auto& grid = airspace_.grid();
    const double rate =
        airspace_.voxels()[grid.index(voxel[0], voxel[1], voxel[2])] / 16.0 * grid.voxel / 2;
    const auto go = [&](const Point& next) {
      double squares = 0;
      for (std::size_t i = 0; i < 3; ++i) squares += (next[i] - point[i]) * (next[i] - point[i]);
      reach(next, cost + rate * std::sqrt(squares));
    };
    for (std::size_t i = 0; i < 3; ++i)
      for (const int side : {-1, 1}) {
        Point next = centre(voxel);
        next[i] += side;
        go(next);
      }
    if (voxel == to) go(centre(voxel));
  }

  void reach(const Point& point, double cost) {
    if (cost >= costs_[index(point)]) return;
    costs_[index(point)] = cost;
    open_.emplace(cost, point);
  }

  const world::Airspace& airspace_;
  std::array<std::size_t, 3> span_{};
  std::vector<double> costs_;
  using Entry = std::pair<double, Point>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

/// Whether points every hundredth of a voxel along the way are all in free voxels or on their
/// faces, by rounding alone: not by the walk of Airspace::is_free.
inline bool samples_are_free(const world::Airspace& airspace, const Way& way) {
  const auto& grid = airspace.grid();
  const auto free_at = [&](const world::Vector3& point) {
    for (int corner = 0; corner < 8; ++corner) {
      world::Voxel voxel{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double nudge = (corner >> i & 1) != 0 ? 1e-6 : -1e-6;
        voxel[i] =
            static_cast<std::int32_t>(std::floor((point[k] - grid.origin[k]) / grid.voxel + nudge));
      }
      if (airspace.is_free(voxel)) return true;
    }
    return false;
  };
  for (std::size_t i = 1; i < way.size(); ++i) {
    const world::Vector3 step = way[i] - way[i - 1];
    const int count = 1 + static_cast<int>(step.norm() / grid.voxel * 100);
    for (int k = 0; k <= count; ++k)
      if (!free_at(way[i - 1] + step * k / count)) return false;
  }
  return true;
}

}  // namespace skein::refiners::testing
