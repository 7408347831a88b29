// SPDX-License-Identifier: Apache-2.0
#include "safety/air_watch.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "flight/closed_air.hpp"
#include "flight/flight_times.hpp"
#include "flight/flights_met.hpp"
#include "safety/warning.hpp"
#include "skein/world/crossing.hpp"
#include "skein/world/steering.hpp"
#include "watch/stand.hpp"

namespace skein::supervisor {

namespace {

/// What closes within this is met: a little more, so that what is looked at when the warning is due
/// counts.
constexpr Duration kAhead = Duration::milliseconds(65'000);
/// What stands still is no faster [m/s]: gusts shake it.
constexpr double kAtRest = 1;
/// When it could not leave.
constexpr Duration kLookAgain = Duration::milliseconds(60'000);
/// A descent that is over sooner goes on [s].
constexpr double kNearlyDown = 15;

/// A way out of closed air is no way into it: only what comes after it is outside counts.
bool leads_in(const world::Volume& volume, double margin, const std::vector<world::Vector3>& way) {
  std::size_t out = 0;
  while (out < way.size() && crosses(volume, margin, way[out], way[out])) ++out;
  if (out == 0) return crosses(volume, margin, way);
  return out == way.size() ||
         crosses(volume, margin, {way.begin() + static_cast<std::ptrdiff_t>(out), way.end()});
}

}  // namespace

AirWatch::AirWatch(const Beliefs& beliefs, OwnGoals& own_goals, Committer& committer,
                   Agenda& agenda, Outbox& out, Book& book)
    : beliefs_(beliefs),
      own_goals_(own_goals),
      committer_(committer),
      agenda_(agenda),
      out_(out),
      book_(book) {}

// ---- when ----

std::optional<MissionTime> AirWatch::next_closing() const {
  std::optional<MissionTime> next;
  for (const world::Volume& volume : beliefs_.world().volumes) {
    if (volume.when.from <= MissionTime() + kWarning) continue;
    const MissionTime at = volume.when.from - kWarning;
    if (at > watched_) next = earliest(next, at);
  }
  return next;
}

void AirWatch::watch() {
  const auto next = next_closing();
  if (!next || *next > now()) return;
  std::string names;
  for (const world::Volume& volume : beliefs_.world().volumes) {
    const MissionTime at = volume.when.from - kWarning;
    if (at > watched_ && at <= now()) names += (names.empty() ? "'" : ", '") + volume.name + "'";
  }
  watched_ = now();
  check("volume " + names + " about to close");
}

void AirWatch::look() {
  const world::VehicleState& vehicle = beliefs_.vehicle();
  if (!vehicle.airborne || beliefs_.world().volumes.empty() || now() < looked_ + kLookAgain) return;
  const bool hovers = beliefs_.model().hovers;
  const bool circles = circled(book_, beliefs_).has_value() || was_stopped(book_, beliefs_);
  const bool stands = hovers ? vehicle.velocity.norm() <= kAtRest : circles;
  const bool moves = std::any_of(book_.tasks.begin(), book_.tasks.end(), [](const auto& one) {
    const Entry& entry = one.second;
    return entry.under_way() && !entry.has_not_moved() &&
           mission::type_of(entry.task).motion == functional::Motion::kMoves;
  });
  if (!stands || moves || agenda_.needed() || is_leaving()) return;
  const world::Vector3& at = vehicle.position;
  const auto& volumes = beliefs_.world().volumes;
  const bool inside = std::any_of(volumes.begin(), volumes.end(), [&](const auto& volume) {
    return volume.when.overlaps({now(), now() + kAhead}) && is_near(volume, at, 0);
  });
  if (!inside && (hovers || closed_around(false) == nullptr)) return;
  looked_ = now();
  check("it is in closed air");
}

// ---- what ----

bool AirWatch::goes_through(const Entry& entry, const world::Volume& volume) const {
  if (entry.task.way.empty()) return false;
  const MissionTime from = entry.seen.started ? now() : entry.dates.earliest_start;
  if (!volume.when.overlaps({from, entry.dates.latest_end})) return false;
  const world::VehicleModel& vehicle = beliefs_.model();
  const bool climbs = entry.task.type == "takeoff" && !vehicle.hovers && !entry.under_way();
  // In circles, around where it stands or a landing brings it.
  const double circles =
      vehicle.orbit_radius + (beliefs_.vehicle().airborne ? stay_radius(vehicle) : 0);
  const double margin = vehicle.body_radius + (climbs ? circles : 0);
  if (entry.under_way()) {
    const auto rest = world::rest_of(entry.task.way, beliefs_.vehicle().position);
    return leads_in(volume, margin, rest) || circles_into(rest.back(), volume) ||
           swings_into(rest, volume);
  }
  return leads_in(volume, margin, entry.task.way) || strays_into(entry.task.way, volume);
}

// One that cannot hover circles where its way ends. Home is where it comes down, closed or not.
bool AirWatch::circles_into(const world::Vector3& end, const world::Volume& volume) const {
  const world::VehicleModel& vehicle = beliefs_.model();
  const double from_home = (end - beliefs_.knowledge().home).head<2>().norm();
  if (vehicle.hovers || from_home < vehicle.orbit_radius) return false;
  return crosses(volume, vehicle.body_radius + stay_radius(vehicle), end, end);
}

// It passes by, and not so far that no flight along it would come there: one that hovers is carried
// past corners. Half of what ways keep away, so that one that was made since the volume is known is
// never in question.
bool AirWatch::strays_into(const std::vector<world::Vector3>& way,
                           const world::Volume& volume) const {
  const world::VehicleModel& vehicle = beliefs_.model();
  const world::Wind& wind = beliefs_.world().wind;
  const double stray = arrival_distance(vehicle, wind);
  const double turns = vehicle.hovers ? world::braking_distance(vehicle, vehicle.cruise_speed)
                                      : vehicle.orbit_radius + vehicle.min_turn_radius;
  const bool level = (way.back() - way.front()).head<2>().norm() > 2 * stray;
  if (!level || crosses(volume, stray, way.front(), way.front())) return false;
  return crosses(volume, stray + turns, way) &&
         flights_meet(way, {volume}, vehicle, wind, {vehicle.hovers ? stray / 4 : stray / 2, 0});
}

// From where it is, as fast as it is, one that hovers is carried past corners. Half of what a way
// is looked at with before it begins.
bool AirWatch::swings_into(const std::vector<world::Vector3>& rest,
                           const world::Volume& volume) const {
  const world::VehicleModel& vehicle = beliefs_.model();
  const world::Wind& wind = beliefs_.world().wind;
  const double stray = arrival_distance(vehicle, wind);
  const double braking = world::braking_distance(vehicle, vehicle.cruise_speed);
  if (!vehicle.hovers || !crosses(volume, stray + braking, rest)) return false;
  const world::Vector3& velocity = beliefs_.vehicle().velocity;
  const Pose pose{rest.front(), std::atan2(velocity.y(), velocity.x()), velocity.head<2>().norm()};
  return flights_meet(rest, {volume}, vehicle, wind, {stray / 4, 0}, {pose});
}

// One that has no end counts as far as it can be foreseen; it is looked at again before more
// closes.
bool AirWatch::stays_in(const Entry& entry, const world::Volume& volume) const {
  const auto stand = stand_of(entry, book_, beliefs_);
  if (!stand) return false;
  const MissionTime from = entry.seen.started ? now() : std::max(now(), entry.dates.earliest_start);
  const bool ends = entry.dates.latest_end != MissionTime::max();
  const MissionTime until = ends ? entry.dates.latest_end : std::max(from, now()) + kAhead;
  if (!volume.when.overlaps({from, until})) return false;
  const world::VehicleModel& vehicle = beliefs_.model();
  return crosses(volume, vehicle.body_radius + stay_radius(vehicle), *stand, *stand);
}

bool AirWatch::is_met(const Entry& entry, const world::Volume& volume) const {
  return goes_through(entry, volume) || stays_in(entry, volume);
}

const world::Volume* AirWatch::met_by(const Entry& entry) const {
  const auto& volumes = beliefs_.world().volumes;
  const auto found = std::find_if(volumes.begin(), volumes.end(),
                                  [&](const auto& one) { return is_met(entry, one); });
  return found == volumes.end() ? nullptr : &*found;
}

// ---- the UAV itself ----

// `stops`: what it does now; then it circles where it is.
const world::Volume* AirWatch::closed_around(bool stops) const {
  if (!beliefs_.vehicle().airborne) return nullptr;
  const world::VehicleModel& vehicle = beliefs_.model();
  const bool circles =
      stops || circled(book_, beliefs_).has_value() || was_stopped(book_, beliefs_);
  const double margin =
      vehicle.body_radius + (circles ? stay_radius(vehicle) : 3 * world::tracking_spread(vehicle));
  const world::Vector3 at = place_of_vehicle(book_, beliefs_);
  const auto& volumes = beliefs_.world().volumes;
  const auto found = std::find_if(volumes.begin(), volumes.end(), [&](const auto& volume) {
    return volume.when.overlaps({now(), now() + kAhead}) && crosses(volume, margin, at, at);
  });
  return found == volumes.end() ? nullptr : &*found;
}

bool AirWatch::is_leaving() const {
  return std::any_of(book_.goals.begin(), book_.goals.end(), [](const auto& one) {
    return one.second.task.name == kLeaveClosedAir && !is_settled(one.second.state);
  });
}

// A descent that is nearly over goes on: it is a way out too.
bool AirWatch::is_nearly_down() const {
  const world::Vector3& at = beliefs_.vehicle().position;
  const double height = at.z() - beliefs_.world().terrain.elevation(at.x(), at.y());
  const bool low = height <= kNearlyDown * beliefs_.model().descent_rate;
  return low && std::any_of(book_.tasks.begin(), book_.tasks.end(), [](const auto& one) {
           return one.second.under_way() && one.second.task.type == "land";
         });
}

// ---- what follows ----

// The goals that would meet closed air, in their order; `what` says how the first of them does.
std::vector<GoalId> AirWatch::goals_met(std::string& what) const {
  std::vector<GoalId> result;
  for (const GoalId id : book_.order) {
    for (const Entry* entry : book_.of(id)) {
      if (!book_.counts(*entry) || met_by(*entry) == nullptr) continue;
      if (result.empty())
        what = entry->task.way.empty() ? ", in which " + book_.named(id) + " would keep it"
                                       : ", which the way of " + book_.named(id) + " crosses";
      result.push_back(id);
      break;
    }
  }
  return result;
}

void AirWatch::check(const std::string& cause) {
  std::string what;
  const std::vector<GoalId> met = goals_met(what);
  std::set<GoalId> stopped;
  for (const GoalId id : met) {
    if (book_.is_given(id)) stopped.insert(id);
  }
  const bool may_leave = own_goals_.can_plan(kLeaveClosedAir) && !is_leaving() && !is_nearly_down();
  const bool stops = std::any_of(stopped.begin(), stopped.end(), [&](GoalId id) {
    const auto tasks = book_.of(id);
    return std::any_of(tasks.begin(), tasks.end(), [](const Entry* one) {
      return one->under_way() && holds_vehicle(one->task);
    });
  });
  const world::Volume* around = may_leave ? closed_around(stops) : nullptr;
  if (around != nullptr) {
    for (const TaskId id : book_.in_hand()) stopped.insert(book_.tasks.at(id).task.origin);
    const std::string leaves =
        "the air around it is closed (volume '" + around->name + "'): it leaves at once";
    out_.notice(leaves);
    what += "; " + leaves;
    own_goals_.enter(*own_goals_.next(kLeaveClosedAir));
  }
  if (met.empty() && around == nullptr) return;
  committer_.retire(book_.falling_with(stopped));
  agenda_.plan_anew(met.empty() ? std::nullopt : std::optional(met.front()), true, cause + what);
}

}  // namespace skein::supervisor
