// SPDX-License-Identifier: Apache-2.0
// What is the case, and which formulas have to be looked at again when it changes.
#include "engine_core.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::interaction {

// Preconditions matter in BI, exits in BI and BA.
bool Engine::Core::listens(Watch watch) const {
  const Place place = entries_[watch.block].place;
  return place == Place::kInactive || (place == Place::kActive && watch.side == Side::kExit);
}

std::optional<std::string> Engine::Core::refusal(const Input& input, MissionTime now) const {
  if (now < now_) return "at: " + to_text(now) + " is before " + to_text(now_);
  if (std::holds_alternative<Start>(input) && started_ && !over_) return "it has started already";
  const auto* status = std::get_if<Status>(&input);
  if (status == nullptr) return std::nullopt;
  const auto componel = automaton_->find(status->componel);
  if (!componel) return "unknown componel '" + status->componel + "'";
  if ((*automaton_)[*componel].block() == nullptr) return std::nullopt;
  return "'" + status->componel + "' is a block; expected a task or an action";
}

std::optional<MissionTime> Engine::Core::instant(const TimeIs& is) const {
  const auto reference = std::visit(
      Overloaded{[](TimeIs::Epoch) { return std::optional<MissionTime>(MissionTime()); },
                 [&](TimeIs::ModelStart) { return started_; },
                 [&](const TimeIs::Event& event) {
                   return entries_[event.componel].since[static_cast<std::size_t>(event.state)];
                 }},
      is.since);
  if (!reference) return std::nullopt;
  return *reference + is.after;
}

Truth Engine::Core::truth(const Literal& literal, const Entry& block) const {
  if (const auto* is = std::get_if<ComponelIs>(&literal.condition)) {
    const ComponelState state = entries_[is->componel].state;
    const bool holds = is_in(state, is->state);
    const bool for_ever = holds ? interaction::is_over(state) : !may_reach(state, is->state);
    return truth_of(literal, holds, for_ever);
  }
  if (const auto* is = std::get_if<MessagePending>(&literal.condition)) {
    return truth_of(literal, block.pending.count(is->message) > 0, false);
  }
  const auto& is = std::get<TimeIs>(literal.condition);
  const auto at = instant(is);
  const bool passed = at && *at <= now_;
  return truth_of(literal, passed == is.passed, passed);  // what has passed has passed for ever
}

Truth Engine::Core::truth(Watch watch) const {
  const Entry& entry = entries_[watch.block];
  return truth_of(formula_of(block(watch.block), watch.side),
                  [&](const Literal& one) { return truth(one, entry); });
}

// Whether all that is true of a loop's exit says so.
bool Engine::Core::continues(ComponelIndex loop) const {
  for (const Clause& clause : block(loop).exit) {
    for (const Literal& literal : clause) {
      if (literal.effect == ExitEffect::kExit && truth(literal, entries_[loop]) == Truth::kTrue) {
        return false;
      }
    }
  }
  return block(loop).type == BlockType::kLoop;
}

void Engine::Core::set_state(ComponelIndex componel, ComponelState state) {
  Entry& entry = entries_[componel];
  entry.state = state;
  for (std::size_t asked = 0; asked < entry.since.size(); ++asked) {
    if (is_in(state, static_cast<AskedState>(asked))) entry.since[asked] = now_;
  }
  emit(StateChanged{(*automaton_)[componel].id, state});
  for (const Watch watch : compiled_.state_watches(componel)) look_again(watch);
  for (const std::size_t timer : compiled_.event_timers(componel)) set_timer(timer);
}

// Back to no state, with all that was activated below.
void Engine::Core::forget(ComponelIndex componel) {
  Entry& entry = entries_[componel];
  if (entry.state == ComponelState::kNone) return;
  entry.state = ComponelState::kNone;
  entry.since = {};
  for (const Watch watch : compiled_.state_watches(componel)) look_again(watch);
  for (const std::size_t timer : compiled_.event_timers(componel)) set_timer(timer);
  if (const Block* block = (*automaton_)[componel].block()) {
    for (const ComponelIndex below : block->content) forget(below);
  }
}

void Engine::Core::look_again(Watch watch) {
  if (!listens(watch)) return;
  if (watch.side == Side::kPrecondition) {
    preconditions_.insert(watch.block);
  } else if (entries_[watch.block].place == Place::kInactive) {
    inactive_exits_.insert(watch.block);
  } else {
    active_exits_.insert(watch.block);
  }
}

// Its instant may have become known, another one, or unknown again.
void Engine::Core::set_timer(std::size_t timer) {
  agenda_.clear(timer);
  const auto& [watch, is] = compiled_.timers()[timer];
  if (!listens(watch)) return;
  look_again(watch);
  const auto at = instant(is);
  if (at && *at > now_) agenda_.set(timer, *at);
}

// Instants pass one by one, each with cycles of its own.
void Engine::Core::pass_until(MissionTime now) {
  while (const auto next = agenda_.next()) {
    if (*next > now) break;
    now_ = *next;
    while (const auto timer = agenda_.take(now_)) look_again(compiled_.timers()[*timer].watch);
    run_cycles();
  }
  now_ = now;
}

void Engine::Core::hear(const std::string& message) {
  for (const ComponelIndex index : compiled_.listeners(message)) {
    if (entries_[index].place == Place::kOut) continue;
    if (!entries_[index].pending.insert(message).second) continue;
    look_again({index, Side::kPrecondition});
    look_again({index, Side::kExit});
  }
}

// All pending messages that the formula names without `not`, in the order in which it names them.
void Engine::Core::read(Watch watch) {
  Entry& entry = entries_[watch.block];
  for (const Clause& clause : formula_of(block(watch.block), watch.side)) {
    for (const Literal& literal : clause) {
      const auto* is = std::get_if<MessagePending>(&literal.condition);
      if (is == nullptr || literal.negated || entry.pending.erase(is->message) == 0) continue;
      emit(Read{is->message, (*automaton_)[watch.block].id});
    }
  }
}

}  // namespace skein::interaction
