// SPDX-License-Identifier: Apache-2.0
// For the tests and the bench of patrol: a naive simulator, the lawn mower, and maps of risk.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/refiners/patrol.hpp"

namespace skein::refiners::testing {

/// Idleness along a way, by small steps; independent of the refiner.
struct NaiveFigures {
  double worst = 0, worst_risk = 0, mean = 0;
  std::size_t unseen = 0;
};

/// What a naive simulation is told.
struct NaiveFlight {
  double speed = 1;
  double footprint = 1;
  double from = 0;     ///< figures count from then on [s]
  double step = 0.25;  ///< [s]
  double least_risk = 0.05;
};

class NaivePatrol {
 public:
  NaivePatrol(const world::GroundState& ground, std::vector<std::size_t> cells,
              const NaiveFlight& flight)
      : ground_(ground),
        cells_(std::move(cells)),
        flight_(flight),
        idle_(cells_.size(), 0),
        seen_(cells_.size(), false) {}

  NaiveFigures fly(const Way& way) {
    for (std::size_t i = 1; i < way.size(); ++i) {
      const world::Vector2 leg = (way[i] - way[i - 1]).head<2>();
      const int steps = static_cast<int>(std::ceil(leg.norm() / (flight_.speed * flight_.step)));
      for (int k = 1; k <= steps; ++k)
        step(way[i - 1].head<2>() + static_cast<double>(k) / steps * leg,
             leg.norm() / flight_.speed / steps);
    }
    NaiveFigures figures = figures_;
    figures.mean = counted_ > 0 ? weighted_ / counted_ : 0;
    figures.unseen = static_cast<std::size_t>(std::count(seen_.begin(), seen_.end(), false));
    return figures;
  }

 private:
  double risk(std::size_t i) const {
    return std::max(flight_.least_risk, ground_.risk.empty() ? 0.5 : ground_.risk[cells_[i]]);
  }

  void step(const world::Vector2& at, double dt) {
    now_ += dt;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      idle_[i] += dt;
      const bool counts = now_ > flight_.from;
      if (counts) {
        figures_.worst = std::max(figures_.worst, idle_[i]);
        figures_.worst_risk = std::max(figures_.worst_risk, risk(i) * idle_[i]);
      }
      if ((ground_.grid.centre(cells_[i]) - at).squaredNorm() <=
          flight_.footprint * flight_.footprint) {
        idle_[i] = 0;
        seen_[i] = true;
      }
      if (counts) {
        weighted_ += risk(i) * idle_[i] * dt;
        counted_ += risk(i) * dt;
      }
    }
  }

  const world::GroundState& ground_;
  std::vector<std::size_t> cells_;
  NaiveFlight flight_;
  std::vector<double> idle_;
  std::vector<bool> seen_;
  NaiveFigures figures_;
  double now_ = 0, weighted_ = 0, counted_ = 0;
};

inline std::vector<std::size_t> cells_in(const world::Grid& grid, const world::Polygon& zone) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < grid.size(); ++cell)
    if (world::contains(zone, grid.centre(cell))) cells.push_back(cell);
  return cells;
}

/// The lawn mower over a rectangle of width × height from the origin: lanes there and back, at most
/// two footprints apart, then straight to where it began, until `length` metres are flown.
/// `cell`: the lanes end where they just perceive the last cells of that side, of the row farthest
/// from its lane: with lanes that are no whole number of rows apart that is farther than half of
/// what lies between a lane's outer rows.
inline Way lawn_mower(double width, double height, double footprint, double cell, double length) {
  const auto lanes = static_cast<int>(std::ceil(height / (2 * footprint) - 1e-9));
  const double spacing = height / lanes;
  double aside = 0;
  for (double y = cell / 2; y < height; y += cell) {
    const double lane = (std::min<double>(std::floor(y / spacing), lanes - 1) + 0.5) * spacing;
    aside = std::max(aside, std::abs(y - lane));
  }
  const double ahead = std::sqrt(std::max(0.0, footprint * footprint - aside * aside));
  const double end = std::min(spacing / 2, cell / 2 + 0.9 * ahead);
  Way round;
  for (int i = 0; i < lanes; ++i) {
    const double y = (i + 0.5) * spacing;
    const double west = end, east = width - end;
    round.emplace_back(i % 2 == 0 ? west : east, y, 0);
    round.emplace_back(i % 2 == 0 ? east : west, y, 0);
  }
  Way way = {round.front()};
  for (double flown = 0; flown < length;)
    for (std::size_t i = 1; i <= round.size(); ++i) {
      const world::Vector3& to = round[i % round.size()];
      flown += (to - way.back()).norm();
      way.push_back(to);
    }
  return way;
}

/// `peaks` round peaks of random place, width (5 to 15 % of the side) and height, the highest of
/// risk 1, on a ground of 0.05; 0 peaks: 0.5 everywhere.
inline world::GroundState peaked_ground(std::size_t side, double cell, int peaks,
                                        std::uint64_t seed) {
  world::GroundState ground;
  ground.grid = {.west = 0, .south = 0, .cell = cell, .columns = side, .rows = side};
  ground.risk.assign(side * side, peaks == 0 ? 0.5 : 0.05);
  Random random(seed);
  const double extent = cell * static_cast<double>(side);
  for (int p = 0; p < peaks; ++p) {
    const world::Vector2 top(random.uniform(0, extent), random.uniform(0, extent));
    const double width = random.uniform(0.05, 0.15) * extent;
    const double height = p == 0 ? 0.95 : random.uniform(0.5, 0.95);
    for (std::size_t i = 0; i < ground.risk.size(); ++i)
      ground.risk[i] +=
          height * std::exp(-(ground.grid.centre(i) - top).squaredNorm() / (2 * width * width));
  }
  for (double& risk : ground.risk) risk = std::min(1.0, risk);
  return ground;
}

/// As maps of where fires were: some hundreds of them, most in clusters of random place and spread,
/// the others anywhere; risk is their density over two cells, 1 where it is greatest.
inline world::GroundState scattered_ground(std::size_t side, double cell, std::uint64_t seed) {
  world::GroundState ground = peaked_ground(side, cell, 0, seed);
  std::fill(ground.risk.begin(), ground.risk.end(), 0.0);
  Random random(seed, "scattered");
  const double extent = cell * static_cast<double>(side);
  std::vector<world::Vector2> fires;
  for (int cluster = 0; cluster < 12; ++cluster) {
    const world::Vector2 at(random.uniform(0, extent), random.uniform(0, extent));
    const double spread = random.uniform(0.02, 0.12) * extent;
    for (int i = 0; i < 30; ++i)
      fires.emplace_back(at +
                         spread * world::Vector2(random.uniform(-1, 1), random.uniform(-1, 1)));
  }
  for (int i = 0; i < 120; ++i)
    fires.emplace_back(random.uniform(0, extent), random.uniform(0, extent));
  for (std::size_t i = 0; i < ground.risk.size(); ++i)
    for (const world::Vector2& fire : fires)
      ground.risk[i] +=
          std::exp(-(ground.grid.centre(i) - fire).squaredNorm() / (2 * 4 * cell * cell));
  const double most = *std::max_element(ground.risk.begin(), ground.risk.end());
  for (double& risk : ground.risk) risk /= most;
  return ground;
}

}  // namespace skein::refiners::testing
