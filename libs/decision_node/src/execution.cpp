// SPDX-License-Identifier: Apache-2.0
#include "execution.hpp"

#include <algorithm>

#include "core.hpp"
#include "role_ids.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/lost_uav.hpp"

namespace skein::decision_node {

namespace {

constexpr const char* kIdleType = "wait";
constexpr const char* kTooLate =
    "it is over here, or was not given back in time and has been planned anew";

executive::Config executive_config(const Config& config) {
  executive::Config result;
  result.name = config.uav;
  result.functional_timeout = config.functional_timeout;
  result.interrupts_unanswered = true;
  result.last_urgent_counts = true;
  result.sync_validity = config.sync_validity;
  result.background_type = config.background_type;
  result.idle_type = kIdleType;
  return result;
}

// Only requests to an executive are routed here.
executive::Input input_of(const mission::Request& request) {
  return std::visit(
      [](const auto& it) -> executive::Input {
        if constexpr (std::is_constructible_v<executive::Input, decltype(it)>) {
          return it;
        } else {
          return executive::Tick{};
        }
      },
      request);
}

/// An own task gives way to one of others that starts, or leaves its place to it.
bool is_displaced(const executive::TaskEvent& event, const executive::Input& cause) {
  const bool own = is_own(event.id) && event.id < functional::kFirstBackgroundId;
  const auto* start = std::get_if<executive::Start>(&cause);
  if (!own || start == nullptr || is_own(start->task.id)) return false;
  const bool urgent = start->mode == executive::InsertionMode::kVut;
  return event.state == executive::TaskState::kAborting ||
         (urgent && event.state == executive::TaskState::kAborted);
}

}  // namespace

Execution::Execution(Core& core) : core_(core), executive_(executive_config(core.config())) {}

// ---- what comes in ----

void Execution::take(const Command& command) {
  const auto* start = std::get_if<executive::Start>(&command.request);
  if (start != nullptr && start->task.id >= functional::kFirstRoleId) {
    return core_.commands().refuse(command, kOwnIds);
  }
  if (start != nullptr && core_.deliberation().has_given_up(start->task.id)) {
    return core_.commands().refuse(command, kTooLate);
  }
  if (const auto* message = std::get_if<executive::ProcessMessage>(&command.request)) {
    if (const auto lost = mission::uav_lost_in(message->message)) core_.declare_lost(*lost);
    if (const auto found = mission::uav_found_in(message->message)) core_.declare_found(*found);
  }
  post({input_of(command.request), By::kNode, command});
}

void Execution::vehicle_told(const world::Telemetry& telemetry) {
  if (telemetry.state.airborne == airborne_) return;
  airborne_ = telemetry.state.airborne;
  run(executive::Flight{airborne_});
}

void Execution::peer_in_reach(const std::string& peer) { run(executive::PeerReachable{peer}); }

void Execution::time_passes() {
  run(executive::Tick{});
  give_up_on_partners();
}

std::optional<MissionTime> Execution::next_wakeup() const {
  std::optional<MissionTime> next = executive_.next_wakeup();
  for (const executive::Wait& wait : waits()) {
    for (const std::string& uav : wait.awaited) {
      next = earliest(next, gives_up_at(wait, uav));
      if (has_lease(uav)) next = earliest(next, stays_away_until(wait, uav));
    }
  }
  return next;
}

// Below degree 4 somebody else decides how long is waited, for whom else says that it is there,
// too.
bool Execution::has_lease(const std::string& uav) const {
  return mission::deliberates(core_.degree()) && synchronises_directly(uav);
}

// Nor by way of a ground station that cannot be heard either.
std::optional<MissionTime> Execution::gives_up_at(const executive::Wait& wait,
                                                  const std::string& uav) const {
  if (!mission::deliberates(core_.degree())) return std::nullopt;
  return has_lease(uav) ? core_.partners().gives_up_at(uav, wait.since)
                        : core_.partners().gives_up_past_ground_at(uav, wait.since);
}

// In reach and without the meeting in its plan it may get it yet, for as long as one that is silent
// may come. Of synchronisations between roles no plan tells.
std::optional<MissionTime> Execution::stays_away_until(const executive::Wait& wait,
                                                       const std::string& uav) const {
  if (is_of_role(wait.id)) return std::nullopt;
  const auto said = degrees_.find(uav);
  if (said != degrees_.end() && !mission::deliberates(said->second)) return std::nullopt;
  if (core_.partners().silent_since(uav)) return std::nullopt;
  const auto since = core_.meetings().stays_away_since(uav, wait.synchronisation);
  if (!since) return std::nullopt;
  const auto before = stayed_away_.find({uav, wait.synchronisation});
  const bool again = before != stayed_away_.end() && before->second >= *since;
  return again ? wait.since : std::max(*since, wait.since) + core_.partners().lease();
}

std::optional<std::string> Execution::why_given_up(const executive::Wait& wait,
                                                   const std::string& uav) {
  const MissionTime now = core_.bus().now();
  const bool leased = has_lease(uav);
  const auto silent_until = gives_up_at(wait, uav);
  if ((silent_until && *silent_until <= now) || core_.partners().is_declared_lost(uav))
    if (auto why = core_.partners().given_up(uav, wait.since, now)) return why;
  const auto until = leased ? stays_away_until(wait, uav) : std::nullopt;
  if (!until || *until > now) return std::nullopt;
  stayed_away_[{uav, wait.synchronisation}] = now;
  return "'" + uav + "' does not plan to come to synchronisation " +
         std::to_string(wait.synchronisation);
}

void Execution::give_up(functional::TaskId wait, const std::string& why) {
  const Asked nobody{executive::Tick{}, By::kNobody};
  for (const executive::Effect& effect : executive_.give_up(wait, why, core_.bus().now()))
    std::visit([&](const auto& one) { carry_out(one, nobody); }, effect);
}

std::vector<executive::Wait> Execution::waits() const {
  std::vector<executive::Wait> waits = executive_.waits();
  for (executive::Wait& wait : waits) wait.since = wait_starts_.start_of(wait);
  return waits;
}

void Execution::give_up_on_partners() {
  for (const executive::Wait& wait : waits()) {
    for (const std::string& uav : wait.awaited) {
      const auto why = why_given_up(wait, uav);
      if (!why) continue;
      core_.bus().post([this, id = wait.id, why = *why] { give_up(id, why); });
      break;
    }
  }
}

void Execution::take(const SyncMessage& message) {
  SyncMessage& last = syncs_[{message.id, message.from}];
  if (last.said <= message.said) last = message;
  if (core_.degree() == mission::kLeastDegree) return core_.bus().emit(SyncPassedOn{message});
  core_.bus().emit(SyncHeard{message});
  run(executive::SyncReceived{message.id, message.from, message.word, message.said});
}

void Execution::run(executive::Input input, By by) { post({std::move(input), by}); }

void Execution::post(Asked asked) {
  core_.bus().post([this, asked = std::move(asked)] { handle(asked); });
}

void Execution::handle(const Asked& asked) {
  if (const auto task = not_given_back(asked.input)) {
    core_.interrupt(*task);
    return carry_out(executive::Reply{executive::RequestKind::kAbort, *task, true, ""}, asked);
  }
  wait_starts_.see(executive_.waits(), core_.bus().now());
  for (const executive::Effect& effect : executive_.handle(asked.input, core_.bus().now())) {
    std::visit([&](const auto& one) { carry_out(one, asked); }, effect);
  }
}

// The ground had it at degree 1, and may be out of reach since: it runs, and can be interrupted.
std::optional<functional::TaskId> Execution::not_given_back(const executive::Input& input) const {
  const auto* abort = std::get_if<executive::Abort>(&input);
  if (abort == nullptr || mission::runs_at_ground(core_.degree())) return std::nullopt;
  const bool runs = core_.vehicle().is_of_ground(abort->id) && !holds(abort->id);
  return runs ? std::optional(abort->id) : std::nullopt;
}

bool Execution::gives_way(executive::TaskId id) const {
  const auto task = executive_.find(id);
  return task && task->gives_way;
}

// ---- what the executive asks for ----

void Execution::carry_out(const executive::TaskEvent& event, const Asked& asked) {
  const auto task = executive_.find(event.id);
  core_.bus().emit(TaskChanged{event, task ? task->parameters : functional::Parameters()});
  if (core_.own_tasks().see(event)) core_.safekeeping().own_task_over(event);
  if (event.state == executive::TaskState::kEnded) wait_starts_.met(event.id);
  if (is_displaced(event, asked.input)) core_.safekeeping().withdraw_what_waits();
  core_.tell_task(event);
  if (is_terminal(event.state)) note_over(event.id);
}

// How a task ended stays known to conditions; the rest of it, once many more are over, is let go.
void Execution::note_over(functional::TaskId id) {
  constexpr std::size_t kKept = 256;
  over_.push_back(id);
  if (over_.size() <= kKept) return;
  run(executive::Suppress{over_.front()}, By::kNobody);
  over_.pop_front();
}

void Execution::carry_out(const executive::Dispatch& dispatch, const Asked&) {
  const auto task = executive_.find(dispatch.id);
  if (!task) return;  // over within the same call
  if (dispatch.joint) {
    core_.deliberation().joint_task_due(dispatch.id, false);
    return core_.interaction().due(dispatch.id, false);
  }
  core_.vehicle().dispatch(
      {functional::Verb::kDispatch, dispatch.id, task->type, task->parameters});
}

void Execution::carry_out(const executive::Interrupt& interrupt, const Asked&) {
  if (interrupt.joint && core_.deliberation().possible()) {
    core_.deliberation().joint_task_due(interrupt.id, true);
    return core_.interaction().due(interrupt.id, true);
  }
  core_.interrupt(interrupt.id);
}

// Of one that has not said its degree it is supposed that it has the same.
bool Execution::synchronises_directly(const std::string& uav) const {
  const auto said = degrees_.find(uav);
  const mission::Degree own = core_.degree();
  return mission::synchronises_directly(own, said == degrees_.end() ? own : said->second);
}

void Execution::carry_out(const executive::SendSync& sync, const Asked&) {
  const Config& config = core_.config();
  if (!config.others.contains(sync.to)) {
    return core_.bus().emit(Notice{"no UAV '" + sync.to + "' to synchronise with"});
  }
  // One that would count no more when it comes need not come: it is said again.
  const bool passes = config.sync_validity && sync.word == executive::SyncWord::kThere;
  core_.bus().emit(
      SendSync{sync, synchronises_directly(sync.to),
               passes ? core_.bus().now() + *config.sync_validity : MissionTime::max()});
}

void Execution::carry_out(const executive::Reply& reply, const Asked& asked) {
  if (asked.by == By::kNobody) return;
  const auto* start = std::get_if<executive::Start>(&asked.input);
  if (asked.command) core_.commands().answer(*asked.command, reply.accepted, reply.why);
  core_.bus().emit(
      RequestHandled{reply, start == nullptr ? executive::InsertionMode::kSeq : start->mode});
  if (start != nullptr && reply.accepted) core_.vehicle().ground_has_no_more(start->task.id);
  if (asked.by == By::kSupervisor) core_.deliberation().request_answered(reply);
}

void Execution::carry_out(const executive::Notice& notice, const Asked&) {
  core_.bus().emit(Notice{notice.text});
}

// ---- what it has ----

bool Execution::holds(functional::TaskId id) const {
  const auto task = executive_.find(id);
  return task && !is_terminal(task->state);
}

bool Execution::stops(functional::TaskId id) const {
  const auto task = executive_.find(id);
  return task && task->state == executive::TaskState::kAborting;
}

std::vector<mission::HeldTask> Execution::held() const {
  std::vector<mission::HeldTask> held;
  for (const executive::TaskStatus& status : executive_.tasks()) {
    if (is_terminal(status.state) || status.id >= executive::kFirstBackgroundId) continue;
    const executive::TaskView view = *executive_.find(status.id);
    mission::HeldTask& one = held.emplace_back();
    one.task.id = view.id;
    one.task.type = view.type;
    one.task.parameters = view.parameters;
    one.task.preconditions = executive_.preconditions(view.id);
    one.task.exit = executive_.exit_conditions(view.id);
    if (view.synchronisation != nullptr) one.task.synchronisation = *view.synchronisation;
    one.state = view.state;
    one.in_executive = true;
    one.origin = core_.deliberation().origin_of(view.id);
  }
  return held;
}

void Execution::let_go(executive::TaskId below, const std::vector<mission::HeldTask>& tasks) {
  for (const mission::HeldTask& one : tasks) {
    if (one.state == executive::TaskState::kScheduled || one.task.synchronisation) continue;
    if (core_.vehicle().is_of_ground(one.task.id)) continue;
    core_.vehicle().ground_has(one.task.id, one.task.type);
  }
  run(executive::Relinquish{below});
  for (const auto& [key, message] : syncs_) core_.bus().emit(SyncPassedOn{message});
}

}  // namespace skein::decision_node
