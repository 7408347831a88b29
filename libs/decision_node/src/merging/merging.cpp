// SPDX-License-Identifier: Apache-2.0
#include "merging/merging.hpp"

#include <algorithm>

#include "core.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/supervisor/way_home.hpp"

namespace skein::decision_node {

namespace {

/// Flights out of the way: beyond the own tasks of Safekeeping, which nobody else may use either.
constexpr functional::TaskId kFirstAside{functional::kFirstBackgroundId.value() / 2};

constexpr Duration kSaidAgain = Duration::milliseconds(10'000);
constexpr Duration kStale = Duration::milliseconds(3'000);     ///< beliefs of the vehicle may be
constexpr Duration kAside = Duration::milliseconds(3'000);     ///< a place aside is had in
constexpr Duration kUnasked = Duration::milliseconds(10'000);  ///< after the energy is short
constexpr double kAtRest = 0.5;                                // [m/s]

bool is_aside(functional::TaskId task) {
  return task >= kFirstAside && task < functional::kFirstBackgroundId;
}

}  // namespace

Merging::Merging(Core& core) : core_(core) {
  const auto& config = core.config().merging;
  if (!config) return;
  merger_.emplace(config->members, core.config().uav);
  margins_ = merging::margins_of(config->model, config->wind, config->model.cruise_speed);
}

// ---- motions ----

bool Merging::takes(const functional::Request& request) {
  if (!merger_ || !(needs_air(request) || comes_after_aside(request))) return false;
  if (waiting_) {
    core_.post_status({request.id, functional::TaskState::kAborted,
                       "another motion waits for its air: " + waiting_->request.type});
    return true;
  }
  waiting_.emplace();
  waiting_->request = request;
  waiting_->since = waiting_->said = core_.bus().now();
  ask();
  return true;
}

/// What it flew aside for is given up, and what comes now needs it to stand still: once it is
/// there.
bool Merging::comes_after_aside(const functional::Request& request) const {
  return flown_ && !flown_->over && is_aside(flown_->airway.request.id) &&
         functional::TaskTypes::shipped().of(request.type).holds_vehicle();
}

bool Merging::drop(functional::TaskId task) {
  if (!waiting_ || waiting_->request.id != task) return false;
  waiting_.reset();
  give(merging::Withdraw{});
  return true;
}

/// From where it is now: as often as it waits anew.
void Merging::ask() {
  if (!waiting_ || !has_seen_ || (flown_ && !flown_->over)) return;
  if (!needs_air(waiting_->request)) {
    functional::Request request = std::move(waiting_->request);
    waiting_.reset();
    return core_.vehicle().begin(std::move(request));
  }
  auto airways = airways_of(waiting_->request, at_any_height(waiting_->request),
                            *core_.config().merging, situation());
  if (!airways) {
    waiting_->why_not = airways.error().why;
    return;
  }
  waiting_->why_not.clear();
  waiting_->aside_since.reset();
  want(std::move(*airways));
}

void Merging::want(Airways airways, merging::Volumes afterwards) {
  waiting_->airways = std::move(airways);
  std::vector<merging::Volumes> choices;
  for (const Airway& one : waiting_->airways) choices.push_back(one.air);
  give(merging::Want{std::move(choices), std::move(afterwards)});
}

void Merging::refuse(const std::string& why) {
  const functional::TaskId task = waiting_->request.id;
  waiting_.reset();
  give(merging::Withdraw{});
  core_.post_status({task, functional::TaskState::kAborted, why});
}

void Merging::begin(const Airway& airway, const std::string& state) {
  note(state, &airway);
  flown_ = Flown{airway, false, false};
  rest_.reset();
  if (waiting_->aside_since) {
    waiting_->airways.clear();
    waiting_->was_aside = true;
    waiting_->waits_for.clear();
    waiting_->noted_for.clear();
  } else {
    waiting_.reset();
  }
  hold();
  core_.vehicle().begin(airway.request);
}

bool Merging::told(const functional::Status& status) {
  if (!merger_) return false;
  if (flown_ && flown_->airway.request.id == status.id && functional::is_terminal(status.state)) {
    flown_->over = true;
    flown_->ended = status.state == functional::TaskState::kEnded;
    come_to_rest();
    if (waiting_ && waiting_->airways.empty()) ask();
  }
  return is_aside(status.id);
}

// ---- the vehicle ----

void Merging::vehicle_told(const world::Telemetry& telemetry) {
  if (!merger_) return;
  const bool first = !has_seen_;
  seen_ = telemetry;
  has_seen_ = true;
  const bool airborne = telemetry.state.airborne;
  if (first && airborne) rest_ = telemetry.state.position;
  if (airborne && flown_ && flown_->airway.way &&
      flown_->airway.way->passed(telemetry.state.position))
    hold();
  come_to_rest();
  if (!waiting_) return;
  if (waiting_->airways.empty()) ask();
  if (waiting_ && !waiting_->why_not.empty() && core_.bus().now() > waiting_->since + kStale)
    return refuse(waiting_->why_not);
  look_at_energy();
}

/// What it flew is given back once it holds where it was to end, or stands still after it was
/// stopped. One that circles keeps all that it had when it was stopped: nobody knows where.
void Merging::come_to_rest() {
  const world::VehicleState& state = seen_.state;
  const bool flies = flown_ && !flown_->over;
  if (!state.airborne && !flies) {
    flown_.reset();
    rest_.reset();
    return hold();
  }
  if (!flown_ || flies || !state.airborne) return hold();
  const bool there = flown_->ended && flown_->airway.end &&
                     (*flown_->airway.end - state.position).norm() <= margins_.settled;
  const bool still = margins_.hovers && state.velocity.norm() <= kAtRest;
  const bool circles = !margins_.hovers && flown_->ended && flown_->airway.end;
  if (!there && !still && !circles) return;
  rest_ = there || circles ? *flown_->airway.end : state.position;
  flown_.reset();
  hold();
}

void Merging::hold() {
  merging::Volumes air;
  if (flown_ && flown_->airway.way) {
    air = flown_->airway.way->left();
  } else if (flown_) {
    air = flown_->airway.air;
  } else if (rest_) {
    air = {stay_at(*rest_, margins_)};
  }
  if (air != merger_->held()) give(merging::Hold{std::move(air)});
}

// ---- waiting ----

/// Whoever can wait no longer goes, and says so: that it falls is no better.
void Merging::look_at_energy() {
  const Deliberation& deliberation = core_.deliberation();
  if (!waiting_ || waiting_->airways.empty() || waiting_->aside_since || !seen_.state.airborne)
    return;
  if (core_.bus().now() < waiting_->since + kUnasked || core_.config().knowledge == nullptr) return;
  if (!supervisor::must_come_home(seen_.state.energy, *core_.config().knowledge,
                                  *deliberation.world(), core_.bus().now(), seen_.state.position))
    return;
  core_.bus().emit(Notice{"flies unasked: its energy lasts no longer than to come home; " +
                          waiting_->request.type + " waited for its air"});
  give(merging::Withdraw{});
  begin(Airway(waiting_->airways.front()), "unasked");
}

/// At once, and then not more often than every few seconds.
void Merging::note_waits() {
  if (waiting_->waits_for == waiting_->noted_for) return;
  if (!waiting_->noted_for.empty() && core_.bus().now() < waiting_->noted + kSaidAgain) return;
  waiting_->noted = core_.bus().now();
  waiting_->noted_for = waiting_->waits_for;
  note("waits", nullptr);
}

void Merging::say_it_waits() {
  if (waiting_) note_waits();
  if (!waiting_ || core_.bus().now() < waiting_->said + kSaidAgain) return;
  waiting_->said = core_.bus().now();
  core_.post_status({waiting_->request.id, functional::TaskState::kStarted, "waits for its air"});
}

void Merging::time_passes() {
  if (!merger_) return;
  say_it_waits();
  if (const auto until = aside_until(); until && core_.bus().now() >= *until) ask();
  give(merging::Tick{});
}

std::optional<MissionTime> Merging::next_wakeup() const {
  if (!merger_) return std::nullopt;
  std::optional<MissionTime> next = merger_->next_wakeup();
  if (waiting_) next = earliest(next, waiting_->said + kSaidAgain);
  return flown_ ? next : earliest(next, aside_until());
}

std::optional<MissionTime> Merging::aside_until() const {
  if (!waiting_ || !waiting_->aside_since) return std::nullopt;
  return *waiting_->aside_since + kAside;
}

// ---- others ----

void Merging::hear(const MergeTold& told) {
  if (merger_) give(merging::Heard{told.from, told.message});
}

void Merging::contact(const Contact& contact) {
  if (merger_ && !contact.ground) give(merging::InReach{contact.peer, contact.reachable});
}

void Merging::give(const merging::Input& input) {
  for (const merging::Effect& effect : merger_->handle(input, core_.bus().now()))
    std::visit([this](const auto& one) { carry_out(one); }, effect);
  tell_orders();
}

// What comes first in time, for the dates of plans.
void Merging::tell_orders() {
  supervisor::AirOrders seen;
  seen.uav = core_.config().uav;
  if (waiting_) seen.for_others = merger_->awaited();
  if (!seen.for_others.empty()) seen.waits = waiting_->request.id;
  if (flown_ && !flown_->over) seen.flies = flown_->airway.request.id;
  for (const merging::Merger::Waiter& one : merger_->waiters())
    (one.for_its_place ? seen.for_its_place : seen.for_its_way).push_back(one.peer);
  if (seen == orders_) return;
  orders_ = seen;
  core_.deliberation().orders_seen({orders_});
}

void Merging::carry_out(const merging::Tell& tell) {
  core_.bus().emit(SendMerge{tell.to, tell.message});
}

void Merging::carry_out(const merging::Granted& granted) {
  if (!waiting_ || granted.choice >= waiting_->airways.size()) return;
  begin(Airway(waiting_->airways[granted.choice]), waiting_->aside_since ? "aside" : "had");
}

void Merging::carry_out(const merging::Waits& waits) {
  if (!waiting_) return;
  std::vector<std::string> now_for;
  for (const merging::Waits::Why& one : waits.whys) now_for.push_back(one.peer + " " + one.why);
  if (!waiting_->aside_since) waiting_->waits_for = std::move(now_for);
  note_waits();
}

void Merging::carry_out(const merging::MoveAside& move) {
  if (!waiting_ || waiting_->airways.empty() || !rest_ || !seen_.state.airborne) return;
  const functional::TaskId id(kFirstAside.value() + aside_);
  Airways aside = ways_aside(id, merger_->others(), *core_.config().merging, situation());
  const merging::Volumes ends = merger_->ends();
  const auto others = std::stable_partition(aside.begin(), aside.end(),
                                            [&](const Airway& one) { return leads_on(one, ends); });
  if (move.for_itself) aside.erase(others, aside.end());
  if (aside.empty()) return;
  ++aside_;
  if (!waiting_->aside_since) waiting_->own_air = waiting_->airways.front().air;
  waiting_->aside_since = core_.bus().now();
  want(std::move(aside), waiting_->own_air);
}

// ---- what it knows ----

/// From there what it waits for could be flown past where the others will be.
bool Merging::leads_on(const Airway& aside, const merging::Volumes& ends) const {
  AirwaySituation there = situation();
  there.state.position = *aside.end;
  there.rest = aside.end;
  there.aside = true;
  const auto on = airways_of(waiting_->request, false, *core_.config().merging, there);
  return on && !overlap(on->front().air, ends);
}

/// Nothing is looked at on the way, and no role of a joint task is played by it.
bool Merging::at_any_height(const functional::Request& request) const {
  if (request.type != "goto") return false;
  if (request.id >= functional::kFirstRoleId && request.id < functional::kFirstOwnId) return false;
  const auto starts_with_it = [&](const executive::Literal& literal) {
    const auto* state = std::get_if<executive::TaskInState>(&literal.condition);
    return state != nullptr && state->task == request.id &&
           state->state == executive::TaskState::kRunning;
  };
  for (const mission::HeldTask& held : core_.execution().held())
    for (const executive::Clause& clause : held.task.preconditions)
      if (std::any_of(clause.begin(), clause.end(), starts_with_it)) return false;
  if (!core_.deliberation().possible()) return true;
  const mission::PlanReport& report = core_.deliberation().report();
  return std::none_of(report.tasks.begin(), report.tasks.end(), [&](const auto& one) {
    const auto& all = one.task.dependences;
    return std::any_of(all.begin(), all.end(), [&](const mission::Dependence& on) {
      return on.kind == mission::DependenceKind::kRunning && on.task == request.id;
    });
  });
}

AirwaySituation Merging::situation() const {
  const bool believes = core_.deliberation().possible();
  return {seen_.state, rest_, waiting_ && waiting_->was_aside,
          believes ? core_.deliberation().world()->volumes : core_.config().merging->volumes,
          core_.bus().now()};
}

void Merging::note(const std::string& state, const Airway* airway) {
  AirNoted noted{waiting_->request.id, waiting_->request.type, state, {}, 0, {}, {}};
  noted.waited = core_.bus().now() - waiting_->since;
  if (airway == nullptr) {
    noted.waits_for = waiting_->waits_for;
  } else {
    noted.raised = airway->raised;
    noted.air = airway->air;
  }
  core_.bus().emit(std::move(noted));
}

}  // namespace skein::decision_node
