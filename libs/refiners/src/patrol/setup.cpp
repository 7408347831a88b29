// SPDX-License-Identifier: Apache-2.0
#include "patrol/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/shared_checks.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Links among more pieces would need too much memory.
constexpr std::size_t kMostBlocks = 3000;
constexpr double kChordTolerance = 0.5;  ///< of curves [m]
/// About what it takes to look at the ground at a place, and whether a curve is open [ns].
constexpr std::uint32_t kElevations = 100, kCurve = 5000;

tl::unexpected<Refusal> out_of_time() {
  return refuse(RefusalKind::kBudgetExhausted, "",
                "the time was up before any patrol of the zone was planned");
}

Refusal beyond(std::string field, std::string why) {
  return {RefusalKind::kBeyondVehicle, std::move(field), std::move(why)};
}

std::optional<Refusal> check_ground(const world::GroundState& ground) {
  const world::Grid& grid = ground.grid;
  if (grid.size() == 0) return bad("world.ground", "there is no ground grid to patrol");
  if (auto problem = check_positive(grid.cell, "world.ground.cell")) return problem;
  if (!std::isfinite(grid.west) || !std::isfinite(grid.south))
    return bad("world.ground", "its corner must be a finite point");
  if (grid.columns > kMostGroundCells || grid.rows > kMostGroundCells ||
      grid.size() > kMostGroundCells)
    return bad("world.ground", std::to_string(grid.columns) + " × " + std::to_string(grid.rows) +
                                   " cells are more than 4 million");
  if (!ground.risk.empty() && ground.risk.size() != grid.size())
    return bad("world.ground.risk", std::to_string(ground.risk.size()) + " figures for " +
                                        std::to_string(grid.size()) + " cells");
  const auto wrong = std::find_if(ground.risk.begin(), ground.risk.end(),
                                  [](double risk) { return !(risk >= 0 && risk <= 1); });
  if (wrong == ground.risk.end()) return std::nullopt;
  return bad("world.ground.risk", "cell " + std::to_string(wrong - ground.risk.begin()) + ": " +
                                      figure(*wrong) + " is not in [0, 1]");
}

std::optional<Refusal> check_figures(const PatrolQuery& query) {
  for (const auto& [value, field] :
       {std::pair{query.altitude, "altitude"}, std::pair{query.footprint, "footprint"},
        std::pair{query.duration.to_seconds(), "duration"},
        std::pair{query.time_scale.to_seconds(), "time_scale"},
        std::pair{query.least_risk, "least_risk"}})
    if (auto problem = check_positive(value, field)) return problem;
  if (query.least_risk > 1) return bad("least_risk", figure(query.least_risk) + " is more than 1");
  if (!std::isfinite(query.heading)) return bad("heading", "must be a finite number");
  if (!(query.speed >= 0) || !std::isfinite(query.speed))
    return bad("speed", figure(query.speed) + " is not a speed: 0 (cruise) or more");
  return check_finite(query.start, "start");
}

std::optional<Refusal> check_abilities(const PatrolQuery& query) {
  const world::VehicleModel& vehicle = query.vehicle;
  if (query.speed > vehicle.max_speed)
    return beyond("speed", figure(query.speed) + " m/s; at most " + figure(vehicle.max_speed));
  if (query.speed > 0 && query.speed < vehicle.min_speed)
    return beyond("speed", figure(query.speed) + " m/s; at least " + figure(vehicle.min_speed));
  if (query.altitude > vehicle.ceiling)
    return beyond("altitude", figure(query.altitude) + " m over the ground; the ceiling is " +
                                  figure(vehicle.ceiling) + " m");
  if (query.mode == PatrolMode::kGradient && !vehicle.hovers)
    return beyond("mode",
                  "the gradient turns on the spot from cell to cell: the vehicle must hover");
  return std::nullopt;
}

std::optional<Refusal> check_sizes(const PatrolQuery& query, const world::Grid& grid) {
  if (query.footprint < grid.cell / 2)
    return bad("footprint", figure(query.footprint) +
                                " m is less than half a cell of the ground (" + figure(grid.cell) +
                                " m)");
  const double cells = query.duration.to_seconds() * patrol_speed(query) / grid.cell;
  if (cells <= kMostCellsFlown) return std::nullopt;
  return bad("duration", "the vehicle would fly over " + figure(cells) + " cells; at most " +
                             figure(kMostCellsFlown));
}

struct Band {
  double low, high;
};

/// Heights that the vehicle may be at over a polygon.
Band heights_over(const world::Polygon& polygon, const PatrolQuery& query,
                  const world::Terrain& terrain, Deadline& deadline) {
  const double step = terrain.spec().cell;
  Vector2 low = polygon.front(), high = polygon.front();
  for (const Vector2& corner : polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const world::TerrainSpec& spec = terrain.spec();
  low = low.cwiseMax(Vector2(spec.west, spec.south)).cwiseMin(Vector2(spec.east, spec.north));
  high = high.cwiseMin(Vector2(spec.east, spec.north)).cwiseMax(low);
  double lowest = kInfinity, steepest = 0;
  for (double y = low.y() - step; y <= high.y() + 2 * step && !deadline.is_over(); y += step)
    for (double x = low.x() - step; x <= high.x() + 2 * step; x += step) {
      if (deadline.passed_after(kElevations)) break;
      lowest = std::min(lowest, terrain.elevation(x, y));
      steepest = std::max(steepest, std::tan(terrain.slope(x, y)));
    }
  // A slope within a cell may be steeper than at the points looked at, the ground lower.
  const double slack = kHeightTolerance * query.altitude + (steepest > 0 ? 2 * step * steepest : 0);
  return {lowest + query.altitude - slack, terrain.highest() + query.altitude + slack};
}

/// Blocks of the part of the network that is reached from the start and holds most cells. Within it
/// every block is flown either way and every sequence of them can be flown.
std::vector<bool> reached(const PatrolGround& ground, const Vector2& start, double heading,
                          Deadline& deadline) {
  const auto visits = static_cast<Visit>(2 * ground.blocks.size());
  std::vector<bool> known(visits, false), best(ground.blocks.size(), false);
  std::size_t most = 0;
  for (Visit from = 0; from < visits; ++from) {
    if (deadline.passed_after(kCurve)) break;
    if (known[from] || ground.links->cost_from(start, heading, from) == kInfinity) continue;
    known[from] = true;
    if (deadline.passed()) break;
    if (!ground.links->leads_there_and_back(from, from ^ 1U)) continue;
    std::vector<bool> part(ground.blocks.size(), false);
    std::size_t cells = 0;
    for (Visit to = 0; to < visits; to += 2) {
      if (!ground.links->leads_there_and_back(from, to) ||
          !ground.links->leads_there_and_back(from, to + 1))
        continue;
      known[to] = known[to + 1] = part[to / 2] = true;
      cells += ground.blocks[to / 2].cells.size();
    }
    if (cells <= most) continue;
    most = cells;
    best = part;
  }
  return best;
}

}  // namespace

double patrol_speed(const PatrolQuery& query) {
  return query.speed > 0 ? query.speed : query.vehicle.cruise_speed;
}

HeightRule height_rule(const PatrolQuery& query) {
  const double speed = patrol_speed(query);
  return {query.altitude, query.vehicle.climb_rate / speed, query.vehicle.descent_rate / speed};
}

std::optional<Refusal> check_patrol(const PatrolQuery& query, const world::World& world) {
  if (auto problem = check_vehicle(query.vehicle)) return problem;
  if (auto problem = check_figures(query)) return problem;
  if (auto problem = check_polygon(query.zone, "zone")) return problem;
  if (auto problem = check_ground(world.ground)) return problem;
  if (auto problem = check_sizes(query, world.ground.grid)) return problem;
  if (auto problem = check_abilities(query)) return problem;
  if (query.start.z() < world.terrain.elevation(query.start.x(), query.start.y()))
    return Refusal{RefusalKind::kBlocked, "start", "it is below the ground"};
  return std::nullopt;
}

std::vector<world::Polygon> closed_volumes(const PatrolQuery& query, const world::World& world,
                                           Deadline& deadline) {
  const world::TimeWindow when{query.depart, query.depart + query.duration};
  std::vector<world::Polygon> closed;
  for (const world::Volume& volume : world.volumes) {
    if (volume.polygon.size() < 3 || !volume.when.overlaps(when)) continue;
    const Band band = heights_over(volume.polygon, query, world.terrain, deadline);
    if (volume.floor <= band.high && volume.ceiling >= band.low) closed.push_back(volume.polygon);
  }
  return closed;
}

Result<std::unique_ptr<PatrolGround>, Refusal> make_patrol_ground(const PatrolQuery& query,
                                                                  const world::World& world,
                                                                  Deadline& deadline) {
  std::unique_ptr<PatrolGround> ground(new PatrolGround{
      PatrolSpace(query.zone, closed_volumes(query, world, deadline)),
      PatrolSight(world.terrain, world.ground.grid, query.altitude, query.footprint, deadline),
      {},
      {},
      {}});
  const Vector2 start = query.start.head<2>();
  if (!ground->space.is_clear(start))
    return refuse(RefusalKind::kBlocked, "start", "it is in a volume that is closed");
  ground->field = make_patrol_field(ground->space, ground->sight, query.zone, world.ground.risk,
                                    query.least_risk);
  if (deadline.passed()) return out_of_time();
  if (ground->field.cells.empty() && ground->field.hidden == 0)
    return refuse(RefusalKind::kBadQuery, "zone", "no cell of the ground has its centre in it");
  if (ground->field.cells.empty())
    return refuse(
        RefusalKind::kNotPerceivable, "zone",
        "none of its " + std::to_string(ground->field.hidden) + " cells can be perceived");
  const double radius = query.vehicle.hovers ? 0 : query.vehicle.min_turn_radius;
  const bool plain = radius == 0 && ground->space.is_simple();
  ground->blocks =
      make_patrol_blocks(ground->field, ground->space, ground->sight,
                         {.straight = radius > 0, .most_blocks = plain ? 1024U : 384U});
  if (deadline.passed()) return out_of_time();
  if (ground->blocks.size() > kMostBlocks)
    return refuse(RefusalKind::kBadQuery, "zone",
                  "too ragged for its footprint: " + std::to_string(ground->blocks.size()) +
                      " pieces of lanes; at most " + std::to_string(kMostBlocks));
  const auto link = [&] {
    ground->links =
        std::make_unique<PatrolLinks>(ground->blocks, ground->space, radius, kChordTolerance);
    return ground->links->prepare(deadline);
  };
  if (!link()) return out_of_time();
  const std::vector<bool> keep = reached(*ground, start, query.heading, deadline);
  if (deadline.passed()) return out_of_time();
  if (std::find(keep.begin(), keep.end(), true) == keep.end())
    return refuse(
        RefusalKind::kUnreachable, "start",
        "no straight way or curve leads from it to the zone clear of what is closed, with "
        "room to turn back");
  if (std::find(keep.begin(), keep.end(), false) != keep.end()) {
    leave_only(ground->field, ground->blocks, keep);
    if (!link()) return out_of_time();
  }
  return ground;
}

}  // namespace skein::refiners
