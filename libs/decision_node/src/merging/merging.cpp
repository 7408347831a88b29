// SPDX-License-Identifier: Apache-2.0
#include "merging/merging.hpp"

#include <algorithm>
#include <utility>

#include "core.hpp"
#include "merging/air_orders.hpp"
#include "merging/short_energy.hpp"
#include "role_ids.hpp"
#include "skein/elementary/parameter_reader.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/mission/degree.hpp"

namespace skein::decision_node {

namespace {

constexpr Duration kStale = Duration::milliseconds(3'000);     ///< beliefs of the vehicle may be
constexpr Duration kUnasked = Duration::milliseconds(10'000);  ///< after the energy is short
/// Who waits for it longer gives it up: as a rule it is its partner that stays there and waits for
/// it to come.
constexpr Duration kRoleWaits = Duration::milliseconds(240'000);
/// A way of the plan that is waited for longer is given up: the plan has something else to do, or
/// somebody else can. Who waits has pressed for two minutes then.
constexpr Duration kPlanWaits = Duration::milliseconds(360'000);
/// Likewise while all in its way fly: they will leave. A sweep takes up to 20 min, three tries 24.
constexpr Duration kPlanWaitsForFlights = Duration::milliseconds(480'000);

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
std::optional<Duration> longest_wait(Core& core, const Waiting& waiting,
                                     const merging::Merger& merger) {
  if (is_of_role(waiting.request.id)) return kRoleWaits;
  if (!may_be_given_up(core, waiting.request)) return std::nullopt;
  const auto& names = waiting.in_its_way;
  const bool for_flights =
      !names.empty() && std::all_of(names.begin(), names.end(), [&](const std::string& peer) {
        return merger.peers().flies(peer);
      });
  return for_flights ? kPlanWaitsForFlights : kPlanWaits;
}

/// Nothing is looked at on the way. A role of a joint task asks for its heights; over whoever stays
/// where its way leads it goes all the same, before it waits for ever.
bool at_any_height(Core& core, const functional::Request& request, bool asked_long) {
  if (request.type != "goto") return false;
  if (is_of_role(request.id) && !asked_long) return false;
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

/// What comes before it in the plan, such as a joint task, may have ended elsewhere than was
/// planned.
bool is_of_plan(Core& core, const functional::Request& request) {
  return mission::deliberates(core.degree()) &&
         core.deliberation().origin_of(request.id) != mission::GoalId();
}

/// What is looked at on the way is looked at from where the way begins, not from where the vehicle
/// got out of the way meanwhile.
bool is_to_begin_there(Core& core, const functional::Request& request) {
  return mission::deliberates(core.degree()) && !at_any_height(core, request, true);
}

/// What it flew aside for is given up, and this needs it to stand still: once it is there.
bool waits_for_flight(const functional::Request& request, const VehicleAir& vehicle) {
  return vehicle.flies() && OwnFlightIds::has(vehicle.flown()->airway.request.id) &&
         functional::TaskTypes::shipped().of(request.type).holds_vehicle();
}

/// Whether something is looked at while the vehicle waits.
bool looks_meanwhile(Core& core, const functional::Request& request) {
  if (request.type != "wait" || !core.deliberation().possible()) return false;
  const mission::PlanReport& report = core.deliberation().report();
  return std::any_of(report.tasks.begin(), report.tasks.end(), [&](const auto& one) {
    const auto& all = one.task.dependences;
    const mission::Dependence runs{mission::DependenceKind::kRunning, request.id};
    return !type_of(one.task).devices.empty() &&
           std::find(all.begin(), all.end(), runs) != all.end();
  });
}

/// To `place`, from where it got out of the way, before it does this there.
bool is_to_come_back(Core& core, const std::optional<world::Vector3>& place,
                     const functional::Request& request, const VehicleAir& vehicle,
                     const merging::Margins& margins) {
  if (!place || !vehicle.state().airborne) return false;
  if (!is_done_in_place(request) && !looks_meanwhile(core, request)) return false;
  return (*place - vehicle.place()).norm() > margins.settled;
}

/// It made room there for others, who have not come yet.
bool gives_way(const Waiting& waiting, const world::Vector3& place, const merging::Merger& merger,
               const merging::Margins& margins, MissionTime now) {
  if (!waiting.gives_way_until || *waiting.gives_way_until <= now) return false;
  const merging::Volumes there{merging::stay_at(place, margins)};
  return std::any_of(merger.peers().begin(), merger.peers().end(),
                     [&](const auto& one) { return overlap(there, one.second.claim().wanted); });
}

/// To the executive, which has the motion running already if it is a sweep's next portion.
void say_it_comes(Core& core, Waiting& waiting, const std::optional<Portions>& portions) {
  waiting.said = core.bus().now();
  if (portions && portions->running) return;
  core.post_status({waiting.request.id, functional::TaskState::kStarted, "waits for its air"});
}

merging::Margins cruising(const std::optional<MergingConfig>& config) {
  if (!config) return {};
  return merging::margins_of(config->model, config->wind, config->model.cruise_speed);
}

}  // namespace

Merging::Merging(Core& core)
    : core_(core), home_(core), margins_(cruising(core.config().merging)), around_(core) {
  const auto& config = core.config().merging;
  if (!config) return;
  merger_.emplace(config->members, core.config().uav, merging::Limits{}, config->witness);
  // Until they are heard: some never are. Nothing follows from it yet.
  for (const auto& [peer, known] : merger_->peers())
    merger_->handle(merging::InReach{peer, false}, {});
  if (!config->witness.empty()) merger_->handle(merging::InReach{config->witness, false}, {});
}

// ---- motions ----

bool Merging::takes(const functional::Request& request) {
  // Whoever asks for it once more, as another executive that takes it over does, is told by the
  // vehicle how far it is.
  if (!merger_ || vehicle_.flies(request.id)) return false;
  if (flies_portion() && portions_->task() == request.id) {
    if (portions_->running) core_.post_status({request.id, functional::TaskState::kRunning, ""});
    return true;
  }
  if (left_wait_.is(request.id)) {
    core_.post_status({request.id, functional::TaskState::kRunning, ""});
    return true;
  }
  if (waiting_ && waiting_->makes_room) stop_waiting();
  if (waiting_ && waiting_->request.id == request.id) {
    say_it_comes(core_, *waiting_, portions_);
    return true;
  }
  // The vehicle cannot tell: it was not given the other yet.
  if (waiting_ && functional::TaskTypes::shipped().of(request.type).holds_vehicle()) {
    core_.post_status({request.id, functional::TaskState::kAborted,
                       "another motion waits for its air: " + waiting_->request.type});
    return true;
  }
  if (!needs_air(request) && !waits_for_flight(request, vehicle_) &&
      !is_to_come_back(core_, place_, request, vehicle_, margins_))
    return false;
  waiting_ = waiting_since(core_.bus().now(), request);
  ask();
  return true;
}

/// A portion of a sweep is flown as it is.
bool Merging::may_be_raised(bool asked_long) const {
  const bool portion = portions_ && portions_->task() == waiting_->request.id;
  return !portion && at_any_height(core_, waiting_->request, asked_long);
}

bool Merging::drop(functional::TaskId task) {
  if (left_wait_.drop(task)) return true;
  if (!waiting_ || waiting_->request.id != task) return false;
  stop_waiting();
  portions_.reset();
  place_.reset();  // what comes next is planned from where it is
  return true;
}

void Merging::stop_waiting() {
  if (!waiting_->noted_for.empty()) waiting_->note(core_.bus(), "given-up", nullptr);
  waiting_.reset();
  give(merging::Withdraw{});
}

/// From where it is now: as often as it waits anew.
void Merging::ask() {
  if (!waiting_ || !vehicle_.is_seen() || vehicle_.flies()) return;
  if (waiting_->makes_room) return stop_waiting();
  waiting_->comes_back = false;
  waiting_->asked_long = waiting_->is_long(core_.bus().now());
  if (is_to_come_back(core_, place_, waiting_->request, vehicle_, margins_)) {
    if (gives_way(*waiting_, *place_, *merger_, margins_, core_.bus().now())) {
      waiting_->ask_later();
      return give(merging::Withdraw{});
    }
    if (Airways back = flights_to(*place_, own_ids_.next(), *core_.config().merging, situation());
        !back.empty()) {
      own_ids_.take();
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
  functional::Request flight = waiting_->request;
  const bool elsewhere = place_ || is_of_plan(core_, flight);
  if (elsewhere && !(portions_ && portions_->running) && core_.deliberation().possible()) {
    if (place_ && is_to_begin_there(core_, flight))
      flight = begun_at(*place_, flight, *core_.config().merging, situation());
    flight = led_around(flight, *core_.config().merging, situation(), core_.deliberation().world());
  }
  auto airways =
      airways_of(flight, may_be_raised(waiting_->asked_long), *core_.config().merging, situation());
  if (!airways) {  // perhaps the vehicle is not what it was thought to be: it is looked at again
    waiting_->cannot(airways.error().why);
    return give(merging::Withdraw{});
  }
  for (Airway& home : home_.flights(waiting_->request, vehicle_.rest()))
    airways->push_back(std::move(home));
  waiting_->why_not.clear();
  waiting_->aside_since.reset();
  want(std::move(*airways));
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
  waiting_->note(core_.bus(), state, &airway);
  const bool aside = waiting_->aside_since.has_value();
  Flown flight{airway};
  if (!aside && !waiting_->comes_back) take_portion(flight.airway.request);
  if (aside && !place_) place_ = vehicle_.rest();
  if (!aside && !waiting_->comes_back) place_.reset();
  functional::Request request = flight.airway.request;
  vehicle_.begin(std::move(flight));
  if (waiting_->makes_room || (!aside && !waiting_->comes_back)) {
    waiting_.reset();
  } else {
    waiting_->airways.clear();
    waiting_->was_aside = waiting_->was_aside || aside;
    waiting_->waits_for.clear();
    waiting_->noted_for.clear();
  }
  hold();
  core_.vehicle().begin(std::move(request));
}

bool Merging::told(const functional::Status& status) {
  if (!merger_) return false;
  if (left_wait_.hides(status)) return true;
  if (runs_already_ == status.id && status.state == functional::TaskState::kRunning) {
    runs_already_.reset();  // an executive that takes it over is told
    return true;
  }
  const bool of_portion = portions_ && portions_->flown == status.id;
  if (of_portion && portions_->begins_to_run(status))
    core_.post_status({portions_->task(), functional::TaskState::kRunning, ""});
  const std::optional<Flown>& flown = vehicle_.flown();
  if (flown && flown->airway.request.id == status.id && functional::is_terminal(status.state)) {
    const bool left = vehicle_.over(status.state == functional::TaskState::kEnded);
    if (vehicle_.come_to_rest() || left) hold();
    if (of_portion) portion_over(status);
    if (waiting_ && waiting_->airways.empty()) ask();
  }
  if (!OwnFlightIds::has(status.id)) return false;
  refused_.told(status, core_.bus().now());
  return true;
}

// ---- the vehicle ----

void Merging::vehicle_told(const world::Telemetry& telemetry) {
  if (!merger_) return;
  if (vehicle_.see(telemetry.state, core_.bus().now())) hold();
  ask_ahead();
  if (vehicle_.come_to_rest()) hold();
  look_for_room();
  if (!waiting_) return;
  if (waiting_->airways.empty()) ask();
  if (waiting_ && !waiting_->why_not.empty() && core_.bus().now() > waiting_->since + kStale)
    return refuse(waiting_->why_not);
  look_at_energy();
}

void Merging::hold() {
  merging::Volumes air = vehicle_.air();
  if (portions_ && portions_->ahead)
    air.insert(air.end(), portions_->ahead->air.begin(), portions_->ahead->air.end());
  if (air != merger_->held()) give(merging::Hold{std::move(air)});
  const auto rest = vehicle_.rests_next();
  if (!home_.is_new(rest)) return;
  home_.look(rest, situation());
  give(merging::Need{home_.choices()});
}

// ---- waiting ----

bool Merging::may_go_around() const {
  if (!waiting_ || !waiting_->looks_around_from() || flies_portion()) return false;
  return vehicle_.state().airborne && core_.deliberation().possible() &&
         !merger_->awaited().to_leave().empty() && may_be_raised(waiting_->asked_long);
}

/// Not where others stay where it is to go: it would wait there.
void Merging::look_for_way_around() {
  const auto from = waiting_ ? waiting_->looks_around_from() : std::nullopt;
  if (!from || core_.bus().now() < *from) return;
  waiting_->looks_around = core_.bus().now() + kLooksAround;
  if (!may_go_around()) return;
  const auto airways = airways_of(waiting_->request, true, *core_.config().merging, situation());
  if (!airways || airways->empty()) return;
  const merging::Volumes taken = merger_->peers().taken();
  if (overlap({airways->front().air.back()}, taken)) return;
  around_.search(waiting_->request, taken, situation());
}

/// Whoever can wait no longer comes home, and says so: that it falls is no better. What it could do
/// without is given up instead: nobody flies to a goal without its air.
void Merging::look_at_energy() {
  const Deliberation& deliberation = core_.deliberation();
  const world::VehicleState& seen = vehicle_.state();
  if (!waiting_ || waiting_->airways.empty() || waiting_->aside_since || !seen.airborne) return;
  if (flies_portion()) return;
  if (core_.bus().now() < waiting_->since + kUnasked || core_.config().knowledge == nullptr) return;
  const ShortEnergy energy(*core_.config().knowledge, *deliberation.world(), core_.bus().now());
  if (energy.lasts_longer(waiting_->airways, seen)) return;
  const std::string why = "its energy lasts no longer than to come home";
  if (longest_wait(core_, *waiting_, *merger_))
    return refuse(
        why + ", and others leave it no air: it waits for " + joined(waiting_->waits_for, "; "),
        functional::AbortCause::kNoAir);
  core_.bus().emit(
      Notice{"flies unasked: " + why + "; " + waiting_->request.type + " waited for its air"});
  give(merging::Withdraw{});
  begin(Airway(energy.least_costly(waiting_->airways)), "unasked");
}

void Merging::say_it_waits() {
  if (flies_portion()) return;
  if (waiting_) waiting_->note_waits(core_.bus());
  const bool asks = waiting_ && !waiting_->airways.empty();
  const auto longest = asks ? longest_wait(core_, *waiting_, *merger_) : std::nullopt;
  if (longest && core_.bus().now() >= waiting_->since + *longest)
    return refuse("others leave it no air: it waits for " + joined(waiting_->waits_for, "; "),
                  functional::AbortCause::kNoAir);
  if (!waiting_ || core_.bus().now() < waiting_->said + kSaidAgain) return;
  say_it_comes(core_, *waiting_, portions_);
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
  return vehicle_.flown() ? next : earliest(next, waiting_->aside_until());
}

// ---- others ----

void Merging::begin(const Started& started) {
  if (!started.first_life) own_ids_.begin_anew(core_.bus().now());
  if (merger_ && started.first_life) give(merging::FirstLife{});
}

void Merging::hear(const MergeTold& told) {
  if (merger_) give(merging::Heard{told.from, told.message});
}

void Merging::hear(const WaySearched& done) {
  const auto task = around_.over(done);
  if (!task || !done.path || !may_go_around() || waiting_->request.id != *task) return;
  auto around = around_.along(*done.path, waiting_->request, merger_->peers().taken(), situation());
  auto airways = airways_of(waiting_->request, true, *core_.config().merging, situation());
  if (!around || !airways) return;
  airways->push_back(std::move(*around));
  want(std::move(*airways));
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
  auto orders = air_orders(core_.config().uav, waiting_, portions_, vehicle_, *merger_);
  if (orders == orders_) return;
  orders_ = std::move(orders);
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
  waiting_->wait_for(waits);
  if (!flies_portion()) waiting_->note_waits(core_.bus());
}

// ---- what it knows ----

AirwaySituation Merging::situation() const {
  const bool believes = core_.deliberation().possible();
  return {vehicle_.state(),
          vehicle_.rest(),
          waiting_ && waiting_->was_aside,
          false,
          believes ? core_.deliberation().world()->volumes : core_.config().merging->volumes,
          core_.bus().now()};
}

}  // namespace skein::decision_node
