// SPDX-License-Identifier: Apache-2.0
// The prover's work on single goals: atoms from facts and axioms, values, expressions met as
// values.
#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "compile/condition_compiler.hpp"
#include "proof/prover.hpp"

namespace skein::htn {
namespace {

/// Goals that still follow on one another, at most: axioms that lead to themselves without end are
/// known for that after some 250 MB.
constexpr std::size_t kDeepestProof = 2'000'000;

}  // namespace

Prover::Move Prover::atom(GoalIndex index, Base base, std::uint32_t after) {
  const Goal& goal = domain_.goals[index];
  if (goal.flat) return flat_atom(index, base, after);
  Term whole;
  const Bindings::Known known = bindings_.look_up(goal.pattern, base, whole);
  Frame& frame = stack_.push_atom(index, base, after);
  const Term predicate = bindings_.resolve(goal.predicate, base);  // may be a variable's value
  if (!predicate.is(TermKind::kSymbol)) return retry_atom();
  if (known == Bindings::Known::kTerm) {
    const FactIndex fact = facts_.find(whole);
    if (fact == kNoFact) return retry_atom();
    note_support(fact);
    stack_.current = after;
    return Move::kForward;
  }
  if (known == Bindings::Known::kOpen) {
    const auto value_at = [this, base](const IndexedPosition& position) -> std::optional<Term> {
      const Term value = bindings_.resolve(position.pattern, base);
      return store_.ground(value) ? std::optional<Term>(value) : std::nullopt;
    };
    frame.cursor = facts_.candidates(predicate, goal.positions, value_at).first;
  }
  return retry_atom();
}

// What only facts tell of needs a frame only while another may match.
Prover::Move Prover::flat_atom(GoalIndex index, Base base, std::uint32_t after) {
  const Goal& goal = domain_.goals[index];
  const bool facts = facts_.any(goal.predicate);
  if (!facts && goal.axioms == nullptr) return Move::kBack;
  FactMatcher::Values values;
  const Bindings::Known known = matcher_.values_of(goal, base, values);
  if (known == Bindings::Known::kOpen) {
    if (goal.axioms == nullptr) return first_fact(index, values, base, after);
    Frame& frame = stack_.push_atom(index, base, after);
    frame.cursor = matcher_.candidates(goal, values, base).first;
    return retry_atom();
  }
  const bool known_values = known == Bindings::Known::kTerm;
  const FactIndex fact =
      known_values ? facts_.find(goal.predicate, std::span(values).first(goal.arguments.size()))
                   : kNoFact;
  const bool decided =
      goal.axioms == nullptr || (goal.logical && !stack_.recording && known_values);
  if (!decided) stack_.push_atom(index, base, after);
  if (fact != kNoFact) {
    note_support(fact);
    stack_.current = after;
    return Move::kForward;
  }
  if (!decided) return retry_atom();
  return goal.axioms == nullptr ? Move::kBack : test_axioms(index, base, after);
}

Prover::Move Prover::first_fact(GoalIndex index, const FactMatcher::Values& values, Base base,
                                std::uint32_t after) {
  const Goal& goal = domain_.goals[index];
  const std::span<const Term> arguments = std::span(values).first(goal.arguments.size());
  const Bindings::Mark mark = bindings_.mark();
  FactBase::Cursor cursor = matcher_.candidates(goal, values, base).first;
  while (cursor.fact != kNoFact) {
    const FactIndex fact = cursor.fact;
    cursor = facts_.next(cursor);
    if (!matcher_.match(arguments, base, fact)) {
      bindings_.undo(mark);
      continue;
    }
    if (cursor.fact != kNoFact) {
      Frame& frame = stack_.push_atom(index, base, after);
      frame.mark = mark;
      frame.cursor = cursor;
    }
    note_support(fact);
    stack_.current = after;
    return Move::kForward;
  }
  return Move::kBack;
}

// (not condition); of one fact without a query of its own.
Prover::Move Prover::negated(const Goal& goal, Query query) {
  const std::vector<GoalIndex>& inner = domain_.conditions[goal.conditions[0]].goals;
  if (stack_.recording || inner.size() != 1 || !facts_alone(domain_.goals[inner[0]])) {
    return begin(Purpose::kNot, goal.conditions[0], true, query);
  }
  if (!budget_.infer()) return Move::kStop;
  if (matcher_.some_fact(domain_.goals[inner[0]], query.base)) return Move::kBack;
  stack_.current = query.after;
  return Move::kForward;
}

// Whether a ground atom that is no fact follows by logical axioms: one proof is enough.
Prover::Move Prover::test_axioms(GoalIndex index, Base base, std::uint32_t after) {
  if (stack_.ends_test(after)) {
    stack_.push_atom(index, base, after);
    return try_axioms();
  }
  Query query;
  query.purpose = Purpose::kHolds;
  query.just_one = query.test = true;
  query.any_order = domain_.goals[index].finite;
  query.frame = static_cast<std::uint32_t>(stack_.frames.size());
  query.set = stack_.sets_open;
  query.after = after;
  query.goal = index;
  query.base = base;
  stack_.push_frame(FrameKind::kQuery, index, base, after);
  stack_.queries.push_back(query);
  stack_.continuations.push_back({});
  stack_.push_atom(index, base, static_cast<std::uint32_t>(stack_.continuations.size() - 1));
  return try_axioms();
}

Prover::Move Prover::retry_atom() {
  Frame& frame = stack_.frames.back();
  const Goal& goal = domain_.goals[frame.goal];
  while (frame.cursor.fact != kNoFact) {
    const FactIndex fact = frame.cursor.fact;
    frame.cursor = facts_.next(frame.cursor);
    if (!matcher_.match(goal.arguments, frame.base, fact)) {
      bindings_.undo(frame.mark);
      continue;
    }
    note_support(fact);
    stack_.current = frame.after;
    if (frame.cursor.fact == kNoFact && goal.axioms == nullptr) stack_.frames.pop_back();
    return Move::kForward;
  }
  if (goal.axioms == nullptr) {
    stack_.frames.pop_back();
    return Move::kBack;
  }
  return try_axioms();
}

Prover::Move Prover::try_axioms() {
  Frame& frame = stack_.frames.back();
  const Goal& goal = domain_.goals[frame.goal];
  if (!frame.axioms_begun) {
    frame.axioms_begun = true;
    frame.answers_middle = stack_.answers_so_far();
  }
  for (; frame.at < goal.axioms->size(); ++frame.at) {
    const Axiom& axiom = (*goal.axioms)[frame.at];
    if (!frame.committed && frame.tail < axiom.tails.size()) {
      Base axiom_base = 0;
      if (bindings_.enter(axiom.slots, store_.cdr(axiom.head), axiom.items,
                          store_.cdr(goal.pattern), frame.base, axiom_base)) {
        return enter_tail(axiom, axiom_base);
      }
      bindings_.undo(frame.mark);
    }
    frame.tail = 0;
    frame.committed = false;
    if (frame.once) {
      frame.once = false;
      --stack_.once_frames;
    }
  }
  return leave_atom();
}

// The tails of an axiom are if-then-else: behind the goals of a tail stands a cut, which makes it
// the last one tried.
Prover::Move Prover::enter_tail(const Axiom& axiom, Base axiom_base) {
  const auto self = static_cast<std::uint32_t>(stack_.frames.size() - 1);
  Frame& frame = stack_.frames.back();
  const AxiomTail& tail = axiom.tails[frame.tail++];
  const bool last_tail = frame.tail == axiom.tails.size();
  std::uint32_t after = frame.after;
  if (!last_tail && !stack_.ends_test(after)) {
    stack_.continuations.push_back({ContinuationKind::kCut, self, 0, nullptr, 0, after});
    after = static_cast<std::uint32_t>(stack_.continuations.size() - 1);
  }
  stack_.current = stack_.push_goals(tail.goals, 0, axiom_base, after);
  if (stack_.continuations.size() > kDeepestProof) return stop_too_deep(axiom);
  if (tail.first != frame.once) {
    frame.once = tail.first;
    stack_.once_frames += tail.first ? 1U : static_cast<std::uint32_t>(-1);
  }
  const bool last = last_tail && frame.at + 1 == domain_.goals[frame.goal].axioms->size();
  const bool order_kept = frame.answers_middle == frame.answers_first;
  if (last && order_kept && !tail.first) stack_.frames.pop_back();
  return Move::kForward;
}

Prover::Move Prover::stop_too_deep(const Axiom& axiom) {
  budget_.stop("proof: the axioms of " + store_.to_text(store_.car(axiom.head)) +
               " lead to themselves, " + std::to_string(kDeepestProof) + " goals deep");
  return Move::kStop;
}

// Answers are reversed in the end; those from facts must then stand before those from axioms.
Prover::Move Prover::leave_atom() {
  const Frame& frame = stack_.frames.back();
  if (frame.answers_middle > frame.answers_first &&
      stack_.answers_so_far() > frame.answers_middle) {
    stack_.set(stack_.queries.back().set).rotate(frame.answers_first, frame.answers_middle);
  }
  stack_.pop_frame();
  return Move::kBack;
}

Prover::Move Prover::evaluate(const Goal& goal, Base base, std::uint32_t after) {
  const std::optional<Term> value = evaluator_.value_of(goal.code, base);
  if (!value) return Move::kStop;
  if (*value == kNil) return Move::kBack;
  stack_.current = after;
  return Move::kForward;
}

Prover::Move Prover::assign(const Goal& goal, Base base, std::uint32_t after) {
  const std::optional<Term> value = evaluator_.value_of(goal.code, base);
  if (!value) return Move::kStop;
  if (!evaluator_.bind(goal.pattern, base, *value)) return Move::kBack;
  stack_.current = after;
  return Move::kForward;
}

Prover::Move Prover::assign_each(GoalIndex index, Base base, std::uint32_t after) {
  const std::optional<Term> value = evaluator_.value_of(domain_.goals[index].code, base);
  if (!value) return Move::kStop;
  stack_.push_frame(FrameKind::kItems, index, base, after).items = *value;
  return next_item();
}

Prover::Move Prover::next_item() {
  Frame& frame = stack_.frames.back();
  while (frame.items.is(TermKind::kPair)) {
    const Term item = store_.car(frame.items);
    frame.items = store_.cdr(frame.items);
    if (!evaluator_.bind(domain_.goals[frame.goal].pattern, frame.base, item)) continue;
    stack_.current = frame.after;
    if (!frame.items.is(TermKind::kPair)) stack_.frames.pop_back();
    return Move::kForward;
  }
  stack_.frames.pop_back();
  return Move::kBack;
}

Prover::Move Prover::value_as_goal(const Goal& goal, Base base, std::uint32_t after) {
  const Term value = bindings_.instance(goal.pattern, base);
  if (value == kNil) {
    stack_.current = after;
    return Move::kForward;
  }
  const std::optional<GoalIndex> made = value_goals_.goal_of(value, goal);
  return made ? execute(*made, base, after) : Move::kStop;
}

}  // namespace skein::htn
