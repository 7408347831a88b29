// SPDX-License-Identifier: Apache-2.0
#include "viewpoint/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/shared_checks.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

/// How far under the ground a target may be and still count as on it [m].
constexpr double kBuried = 0.5;

std::optional<Refusal> check_between(double value, double least, double most,
                                     const std::string& field) {
  if (value >= least && value <= most) return std::nullopt;
  return bad(field, figure(value) + " is not between " + figure(least) + " and " + figure(most));
}

std::optional<Refusal> check_sensor(const world::SensorModel& sensor) {
  const std::string where = "vehicle.sensors." + sensor.device + ".";
  const world::QualityModel& quality = sensor.quality;
  if (auto problem = check_positive(sensor.range, where + "range")) return problem;
  const std::array<std::tuple<double, double, double, const char*>, 6> figures = {{
      {sensor.aperture, 1e-6, std::numbers::pi, "aperture"},
      {sensor.boresight_pitch, -1.6, 1.6, "pitch"},
      {sensor.cost, 0, 1e6, "cost"},
      {quality.best_distance, 0, sensor.range, "quality.best_distance"},
      {quality.at_range, 0, 1, "quality.at_range"},
      {quality.incidence_power, 0, 1e3, "quality.incidence_power"},
  }};
  for (const auto& [value, least, most, field] : figures)
    if (auto problem = check_between(value, least, most, where + field)) return problem;
  return std::nullopt;
}

std::optional<Refusal> check_figures(const ViewpointQuery& query) {
  constexpr double most = 1e6;
  const std::array<std::tuple<double, double, const char*>, 5> figures = {{
      {query.nearest, most, "nearest"},
      {query.farthest, most, "farthest"},
      {query.clearance, most, "clearance"},
      {query.least_angle, std::numbers::pi, "least_angle"},
      {query.cost_of_way, most, "cost_of_way"},
  }};
  for (const auto& [value, limit, field] : figures)
    if (auto problem = check_between(value, 0, limit, field)) return problem;
  if (query.count < 1 || query.count > kMostViewpoints)
    return bad("count", std::to_string(query.count) + " view points: from 1 to " +
                            std::to_string(kMostViewpoints));
  if (query.farthest > 0 && query.nearest > query.farthest)
    return bad("nearest", figure(query.nearest) + " m is more than farthest, " +
                              figure(query.farthest) + " m");
  for (const PlaceConstraint& constraint : query.constraints)
    if (!constraint.holds)
      return bad("constraints", "constraint '" + constraint.name + "' has no predicate");
  if (query.from) return check_finite(*query.from, "from");
  return std::nullopt;
}

std::optional<Refusal> check_target(const world::Vector3& target, const world::Terrain& terrain) {
  if (auto problem = check_finite(target, "target")) return problem;
  if (!terrain.contains(target.x(), target.y()))
    return Refusal{RefusalKind::kBlocked, "target", "it is outside the terrain"};
  const double depth = terrain.elevation(target.x(), target.y()) - target.z();
  if (depth > kBuried)
    return Refusal{RefusalKind::kBlocked, "target",
                   "it is " + figure(depth) + " m under the ground"};
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> check(const ViewpointQuery& query, const world::World& world,
                             const world::SensorModel& sensor) {
  if (auto problem = check_vehicle(query.vehicle)) return problem;
  if (auto problem = check_sensor(sensor)) return problem;
  if (auto problem = check_figures(query)) return problem;
  if (auto problem = check_target(query.target, world.terrain)) return problem;
  if (query.nearest > sensor.range)
    return Refusal{RefusalKind::kNotPerceivable, "nearest",
                   "'" + sensor.device + "' perceives nothing from " + figure(query.nearest) +
                       " m: its range is " + figure(sensor.range) + " m"};
  if (query.clearance > query.vehicle.ceiling)
    return Refusal{RefusalKind::kBeyondVehicle, "clearance",
                   figure(query.clearance) + " m is over the vehicle's ceiling, " +
                       figure(query.vehicle.ceiling) + " m over the ground"};
  return std::nullopt;
}

Refusal explain(const ViewpointField& field, const ViewpointSearch::Survey& survey) {
  std::vector<std::pair<Verdict, std::size_t>> fates(survey.fates.begin(), survey.fates.end());
  std::stable_sort(fates.begin(), fates.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  const BearingCell& whole = field.whole();
  std::string why = "of " + std::to_string(survey.places) + " places from " + figure(whole.range) +
                    " to " + figure(whole.range_end) + " m away that '" + field.query().device +
                    "' could look from, none will do: ";
  for (std::size_t i = 0; i < fates.size(); ++i)
    why += (i > 0 ? ", " : "") + std::to_string(fates[i].second) + " are " +
           field.describe(fates[i].first);
  return {RefusalKind::kNotPerceivable, "target", std::move(why)};
}

}  // namespace skein::refiners
