// SPDX-License-Identifier: Apache-2.0
// The prover's work on single goals: atoms from facts and axioms, values, expressions met as
// values.
#include <algorithm>
#include <array>

#include "condition_compiler.hpp"
#include "prover.hpp"

namespace skein::htn {

Prover::Move Prover::atom(GoalIndex index, Base base, std::uint32_t after) {
  const Goal& goal = domain_.goals[index];
  const std::vector<Axiom>* axioms = goal.axioms;
  // What only axioms tell of needs no search among the facts.
  const bool no_fact =
      goal.predicate.is(TermKind::kSymbol) && facts_.all(goal.predicate).fact == kNoFact;
  if (no_fact && axioms == nullptr) return Move::kBack;
  if (no_fact) {
    Frame& frame = push_frame(FrameKind::kAtom, index, base, after);
    frame.answers_first = static_cast<std::uint32_t>(set(queries_.back().set).count());
    return retry_atom();
  }
  Term whole;
  const Bindings::Known known = bindings_.look_up(goal.pattern, base, whole);
  if (known == Bindings::Known::kTerm) {
    const FactIndex fact = facts_.find(whole);
    if (axioms == nullptr) {
      if (fact == kNoFact) return Move::kBack;
      note_support(whole, facts_.producer(fact));
      current_ = after;
      return Move::kForward;
    }
    Frame& frame = push_frame(FrameKind::kAtom, index, base, after);
    frame.answers_first = static_cast<std::uint32_t>(set(queries_.back().set).count());
    if (fact == kNoFact) return retry_atom();
    note_support(whole, facts_.producer(fact));
    current_ = after;
    return Move::kForward;
  }
  Frame& frame = push_frame(FrameKind::kAtom, index, base, after);
  frame.answers_first = static_cast<std::uint32_t>(set(queries_.back().set).count());
  const Term predicate = bindings_.resolve(goal.predicate, base);  // may be a variable's value
  if (known == Bindings::Known::kOpen && predicate.is(TermKind::kSymbol)) {
    frame.cursor = facts_.candidates(predicate, goal.positions,
                                     [this, base](Term pattern) -> std::optional<Term> {
                                       const Term value = bindings_.resolve(pattern, base);
                                       if (!store_.ground(value)) return std::nullopt;
                                       return value;
                                     });
  }
  return retry_atom();
}

Prover::Move Prover::retry_atom() {
  Frame& frame = frames_.back();
  const Goal& goal = domain_.goals[frame.goal];
  while (frame.cursor.fact != kNoFact) {
    const FactIndex fact = frame.cursor.fact;
    frame.cursor = facts_.next(frame.cursor);
    if (!match_fact(goal, frame.base, fact)) {
      bindings_.undo(frame.mark);
      continue;
    }
    note_support(facts_.atom(fact), facts_.producer(fact));
    current_ = frame.after;
    if (frame.cursor.fact == kNoFact && goal.axioms == nullptr) frames_.pop_back();
    return Move::kForward;
  }
  if (goal.axioms == nullptr) {
    frames_.pop_back();
    return Move::kBack;
  }
  return try_axioms();
}

bool Prover::match_fact(const Goal& goal, Base base, FactIndex fact) {
  const std::span<const Term> values = facts_.arguments(fact);
  if (values.size() != goal.arguments.size()) return false;
  for (std::size_t at = 0; at < values.size(); ++at) {
    const Term argument = bindings_.resolve(goal.arguments[at], base);
    if (argument == values[at]) continue;
    if (argument.is(TermKind::kVariable)) {
      bindings_.bind(argument, values[at]);
    } else if (store_.ground(argument) || !bindings_.unify(argument, base, values[at], 0)) {
      return false;
    }
  }
  return true;
}

Prover::Move Prover::try_axioms() {
  Frame& frame = frames_.back();
  const Goal& goal = domain_.goals[frame.goal];
  if (!frame.axioms_begun) {
    frame.axioms_begun = true;
    frame.answers_middle = static_cast<std::uint32_t>(set(queries_.back().set).count());
  }
  for (; frame.at < goal.axioms->size(); ++frame.at) {
    const Axiom& axiom = (*goal.axioms)[frame.at];
    if (!frame.committed && frame.tail < axiom.tails.size()) {
      const Base axiom_base = bindings_.open(axiom.slots);
      if (bindings_.unify(store_.cdr(goal.pattern), frame.base, store_.cdr(axiom.head),
                          axiom_base)) {
        return enter_tail(axiom, axiom_base);
      }
      bindings_.undo(frame.mark);
    }
    frame.tail = 0;
    frame.committed = false;
    if (frame.once) {
      frame.once = false;
      --once_frames_;
    }
  }
  return leave_atom();
}

// The tails of an axiom are if-then-else: behind the goals of a tail stands a cut, which makes it
// the last one tried.
Prover::Move Prover::enter_tail(const Axiom& axiom, Base axiom_base) {
  const auto self = static_cast<std::uint32_t>(frames_.size() - 1);
  Frame& frame = frames_.back();
  const AxiomTail& tail = axiom.tails[frame.tail++];
  const bool last_tail = frame.tail == axiom.tails.size();
  std::uint32_t after = frame.after;
  if (!last_tail) {
    continuations_.push_back({ContinuationKind::kCut, self, nullptr, 0, after});
    after = static_cast<std::uint32_t>(continuations_.size() - 1);
  }
  current_ = push_goals(tail.goals, 0, axiom_base, after);
  if (tail.first != frame.once) {
    frame.once = tail.first;
    once_frames_ += tail.first ? 1U : static_cast<std::uint32_t>(-1);
  }
  const bool last = last_tail && frame.at + 1 == domain_.goals[frame.goal].axioms->size();
  const bool order_kept = frame.answers_middle == frame.answers_first;
  if (last && order_kept && !tail.first) frames_.pop_back();
  return Move::kForward;
}

// Answers are reversed in the end; those from facts must then stand before those from axioms.
Prover::Move Prover::leave_atom() {
  const Frame& frame = frames_.back();
  Answers& answers = set(queries_.back().set);
  if (frame.answers_middle > frame.answers_first && answers.count() > frame.answers_middle) {
    answers.rotate(frame.answers_first, frame.answers_middle);
  }
  pop_frames(frames_.size() - 1);
  return Move::kBack;
}

std::optional<Term> Prover::value_of(CodeIndex code, Base base) {
  const auto value = domain_.lisp.evaluate(code, [this, base](std::uint32_t slot) {
    return bindings_.instance(Term(TermKind::kSlot, slot), base);
  });
  if (value) return *value;
  budget_.fail(place_text(value.error().where) + ": " + value.error().why);
  return std::nullopt;
}

Prover::Move Prover::evaluate(const Goal& goal, Base base, std::uint32_t after) {
  const std::optional<Term> value = value_of(goal.code, base);
  if (!value) return Move::kStop;
  if (*value == kNil) return Move::kBack;
  current_ = after;
  return Move::kForward;
}

// A variable takes the value; anything else must be `equalp` to it.
bool Prover::bind_value(Term pattern, Base base, Term value) {
  const Term known = bindings_.resolve(pattern, base);
  if (known.is(TermKind::kVariable)) {
    if (known != value) bindings_.bind(known, value);
    return true;
  }
  return store_.loose(bindings_.instance(known, base)) == store_.loose(value);
}

Prover::Move Prover::assign(const Goal& goal, Base base, std::uint32_t after) {
  const std::optional<Term> value = value_of(goal.code, base);
  if (!value) return Move::kStop;
  if (!bind_value(goal.pattern, base, *value)) return Move::kBack;
  current_ = after;
  return Move::kForward;
}

Prover::Move Prover::assign_each(GoalIndex index, Base base, std::uint32_t after) {
  const std::optional<Term> value = value_of(domain_.goals[index].code, base);
  if (!value) return Move::kStop;
  push_frame(FrameKind::kItems, index, base, after).items = *value;
  return next_item();
}

Prover::Move Prover::next_item() {
  Frame& frame = frames_.back();
  while (frame.items.is(TermKind::kPair)) {
    const Term item = store_.car(frame.items);
    frame.items = store_.cdr(frame.items);
    if (!bind_value(domain_.goals[frame.goal].pattern, frame.base, item)) continue;
    current_ = frame.after;
    if (!frame.items.is(TermKind::kPair)) frames_.pop_back();
    return Move::kForward;
  }
  frames_.pop_back();
  return Move::kBack;
}

Prover::Move Prover::value_as_goal(const Goal& goal, Base base, std::uint32_t after) {
  const Term value = bindings_.instance(goal.pattern, base);
  if (value == kNil) {
    current_ = after;
    return Move::kForward;
  }
  const std::optional<GoalIndex> made = goal_of_term(value, goal);
  return made ? execute(*made, base, after) : Move::kStop;
}

// An atom, (and …), (or …), (not …), (imply …) or a list of these, as a value.
std::optional<GoalIndex> Prover::goal_of_term(Term term, const Goal& from) {
  const auto known = domain_.goals_of_terms.find(term);
  if (known != domain_.goals_of_terms.end()) return known->second;
  Goal made;
  if (!term.is(TermKind::kPair)) {
    fail(from, store_.to_text(term) + " is no condition");
    return std::nullopt;
  }
  const Term head = store_.car(term);
  const std::string_view name = head.is(TermKind::kSymbol) ? store_.name(head) : std::string_view{};
  const bool group = head.is(TermKind::kPair);
  if (name == "and" || group || name == "not") {
    made.kind = name == "not" ? GoalKind::kNot : GoalKind::kAnd;
    const auto inner = condition_of_terms(group ? term : store_.cdr(term), from);
    if (!inner) return std::nullopt;
    made.conditions = {*inner};
  } else if (name == "or") {
    made.kind = GoalKind::kOr;
    for (const Term part : store_.items(store_.cdr(term))) {
      const auto inner = condition_of_terms(store_.pair(part, kNil), from);
      if (!inner) return std::nullopt;
      made.conditions.push_back(*inner);
    }
  } else if (!head.is(TermKind::kSymbol) || connective(name)) {
    fail(from, "a value cannot be the condition " + store_.to_text(term));
    return std::nullopt;
  } else {
    made = atom_goal(store_, term, from.where);
  }
  made.where = from.where;
  link_axioms(domain_, made);
  domain_.goals.push_back(std::move(made));
  const auto index = static_cast<GoalIndex>(domain_.goals.size() - 1);
  domain_.goals_of_terms.emplace(term, index);
  return index;
}

std::optional<ConditionIndex> Prover::condition_of_terms(Term list, const Goal& from) {
  if (++value_nesting_ > kDeepestValue) {
    fail(from, "a value is nested too deeply to be a condition");
    return std::nullopt;
  }
  Condition condition;
  for (const Term part : store_.items(list)) {
    const std::optional<GoalIndex> goal = goal_of_term(part, from);
    if (!goal) return std::nullopt;
    condition.goals.push_back(*goal);
    bindings_.collect_unbound(part, 0, condition.variables);
  }
  --value_nesting_;
  domain_.conditions.push_back(std::move(condition));
  return static_cast<ConditionIndex>(domain_.conditions.size() - 1);
}

bool Prover::connective(std::string_view name) {
  constexpr std::array kNames{"imply",   "forall", "exists", "eval",    "call",   "assign",
                              "assign*", "setof",  "bagof",  "enforce", ":first", ":sort-by"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

}  // namespace skein::htn
