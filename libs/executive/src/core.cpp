// SPDX-License-Identifier: Apache-2.0
#include "core.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::executive {

namespace {

std::string reason_of_exit(const TaskRecord& record, MissionTime now) {
  const bool late = record.synchronisation && record.synchronisation->deadline &&
                    *record.synchronisation->deadline <= now;
  return late ? "the deadline has passed" : "exit conditions satisfied";
}

}  // namespace

Executive::Core::Core(Config config)
    : config_(std::move(config)),
      conditions_(plan_),
      synchroniser_(config_.name, config_.sync_validity),
      motion_(resources_.number_of(std::string(kMotion))) {
  SKEIN_EXPECTS(config_.urgent_wait > Duration());
  SKEIN_EXPECTS(config_.background_retry > Duration());
  SKEIN_EXPECTS(!config_.sync_validity || *config_.sync_validity > Duration());
  SKEIN_EXPECTS(!config_.functional_timeout || *config_.functional_timeout > Duration());
}

Effects Executive::Core::handle(const Input& input, MissionTime now) {
  now_ = std::max(now_, now);
  const auto* tick = std::get_if<Tick>(&input);
  if (tick != nullptr && tick->after_silence)
    timers_.put_off(Timer::Kind::kTimeout, now_ + config_.functional_timeout.value_or(Duration()));
  advance();
  std::visit([this](const auto& one) { on(one); }, input);
  return done();
}

// running, and a synchronisation    aborting, and at once aborted
Effects Executive::Core::give_up(TaskId synchronisation, const std::string& why, MissionTime now) {
  now_ = std::max(now_, now);
  advance();
  const std::optional<Slot> slot = plan_.find(synchronisation);
  const bool waits =
      slot && plan_[*slot].synchronisation && plan_[*slot].state == TaskState::kRunning;
  if (waits) interrupt(*slot, why);
  return done();
}

Effects Executive::Core::done() {
  settle();
  conditions_.trim_instants();
  return outbox_.take();
}

std::optional<MissionTime> Executive::Core::next_wakeup() const {
  return earliest(conditions_.next_instant(), timers_.next());
}

// --- time ----------------------------------------------------------------------------------------

// At one instant: time conditions (and deadlines), urgent waits, time-outs.
void Executive::Core::advance() {
  while (true) {
    const std::optional<MissionTime> condition = conditions_.next_instant();
    const std::optional<MissionTime> timer = timers_.next();
    const std::optional<MissionTime> next = earliest(condition, timer);
    if (!next || *next > now_) break;
    if (condition == next) {
      conditions_.instant_passed(*next);
    } else {
      pass_timer(timers_.take());
    }
    settle();
  }
  conditions_.now_is(now_);
}

void Executive::Core::pass_timer(const Timer& timer) {
  if (timer.kind == Timer::Kind::kBackgroundRetry) {
    background_.retry();
    return;
  }
  const Slot slot = *plan_.find(timer.id);
  TaskRecord& record = plan_[slot];
  if (timer.kind == Timer::Kind::kUrgentWait) {
    outbox_.notice("urgent task " + to_text(timer.id) + " goes after " +
                   to_text(config_.urgent_wait) + " s although " + std::to_string(record.blockers) +
                   " incompatible task(s) are not terminal");
    urgents_.force(record, slot);
  } else if (timer.kind == Timer::Kind::kSyncAgain) {
    say(*record.synchronisation, SyncWord::kThere);
    say_again_later(slot);
  } else {
    const bool unanswered = record.state == TaskState::kStarted;
    set_state(slot, TaskState::kAborted, "no answer within the time-out");
    if (!unanswered || !config_.interrupts_unanswered) return;
    outbox_.add(Interrupt{record.id, record.joint});
    record.answers = true;
  }
}

// --- the loop of spec 2.4 ------------------------------------------------------------------------

void Executive::Core::settle() {
  while (step()) {
  }
}

// One thing that is due, if any: Ξ first, then urgent tasks, then Π; last the background routine.
bool Executive::Core::step() {
  if (const auto exit = conditions_.take_exit()) {
    interrupt_or_cancel(*exit, reason_of_exit(plan_[*exit], now_));
  } else if (const auto urgent = urgents_.take(plan_)) {
    dispatch(*urgent);
  } else if (const auto ready = conditions_.take_precondition()) {
    if (plan_[*ready].preconditions.dead()) {
      set_state(*ready, TaskState::kAborted, "the preconditions are false for ever");
    } else {
      dispatch(*ready);
    }
  } else {
    return dispatch_background();
  }
  return true;
}

// --- inputs that are not requests ----------------------------------------------------------------

// from               status             to
// started            started            started, and the answer may take as long again
// started            running            running
// started, running   ended              ended
// started, running   aborted            aborted
// aborting           ended or aborted   aborted; who was over already answers the interruption too
// anything else: a notice
void Executive::Core::on(const FunctionalStatus& status) {
  const std::string what = "status '" + std::string(to_text(status.state)) + "' of ";
  const std::optional<Slot> slot = plan_.find(status.id);
  if (!slot) return outbox_.notice(what + "unknown task " + to_text(status.id));
  TaskRecord& record = plan_[*slot];
  const TaskState from = record.state;
  if (status.state == TaskState::kStarted && from == TaskState::kStarted && !record.synchronisation)
    return expect_answer(record);
  if (is_terminal(status.state) && std::exchange(record.answers, false)) return;
  const bool fits = !record.synchronisation && is_active(from) &&
                    (is_terminal(status.state) ||
                     (status.state == TaskState::kRunning && from == TaskState::kStarted));
  if (!fits) {
    return outbox_.notice(what + "task " + to_text(status.id) + ", which is " +
                          std::string(to_text(from)) + ", does not fit");
  }
  const bool counts_as_aborted = from == TaskState::kAborting;
  std::string reason = status.reason;
  if (reason.empty()) reason = counts_as_aborted ? record.reason : "";
  if (reason.empty() && status.state == TaskState::kAborted) {
    reason = from == TaskState::kStarted ? "rejected" : "aborted by who carries it out";
  }
  record.answers = counts_as_aborted;
  if (!counts_as_aborted && status.state == TaskState::kAborted) record.cause = status.cause;
  set_state(*slot, counts_as_aborted ? TaskState::kAborted : status.state, reason);
}

void Executive::Core::on(const SyncReceived& message) {
  for (const TaskId id : synchroniser_.received(message, now_)) {
    const Slot slot = *plan_.find(id);
    if (config_.sync_validity) say(*plan_[slot].synchronisation, SyncWord::kDone);
    set_state(slot, TaskState::kEnded);
  }
}

void Executive::Core::on(const PeerReachable& peer) {
  for (const auto& [id, word] : synchroniser_.missed_by(peer.name)) {
    outbox_.add(SendSync{id, peer.name, word});
  }
}

void Executive::Core::on(const Flight& flight) {
  background_.flies(flight.airborne);
  if (!flight.airborne) end_background("no longer in flight");
}

// scheduled, started, running, aborting    out of the plan, remembered as aborted
void Executive::Core::on(const Relinquish& request) {
  std::vector<Slot> slots;
  for (const TaskId id : plan_.open()) {
    if (id < request.below) slots.push_back(*plan_.find(id));
  }
  for (const Slot slot : slots) {
    conditions_.detach(slot, Role::kPreconditions);
    conditions_.detach(slot, Role::kExit);
  }
  for (const Slot slot : slots) let_go(slot);
  if (!slots.empty()) {
    outbox_.notice(std::to_string(slots.size()) + " task(s) are another executive's from now on");
  }
  background_.rest(true);
  end_background("another executive is in charge");
}

}  // namespace skein::executive
