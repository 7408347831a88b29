// SPDX-License-Identifier: Apache-2.0
#include "refinery/meeting_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planning/terms.hpp"

namespace skein::supervisor {

using world::Vector3;

namespace {

constexpr double kAngleApart = std::numbers::pi / 3;  // [rad] between two views
constexpr double kLeastBetween = 8;  // [m] between two that waver towards each other
constexpr double kOver = 25;         // [m] over each other is apart as well
constexpr double kAround = 75;       // [m] from a place in the air, at least
constexpr std::size_t kSides = 6;    // around it, as far from each other as from it
constexpr std::array<double, kSides> kSideOf = {1, -1, 2, -2, 3, 0};  // by rank

double level(const Vector3& a, const Vector3& b) { return (a - b).head<2>().norm(); }

double angle_between(const Vector3& place, const Vector3& a, const Vector3& b) {
  const Vector3 to_a = a - place, to_b = b - place;
  return std::abs(world::wrapped(std::atan2(to_a.y(), to_a.x()) - std::atan2(to_b.y(), to_b.x())));
}

/// Beside all of them, or over or under.
bool is_apart(const Vector3& at, double room, const std::vector<Spot>& before) {
  return std::all_of(before.begin(), before.end(), [&](const Spot& other) {
    return std::abs(at.z() - other.at.z()) >= kOver || level(at, other.at) >= room + other.room;
  });
}

/// How strictly a place is kept apart from those before.
enum class Apart { kAnotherSide, kBeside, kBesideOrOver };

Views::Constraints apart_from(const std::vector<Spot>& before, const Vector3& place, double room,
                              Apart how) {
  if (before.empty()) return {};
  return {{"room for the partners", [&before, place, room, how](const Vector3& at) {
             if (how == Apart::kBesideOrOver) return is_apart(at, room, before);
             return std::all_of(before.begin(), before.end(), [&](const Spot& other) {
               if (level(at, other.at) < room + other.room) return false;
               return how == Apart::kBeside || angle_between(place, at, other.at) >= kAngleApart;
             });
           }}};
}

}  // namespace

bool MeetingPlaces::is_me(const std::string& name) const {
  return same_name(name, air_.gazetteer().knowledge().uav);
}

MeetingPlaces::Party MeetingPlaces::party(const std::string& name) {
  const auto with = [](TimedAir& air, Views& views) {
    return Party{air, views, air.reach() + kLeastBetween};
  };
  if (is_me(name)) return with(air_, views_);
  auto& other = others_[name];
  if (!other) other = std::make_unique<Stranger>(air_.of(name));
  return with(other->air, other->views);
}

Answer<MeetingPlaces::Gathering> MeetingPlaces::at(const Vector3& place,
                                                   const std::vector<std::string>& names,
                                                   const Devices& devices, const Departure& when) {
  const bool in_the_air = !air_.gazetteer().on_ground(place);
  Gathering gathering;
  std::vector<Spot> before;
  for (std::size_t rank = 0; rank < names.size(); ++rank) {
    const bool mine = is_me(names[rank]);
    const Party one = party(names[rank]);
    double widest = 0;
    for (const std::string& name : names)
      if (name != names[rank]) widest = std::max(widest, party(name).room);
    const auto spot =
        in_the_air
            ? around(place, one, rank, before, std::max(kAround, one.room + widest))
            : beside(place, one, mine ? std::vector{devices.own} : devices.order, before, when);
    if (!spot && mine) return no(spot.error());
    if (!spot) continue;
    before.push_back(*spot);
    if (mine)
      gathering.own = *spot;
    else
      gathering.others.push_back(*spot);
  }
  return gathering;
}

Answer<Spot> MeetingPlaces::around(const Vector3& place, const Party& one, std::size_t rank,
                                   const std::vector<Spot>& before, double distance) {
  const auto air = one.air.airspace();
  if (!air) return no(air.error());
  // From the side of where the world begins, that of their homes as a rule.
  const double first = std::atan2(-place.y(), -place.x());
  const double step = 2 * std::numbers::pi / static_cast<double>(kSides);
  const double ring = static_cast<double>(1 + rank / kSides);
  const std::vector<Spot> there = {{place, 0}};
  for (const double up : {0.0, kOver, -kOver, 2 * kOver}) {
    for (const double far : {distance, kAround}) {
      // Turned by less than half of what is between two.
      for (const double turned : {0.0, 0.25, -0.25, 0.4, -0.4}) {
        const double angle = first + (kSideOf[rank % kSides] + turned) * step;
        Vector3 at =
            place + Vector3(ring * far * std::cos(angle), ring * far * std::sin(angle), up);
        if (one.air.vehicle().ground) at = one.air.gazetteer().above(at);
        const bool apart = is_apart(at, one.room, before) && is_apart(at, one.room, there);
        if (apart && (*air)->is_free(one.air.in_airspace(at)) && one.air.has_room(at))
          return Spot{at, one.room};
      }
    }
  }
  return no("no free air beside it for partner " + std::to_string(rank + 1));
}

Answer<Spot> MeetingPlaces::beside(const Vector3& place, const Party& one,
                                   const std::vector<std::string>& devices,
                                   const std::vector<Spot>& before, const Departure& when) {
  std::string why = "no device sees it";
  for (const std::string& device : devices) {
    const auto* sensor = one.air.gazetteer().sensor(device);
    if (sensor == nullptr) continue;
    for (const Apart how : {Apart::kAnotherSide, Apart::kBeside, Apart::kBesideOrOver}) {
      auto seen =
          one.views.of(place, *sensor, 1, when, 0, apart_from(before, place, one.room, how));
      if (seen) return Spot{seen->front(), one.room};
      why = seen.error();
      if (before.empty()) break;
    }
  }
  return no(why);
}

}  // namespace skein::supervisor
