// SPDX-License-Identifier: Apache-2.0
// What is done with blocks: entering, leaving, beginning anew.
#include "engine_core.hpp"

#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::interaction {

namespace {
constexpr int kMostRestarts = 1000;  // of a loop at one instant
}  // namespace

Engine::Core::Core(std::shared_ptr<const Automaton> automaton)
    : automaton_(std::move(automaton)),
      compiled_(*automaton_),
      entries_(automaton_->size()),
      agenda_(compiled_.timers().size()) {
  SKEIN_EXPECTS(!automaton_->empty() && (*automaton_)[0].block() != nullptr);
}

Result<Effects, Failure> Engine::Core::handle(const Input& input, MissionTime now) {
  if (auto why = refusal(input, now)) return failure(std::move(*why));
  effects_.clear();
  pass_until(now);
  apply(input);
  run_cycles();
  return std::move(effects_);
}

void Engine::Core::apply(const Input& input) {
  if (over_) return;
  std::visit(Overloaded{[&](Start) {
                          started_ = now_;
                          make_inactive(0);
                        },
                        [&](Abort) { abort_model(""); },
                        [&](const Status& status) {
                          change_status(*automaton_->find(status.componel), status.word);
                        },
                        [&](const Message& message) { hear(message.text); },
                        [&](const ScmReport& report) {
                          for (const ComponelIndex index : compiled_.scm_blocks(report.scm)) {
                            if (entries_[index].place != Place::kActive) continue;
                            return hear(message_of(report.scm, report.finding));
                          }
                        },
                        [](Tick) {}},
             input);
}

void Engine::Core::run_cycles() {
  bool changed = true;
  while (changed && !over_) {
    changed = step(inactive_exits_, [&](ComponelIndex b) { return leave_inactive(b); });
    changed = step(active_exits_, [&](ComponelIndex b) { return leave_active(b); }) || changed;
    changed = step(preconditions_, [&](ComponelIndex b) { return enter_active(b); }) || changed;
  }
}

// Visits, in document order, the blocks that were where they are when the step began.
template <class Visit>
bool Engine::Core::step(Ripe& ripe, const Visit& visit) {
  ++step_;
  bool changed = false;
  for (auto next = ripe.begin(); next != ripe.end() && !over_;) {
    const ComponelIndex block = *next;
    if (entries_[block].entered == step_) {
      ++next;
      continue;
    }
    ripe.erase(next);
    changed = visit(block) || changed;
    next = ripe.upper_bound(block);
  }
  return changed;
}

bool Engine::Core::leave_inactive(ComponelIndex index) {
  const Watch watch{index, Side::kExit};
  if (entries_[index].place != Place::kInactive || block(index).exit.empty()) return false;
  if (truth(watch) != Truth::kTrue) return false;
  read(watch);
  drop(index);
  return true;
}

bool Engine::Core::leave_active(ComponelIndex index) {
  const Watch watch{index, Side::kExit};
  const Entry& entry = entries_[index];
  if (entry.place != Place::kActive || entry.leaving != Leaving::kNot) return false;
  if (block(index).exit.empty() || truth(watch) != Truth::kTrue) return false;
  const bool anew = continues(index);
  read(watch);
  if (anew) {
    leave(index, Leaving::kToRestart);
  } else {
    deactivate(index);
  }
  return true;
}

bool Engine::Core::enter_active(ComponelIndex block) {
  const Watch watch{block, Side::kPrecondition};
  if (entries_[block].place != Place::kInactive) return false;
  const Truth value = truth(watch);
  if (value == Truth::kFalse) return false;
  if (value == Truth::kTrue) {
    read(watch);
    activate(block);
  } else {
    drop(block);
  }
  return true;
}

// (new) → scheduled, on the activation of its parent.
void Engine::Core::make_inactive(ComponelIndex block) {
  Entry& entry = entries_[block];
  entry.place = Place::kInactive;
  entry.leaving = Leaving::kNot;
  entry.entered = step_;
  entry.pending.clear();
  set_state(block, ComponelState::kScheduled);
  for (const Side side : {Side::kPrecondition, Side::kExit}) {
    for (const std::size_t timer : compiled_.timers_of({block, side})) set_timer(timer);
    look_again({block, side});
  }
}

// scheduled → running, when its precondition is true.
void Engine::Core::activate(ComponelIndex block) {
  for (const std::size_t timer : compiled_.timers_of({block, Side::kPrecondition}))
    agenda_.clear(timer);
  entries_[block].place = Place::kActive;
  set_state(block, ComponelState::kRunning);
  look_again({block, Side::kExit});
  begin_content(block);
}

void Engine::Core::begin_content(ComponelIndex index) {
  const Block& block = this->block(index);
  for (const LocalParameter& local : block.locals) emit(Compute{local.name});
  entries_[index].open = block.content.size();
  for (const ComponelIndex below : block.content) {
    const Componel& componel = (*automaton_)[below];
    if (componel.block() != nullptr) {
      make_inactive(below);
      continue;
    }
    set_state(below, ComponelState::kScheduled);
    if (componel.task() != nullptr) {
      emit(Run{componel.id});
    } else {
      set_state(below, ComponelState::kRunning);
      emit(Negotiate{componel.id});
    }
  }
}

// scheduled → aborted: it is archived.
void Engine::Core::drop(ComponelIndex block) { finish(block, ComponelState::kAborted); }

// running → aborting, also if it was on its way to something else.
void Engine::Core::deactivate(ComponelIndex block) {
  set_state(block, ComponelState::kAborting);
  leave(block, Leaving::kToAborted);
}

void Engine::Core::leave(ComponelIndex block, Leaving to) {
  entries_[block].leaving = to;
  stop_content(block);
}

void Engine::Core::stop_content(ComponelIndex index) {
  entries_[index].stopping = true;
  for (const ComponelIndex below : block(index).content) {
    const Componel& componel = (*automaton_)[below];
    const Entry& entry = entries_[below];
    if (entry.place == Place::kInactive) {
      drop(below);
    } else if (entry.place == Place::kActive) {
      if (entry.leaving != Leaving::kToAborted) deactivate(below);
    } else if (entry.state == ComponelState::kScheduled || entry.state == ComponelState::kRunning) {
      set_state(below, ComponelState::kAborting);
      if (componel.task() != nullptr) {
        emit(Interrupt{componel.id});
      } else {
        emit(Withdraw{componel.id});
      }
    }
  }
  entries_[index].stopping = false;
  if (entries_[index].open == 0) content_over(index);
}

void Engine::Core::content_over(ComponelIndex index) {
  switch (entries_[index].leaving) {
    case Leaving::kToAborted:
      return finish(index, ComponelState::kAborted);
    case Leaving::kToEnded:
      return finish(index, ComponelState::kEnded);
    case Leaving::kToRestart:
      return restart(index);
    case Leaving::kNot:
      break;
  }
  if (block(index).type == BlockType::kLoop) return restart(index);
  finish(index, ComponelState::kEnded);
}

void Engine::Core::restart(ComponelIndex index) {
  Entry& entry = entries_[index];
  entry.restarts = entry.restarted == now_ ? entry.restarts + 1 : 1;
  entry.restarted = now_;
  if (entry.restarts >= kMostRestarts) {
    return abort_model("'" + (*automaton_)[index].id + "' began anew " +
                       std::to_string(kMostRestarts) + " times at one instant");
  }
  entry.leaving = Leaving::kNot;
  for (const ComponelIndex below : block(index).content) forget(below);
  look_again({index, Side::kExit});
  begin_content(index);
}

// A block is over. What that means to the one around it: T def. V.9 (endMode).
void Engine::Core::finish(ComponelIndex index, ComponelState state) {
  Entry& entry = entries_[index];
  entry.place = Place::kOut;
  entry.leaving = Leaving::kNot;
  for (const Side side : {Side::kPrecondition, Side::kExit})
    for (const std::size_t timer : compiled_.timers_of({index, side})) agenda_.clear(timer);
  set_state(index, state);
  if (index == 0) {
    over_ = true;
    return emit(ModelOver{state, abort_reason_});
  }
  const ComponelIndex parent = (*automaton_)[index].parent;
  const bool ends_it = state == ComponelState::kEnded && block(index).end == EndMode::kImmediate &&
                       entries_[parent].leaving == Leaving::kNot;
  if (!ends_it) return one_over(index);
  --entries_[parent].open;
  const bool loop = block(parent).type == BlockType::kLoop;
  leave(parent, loop ? Leaving::kToRestart : Leaving::kToEnded);
}

void Engine::Core::one_over(ComponelIndex componel) {
  const ComponelIndex parent = (*automaton_)[componel].parent;
  Entry& entry = entries_[parent];
  if (--entry.open == 0 && !entry.stopping) content_over(parent);
}

// Of a task or an action: scheduled, running → what it says; aborting → aborted.
void Engine::Core::change_status(ComponelIndex componel, Status::Word word) {
  constexpr std::array kStates{ComponelState::kRunning, ComponelState::kEnded,
                               ComponelState::kAborted};
  const ComponelState before = entries_[componel].state;
  ComponelState after = kStates[static_cast<std::size_t>(word)];
  if (before == ComponelState::kAborting) after = ComponelState::kAborted;
  if (before == ComponelState::kNone || interaction::is_over(before) || before == after) return;
  set_state(componel, after);
  if (interaction::is_over(after)) one_over(componel);
}

void Engine::Core::abort_model(std::string why) {
  const Entry& main = entries_[0];
  if (!why.empty()) abort_reason_ = std::move(why);
  if (main.place == Place::kInactive) return drop(0);
  if (main.place == Place::kActive && main.leaving != Leaving::kToAborted) deactivate(0);
}

// --- the facade ----------------------------------------------------------------------------------

Engine::Engine(std::shared_ptr<const Automaton> automaton)
    : core_(std::make_unique<Core>(std::move(automaton))) {
  SKEIN_EXPECTS(named_times(core_->automaton()).empty());
}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

Result<Effects, Failure> Engine::handle(const Input& input, MissionTime now) {
  return core_->handle(input, now);
}
std::optional<MissionTime> Engine::next_wakeup() const { return core_->next_wakeup(); }
ComponelState Engine::state(ComponelIndex componel) const { return core_->state(componel); }
bool Engine::is_over() const { return core_->is_over(); }
const Automaton& Engine::automaton() const { return core_->automaton(); }

std::string_view to_text(ScmReport::Finding finding) {
  switch (finding) {
    case ScmReport::Finding::kViolated:
      return "violated";
    case ScmReport::Finding::kSatisfied:
      return "satisfied";
    case ScmReport::Finding::kUndetermined:
      break;
  }
  return "undetermined";
}

std::string message_of(const std::string& scm, ScmReport::Finding finding) {
  return scm + " " + std::string(to_text(finding));
}

}  // namespace skein::interaction
