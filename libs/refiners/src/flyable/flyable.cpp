// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/flyable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "flyable/again.hpp"
#include "flyable/search.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

constexpr std::uint64_t kMostAsked = 150'000;  // per attempt
constexpr std::uint64_t kMostAskedAgain = 20'000;
/// Of a pass that has more heights to choose from.
constexpr std::uint64_t kMostAskedLower = 600'000;
/// Ways that are longer than a straight one by more than that are flown again.
constexpr double kNearlyStraight = 1.02;
/// Shorter legs cannot be steered [m].
constexpr double kLeastLeg = 1;
/// What rounding may add to a turn [rad], and to a slope relatively.
constexpr double kTurnSlack = 1e-5, kSlopeSlack = 1e-6;

std::string place(const Vector3& at) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.1f, %.1f, %.1f)", at.x(), at.y(), at.z());
  return text.data();
}

FlightLimits limits_of(const world::VehicleModel& vehicle, double speed, double tolerance) {
  const double flown = speed > 0 ? speed : vehicle.cruise_speed;
  return {vehicle.min_turn_radius, vehicle.climb_rate / flown, vehicle.descent_rate / flown,
          tolerance};
}

std::optional<Refusal> check_query(const FlyableQuery& query, const world::VehicleModel& vehicle) {
  if (auto refusal = check_vehicle(vehicle)) return refusal;
  if (query.corners.size() < 2)
    return Refusal{RefusalKind::kBadQuery, "corners", "a way has at least two points"};
  for (std::size_t i = 0; i < query.corners.size(); ++i)
    if (auto refusal = check_finite(query.corners[i], "corners." + std::to_string(i)))
      return refusal;
  if (!std::isfinite(query.heading_from.value_or(0)))
    return Refusal{RefusalKind::kBadQuery, "heading_from", "the heading must be finite"};
  if (!std::isfinite(query.heading_to.value_or(0)))
    return Refusal{RefusalKind::kBadQuery, "heading_to", "the heading must be finite"};
  if (!(query.speed >= 0) || !std::isfinite(query.speed))
    return Refusal{RefusalKind::kBadQuery, "speed", "the speed must be finite, and not negative"};
  return check_positive(query.tolerance, "tolerance");
}

Result<Way, Refusal> hovered(const FlyableQuery& query) {
  const Way& way = query.corners;
  for (std::size_t i = 1; query.is_free && i < way.size(); ++i)
    if (!query.is_free(way[i - 1], way[i]))
      return refuse(RefusalKind::kBlocked, "corners." + std::to_string(i),
                    "the leg from " + place(way[i - 1]) + " to " + place(way[i]) + " is not free");
  return way;
}

/// What no way is shorter than: the corners' own, or the climbing it takes.
double plain_length(const Way& corners, const FlightLimits& limits) {
  double length = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vector3 leg = corners[i] - corners[i - 1];
    length += std::max({leg.head<2>().norm(), leg.z() / limits.climb, -leg.z() / limits.descent});
  }
  return length;
}

Refusal none_found(const FlyableQuery& query, const FlightLimits& limits, std::size_t corner) {
  std::array<char, 160> figures{};
  std::snprintf(
      figures.data(), figures.size(),
      "turns of at least %g m, climbs of at most %.3g and descents of at most %.3g m per m",
      limits.radius, limits.climb, limits.descent);
  return {RefusalKind::kBeyondVehicle, "corners." + std::to_string(corner),
          "no free way with " + std::string(figures.data()) + " was found past the corner at " +
              place(query.corners[corner])};
}

/// As `evaluate` judges them.
bool slopes_fit(const Way& way, const FlightLimits& limits) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3 leg = way[i] - way[i - 1];
    const double allowed = (leg.z() > 0 ? limits.climb : limits.descent) * leg.head<2>().norm();
    if (std::abs(leg.z()) > allowed * (1 + 1e-9)) return false;
  }
  return true;
}

/// Made shorter with so many questions, if any, and without legs that are too short to be steered.
Way improved(const Way& found, const FlyableQuery& query, const world::VehicleModel& vehicle,
             std::uint64_t most_asked, const Floor& floor) {
  const FlightLimits limits = limits_of(vehicle, query.speed, query.tolerance);
  const auto is_flown = [&](const Way& way) {
    return slopes_fit(way, limits) && is_flyable(way, vehicle, query.speed, query.tolerance);
  };
  Way way = found;
  if (most_asked > 0) {
    FlyableLegs legs(limits, query.is_free, most_asked, {query.time_is_up});
    Way again = flown_again(way, legs, limits, {query.heading_from, query.heading_to}, floor);
    if (is_flown(again)) way = std::move(again);
  }
  return without_tiny_legs(way, kLeastLeg, limits.radius, query.is_free, is_flown);
}

/// Made shorter where it goes a long way round.
Way finished(const Way& found, const FlyableQuery& query, const world::VehicleModel& vehicle) {
  const double straight = (query.corners.back() - query.corners.front()).head<2>().norm();
  const bool is_round = query.shortest && level_length(found) > kNearlyStraight * straight;
  return improved(found, query, vehicle, is_round ? kMostAskedAgain : 0, {});
}

/// At most what two chords of an arc that meet show.
double half_chord_angle(double chord, double radius, double most) {
  return std::min(most / 2, std::asin(std::min(1.0, chord / (2 * radius))));
}

bool turns_fit(const std::vector<Vector2>& legs, double radius, double tolerance) {
  const double most = chord_angle(radius, tolerance);
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const Vector2 &in = legs[i - 1], &out = legs[i];
    const double turn = std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
    const double allowed =
        half_chord_angle(in.norm(), radius, most) + half_chord_angle(out.norm(), radius, most);
    if (turn > allowed + kTurnSlack) return false;
  }
  return true;
}

}  // namespace

Result<Way, Refusal> make_flyable(const FlyableQuery& query, const world::VehicleModel& vehicle) {
  if (auto refusal = check_query(query, vehicle)) return tl::unexpected(*std::move(refusal));
  if (vehicle.hovers) return hovered(query);
  const FlightLimits limits = limits_of(vehicle, query.speed, query.tolerance);

  const Budget budget{query.time_is_up};
  FlyableLegs legs(limits, query.is_free, kMostAsked, budget);
  const auto near = stations_of(query, limits.radius, false);
  const FoundWay plain = search_stations(near, legs, {});
  // Much longer than need be: it goes round in circles between corners that stand too close.
  const double enough = 1.25 * plain_length(query.corners, limits) + 4 * limits.radius;
  if (!plain.way.empty() && level_length(plain.way) <= enough)
    return finished(plain.way, query, vehicle);

  FlyableLegs more_legs(limits, query.is_free, kMostAsked, budget);
  const auto wide = stations_of(query, limits.radius, true);
  const FoundWay wider = search_stations(wide, more_legs, {.most_skipped = 4, .thorough = true});
  if (plain.way.empty() && wider.way.empty()) {
    return tl::unexpected(none_found(query, limits, wide[wider.furthest].corner));
  }
  const bool shorter = plain.way.empty() ||
                       (!wider.way.empty() && level_length(wider.way) < level_length(plain.way));
  return finished(shorter ? wider.way : plain.way, query, vehicle);
}

Way lowered(const Way& way, const FlyableQuery& query, const world::VehicleModel& vehicle,
            const Floor& floor) {
  Way lower = improved(way, query, vehicle, kMostAskedLower, floor);
  return level_length(lower) < level_length(way) ? lower : way;
}

bool is_flyable(const Way& way, const world::VehicleModel& vehicle, double speed,
                double tolerance) {
  if (!std::all_of(way.begin(), way.end(), [](const Vector3& p) { return p.allFinite(); }))
    return false;
  if (vehicle.hovers) return true;
  if (check_vehicle(vehicle) || check_positive(tolerance, "tolerance")) return false;
  const FlightLimits limits = limits_of(vehicle, speed, tolerance);
  std::vector<Vector2> legs;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3 leg = way[i] - way[i - 1];
    const double level = leg.head<2>().norm();
    const double allowed = (leg.z() > 0 ? limits.climb : limits.descent) * level;
    if (std::abs(leg.z()) > allowed * (1 + kSlopeSlack) + kSlopeSlack) return false;
    if (level > 1e-9) legs.emplace_back(leg.head<2>());
  }
  return turns_fit(legs, limits.radius, tolerance);
}

}  // namespace skein::refiners
