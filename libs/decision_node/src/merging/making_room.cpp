// SPDX-License-Identifier: Apache-2.0
// Whoever has nothing to do makes room.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core.hpp"
#include "merging/merging.hpp"
#include "merging/short_energy.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/mission/degree.hpp"
#include "skein/world/crossing.hpp"

namespace skein::decision_node {

namespace {

/// Who stays with nothing to do, and has been wanted away for so long, makes room.
constexpr Duration kMakesRoom = Duration::milliseconds(1'000);

/// Who waits for its air in closed air looks for other air to leave by after so long.
constexpr Duration kLeavesClosedAir = Duration::milliseconds(1'000);

/// Who waits for its air over where another is to take off or land, or where one wants to come that
/// has waited long, gets out of the way after so long.
constexpr Duration kLeavesPad = Duration::milliseconds(10'000);

/// Who has waited for its air to land for so long waits for somebody who does not leave: it makes
/// room like one that has nothing to do.
constexpr Duration kLandsNotSoon = Duration::milliseconds(60'000);
/// It comes back to land no sooner while others want to go where it was.
constexpr Duration kGivesWay = Duration::milliseconds(60'000);

/// Of the UAV's own, for want of anything else.
bool waits_safely(Core& core, const executive::TaskStatus& task) {
  return task.type == "wait" && task.id < functional::kFirstRoleId && !is_terminal(task.state) &&
         task.state != executive::TaskState::kScheduled &&
         core.deliberation().origin_of(task.id) == mission::GoalId();
}

/// A meeting ends it, as soon as the partners have come.
bool ends_with_meeting(const mission::ElementaryTask& wait, const mission::PlanReport& report) {
  const auto meets = [&](const mission::Dependence& on) {
    return std::any_of(report.tasks.begin(), report.tasks.end(), [&](const auto& one) {
      return one.task.id == on.task && type_of(one.task).synchronises();
    });
  };
  return !wait.stop.empty() && std::all_of(wait.stop.begin(), wait.stop.end(), meets);
}

/// A wait of the plan, until orders or partners come: wherever it is.
bool waits_for_others(Core& core, const executive::TaskStatus& task) {
  if (task.type != "wait" || task.state != executive::TaskState::kRunning) return false;
  if (!core.deliberation().possible()) return false;
  const mission::PlanReport& report = core.deliberation().report();
  return std::any_of(report.tasks.begin(), report.tasks.end(), [&](const auto& one) {
    return one.task.id == task.id && (one.task.open_ended || ends_with_meeting(one.task, report));
  });
}

/// A synchronisation, or a joint task that is not agreed on, or whose role keeps no place: it waits
/// for others, wherever it is.
bool waits_for_partners(Core& core, const executive::TaskStatus& task) {
  return functional::TaskTypes::shipped().of(task.type).synchronises() ||
         core.interaction().needs_no_place(task.id);
}

std::vector<executive::TaskStatus> safe_waits(Core& core) {
  std::vector<executive::TaskStatus> waits;
  for (const executive::TaskStatus& one : core.execution().tasks())
    if (waits_safely(core, one)) waits.push_back(one);
  return waits;
}

/// The vehicle has it under way, and need not.
std::optional<functional::TaskId> wait_for_others(Core& core) {
  const auto under_way = core.vehicle().under_way();
  for (const executive::TaskStatus& one : core.execution().tasks()) {
    const bool has = std::find(under_way.begin(), under_way.end(), one.id) != under_way.end();
    if (has && waits_for_others(core, one)) return one.id;
  }
  return std::nullopt;
}

/// Of what the UAV does nothing needs the vehicle where it stays. Below degree 4 it is where its
/// operator has put it.
bool has_nothing_to_do(Core& core) {
  if (!mission::deliberates(core.degree())) return false;
  const auto tasks = core.execution().tasks();
  const std::size_t idle = safe_waits(core).size() + (wait_for_others(core) ? 1 : 0);
  if (core.vehicle().under_way().size() > idle) return false;
  return std::none_of(tasks.begin(), tasks.end(), [&](const executive::TaskStatus& one) {
    const bool waits = one.state == executive::TaskState::kScheduled;
    if (waits || is_terminal(one.state) || one.id >= executive::kFirstBackgroundId) return false;
    return !waits_safely(core, one) && !waits_for_others(core, one) &&
           !waits_for_partners(core, one);
  });
}

/// Another one waits for it to leave where it stays: somewhere in all that it had, when it circles
/// since it was stopped.
bool is_in_the_way(const merging::Merger& merger, bool somewhere) {
  const auto waiters = merger.waiters();
  return std::any_of(waiters.begin(), waiters.end(),
                     [&](const auto& one) { return somewhere || one.for_its_place; });
}

/// Those who wait for it to leave want air down to the ground where it stays.
bool is_over_a_pad(const merging::Merger& merger, const world::Terrain& terrain) {
  const merging::Volumes others = merger.peers().others();
  return !merger.waiters().empty() &&
         std::any_of(others.begin(), others.end(), [&](const merging::Volume& one) {
           return one.from == one.to && one.floor < terrain.elevation(one.from.x(), one.from.y()) &&
                  overlap({one}, merger.held());
         });
}

/// One that has waited long wants to come where it stays.
bool is_pressed(const merging::Merger& merger) {
  const auto waiters = merger.waiters();
  return std::any_of(waiters.begin(), waiters.end(),
                     [](const auto& one) { return one.for_its_place && one.presses; });
}

/// Closed air is where it stays, or on the circle that it flies there.
bool is_in_closed_air(const world::Vector3& place, const world::VehicleModel& model,
                      const AirwaySituation& situation) {
  constexpr Duration kMoment = Duration::milliseconds(1);
  const double circle = model.hovers ? 0 : model.orbit_radius;
  const auto& volumes = situation.volumes;
  return std::any_of(volumes.begin(), volumes.end(), [&](const world::Volume& one) {
    return one.when.overlaps({situation.now, situation.now + kMoment}) &&
           world::crosses(one, circle, place, place);
  });
}

/// Whether who waits there stays in closed air, or where others are to take off or land or have
/// waited long to come, and how long it does so. Who is to land there itself goes first, if it can.
std::optional<Duration> patience_at(const world::Vector3& place, const Waiting& waiting,
                                    const merging::Merger& merger, const MergingConfig& config,
                                    const AirwaySituation& situation) {
  const bool over_a_pad = is_over_a_pad(merger, *config.terrain);
  if (waiting.request.type == "land") {
    const bool soon = situation.now < waiting.since + kLandsNotSoon;
    const bool is_wanted = over_a_pad || is_in_the_way(merger, false);
    return is_wanted && !soon ? std::optional(kMakesRoom) : std::nullopt;
  }
  if (is_in_closed_air(place, config.model, situation)) return kLeavesClosedAir;
  const bool is_wanted = over_a_pad || is_pressed(merger);
  return is_wanted ? std::optional(kLeavesPad) : std::nullopt;
}

bool is_aborting(const executive::TaskStatus& task) {
  return task.state == executive::TaskState::kAborting;
}

/// From where that one ends, what waits could be flown past where the others will be; of what is
/// done at a place, the way to it.
bool leads_on(const Airway& aside, const functional::Request& request, const world::Vector3& place,
              const merging::Volumes& ends, const MergingConfig& config,
              AirwaySituation situation) {
  situation.aside = true;
  situation = resting_at(std::move(situation), *aside.end);
  const Airways on = !needs_air(request) || is_done_in_place(request)
                         ? flights_to(place, aside.request.id, config, situation)
                         : airways_of(request, false, config, situation).value_or(Airways());
  return !on.empty() && !overlap(on.front().air, ends);
}

/// The vehicle is stopped in a wait for others. False: it has none.
bool leave_wait(Core& core, LeftWait& left) {
  const auto wait = wait_for_others(core);
  if (!wait) return false;
  if (!left.is(*wait)) core.vehicle().interrupt(*wait);
  left.leave(*wait);
  return true;
}

/// Whose energy does not last for it stays, and the next of the circle moves.
bool energy_lasts_after(Core& core, const Airway& aside, const world::VehicleState& seen) {
  const auto& knowledge = core.config().knowledge;
  if (knowledge == nullptr || !core.deliberation().possible()) return true;
  return ShortEnergy(*knowledge, *core.deliberation().world(), core.bus().now())
      .lasts_after(aside, seen.energy);
}

/// Those that lead on come first, or are all.
template <class Leads>
Airways ordered(Airways aside, bool only_leading, const Leads& leads) {
  const auto others = std::stable_partition(aside.begin(), aside.end(), leads);
  if (only_leading) aside.erase(others, aside.end());
  return aside;
}

}  // namespace

/// Else one that waits here for another, at a meeting, is waited for by it for its air; and one
/// whose joint task nobody else is free for lets others wait all that time.
void Merging::look_for_room() {
  const MissionTime now = core_.bus().now();
  if (!refused_.may_try(now)) return;
  if (waiting_) return leave_place();
  const bool is_wanted = vehicle_.stays() && is_in_the_way(*merger_, !vehicle_.rest());
  if (!is_wanted || !has_nothing_to_do(core_)) return room_since_.reset();
  if (!room_since_) room_since_ = now;
  if (now < *room_since_ + kMakesRoom) return;
  const std::vector<executive::TaskStatus> waits = safe_waits(core_);
  if (std::any_of(waits.begin(), waits.end(), is_aborting)) return;
  const merging::Volumes others = merger_->peers().others();
  Airways aside = ways_aside(own_ids_.take(), others, *core_.config().merging, situation());
  if (!aside.empty() && !waits.empty()) {  // once they have ended, there is room to be made
    for (const executive::TaskStatus& one : waits) core_.execution().run(executive::Abort{one.id});
    return;
  }
  if (!aside.empty() && leave_wait(core_, left_wait_)) return;
  room_since_ = now;
  if (aside.empty()) return;
  waiting_ = waiting_since(now, aside.front().request);
  waiting_->aside_since = now;
  waiting_->makes_room = true;
  want(std::move(aside));
}

/// It waits itself, for somebody who is in no circle with it: it gets out of the way as if there
/// were a circle.
void Merging::leave_place() {
  const bool could = !waiting_->airways.empty() && !waiting_->aside_since &&
                     !waiting_->comes_back && vehicle_.stays();
  const auto patience = could ? patience_at(vehicle_.place(), *waiting_, *merger_,
                                            *core_.config().merging, situation())
                              : std::nullopt;
  if (!patience) return room_since_.reset();
  const MissionTime now = core_.bus().now();
  if (!room_since_) room_since_ = now;
  if (now < *room_since_ + *patience) return;
  room_since_.reset();
  if (waiting_->request.type == "land") waiting_->gives_way_until = now + kGivesWay;
  carry_out(merging::MoveAside{{core_.config().uav}, false});
}

/// To where nobody wants to go; when that gave it no air, also higher up, and to where neither the
/// circle nor whoever waits for it wants to go: others wait for it a little longer.
void Merging::carry_out(const merging::MoveAside& move) {
  if (!waiting_ || waiting_->airways.empty() || !vehicle_.stays()) return;
  if (!refused_.may_try(core_.bus().now())) return;
  const bool again = waiting_->aside_since.has_value();
  const world::Vector3 place = place_.value_or(vehicle_.place());
  const merging::Volumes ends = merger_->peers().ends();
  const auto lasts = [&](const Airway& one) {
    return energy_lasts_after(core_, one, vehicle_.state());
  };
  const auto places = [&](const merging::Volumes& taken, const std::vector<double>& heights) {
    return ordered(
        ways_aside(own_ids_.take(), taken, *core_.config().merging, situation(), heights), true,
        lasts);
  };
  const auto leads = [&](const Airway& one) {
    return leads_on(one, waiting_->request, place, ends, *core_.config().merging, situation());
  };
  Airways aside = ordered(places(merger_->peers().others(), {0}), move.for_itself, leads);
  if (again || aside.empty()) {
    std::vector<std::string> in_need = move.circle;
    for (const merging::Merger::Waiter& one : merger_->waiters()) in_need.push_back(one.peer);
    Airways more =
        ordered(places(merger_->peers().taken(in_need), {0, 24, 48}), move.for_itself, leads);
    std::move(more.begin(), more.end(), std::back_inserter(aside));
  }
  if (aside.empty()) return;
  if (!again) waiting_->own_air = waiting_->airways.front().air;
  waiting_->aside_since = core_.bus().now();
  want(std::move(aside), waiting_->own_air);
}

std::optional<world::Vector3> Merging::way_home_begins() const {
  if (!merger_ || merger_->can_ask() || home_.choices().empty()) return std::nullopt;
  if (!vehicle_.flies() || !vehicle_.flown()->airway.way) return std::nullopt;
  const Airway& flight = vehicle_.flown()->airway;
  return flies_portion() || flight.request.id < functional::kFirstAsideId ? flight.end
                                                                          : std::nullopt;
}

std::function<bool(const world::Vector3&)> Merging::free_to_stay() const {
  if (!merger_) return {};
  return [ends = merger_->peers().ends(), margins = margins_](const world::Vector3& place) {
    merging::Volume air = stay_at(place, margins);
    air.radius = margins.way;
    return !overlap({air}, ends);
  };
}

}  // namespace skein::decision_node
