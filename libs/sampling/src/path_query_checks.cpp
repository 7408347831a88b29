// SPDX-License-Identifier: Apache-2.0
#include "path_query_checks.hpp"

#include <cmath>

#include "skein/refiners/checks.hpp"

namespace skein::sampling {
namespace {

using refiners::PathQuery;
using refiners::Refusal;
using refiners::RefusalKind;

Refusal bad(std::string field, std::string why) {
  return {RefusalKind::kBadQuery, std::move(field), std::move(why)};
}

std::optional<Refusal> check_volume(const world::Volume& volume, const std::string& field) {
  if (auto refusal = refiners::check_polygon(volume.polygon, field + ".polygon")) return refusal;
  if (!(volume.floor < volume.ceiling)) return bad(field, "the floor is not below the ceiling");
  return std::nullopt;
}

std::optional<Refusal> check_contact(const refiners::Contact& contact) {
  if (auto refusal = refiners::check_finite(contact.with, "contact.with")) return refusal;
  for (std::size_t i = 0; i < contact.relays.size(); ++i)
    if (auto refusal =
            refiners::check_finite(contact.relays[i], "contact.relays." + std::to_string(i)))
      return refusal;
  return std::nullopt;
}

std::optional<Refusal> check_figures(const PathQuery& query) {
  if (!(query.vehicle.body_radius >= 0) || !std::isfinite(query.vehicle.body_radius))
    return bad("vehicle.body_radius", "the radius must be finite, and not negative");
  if (!(query.clearance >= 0) || !std::isfinite(query.clearance))
    return bad("clearance", "the clearance must be finite, and not negative");
  if (!(query.speed >= 0) || !std::isfinite(query.speed))
    return bad("speed", "the speed must be finite, and not negative");
  if (query.speed > query.vehicle.max_speed)
    return Refusal{RefusalKind::kBeyondVehicle, "speed", "the vehicle does not fly that fast"};
  if (query.speed > 0 && query.speed < query.vehicle.min_speed)
    return Refusal{RefusalKind::kBeyondVehicle, "speed", "the vehicle does not fly that slowly"};
  if (!std::isfinite(query.heading_from.value_or(0)))
    return bad("heading_from", "the heading must be finite");
  if (!std::isfinite(query.heading_to.value_or(0)))
    return bad("heading_to", "the heading must be finite");
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> check_query(const PathQuery& query, const world::World& world) {
  if (const auto problems = world::problems_of(world.airspace); !problems.empty())
    return bad("world", problems.front());
  if (auto refusal = refiners::check_vehicle(query.vehicle)) return refusal;
  if (auto refusal = refiners::check_finite(query.from, "from")) return refusal;
  if (auto refusal = refiners::check_finite(query.to, "to")) return refusal;
  if (auto refusal = check_figures(query)) return refusal;
  for (std::size_t i = 0; i < query.reserved.size(); ++i)
    if (auto refusal = check_volume(query.reserved[i], "reserved." + std::to_string(i)))
      return refusal;
  return query.contact ? check_contact(*query.contact) : std::nullopt;
}

}  // namespace skein::sampling
