// SPDX-License-Identifier: Apache-2.0
#include "safekeeping.hpp"

#include <algorithm>
#include <utility>

#include "core.hpp"
#include "interrupted.hpp"
#include "skein/elementary/parameter_reader.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/supervisor/own_ways.hpp"
#include "skein/supervisor/way_home.hpp"

namespace skein::decision_node {

namespace {

constexpr Duration kFirstPause = Duration::milliseconds(10'000);
constexpr Duration kLongestPause = Duration::milliseconds(60'000);
constexpr Duration kEnergyAgain = Duration::milliseconds(5'000);
constexpr Duration kOutAgain = Duration::milliseconds(30'000);
constexpr Duration kIdles = Duration::milliseconds(60'000);  ///< until an operator is told
constexpr double kAtHome = 1;                                // [m]

}  // namespace

Safekeeping::Safekeeping(Core& core)
    : core_(core), contact_(core.config().contact_policy, core.config().contact_after) {}

bool Safekeeping::may_be_on_its_way() const {
  return core_.config().drives || core_.execution().airborne();
}

void Safekeeping::time_passes() {
  if (contact_.due(core_.bus().now())) carry_out_policy();
  if (again_at_ && core_.bus().now() >= *again_at_) come_home_again();
}

std::optional<MissionTime> Safekeeping::next_wakeup() const {
  return earliest(contact_.next_wakeup(), again_at_);
}

// What is planned, or being synchronised, is given up and what flies the vehicle is interrupted, so
// that nothing of the plan moves it while the ground is silent; the supervisor decides nothing
// more. What the ground itself requested (degree 1) is interrupted first. The ground gets the plan
// of the supervisor, or else the tasks that were interrupted, for somebody to give them again.
// One on the ground that has nothing to do has nothing to stop, and goes on taking missions.
void Safekeeping::carry_out_policy() {
  const ContactPolicy policy = core_.config().contact_policy;
  core_.bus().emit(PolicyCarriedOut{policy, ""});
  core_.voice().give_up("its contact-loss policy: " + std::string(to_text(policy)));
  Deliberation& deliberation = core_.deliberation();
  const bool deliberated = deliberation.engaged() && !has_nothing_to_do();
  if (deliberated) deliberation.disengage("contact lost: " + std::string(to_text(policy)));
  owed_ = !may_be_on_its_way();
  std::vector<mission::HeldTask> before = core_.execution().held();
  if (may_be_on_its_way()) {
    stop_plan();
    keep(policy);
  }
  if (deliberated) return core_.autonomy().hand_over(core_.execution().held());
  core_.bus().post([this, before = std::move(before)] { give_back(before); });
}

// Of team tasks, at degree 5, it may be granted one by others at any time.
bool Safekeeping::has_nothing_to_do() const {
  const std::vector<mission::GoalStatus> goals = core_.deliberation().goals();
  return !may_be_on_its_way() && !mission::allocates(core_.degree()) &&
         core_.execution().held().empty() &&
         std::all_of(goals.begin(), goals.end(),
                     [](const auto& goal) { return mission::is_settled(goal.state); });
}

void Safekeeping::give_back(const std::vector<mission::HeldTask>& before) {
  auto interrupted = interrupted_since(before, core_.execution().held());
  if (!interrupted.empty()) core_.autonomy().hand_over(std::move(interrupted));
}

void Safekeeping::stop_plan() {
  const auto passed = core_.vehicle().of_ground();
  for (const auto& [task, type] : passed) core_.interrupt(task);
  const std::vector<executive::TaskStatus> tasks = core_.execution().tasks();
  for (auto task = tasks.rbegin(); task != tasks.rend(); ++task) {
    const bool waits = task->state == executive::TaskState::kScheduled;
    const bool talks = functional::TaskTypes::shipped().of(task->type).synchronises();
    if (waits || talks) core_.execution().run(executive::Abort{task->id});
  }
}

void Safekeeping::keep(ContactPolicy how) {
  pending_ = how;
  again_at_.reset();
  pause_ = kFirstPause;
  start_pending();
}

// An own task that still waits for what it interrupted would begin together with the new one.
void Safekeeping::start_pending() {
  if (!pending_ || !core_.vehicle().of_ground().empty()) return;
  const ContactPolicy how = *pending_;
  pending_.reset();
  withdraw_what_waits();
  holds_ = how == ContactPolicy::kHold;
  holds_ ? hold() : come_home();
}

void Safekeeping::withdraw_what_waits() {
  for (const executive::TaskStatus& task : core_.execution().tasks()) {
    const bool waits = task.state == executive::TaskState::kScheduled;
    if (waits && is_own(task.id)) core_.execution().run(executive::Abort{task.id});
  }
}

bool Safekeeping::is_idle() const {
  const std::vector<executive::TaskStatus> tasks = core_.execution().tasks();
  return core_.vehicle().of_ground().empty() &&
         std::none_of(tasks.begin(), tasks.end(), [](const executive::TaskStatus& task) {
           return executive::is_active(task.state);
         });
}

bool Safekeeping::knows_world() const {
  return core_.config().knowledge && core_.deliberation().possible();
}

/// The first way-point is where it is then.
void Safekeeping::go(const std::vector<world::Vector3>& way, executive::InsertionMode mode) {
  core_.own_tasks().start(
      "goto", {elementary::points_parameter("waypoints", {way.begin() + 1, way.end()})}, mode);
}

void Safekeeping::hold() {
  if (!leaves_to_) return core_.own_tasks().start("wait", {}, executive::InsertionMode::kVut);
  go({*seen_at_, *leaves_to_}, executive::InsertionMode::kVut);
  core_.own_tasks().start("wait", {}, executive::InsertionMode::kNut);
}

void Safekeeping::come_home() {
  const auto& place = core_.config().home;
  const world::Vector3 pad(place.at(0), place.at(1), place.at(2));
  const auto end = core_.merging().way_home_begins();
  const world::Vector3 home = end ? pad : over_landing_place(pad);
  if (end)
    core_.bus().emit(Notice{
        "flies its way to the end before it comes home: nobody can be asked for air on another"});
  else if (home != pad)
    core_.bus().emit(
        Notice{"its pad does not serve to land on: it comes down on the nearest ground that does"});
  if (!end || (*end - home).norm() > kAtHome) {
    way_home_ = way_to(home, end ? end : seen_at_);
    if (knows_world()) way_home_among_ = core_.deliberation().world()->volumes;
    go(way_home_, end ? executive::InsertionMode::kNut : executive::InsertionMode::kVut);
  }
  if (!core_.config().drives) core_.own_tasks().start("land", {}, executive::InsertionMode::kNut);
}

// On air that is kept free for it nobody can be asked for other air.
world::Vector3 Safekeeping::over_landing_place(const world::Vector3& pad) const {
  if (!knows_world() || core_.config().drives) return pad;
  return supervisor::over_landing_place(*core_.config().knowledge, *core_.deliberation().world(),
                                        core_.bus().now(), seen_at_.value_or(pad), pad);
}

std::vector<world::Vector3> Safekeeping::way_to(const world::Vector3& home,
                                                const std::optional<world::Vector3>& from) const {
  if (!knows_world() || !from) return {home, home};
  return supervisor::own_way(core_.config().knowledge, core_.deliberation().world(),
                             core_.bus().now(), *from, home);
}

// A landing that the vehicle gave up is not its last: nobody else would bring it down.
void Safekeeping::own_task_over(const executive::TaskEvent& event) {
  const bool over = core_.own_tasks().none_open();
  holds_ = holds_ && !over;
  const bool came = event.type == "goto" && event.state == executive::TaskState::kEnded;
  if (over || came) way_home_.clear();
  if (!over || event.type != "land" || !core_.own_tasks().given_up()) return;
  again_at_ = core_.bus().now() + pause_;
  core_.bus().emit(Notice{"in the air without a task: the vehicle gave its landing up (" +
                          event.reason + "); once more in " + to_text(pause_)});
  pause_ = std::min(pause_ + pause_, kLongestPause);
}

void Safekeeping::come_home_again() {
  again_at_.reset();
  const bool flies = core_.execution().airborne() && !core_.deliberation().engaged();
  if (!flies || !core_.own_tasks().none_open() || !core_.execution().held().empty() ||
      !core_.vehicle().of_ground().empty())
    return;
  core_.bus().emit(PolicyCarriedOut{ContactPolicy::kReturn, "it has not come down: once more"});
  come_home();
}

void Safekeeping::look_after(const world::Telemetry& telemetry) {
  seen_at_ = telemetry.state.position;
  if (!holds_) leaves_to_.reset();
  if (owed_ && core_.execution().airborne() && is_idle()) carry_out_policy();
  warned_ = warned_ && may_be_on_its_way();
  warn_of_idling();
  if (!may_be_on_its_way() || !knows_world()) return;
  look_ahead(telemetry.state.position);
  if (core_.config().drives) {
    warn_of_energy(telemetry);
    return warn_of_closed_air(telemetry.state.position);
  }
  if (!holds_) {
    warn_of_energy(telemetry);
    if (is_left_alone()) return leave_closed_air(telemetry.state.position);
    return warn_of_closed_air(telemetry.state.position);
  }
  if (!must_return(telemetry)) return leave_closed_air(telemetry.state.position);
  core_.bus().emit(PolicyCarriedOut{ContactPolicy::kReturn,
                                    "held until the energy lasts no longer than to come home"});
  holds_ = false;
  warned_ = true;  // that says it
  keep(ContactPolicy::kReturn);
}

// Of a vehicle without figures nothing is known.
bool Safekeeping::must_return(const world::Telemetry& telemetry) const {
  return supervisor::must_come_home(telemetry.state.energy, *core_.config().knowledge,
                                    *core_.deliberation().world(), core_.bus().now(),
                                    telemetry.state.position);
}

// Whoever has it in hand decides; the UAV itself comes home only where it deliberates, holds, or
// was left in the air. What keeps to the ground is safe where it stands.
void Safekeeping::warn_of_energy(const world::Telemetry& telemetry) {
  const MissionTime now = core_.bus().now();
  if (core_.deliberation().engaged() || now < looked_at_energy_ + kEnergyAgain) return;
  const bool left = !core_.config().drives && is_left_alone();
  if (warned_ && !left) return;
  looked_at_energy_ = now;
  if (!must_return(telemetry)) return;
  if (!std::exchange(warned_, true))
    core_.bus().emit(Notice{"its energy lasts no longer than to come home"});
  if (!left) return;
  core_.bus().emit(PolicyCarriedOut{
      ContactPolicy::kReturn, "left in the air without a task, and its deliberation was stopped"});
  keep(ContactPolicy::kReturn);
}

// Likewise: what was asked of it may have been refused, or be given up, and others may want its
// air.
void Safekeeping::warn_of_idling() {
  const bool idles = core_.execution().airborne() && !core_.config().drives &&
                     !mission::deliberates(core_.degree()) && is_idle();
  const MissionTime now = core_.bus().now();
  if (!idles) return says_it_idles_.reset();
  if (!says_it_idles_) says_it_idles_ = now + kIdles;
  if (now < *says_it_idles_) return;
  says_it_idles_ = MissionTime::max();  // once
  const std::string whose = core_.voice().plays()
                                ? ": the ground station plays a role of it, which waits"
                                : ": who has it in hand decides";
  core_.bus().emit(Notice{"in the air with nothing under way for " + to_text(kIdles) +
                          " s, at degree " + std::to_string(core_.degree()) + whose});
}

// Whoever has it in hand decides where it goes. One that wavers on the border says so once.
void Safekeeping::warn_of_closed_air(const world::Vector3& at) {
  if (core_.deliberation().engaged()) return;
  const MissionTime now = core_.bus().now();
  std::erase_if(closed_around_, [&](const auto& one) { return one.second + kOutAgain < now; });
  for (const std::string& volume : supervisor::closed_around(
           *core_.config().knowledge, *core_.deliberation().world(), now, at)) {
    if (closed_around_.insert_or_assign(volume, now).second)
      core_.bus().emit(
          Notice{"it is in air that is closed or about to be (volume '" + volume + "')"});
  }
}

// At degree 4 no operator looks after it between two tasks.
bool Safekeeping::is_left_alone() const {
  return mission::deliberates(core_.degree()) && !core_.deliberation().engaged() && is_idle() &&
         !again_at_;
}

// A way home is free among the volumes that were known when it began.
void Safekeeping::look_ahead(const world::Vector3& at) {
  const auto world = core_.deliberation().world();
  if (way_home_.empty() || world->volumes == way_home_among_) return;
  way_home_among_ = world->volumes;
  const auto closed = [&](const std::vector<world::Vector3>& way) {
    return supervisor::closed_ahead(*core_.config().knowledge, *world, core_.bus().now(), at, way);
  };
  const auto ahead = closed(way_home_);
  if (!ahead) return;
  const std::string why = "the air on its way home is closed (volume '" + *ahead + "'): ";
  const auto& place = core_.config().home;
  const world::Vector3 pad(place.at(0), place.at(1), place.at(2));
  const bool asked = core_.merging().way_home_begins().has_value();
  if (closed(way_to(asked ? way_home_.back() : over_landing_place(pad), at)))
    return core_.bus().emit(Notice{why + "there is no way around it"});
  core_.bus().emit(PolicyCarriedOut{ContactPolicy::kReturn, why + "around it"});
  keep(ContactPolicy::kReturn);
}

/// While it is on its way, where that leads counts.
void Safekeeping::leave_closed_air(const world::Vector3& at) {
  const auto out = [this](const world::Vector3& from) {
    return supervisor::way_out(core_.config().knowledge, core_.deliberation().world(),
                               core_.bus().now(), from);
  };
  if (leaves_to_ && !out(*leaves_to_)) return;
  const auto way = out(at);
  if (!way) return;
  leaves_to_ = way->to;
  core_.bus().emit(PolicyCarriedOut{ContactPolicy::kHold, "the air around it is closed (volume '" +
                                                              way->volume + "'): it leaves"});
  keep(ContactPolicy::kHold);
}

}  // namespace skein::decision_node
