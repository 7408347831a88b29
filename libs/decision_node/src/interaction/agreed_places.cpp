// SPDX-License-Identifier: Apache-2.0
#include "interaction/agreed_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "interaction/sightings.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::decision_node {

namespace {

using interaction::Position;
using interaction::Row;
using interaction::Rows;

constexpr const char* kPositions = "perception-positions";
constexpr const char* kChain = "relay-chain";
constexpr const char* kCircle = "circle";  // x, y, radius, altitude over the ground
constexpr const char* kDirections = "directions";
constexpr const char* kLink = "link";
constexpr double kClearance = 10;  // [m] over the ground

Position over_ground(double x, double y, double altitude, const world::World& world) {
  return {x, y, world.terrain.elevation(x, y) + altitude};
}

// ---- what the action says ----

Result<Argument, Failure> said(const interaction::CoordinationAction& action, const char* name,
                               const Arguments& scope) {
  const config::Value* given = action.in.find(name);
  if (given == nullptr) return failure("it has no '" + std::string(name) + "'");
  return value_of(*given, scope);
}

Result<double, Failure> number(const interaction::CoordinationAction& action, const char* name,
                               const Arguments& scope) {
  const auto value = said(action, name, scope);
  if (!value) return tl::unexpected(value.error());
  const double* number = std::get_if<double>(&*value);
  if (number == nullptr) return failure("its '" + std::string(name) + "' is no number");
  return *number;
}

Result<Position, Failure> place(const interaction::CoordinationAction& action, const char* name,
                                const Arguments& scope, const Outlook& outlook) {
  const auto value = said(action, name, scope);
  if (!value) return tl::unexpected(value.error());
  if (const auto* point = std::get_if<Position>(&*value)) return *point;
  const auto* object = std::get_if<std::string>(&*value);
  const auto seen = object == nullptr ? std::nullopt : outlook.observer(*object);
  if (!seen) return failure("nobody knows where its '" + std::string(name) + "' is");
  return seen->position;
}

Result<Rows, Failure> directions(const interaction::CoordinationAction& action,
                                 const Arguments& scope, const Outlook& outlook) {
  const auto around = place(action, "around", scope, outlook);
  if (!around) return tl::unexpected(around.error());
  std::vector<double> numbers;
  for (const char* name : {"distance", "altitude", kDirections}) {
    const auto value = number(action, name, scope);
    if (!value) return tl::unexpected(value.error());
    numbers.push_back(*value);
  }
  return Rows{{kDirections, "", {numbers[2]}},
              {kCircle, "", {(*around)[0], (*around)[1], numbers[0], numbers[1]}}};
}

// As far from each other as from the two ends.
Result<Rows, Failure> links(const interaction::CoordinationAction& action, const Arguments& scope,
                            std::size_t members, const Outlook& outlook) {
  const auto from = place(action, "from", scope, outlook), to = place(action, "to", scope, outlook);
  const auto altitude = number(action, "altitude", scope);
  if (!from) return tl::unexpected(from.error());
  if (!to) return tl::unexpected(to.error());
  if (!altitude) return tl::unexpected(altitude.error());
  Rows rows;
  for (std::size_t i = 1; i <= members; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(members + 1);
    const Position at =
        over_ground((*from)[0] + share * ((*to)[0] - (*from)[0]),
                    (*from)[1] + share * ((*to)[1] - (*from)[1]), *altitude, outlook.world);
    rows.push_back({kLink, "", {at[0], at[1], at[2]}});
  }
  return rows;
}

// ---- what the terms mean ----

std::vector<Position> places_of(const interaction::Terms& terms, const world::World& world) {
  std::vector<Position> places;
  const Row *circle = nullptr, *count = nullptr;
  for (const Row& row : terms.parameters) {
    if (!std::all_of(row.numbers.begin(), row.numbers.end(),
                     [](double one) { return std::isfinite(one); })) {
      return {};
    }
    if (row.name == kLink && row.numbers.size() == 3) {
      places.push_back({row.numbers[0], row.numbers[1], row.numbers[2]});
    }
    if (row.name == kCircle && row.numbers.size() == 4) circle = &row;
    if (row.name == kDirections && row.numbers.size() == 1) count = &row;
  }
  if (terms.modality == kChain || circle == nullptr || count == nullptr) return places;
  places.clear();
  const std::vector<double>& at = circle->numbers;
  for (double i = 0; i < count->numbers[0]; ++i) {  // the modality bounds how many
    const double angle = 2 * std::numbers::pi * i / count->numbers[0];
    places.push_back(over_ground(at[0] + at[2] * std::cos(angle), at[1] + at[2] * std::sin(angle),
                                 at[3], world));
  }
  return places;
}

}  // namespace

bool gives_places(std::string_view modality) {
  return modality == kPositions || modality == kChain;
}

Result<Rows, Failure> place_terms(const interaction::CoordinationAction& action,
                                  const Arguments& scope, std::size_t members,
                                  const Outlook& outlook) {
  if (action.modality == kPositions) return directions(action, scope, outlook);
  return links(action, scope, members, outlook);
}

Result<Rows, Failure> offer_of_places(const interaction::Terms& terms,
                                      const world::VehicleState& state, const Outlook& outlook) {
  const std::vector<Position> places = places_of(terms, outlook.world);
  if (places.empty()) return failure("it is not said where");
  const world::VehicleModel& vehicle = outlook.knowledge.vehicle;
  const auto air = interaction::free_air_of(outlook.world, vehicle, kClearance, outlook.now);
  Rows rows;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!air.holds(places[i])) continue;
    const auto flight = refiners::estimate_flight({state.position, vector_of(places[i])}, vehicle,
                                                  outlook.world.wind);
    rows.push_back({terms.modality == kChain ? kLink : "direction",
                    "",
                    {static_cast<double>(i), flight.duration.expected.to_seconds()}});
  }
  if (rows.empty()) return failure("none of the places is in free air");
  return rows;
}

std::optional<Position> place_of_member(const std::string& member, const interaction::Terms& terms,
                                        const Rows& result, const world::World& world) {
  const auto own = std::find_if(result.begin(), result.end(),
                                [&](const Row& row) { return row.name == member; });
  const std::vector<Position> places = places_of(terms, world);
  if (own == result.end() || own->numbers.empty() || own->numbers[0] < 0) return std::nullopt;
  const auto which = static_cast<std::size_t>(own->numbers[0]);
  return which < places.size() ? std::optional(places[which]) : std::nullopt;
}

}  // namespace skein::decision_node
