// SPDX-License-Identifier: Apache-2.0
// Detection and mapping, by the footprint of the sensor over the ground from where it really flew.
#include <algorithm>
#include <cmath>
#include <limits>

#include "checks.hpp"
#include "skein/world/segment.hpp"
#include "skein/world/sensor_model.hpp"
#include "statement.hpp"

namespace skein::laws {

namespace {

constexpr double kConeStep = 0.5;     ///< [s]
constexpr double kDetectPart = 0.85;  ///< of the time asked: turns beyond the zone's edge count not

/// The middle points of square cells over a zone, on the ground.
std::vector<world::Vector3> cells_of(const History& history, const world::Polygon& zone,
                                     double side) {
  world::Vector2 low = zone.front(), high = zone.front();
  for (const world::Vector2& corner : zone) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  std::vector<world::Vector3> cells;
  for (double x = low.x() + side / 2; x < high.x(); x += side) {
    for (double y = low.y() + side / 2; y < high.y(); y += side) {
      if (!world::contains(zone, {x, y})) continue;
      cells.emplace_back(x, y, history.terrain.elevation(x, y));
    }
  }
  return cells;
}

std::optional<world::View> view_at(const Uav& uav, const Activity& look, double t) {
  const world::SensorModel* sensor = world::find_sensor(uav.spec->model, look.device);
  const auto sample = uav.at(t);
  if (sensor == nullptr || !sample || !sample->airborne) return std::nullopt;
  const world::Vector3 axis = sensor->gimballed && look.target
                                  ? world::Vector3((*look.target - sample->position).normalized())
                                  : world::direction_of(sample->heading, sensor->boresight_pitch);
  return world::View{sample->position, axis, sensor->range, sensor->aperture};
}

/// The goal, and the parts of it that the UAV gave itself: "map-part Z2 0.5 701".
std::vector<std::int64_t> with_parts(const Uav& uav, const Goal& goal) {
  std::vector<std::int64_t> all{goal.id};
  for (const auto& [id, other] : uav.goals) {
    if (other.task.name != "map-part" || other.task.arguments.size() != 3) continue;
    const auto whole = number_of(other.task.arguments[2]);
    if (whole && std::llround(*whole) == goal.id) all.push_back(id);
  }
  return all;
}

std::vector<Look> looks_of(const Uav& uav, const Goal& goal) {
  std::vector<Look> looks;
  for (const std::int64_t part : with_parts(uav, goal)) {
    for (const Activity* look : uav.activities_of(part)) {
      if (look->looks()) looks.push_back({&uav, look});
    }
  }
  return looks;
}

template <class See>
void along(const History& history, const std::vector<Look>& looks, const See& see) {
  for (const auto& [uav, look] : looks) {
    for (double t = look->from; t < std::min(look->until, history.end); t += kConeStep) {
      if (const auto view = view_at(*uav, *look, t)) see(*view);
    }
  }
}

double seconds_over(const History& history, const Uav& uav, const Goal& goal,
                    const std::vector<world::Vector3>& cells) {
  double seconds = 0;
  along(history, looks_of(uav, goal), [&](const world::View& view) {
    const bool sees = std::any_of(cells.begin(), cells.end(), [&](const world::Vector3& cell) {
      return world::in_view(view, cell);
    });
    if (sees) seconds += kConeStep;
  });
  return seconds;
}

/// Of the middle points of cells over a zone.
double side_of_cells(const world::Polygon& zone) {
  return std::max(3.0, std::sqrt(world::area(zone) / 1500));
}

/// Which of the cells were in view during one of `looks`.
std::vector<bool> cells_seen(const History& history, const std::vector<Look>& looks,
                             const std::vector<world::Vector3>& cells) {
  std::vector<bool> seen(cells.size(), false);
  along(history, looks, [&](const world::View& view) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!seen[i] && world::in_view(view, cells[i])) seen[i] = true;
    }
  });
  return seen;
}

/// How far beside the way of the view it lies; ahead of one that looks straight down is everywhere.
double beside(const world::View& view, const world::Vector3& cell) {
  constexpr double kLooksDown = 0.05;
  const world::Vector2 ahead = view.direction.head<2>(), off = (cell - view.viewpoint).head<2>();
  if (ahead.norm() < kLooksDown) return off.norm();
  return std::abs(off.x() * ahead.y() - off.y() * ahead.x()) / ahead.norm();
}

/// How far to the side cells were in view at the most [m].
double reach_of(const History& history, const std::vector<Look>& looks,
                const std::vector<world::Vector3>& cells) {
  double reach = 0;
  along(history, looks, [&](const world::View& view) {
    for (const world::Vector3& cell : cells) {
      const double side = beside(view, cell);
      if (side > reach && world::in_view(view, cell)) reach = side;
    }
  });
  return reach;
}

double to_border(const world::Polygon& zone, const world::Vector3& cell) {
  const world::Vector2 at = cell.head<2>();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zone.size(); ++i)
    least = std::min(least, world::to_segment(at, zone[i], zone[(i + 1) % zone.size()]));
  return least;
}

/// How many of the marked cells lie in a disc of that radius within the zone, all of which is
/// marked.
double in_marked_discs(const world::Polygon& zone, const std::vector<world::Vector3>& cells,
                       const std::vector<bool>& marked, double radius) {
  const auto near = [&](std::size_t i, std::size_t j) {
    return (cells[i] - cells[j]).head<2>().norm() <= radius;
  };
  std::vector<bool> in_disc(cells.size(), false);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    bool whole = marked[i] && to_border(zone, cells[i]) >= radius;
    for (std::size_t j = 0; whole && j < cells.size(); ++j) whole = marked[j] || !near(i, j);
    for (std::size_t j = 0; whole && j < cells.size(); ++j)
      if (near(i, j)) in_disc[j] = true;
  }
  return static_cast<double>(std::count(in_disc.begin(), in_disc.end(), true));
}

}  // namespace

double part_in_view(const History& history, const std::vector<Look>& looks,
                    const world::Polygon& zone) {
  const std::vector<bool> seen =
      cells_seen(history, looks, cells_of(history, zone, side_of_cells(zone)));
  const auto count = std::count(seen.begin(), seen.end(), true);
  return seen.empty() ? 1 : static_cast<double>(count) / static_cast<double>(seen.size());
}

double part_mapped_twice(const History& history, const std::vector<Look>& some,
                         const std::vector<Look>& others, const world::Polygon& zone) {
  constexpr double kCells = 1.5;  // what the middle points of cells are off at both sides
  const double side = side_of_cells(zone);
  const std::vector<world::Vector3> cells = cells_of(history, zone, side);
  std::vector<bool> both = cells_seen(history, some, cells);
  const std::vector<bool> other = cells_seen(history, others, cells);
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] && other[i];
  if (std::none_of(both.begin(), both.end(), [](bool it) { return it; })) return 0;
  const double border = reach_of(history, some, cells) + reach_of(history, others, cells);
  return in_marked_discs(zone, cells, both, border / 2 + kCells * side) /
         static_cast<double>(cells.size());
}

std::optional<double> seconds_detected(const History& history, const Uav& uav, const Goal& goal) {
  if (goal.task.name != "perform-detection" || goal.task.arguments.size() < 3) return std::nullopt;
  const world::Zone* zone = history.zone(goal.task.arguments[0]);
  if (zone == nullptr) return std::nullopt;
  const double side = std::max(5.0, std::sqrt(world::area(zone->polygon) / 200));
  return seconds_over(history, uav, goal, cells_of(history, zone->polygon, side));
}

std::vector<Violation> detections_not_done(const History& history) {
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    const auto seconds = seconds_detected(history, uav, goal);
    const auto wanted = seconds ? number_of(goal.task.arguments[2]) : std::nullopt;
    if (!wanted || *seconds >= kDetectPart * *wanted) return;
    result.push_back({"", at, uav.name(), goal.id,
                      mission::to_text(goal.task) + " is achieved: it looked at the zone for " +
                          figure(*seconds) + " of " + figure(*wanted) + " s"});
  });
  return result;
}

std::vector<Violation> mappings_not_done(const History& history) {
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    if (goal.task.name != "perform-mapping" || goal.task.arguments.empty()) return;
    const world::Zone* zone = history.zone(goal.task.arguments[0]);
    if (zone == nullptr) return;
    const double part = part_in_view(history, looks_of(uav, goal), zone->polygon);
    if (part >= kMapPart) return;
    result.push_back({"", at, uav.name(), goal.id,
                      mission::to_text(goal.task) + " is achieved: " + figure(100 * part) +
                          " % of the zone was in the sensor's view"});
  });
  return result;
}

}  // namespace skein::laws
