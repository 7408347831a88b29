// SPDX-License-Identifier: Apache-2.0
#include "conditions.hpp"

#include <algorithm>
#include <limits>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::executive {

namespace {

std::uint64_t key_of(MissionTime instant) { return static_cast<std::uint64_t>(instant.count()); }
MissionTime instant_of(std::uint64_t key) {
  return MissionTime::nanoseconds(static_cast<std::int64_t>(key));
}

bool exit_ready(const TaskRecord& record) {
  return !is_terminal(record.state) && record.state != TaskState::kAborting &&
         !record.exit.empty() && record.exit.satisfied();
}

bool precondition_ready(const TaskRecord& record) {
  return record.state == TaskState::kScheduled && !record.urgent &&
         (record.preconditions.satisfied() || record.preconditions.dead());
}

}  // namespace

// --- coherence -----------------------------------------------------------------------------------

Truth Conditions::evaluate(const Literal& literal) const {
  const Standing standing = std::visit(
      Overloaded{
          [&](const TaskInState& c) { return standing_of_task(*plan_.state_of(c.task), c.state); },
          [&](const MessageReceived& c) {
            const auto found = message_indices_.find(c.message);
            return standing_of_message(found != message_indices_.end() &&
                                       messages_[found->second].received);
          },
          [&](const TimeIs& c) { return standing_of_time(c.instant <= now_, c.passed); }},
      literal.condition);
  return truth_of(standing, literal.negated, literal.modality);
}

// Every task named must be known. A clause is false for ever when all its literals are.
Truth Conditions::evaluate(const Formula& formula) const {
  Truth whole = Truth::kTrue;
  for (const Clause& clause : formula) {
    Truth best = Truth::kNever;
    for (const Literal& literal : clause) {
      const Truth one = evaluate(literal);
      if (one == Truth::kTrue || best == Truth::kNever) best = one;
      if (best == Truth::kTrue) break;
    }
    if (best == Truth::kNever) return Truth::kNever;
    if (best == Truth::kFalse) whole = Truth::kFalse;
  }
  return whole;
}

std::optional<TaskId> Conditions::unknown_task(TaskId self, const Formula& formula) const {
  for (const Clause& clause : formula) {
    for (const Literal& literal : clause) {
      const auto* named = std::get_if<TaskInState>(&literal.condition);
      if (named == nullptr) continue;
      const bool usable = named->task != self && named->task < kFirstBackgroundId &&
                          plan_.state_of(named->task).has_value();
      if (!usable) return named->task;
    }
  }
  return std::nullopt;
}

std::optional<std::string> Conditions::incoherence(TaskId self, const Formula* preconditions,
                                                   const Formula* exit,
                                                   std::optional<MissionTime> deadline) const {
  for (const Formula* formula : {preconditions, exit}) {
    if (formula == nullptr) continue;
    if (const auto id = unknown_task(self, *formula)) {
      return *id == self ? "a condition names the task itself"
                         : "a condition names task " + to_text(*id) + ", not inserted before";
    }
  }
  if (preconditions != nullptr && evaluate(*preconditions) == Truth::kNever) {
    return "the preconditions are false for ever";
  }
  if (exit != nullptr && !exit->empty() && evaluate(*exit) == Truth::kTrue) {
    return "the exit conditions are satisfied already";
  }
  if (deadline && *deadline <= now_) return "the deadline has passed already";
  return std::nullopt;
}

// --- formulas ------------------------------------------------------------------------------------

std::uint32_t Conditions::message_index(const std::string& text) {
  const auto [place, is_new] =
      message_indices_.emplace(text, static_cast<std::uint32_t>(messages_.size()));
  if (is_new) messages_.push_back(Message{text, false, {}});
  return place->second;
}

CompiledLiteral Conditions::compile(const Literal& literal, std::uint32_t clause) {
  CompiledLiteral result;
  result.clause = clause;
  result.flags = static_cast<std::uint8_t>(
      (literal.negated ? CompiledLiteral::kNegated : 0) |
      (literal.modality == Modality::kOptional ? CompiledLiteral::kOptional : 0));
  std::visit(Overloaded{[&](const TaskInState& c) {
                          result.kind = CompiledLiteral::Kind::kTask;
                          result.key = c.task.value();
                          result.wanted = static_cast<std::uint8_t>(c.state);
                        },
                        [&](const MessageReceived& c) {
                          result.kind = CompiledLiteral::Kind::kMessage;
                          result.key = message_index(c.message);
                        },
                        [&](const TimeIs& c) {
                          result.kind = CompiledLiteral::Kind::kTime;
                          result.key = key_of(c.instant);
                          result.wanted = c.passed ? 1 : 0;
                        }},
             literal.condition);
  result.value = result.truth(standing_of(result));
  return result;
}

Standing Conditions::standing_of(const CompiledLiteral& literal) const {
  switch (literal.kind) {
    case CompiledLiteral::Kind::kTask:
      return standing_of_task(*plan_.state_of(TaskId(literal.key)),
                              static_cast<TaskState>(literal.wanted));
    case CompiledLiteral::Kind::kMessage:
      return standing_of_message(messages_[literal.key].received);
    case CompiledLiteral::Kind::kTime:
      break;
  }
  return standing_of_time(instant_of(literal.key) <= now_, literal.wanted != 0);
}

void Conditions::attach(Plan::Slot slot, Role role, const Formula& formula,
                        std::optional<MissionTime> deadline) {
  std::vector<CompiledLiteral> literals;
  std::uint32_t clauses = 0;
  const auto add_deadline = [&] {
    if (!deadline) return;
    literals.push_back(compile(Literal{TimeIs{*deadline, true}}, clauses));
    literals.back().flags |= CompiledLiteral::kImplicit;
  };
  for (const Clause& clause : formula) {
    for (const Literal& literal : clause) literals.push_back(compile(literal, clauses));
    add_deadline();
    ++clauses;
  }
  if (formula.empty() && deadline) {
    add_deadline();
    ++clauses;
  }
  literals.shrink_to_fit();
  FormulaState& state = plan_[slot].formula(role);
  state.assign(std::move(literals), clauses);
  for (std::uint32_t i = 0; i < state.literals().size(); ++i) {
    Watch one{slot, state.version(), 0, 0};
    one.literal = i & 0x7fffffffU;
    one.exit = role == Role::kExit ? 1U : 0U;
    watch(state.literal(i), one);
  }
  queue_if_ready(slot, role);
}

// Facts that are settled are not watched.
void Conditions::watch(const CompiledLiteral& literal, Watch watch) {
  const auto live = [this](const Watch& one) { return is_live(one); };
  const Standing standing = standing_of(literal);
  if (standing == Standing::kHoldsForEver || standing == Standing::kNeverAgain) return;
  switch (literal.kind) {
    case CompiledLiteral::Kind::kTask:
      plan_[*plan_.find(TaskId(literal.key))].watchers.add(watch, live);
      return;
    case CompiledLiteral::Kind::kMessage:
      messages_[literal.key].watchers.add(watch, live);
      return;
    case CompiledLiteral::Kind::kTime:
      if (++instant_watches_ > sweep_at_) sweep_instants();
      instants_[instant_of(literal.key)].add(watch, live);
      return;
  }
}

// Instants far ahead that no formula watches any more would pile up under repeated UPDATE-COND.
void Conditions::sweep_instants() {
  std::size_t left = 0;
  for (auto it = instants_.begin(); it != instants_.end();) {
    it->second.drop_stale([this](const Watch& one) { return is_live(one); });
    left += it->second.all().size();
    it = it->second.empty() ? instants_.erase(it) : std::next(it);
  }
  instant_watches_ = left + 1;
  sweep_at_ = 2 * left + 64;
}

Formula Conditions::formula_of(Plan::Slot slot, Role role) const {
  const FormulaState& state = plan_[slot].formula(role);
  Formula formula(state.clauses());
  bool only_deadline = state.clauses() == 1;
  for (const CompiledLiteral& c : state.literals()) {
    if ((c.flags & CompiledLiteral::kImplicit) != 0) continue;
    only_deadline = false;
    Condition condition;
    if (c.kind == CompiledLiteral::Kind::kTask) {
      condition = TaskInState{TaskId(c.key), static_cast<TaskState>(c.wanted)};
    } else if (c.kind == CompiledLiteral::Kind::kMessage) {
      condition = MessageReceived{messages_[c.key].text};
    } else {
      condition = TimeIs{instant_of(c.key), c.wanted != 0};
    }
    formula[c.clause].push_back(Literal{
        std::move(condition), (c.flags & CompiledLiteral::kNegated) != 0,
        (c.flags & CompiledLiteral::kOptional) != 0 ? Modality::kOptional : Modality::kMandatory});
  }
  if (only_deadline && !state.literals().empty()) formula.clear();
  return formula;
}

// --- facts that change ---------------------------------------------------------------------------

template <class NewStanding>
void Conditions::visit(WatchList& list, const NewStanding& standing) {
  list.drop_stale([this](const Watch& one) { return is_live(one); });
  for (const Watch& one : list.all()) {
    FormulaState& formula = plan_[one.slot].formula(one.role());
    const CompiledLiteral& literal = formula.literal(one.literal);
    formula.set(one.literal, literal.truth(standing(literal)));
    queue_if_ready(one.slot, one.role());
  }
}

void Conditions::task_changed(Plan::Slot slot) {
  TaskRecord& record = plan_[slot];
  visit(record.watchers, [&](const CompiledLiteral& literal) {
    return standing_of_task(record.state, static_cast<TaskState>(literal.wanted));
  });
  if (is_terminal(record.state)) record.watchers = WatchList();
}

void Conditions::message_received(const std::string& text) {
  Message& message = messages_[message_index(text)];
  if (message.received) return;
  message.received = true;
  visit(message.watchers, [](const CompiledLiteral&) { return standing_of_message(true); });
  message.watchers = WatchList();
}

std::optional<MissionTime> Conditions::next_instant() const {
  if (instants_.empty()) return std::nullopt;
  return instants_.begin()->first;
}

void Conditions::instant_passed(MissionTime instant) {
  const auto found = instants_.find(instant);
  SKEIN_EXPECTS(found != instants_.end() && found == instants_.begin());
  now_ = instant;
  WatchList watchers = std::move(found->second);
  instants_.erase(found);
  visit(watchers,
        [](const CompiledLiteral& literal) { return standing_of_time(true, literal.wanted != 0); });
}

void Conditions::trim_instants() {
  const auto live = [this](const Watch& one) { return is_live(one); };
  while (!instants_.empty() && instants_.begin()->second.trim(live)) {
    instants_.erase(instants_.begin());
  }
}

// --- ready tasks ---------------------------------------------------------------------------------

void Conditions::queue_if_ready(Plan::Slot slot, Role role) {
  const TaskRecord& record = plan_[slot];
  if (role == Role::kExit) {
    if (exit_ready(record)) exits_.push(record.id, slot);
  } else if (precondition_ready(record)) {
    preconditions_.push(record.id, slot);
  }
}

std::optional<Plan::Slot> Conditions::take_exit() { return exits_.take(plan_, exit_ready); }

std::optional<Plan::Slot> Conditions::take_precondition() {
  return preconditions_.take(plan_, precondition_ready);
}

}  // namespace skein::executive
