// SPDX-License-Identifier: Apache-2.0
#include "path/checks.hpp"

#include <cmath>

#include "common/shared_checks.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

std::optional<Refusal> check_speed(const PathQuery& query) {
  const world::VehicleModel& vehicle = query.vehicle;
  if (!(std::isfinite(query.speed) && query.speed >= 0))
    return bad("speed", "the speed must be 0 (cruise) or more [m/s]");
  if (query.speed > vehicle.max_speed || (query.speed > 0 && query.speed < vehicle.min_speed))
    return Refusal{RefusalKind::kBeyondVehicle, "speed",
                   rounded(query.speed) + " m/s is not between the least, " +
                       rounded(vehicle.min_speed) + " m/s, and the greatest, " +
                       rounded(vehicle.max_speed) + " m/s"};
  return std::nullopt;
}

std::optional<Refusal> check_figures(const PathQuery& query) {
  if (!(std::isfinite(query.vehicle.body_radius) && query.vehicle.body_radius >= 0))
    return bad("vehicle.body_radius", "the radius must be 0 or more [m]");
  if (!(std::isfinite(query.clearance) && query.clearance >= 0))
    return bad("clearance", "the clearance must be 0 or more [m]");
  if (query.heading_from && !std::isfinite(*query.heading_from))
    return bad("heading_from", "the heading must be a finite number");
  if (query.heading_to && !std::isfinite(*query.heading_to))
    return bad("heading_to", "the heading must be a finite number");
  return check_speed(query);
}

std::optional<Refusal> check_reserved(const PathQuery& query) {
  for (std::size_t i = 0; i < query.reserved.size(); ++i) {
    const world::Volume& volume = query.reserved[i];
    const std::string field = "reserved." + std::to_string(i);
    if (auto problem = check_polygon(volume.polygon, field + ".polygon")) return problem;
    if (!(volume.floor < volume.ceiling))
      return bad(field + ".ceiling", "the ceiling must be above the floor");
  }
  return std::nullopt;
}

std::optional<Refusal> check_contact(const PathQuery& query) {
  if (!query.contact) return std::nullopt;
  if (auto problem = check_finite(query.contact->with, "contact.with")) return problem;
  const std::vector<world::Vector3>& relays = query.contact->relays;
  if (relays.size() > kMostRelays)
    return bad("contact.relays",
               std::to_string(relays.size()) + " relays: at most " + std::to_string(kMostRelays));
  for (std::size_t i = 0; i < relays.size(); ++i)
    if (auto problem = check_finite(relays[i], "contact.relays." + std::to_string(i)))
      return problem;
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> check(const PathQuery& query, const world::World& world) {
  if (auto problem = check_vehicle(query.vehicle)) return problem;
  if (auto problem = check_finite(query.from, "from")) return problem;
  if (auto problem = check_finite(query.to, "to")) return problem;
  if (auto problem = check_figures(query)) return problem;
  if (auto problem = check_reserved(query)) return problem;
  if (auto problem = check_contact(query)) return problem;
  const std::vector<std::string> problems = world::problems_of(world.airspace);
  if (!problems.empty()) return bad("world.airspace", problems.front());
  return std::nullopt;
}

}  // namespace skein::refiners
