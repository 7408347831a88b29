// SPDX-License-Identifier: Apache-2.0
// Air that is closed: across a way, where a task keeps the UAV, or around it.
#include <algorithm>

#include "core.hpp"
#include "flight/crossing.hpp"
#include "flight/flight_times.hpp"

namespace skein::supervisor {

namespace {

/// Time that it is given to leave air before that closes, and to plan anew.
constexpr Duration kWarning = Duration::milliseconds(60'000);
/// What closes within this is met: a little more, so that what is looked at when the warning is due
/// counts.
constexpr Duration kAhead = Duration::milliseconds(65'000);
/// A descent that is over sooner goes on [s].
constexpr double kNearlyDown = 15;
/// Radii from its middle within which it counts as on its circle, which it may still be joining.
constexpr double kOnCircle = 1.5;

/// A way out of closed air is no way into it: only what comes after it is outside counts.
bool leads_in(const world::Volume& volume, double margin, const std::vector<world::Vector3>& way) {
  std::size_t out = 0;
  while (out < way.size() && crosses(volume, margin, way[out], way[out])) ++out;
  if (out == 0) return crosses(volume, margin, way);
  return out == way.size() ||
         crosses(volume, margin, {way.begin() + static_cast<std::ptrdiff_t>(out), way.end()});
}

}  // namespace

// ---- when ----

// The next instant at which air is to close so soon that what is in it must leave.
std::optional<MissionTime> Supervisor::Core::next_closing() const {
  std::optional<MissionTime> next;
  for (const world::Volume& volume : world_->volumes) {
    if (volume.when.from <= MissionTime() + kWarning) continue;
    const MissionTime at = volume.when.from - kWarning;
    if (at > air_watched_) next = earliest(next, at);
  }
  return next;
}

void Supervisor::Core::watch_air() {
  const auto next = next_closing();
  if (!next || *next > now_) return;
  std::string names;
  for (const world::Volume& volume : world_->volumes) {
    const MissionTime at = volume.when.from - kWarning;
    if (at > air_watched_ && at <= now_) names += (names.empty() ? "'" : ", '") + volume.name + "'";
  }
  air_watched_ = now_;
  check_air("volume " + names + " about to close");
}

// ---- what ----

// Where a task keeps it: the end of the last way before it; nothing on the ground, and of what
// rides along with a flight.
std::optional<world::Vector3> Supervisor::Core::stand_of(const Entry& entry) const {
  const auto flies = [this](const mission::Dependence& on) {
    const Entry* other = book_.find(on.task);
    return on.kind == mission::DependenceKind::kRunning && other != nullptr &&
           !other->task.way.empty();
  };
  const auto& on = entry.task.dependences;
  if (!entry.task.way.empty() || std::any_of(on.begin(), on.end(), flies)) return std::nullopt;
  Whereabouts there{place(), vehicle_.airborne};
  for (const auto& [id, before] : book_.tasks) {
    if (id >= entry.task.id) break;
    if (book_.counts(before)) there = after(there, {before.task});
  }
  return there.airborne ? std::optional(there.position) : std::nullopt;
}

bool Supervisor::Core::goes_through(const Entry& entry, const world::Volume& volume) const {
  if (entry.task.way.empty()) return false;
  const MissionTime from = entry.seen.started ? now_ : entry.dates.earliest_start;
  if (!volume.when.overlaps({from, entry.dates.latest_end})) return false;
  const double margin = config_.knowledge->vehicle.body_radius;
  if (entry.under_way()) {
    return leads_in(volume, margin, rest_of(entry.task.way, vehicle_.position));
  }
  return leads_in(volume, margin, entry.task.way);
}

// One that has no end counts as far as it can be foreseen; it is looked at again before more
// closes.
bool Supervisor::Core::stays_in(const Entry& entry, const world::Volume& volume) const {
  const auto stand = stand_of(entry);
  if (!stand) return false;
  const MissionTime from = entry.seen.started ? now_ : std::max(now_, entry.dates.earliest_start);
  const bool ends = entry.dates.latest_end != MissionTime::max();
  const MissionTime until = ends ? entry.dates.latest_end : std::max(from, now_) + kAhead;
  if (!volume.when.overlaps({from, until})) return false;
  const world::VehicleModel& vehicle = config_.knowledge->vehicle;
  return crosses(volume, vehicle.body_radius + stay_radius(vehicle), *stand, *stand);
}

bool Supervisor::Core::is_met(const Entry& entry, const world::Volume& volume) const {
  return goes_through(entry, volume) || stays_in(entry, volume);
}

const world::Volume* Supervisor::Core::met_by(const Entry& entry) const {
  const auto found = std::find_if(world_->volumes.begin(), world_->volumes.end(),
                                  [&](const auto& one) { return is_met(entry, one); });
  return found == world_->volumes.end() ? nullptr : &*found;
}

// ---- the UAV itself ----

// What one that cannot hover circles over: where its last motion led, while it is near that.
std::optional<world::Vector3> Supervisor::Core::circled() const {
  const world::VehicleModel& vehicle = config_.knowledge->vehicle;
  if (vehicle.hovers || !vehicle_.airborne) return std::nullopt;
  std::optional<world::Vector3> over;
  for (const auto& [id, entry] : book_.tasks) {
    if (entry.task.way.empty() || !entry.seen.started) continue;
    if (!entry.over()) return std::nullopt;
    over = entry.done ? std::optional(entry.task.way.back()) : std::nullopt;
  }
  const bool near = over && (vehicle_.position - *over).norm() <= kOnCircle * stay_radius(vehicle);
  return near ? over : std::nullopt;
}

const world::Volume* Supervisor::Core::closed_around() const {
  if (!vehicle_.airborne || !ever_gave_) return nullptr;
  const world::VehicleModel& vehicle = config_.knowledge->vehicle;
  const bool circles = circled().has_value();
  const double margin =
      vehicle.body_radius + (circles ? stay_radius(vehicle) : 3 * world::tracking_spread(vehicle));
  const world::Vector3 at = place();
  const auto found =
      std::find_if(world_->volumes.begin(), world_->volumes.end(), [&](const auto& volume) {
        return volume.when.overlaps({now_, now_ + kAhead}) && crosses(volume, margin, at, at);
      });
  return found == world_->volumes.end() ? nullptr : &*found;
}

bool Supervisor::Core::is_leaving() const {
  return std::any_of(book_.goals.begin(), book_.goals.end(), [](const auto& one) {
    return one.second.task.name == kLeaveClosedAir && !is_settled(one.second.state);
  });
}

// A descent that is nearly over goes on: it is a way out too.
bool Supervisor::Core::is_nearly_down() const {
  const world::Vector3& at = vehicle_.position;
  const double height = at.z() - world_->terrain.elevation(at.x(), at.y());
  const bool low = height <= kNearlyDown * config_.knowledge->vehicle.descent_rate;
  return low && std::any_of(book_.tasks.begin(), book_.tasks.end(), [](const auto& one) {
           return one.second.under_way() && one.second.task.type == "land";
         });
}

// ---- what follows ----

// The goals that would meet closed air, in their order; `what` says how the first of them does.
std::vector<GoalId> Supervisor::Core::goals_met(std::string& what) const {
  std::vector<GoalId> result;
  for (const GoalId id : book_.order) {
    for (const Entry* entry : book_.of(id)) {
      if (!book_.counts(*entry) || met_by(*entry) == nullptr) continue;
      if (result.empty())
        what = entry->task.way.empty() ? ", in which " + named(id) + " would keep it"
                                       : ", which the way of " + named(id) + " crosses";
      result.push_back(id);
      break;
    }
  }
  return result;
}

// Every goal that would meet closed air is stopped; the first of them counts as failed. A UAV in
// closed air stops all that it does and leaves first.
void Supervisor::Core::check_air(const std::string& cause) {
  std::string what;
  const std::vector<GoalId> met = goals_met(what);
  std::set<GoalId> stopped;
  for (const GoalId id : met) {
    if (book_.is_given(id)) stopped.insert(id);
  }
  const bool may_leave = can_plan(kLeaveClosedAir) && !is_leaving() && !is_nearly_down();
  const world::Volume* around = may_leave ? closed_around() : nullptr;
  if (around != nullptr) {
    for (const TaskId id : book_.in_hand()) stopped.insert(book_.tasks.at(id).task.origin);
    const std::string leaves =
        "the air around it is closed (volume '" + around->name + "'): it leaves at once";
    notice(leaves);
    what += "; " + leaves;
    enter_own(*own_task(kLeaveClosedAir));
  }
  if (met.empty() && around == nullptr) return;
  retire(book_.falling_with(stopped));
  need(met.empty() ? std::nullopt : std::optional(met.front()), true, cause + what);
}

}  // namespace skein::supervisor
