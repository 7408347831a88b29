// SPDX-License-Identifier: Apache-2.0
#include "merging/merging.hpp"

#include <algorithm>
#include <utility>

#include "core.hpp"
#include "skein/elementary/parameter_reader.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/mission/degree.hpp"
#include "skein/supervisor/way_home.hpp"

namespace skein::decision_node {

namespace {

constexpr Duration kSaidAgain = Duration::milliseconds(10'000);
constexpr Duration kStale = Duration::milliseconds(3'000);     ///< beliefs of the vehicle may be
constexpr Duration kAside = Duration::milliseconds(3'000);     ///< a place aside is had in
constexpr Duration kUnasked = Duration::milliseconds(10'000);  ///< after the energy is short
/// A role's way is flown higher than it asked for once it has waited so long.
constexpr Duration kRises = Duration::milliseconds(10'000);
/// Who waits for it longer gives it up: as a rule it is its partner that stays there and waits for
/// it to come.
constexpr Duration kRoleWaits = Duration::milliseconds(240'000);
/// A way of the plan that is waited for longer is given up: the plan has something else to do, or
/// somebody else can. Who waits has pressed for two minutes then.
constexpr Duration kPlanWaits = Duration::milliseconds(360'000);
/// Who has waited so long for others to leave looks for a way around them, and so often again.
constexpr Duration kLooksAround = Duration::milliseconds(15'000);
constexpr double kAtRest = 0.5;  // [m/s]

bool is_aside(functional::TaskId task) {
  return task >= kFirstAside && task < functional::kFirstBackgroundId;
}

/// Also of one that the ground station plays.
bool is_of_role(const functional::Request& request) {
  return request.id >= functional::kFirstPlayedId && request.id < functional::kFirstOwnId;
}

/// A takeoff or a way of the plan's that something else could come before, or somebody else could
/// do; not that of a goal which lands. Also one that an operator had asked for before the UAV
/// planned for itself: the plan waits behind it.
bool may_be_given_up(Core& core, const functional::Request& request) {
  const bool moves = request.type == "goto" || request.type == "takeoff";
  if (!moves || !mission::deliberates(core.degree()) || !core.deliberation().possible())
    return false;
  const mission::GoalId goal = core.deliberation().origin_of(request.id);
  if (goal == mission::GoalId()) return request.id < functional::kFirstPlayedId;
  const auto& tasks = core.deliberation().report().tasks;
  return std::none_of(tasks.begin(), tasks.end(), [&](const mission::PlannedTask& one) {
    return one.task.origin == goal && one.task.type == "land";
  });
}

/// How long it waits before it is given up; nothing: for good.
std::optional<Duration> longest_wait(Core& core, const functional::Request& request) {
  if (is_of_role(request)) return kRoleWaits;
  return may_be_given_up(core, request) ? std::optional(kPlanWaits) : std::nullopt;
}

/// Nothing is looked at on the way. A role of a joint task asks for its heights; over whoever stays
/// where its way leads it goes all the same, before it waits for ever.
bool at_any_height(Core& core, const functional::Request& request, bool asked_long) {
  if (request.type != "goto") return false;
  if (is_of_role(request) && !asked_long) return false;
  const auto starts_with_it = [&](const executive::Literal& literal) {
    const auto* state = std::get_if<executive::TaskInState>(&literal.condition);
    return state != nullptr && state->task == request.id &&
           state->state == executive::TaskState::kRunning;
  };
  for (const mission::HeldTask& held : core.execution().held())
    for (const executive::Clause& clause : held.task.preconditions)
      if (std::any_of(clause.begin(), clause.end(), starts_with_it)) return false;
  if (!core.deliberation().possible()) return true;
  const mission::PlanReport& report = core.deliberation().report();
  return std::none_of(report.tasks.begin(), report.tasks.end(), [&](const auto& one) {
    const auto& all = one.task.dependences;
    return std::any_of(all.begin(), all.end(), [&](const mission::Dependence& on) {
      return on.kind == mission::DependenceKind::kRunning && on.task == request.id;
    });
  });
}

}  // namespace

Merging::Merging(Core& core) : core_(core), home_(core) {
  const auto& config = core.config().merging;
  if (!config) return;
  merger_.emplace(config->members, core.config().uav, merging::Limits{}, config->witness);
  margins_ = merging::margins_of(config->model, config->wind, config->model.cruise_speed);
}

// ---- motions ----

bool Merging::takes(const functional::Request& request) {
  // Whoever asks for it once more, as another executive that takes it over does, is told by the
  // vehicle how far it is.
  if (!merger_ || (flown_ && flown_->flies(request.id))) return false;
  if (flies_portion() && portions_->task() == request.id) {
    if (portions_->running) core_.post_status({request.id, functional::TaskState::kRunning, ""});
    return true;
  }
  if (waiting_ && waiting_->makes_room) stop_waiting();
  if (waiting_ && waiting_->request.id == request.id) {
    say_it_has_begun();
    return true;
  }
  // The vehicle cannot tell: it was not given the other yet.
  if (waiting_ && functional::TaskTypes::shipped().of(request.type).holds_vehicle()) {
    core_.post_status({request.id, functional::TaskState::kAborted,
                       "another motion waits for its air: " + waiting_->request.type});
    return true;
  }
  const bool once_there = flown_ && flown_->is_waited_for_by(request);
  if (!needs_air(request) && !once_there && !is_to_come_back(request)) return false;
  wait_for(request);
  ask();
  return true;
}

void Merging::wait_for(functional::Request request) {
  waiting_.emplace();
  waiting_->request = std::move(request);
  waiting_->since = waiting_->said = core_.bus().now();
  waiting_->looks_around = waiting_->since + kLooksAround;
}

/// A portion of a sweep is flown as it is.
bool Merging::may_be_raised(bool asked_long) const {
  const bool portion = portions_ && portions_->task() == waiting_->request.id;
  return !portion && at_any_height(core_, waiting_->request, asked_long);
}

bool Merging::Flown::is_waited_for_by(const functional::Request& request) const {
  return !over && is_aside(airway.request.id) &&
         functional::TaskTypes::shipped().of(request.type).holds_vehicle();
}

bool Merging::drop(functional::TaskId task) {
  if (!waiting_ || waiting_->request.id != task) return false;
  stop_waiting();
  portions_.reset();
  place_.reset();  // what comes next is planned from where it is
  return true;
}

void Merging::stop_waiting() {
  if (!waiting_->noted_for.empty()) note("given-up", nullptr);
  waiting_.reset();
  give(merging::Withdraw{});
}

bool Merging::is_to_come_back(const functional::Request& request) const {
  if (!place_ || !seen_.state.airborne || !is_done_in_place(request)) return false;
  return (*place_ - rest_.value_or(seen_.state.position)).norm() > margins_.settled;
}

/// From where it is now: as often as it waits anew.
void Merging::ask() {
  if (!waiting_ || !has_seen_ || (flown_ && !flown_->over)) return;
  if (waiting_->makes_room) return stop_waiting();
  waiting_->comes_back = false;
  waiting_->asked_long = core_.bus().now() >= waiting_->since + kRises;
  if (is_to_come_back(waiting_->request)) {
    if (Airways back = flights_to(*place_, aside_, *core_.config().merging, situation());
        !back.empty()) {
      aside_ = functional::TaskId(aside_.value() + 1);
      waiting_->comes_back = true;
      waiting_->aside_since.reset();
      merging::Volumes there =
          air_from(*place_, waiting_->request, *core_.config().merging, situation());
      return want(std::move(back), std::move(there));
    }
  }
  if (!needs_air(waiting_->request)) {
    functional::Request request = std::move(waiting_->request);
    waiting_.reset();
    return core_.vehicle().begin(std::move(request));
  }
  cut();
  auto airways = airways_of(waiting_->request, may_be_raised(waiting_->asked_long),
                            *core_.config().merging, situation());
  if (!airways) return cannot_fly(airways.error().why);
  for (Airway& home : home_.flights(waiting_->request, rest_)) airways->push_back(std::move(home));
  waiting_->why_not.clear();
  waiting_->aside_since.reset();
  want(std::move(*airways));
}

/// Perhaps the vehicle is not what it was thought to be: it is looked at once more.
void Merging::cannot_fly(const std::string& why) {
  waiting_->why_not = why;
  waiting_->airways.clear();
  waiting_->aside_since.reset();
  give(merging::Withdraw{});
}

void Merging::want(Airways airways, merging::Volumes afterwards) {
  waiting_->airways = std::move(airways);
  std::vector<merging::Volumes> choices;
  for (const Airway& one : waiting_->airways) choices.push_back(one.air);
  const bool leaves = waiting_->request.type == "land" && !waiting_->comes_back &&
                      !waiting_->aside_since.has_value();
  give(merging::Want{std::move(choices), std::move(afterwards), leaves});
}

void Merging::refuse(std::string why, functional::AbortCause cause) {
  const functional::TaskId task = waiting_->request.id;
  stop_waiting();
  portions_.reset();
  core_.post_status({task, functional::TaskState::kAborted, std::move(why), cause});
}

void Merging::begin(const Airway& airway, const std::string& state) {
  note(state, &airway);
  const bool aside = waiting_->aside_since.has_value();
  flown_ = Flown{airway, false, false};
  if (!aside && !waiting_->comes_back) take_portion(flown_->airway.request);
  if (aside && !place_) place_ = rest_;
  if (!aside && !waiting_->comes_back) place_.reset();
  rest_.reset();
  if (waiting_->makes_room || (!aside && !waiting_->comes_back)) {
    waiting_.reset();
  } else {
    waiting_->airways.clear();
    waiting_->was_aside = waiting_->was_aside || aside;
    waiting_->waits_for.clear();
    waiting_->noted_for.clear();
  }
  hold();
  core_.vehicle().begin(flown_->airway.request);
}

bool Merging::told(const functional::Status& status) {
  if (!merger_) return false;
  const bool of_portion = portions_ && portions_->flown == status.id;
  if (of_portion && !functional::is_terminal(status.state)) portion_runs(status);
  if (flown_ && flown_->airway.request.id == status.id && functional::is_terminal(status.state)) {
    flown_->over = true;
    flown_->ended = status.state == functional::TaskState::kEnded;
    come_to_rest();
    if (of_portion) portion_over(status);
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
  if (airborne && flown_ && !flown_->over && flown_->passed(telemetry.state.position)) hold();
  ask_ahead();
  come_to_rest();
  look_for_room();
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
  if (flown_) {
    air = flown_->air();
  } else if (rest_) {
    air = {stay_at(*rest_, margins_)};
  }
  if (portions_ && portions_->ahead)
    air.insert(air.end(), portions_->ahead->air.begin(), portions_->ahead->air.end());
  if (air != merger_->held()) give(merging::Hold{std::move(air)});
  const auto rest = flown_ && !flown_->over ? flown_->airway.end : rest_;
  if (!home_.is_new(rest)) return;
  home_.look(rest, situation());
  give(merging::Need{home_.choices()});
}

// ---- waiting ----

/// Not where others stay where it is to go: it would wait there.
void Merging::look_for_way_around() {
  const auto from = waiting_ ? waiting_->looks_around_from() : std::nullopt;
  if (!from || core_.bus().now() < *from) return;
  waiting_->looks_around = core_.bus().now() + kLooksAround;
  const bool could = seen_.state.airborne && core_.deliberation().possible();
  if (!could || merger_->awaited().empty() || !may_be_raised(waiting_->asked_long)) return;
  auto airways = airways_of(waiting_->request, true, *core_.config().merging, situation());
  if (!airways || airways->empty()) return;
  const merging::Volumes taken = merger_->taken();
  if (overlap({airways->front().air.back()}, taken)) return;
  const auto world = core_.deliberation().world();
  auto around = way_around(waiting_->request, taken, *core_.config().merging, situation(), *world);
  if (!around) return;
  const double home = supervisor::least_to_come_home(*core_.config().knowledge, *world,
                                                     core_.bus().now(), *around->end);
  if (around->energy + home > seen_.state.energy) return;
  airways->push_back(std::move(*around));
  want(std::move(*airways));
}

/// Whoever can wait no longer goes, and says so: that it falls is no better.
void Merging::look_at_energy() {
  const Deliberation& deliberation = core_.deliberation();
  if (!waiting_ || waiting_->airways.empty() || waiting_->aside_since || !seen_.state.airborne)
    return;
  if (flies_portion()) return;
  if (core_.bus().now() < waiting_->since + kUnasked || core_.config().knowledge == nullptr) return;
  if (!supervisor::must_come_home(seen_.state.energy, *core_.config().knowledge,
                                  *deliberation.world(), core_.bus().now(), seen_.state.position))
    return;
  core_.bus().emit(Notice{"flies unasked: its energy lasts no longer than to come home; " +
                          waiting_->request.type + " waited for its air"});
  give(merging::Withdraw{});
  begin(Airway(waiting_->airways.front()), "unasked");
}

/// At once when others stand in its way; other reasons not more often than every few seconds.
void Merging::note_waits() {
  if (waiting_->waits_for == waiting_->noted_for) return;
  const bool soon = core_.bus().now() < waiting_->noted + kSaidAgain;
  if (!waiting_->noted_for.empty() && waiting_->in_its_way == waiting_->noted_way && soon) return;
  waiting_->noted = core_.bus().now();
  waiting_->noted_for = waiting_->waits_for;
  waiting_->noted_way = waiting_->in_its_way;
  note("waits", nullptr);
}

void Merging::say_it_waits() {
  if (flies_portion()) return;
  if (waiting_) note_waits();
  const bool asks = waiting_ && !waiting_->airways.empty();
  const auto longest = asks ? longest_wait(core_, waiting_->request) : std::nullopt;
  if (longest && core_.bus().now() >= waiting_->since + *longest)
    return refuse("others leave it no air: it waits for " + joined(waiting_->waits_for, "; "),
                  functional::AbortCause::kNoAir);
  if (!waiting_ || core_.bus().now() < waiting_->said + kSaidAgain) return;
  say_it_has_begun();
}

void Merging::say_it_has_begun() {
  waiting_->said = core_.bus().now();
  if (portions_ && portions_->running) return;
  core_.post_status({waiting_->request.id, functional::TaskState::kStarted, "waits for its air"});
}

void Merging::time_passes() {
  if (!merger_) return;
  say_it_waits();
  if (const auto until = waiting_ ? waiting_->aside_until() : std::nullopt;
      until && core_.bus().now() >= *until)
    ask();
  if (const auto from = waiting_ ? waiting_->rises_from() : std::nullopt;
      from && core_.bus().now() >= *from)
    ask();
  if (!flies_portion()) look_for_way_around();
  give(merging::Tick{});
}

std::optional<MissionTime> Merging::next_wakeup() const {
  if (!merger_) return std::nullopt;
  std::optional<MissionTime> next = merger_->next_wakeup();
  if (!waiting_ || flies_portion()) return next;
  next = earliest(next, waiting_->said + kSaidAgain);
  next = earliest(next, waiting_->rises_from());
  next = earliest(next, waiting_->looks_around_from());
  return flown_ ? next : earliest(next, waiting_->aside_until());
}

std::optional<MissionTime> Merging::Waiting::rises_from() const {
  const bool asks = !airways.empty() && !aside_since && !comes_back && !asked_long;
  return asks && is_of_role(request) ? std::optional(since + kRises) : std::nullopt;
}

std::optional<MissionTime> Merging::Waiting::looks_around_from() const {
  const bool asks = !airways.empty() && !aside_since && !comes_back;
  return asks ? std::optional(looks_around) : std::nullopt;
}

std::optional<MissionTime> Merging::Waiting::aside_until() const {
  return aside_since ? std::optional(*aside_since + kAside) : std::nullopt;
}

// ---- others ----

void Merging::begin(const Started& started) {
  if (merger_ && started.first_life) give(merging::FirstLife{});
}

void Merging::hear(const MergeTold& told) {
  if (merger_) give(merging::Heard{told.from, told.message});
}

void Merging::contact(const Contact& contact) {
  if (!merger_) return;
  if (contact.ground) home_.contact(contact.reachable);
  const std::string& peer = contact.ground ? core_.config().merging->witness : contact.peer;
  if (!peer.empty()) give(merging::InReach{peer, contact.reachable});
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
  const bool has_begun = portions_ && portions_->running;
  if (waiting_ && !has_begun) seen.for_others = merger_->awaited();
  if (!seen.for_others.empty()) seen.waits = waiting_->request.id;
  if (flown_ && !flown_->over)
    seen.flies = flies_portion() ? portions_->task() : flown_->airway.request.id;
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
  if (flies_portion()) return had_ahead(Airway(waiting_->airways[granted.choice]));
  const char* state = waiting_->aside_since ? "aside" : waiting_->comes_back ? "back" : "had";
  begin(Airway(waiting_->airways[granted.choice]), state);
}

void Merging::carry_out(const merging::Waits& waits) {
  if (!waiting_) return;
  std::vector<std::string> now_for;
  for (const merging::Waits::Why& one : waits.whys)
    now_for.push_back(one.peer + " " + std::string(to_text(one.what)));
  if (!waiting_->aside_since) {
    waiting_->waits_for = std::move(now_for);
    waiting_->in_its_way = merger_->in_its_way();
  }
  if (!flies_portion()) note_waits();
}

// ---- what it knows ----

AirwaySituation Merging::situation() const {
  const bool believes = core_.deliberation().possible();
  return {seen_.state,
          rest_,
          waiting_ && waiting_->was_aside,
          false,
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
