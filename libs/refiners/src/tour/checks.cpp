// SPDX-License-Identifier: Apache-2.0
#include "tour/checks.hpp"

#include <cmath>

#include "common/shared_checks.hpp"
#include "skein/refiners/checks.hpp"
#include "skein/refiners/tour_problem.hpp"

namespace skein::refiners {
namespace {

constexpr std::size_t kMostGates = 3000;  // of all stops; their costs take 72 MB

/// What all three ask for.
std::optional<Refusal> check_flight(const world::VehicleModel& vehicle, double clearance,
                                    double speed) {
  if (auto problem = check_vehicle(vehicle)) return problem;
  if (!(std::isfinite(clearance) && clearance >= 0))
    return bad("clearance", "the clearance must be 0 or more [m]");
  if (!(std::isfinite(speed) && speed >= 0))
    return bad("speed", "the speed must be 0 (cruise) or more [m/s]");
  return std::nullopt;
}

/// The same, for what is to be planned at a speed the vehicle can keep.
std::optional<Refusal> check_planned_flight(const world::VehicleModel& vehicle, double clearance,
                                            double speed) {
  if (auto problem = check_flight(vehicle, clearance, speed)) return problem;
  if (speed > vehicle.max_speed || (speed > 0 && speed < vehicle.min_speed))
    return Refusal{RefusalKind::kBeyondVehicle, "speed",
                   rounded(speed) + " m/s is not between the least, " + rounded(vehicle.min_speed) +
                       " m/s, and the greatest, " + rounded(vehicle.max_speed) + " m/s"};
  return std::nullopt;
}

std::optional<Refusal> check_end(const std::optional<world::Vector3>& end) {
  return end ? check_finite(*end, "end") : std::nullopt;
}

std::optional<Refusal> check_gate(const Gate& gate, const std::string& field) {
  if (auto problem = check_finite(gate.entry, field + ".entry")) return problem;
  if (auto problem = check_finite(gate.exit, field + ".exit")) return problem;
  if (gate.inside < Duration{}) return bad(field + ".inside", "the time inside is negative");
  if (gate.inside.count() >= kNoWay) return bad(field + ".inside", "the time inside is too long");
  return std::nullopt;
}

std::optional<Refusal> check_task(const PlannedTask& task, const std::string& field) {
  if (auto problem = check_finite(task.from, field + ".from")) return problem;
  if (auto problem = check_finite(task.to, field + ".to")) return problem;
  if (task.duration < Duration{}) return bad(field + ".duration", "the duration is negative");
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> check(const TourQuery& query) {
  if (auto problem = check_planned_flight(query.vehicle, query.clearance, query.speed))
    return problem;
  if (auto problem = check_finite(query.start, "start")) return problem;
  if (auto problem = check_end(query.end)) return problem;
  if (query.stops.empty()) return bad("stops", "there is nothing to visit");
  if (query.stops.size() > kMostStops)
    return bad("stops", std::to_string(query.stops.size()) + " stops: at most " +
                            std::to_string(kMostStops));
  std::size_t gates = 0;
  for (std::size_t i = 0; i < query.stops.size(); ++i) {
    const std::string field = "stops." + std::to_string(i) + ".gates";
    const std::vector<Gate>& own = query.stops[i].gates;
    if (own.empty()) return bad(field, "a stop needs at least one gate");
    for (std::size_t k = 0; k < own.size(); ++k)
      if (auto problem = check_gate(own[k], field + "." + std::to_string(k))) return problem;
    gates += own.size();
    if (gates > kMostGates)
      return bad(field, "more than " + std::to_string(kMostGates) + " gates in all");
  }
  return std::nullopt;
}

std::optional<Refusal> check(const InsertionQuery& query) {
  if (auto problem = check_planned_flight(query.vehicle, query.clearance, query.speed))
    return problem;
  if (auto problem = check_finite(query.start, "start")) return problem;
  if (auto problem = check_end(query.end)) return problem;
  for (std::size_t i = 0; i < query.plan.size(); ++i)
    if (auto problem = check_task(query.plan[i], "plan." + std::to_string(i))) return problem;
  return check_task(query.task, "task");
}

std::optional<Refusal> check(const EvaluateQuery& query) {
  if (auto problem = check_flight(query.vehicle, query.clearance, query.speed)) return problem;
  if (query.way.size() < 2) return bad("way", "a way has at least two points");
  for (std::size_t i = 0; i < query.way.size(); ++i)
    if (auto problem = check_finite(query.way[i], "way." + std::to_string(i))) return problem;
  for (std::size_t i = 0; i < query.reserved.size(); ++i) {
    const std::string field = "reserved." + std::to_string(i);
    if (auto problem = check_polygon(query.reserved[i].polygon, field + ".polygon")) return problem;
    if (!(query.reserved[i].floor < query.reserved[i].ceiling))
      return bad(field + ".ceiling", "the ceiling must be above the floor");
  }
  return std::nullopt;
}

}  // namespace skein::refiners
