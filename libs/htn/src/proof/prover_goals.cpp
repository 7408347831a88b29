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

Prover::Move Prover::atom(GoalIndex index, Base base, std::uint32_t after) {
  const Goal& goal = domain_.goals[index];
  if (goal.flat) return flat_atom(index, base, after);
  Term whole;
  const Bindings::Known known = bindings_.look_up(goal.pattern, base, whole);
  Frame& frame = push_atom(index, base, after);
  const Term predicate = bindings_.resolve(goal.predicate, base);  // may be a variable's value
  if (!predicate.is(TermKind::kSymbol)) return retry_atom();
  if (known == Bindings::Known::kTerm) {
    const FactIndex fact = facts_.find(whole);
    if (fact == kNoFact) return retry_atom();
    note_support(fact);
    current_ = after;
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
  Values values;
  const Bindings::Known known = values_of(goal, base, values);
  if (known == Bindings::Known::kOpen) {
    if (goal.axioms == nullptr) return first_fact(index, values, base, after);
    Frame& frame = push_atom(index, base, after);
    frame.cursor = candidates(goal, values, base).first;
    return retry_atom();
  }
  const bool known_values = known == Bindings::Known::kTerm;
  const FactIndex fact =
      known_values ? facts_.find(goal.predicate, std::span(values).first(goal.arguments.size()))
                   : kNoFact;
  const bool decided = goal.axioms == nullptr || (goal.logical && !recording_ && known_values);
  if (!decided) push_atom(index, base, after);
  if (fact != kNoFact) {
    note_support(fact);
    current_ = after;
    return Move::kForward;
  }
  if (!decided) return retry_atom();
  return goal.axioms == nullptr ? Move::kBack : test_axioms(index, base, after);
}

// The values of the arguments as far as they are known: any kOpen one may be followed by others
// that are not looked at.
Bindings::Known Prover::values_of(const Goal& goal, Base base, Values& values) {
  Bindings::Known all = Bindings::Known::kTerm;
  for (std::size_t at = 0; at < goal.arguments.size(); ++at) {
    Term value = bindings_.resolve(goal.arguments[at], base);
    if (!bindings_.plain(value)) {
      const Bindings::Known known = value.is(TermKind::kPair)
                                        ? bindings_.look_up(value, base, value)
                                        : Bindings::Known::kOpen;
      if (known == Bindings::Known::kNever) return known;
      if (known == Bindings::Known::kOpen) all = known;
    }
    values[at] = value;
  }
  return all;
}

FactBase::Candidates Prover::candidates(const Goal& goal, const Values& values, Base base) {
  return facts_.candidates(goal.predicate, goal.positions, [&](const IndexedPosition& position) {
    const bool whole = position.path.inner == Path::kWhole;
    const Term value =
        whole ? values[position.path.outer] : bindings_.resolve(position.pattern, base);
    return store_.ground(value) ? std::optional<Term>(value) : std::nullopt;
  });
}

Prover::Move Prover::first_fact(GoalIndex index, const Values& values, Base base,
                                std::uint32_t after) {
  const Goal& goal = domain_.goals[index];
  const std::span<const Term> arguments = std::span(values).first(goal.arguments.size());
  const Bindings::Mark mark = bindings_.mark();
  FactBase::Cursor cursor = candidates(goal, values, base).first;
  while (cursor.fact != kNoFact) {
    const FactIndex fact = cursor.fact;
    cursor = facts_.next(cursor);
    if (!match_fact(arguments, base, fact)) {
      bindings_.undo(mark);
      continue;
    }
    if (cursor.fact != kNoFact) {
      Frame& frame = push_atom(index, base, after);
      frame.mark = mark;
      frame.cursor = cursor;
    }
    note_support(fact);
    current_ = after;
    return Move::kForward;
  }
  return Move::kBack;
}

// One that nobody asks for the values of its variables.
bool Prover::some_fact(const Goal& goal, Base base) {
  if (!facts_.any(goal.predicate)) return false;
  Values values;
  const Bindings::Known known = values_of(goal, base, values);
  if (known == Bindings::Known::kNever) return false;
  const std::span<const Term> arguments = std::span(values).first(goal.arguments.size());
  if (known == Bindings::Known::kTerm) return facts_.find(goal.predicate, arguments) != kNoFact;
  const Bindings::Mark mark = bindings_.mark();
  for (FactBase::Cursor cursor = candidates(goal, values, base).first; cursor.fact != kNoFact;
       cursor = facts_.next(cursor)) {
    const bool matches = match_fact(arguments, base, cursor.fact);
    bindings_.undo(mark);
    if (matches) return true;
  }
  return false;
}

// How many facts may match, at most.
std::uint32_t Prover::matching(const Goal& goal, Base base) {
  if (!facts_.any(goal.predicate)) return 0;
  Values values;
  switch (values_of(goal, base, values)) {
    case Bindings::Known::kNever:
      return 0;
    case Bindings::Known::kTerm:
      return 1;
    case Bindings::Known::kOpen:
      break;
  }
  return candidates(goal, values, base).count;
}

// (not condition); of one fact without a query of its own.
Prover::Move Prover::negated(const Goal& goal, Query query) {
  const std::vector<GoalIndex>& inner = domain_.conditions[goal.conditions[0]].goals;
  if (recording_ || inner.size() != 1 || !facts_alone(inner[0])) {
    return begin(Purpose::kNot, goal.conditions[0], true, query);
  }
  if (!budget_.infer()) return Move::kStop;
  if (some_fact(domain_.goals[inner[0]], query.base)) return Move::kBack;
  current_ = query.after;
  return Move::kForward;
}

// Whether a ground atom that is no fact follows by logical axioms: one proof is enough.
Prover::Move Prover::test_axioms(GoalIndex index, Base base, std::uint32_t after) {
  if (ends_test(after)) {
    push_atom(index, base, after);
    return try_axioms();
  }
  Query query;
  query.purpose = Purpose::kHolds;
  query.just_one = query.test = true;
  query.any_order = domain_.goals[index].finite;
  query.frame = static_cast<std::uint32_t>(frames_.size());
  query.set = sets_open_;
  query.after = after;
  query.goal = index;
  query.base = base;
  push_frame(FrameKind::kQuery, index, base, after);
  queries_.push_back(query);
  continuations_.push_back({});
  push_atom(index, base, static_cast<std::uint32_t>(continuations_.size() - 1));
  return try_axioms();
}

std::uint32_t Prover::answers_so_far() {
  const Query& query = queries_.back();
  return query.test ? 0 : static_cast<std::uint32_t>(set(query.set).count());
}

Prover::Frame& Prover::push_atom(GoalIndex index, Base base, std::uint32_t after) {
  Frame& frame = push_frame(FrameKind::kAtom, index, base, after);
  frame.answers_first = answers_so_far();
  return frame;
}

Prover::Move Prover::retry_atom() {
  Frame& frame = frames_.back();
  const Goal& goal = domain_.goals[frame.goal];
  while (frame.cursor.fact != kNoFact) {
    const FactIndex fact = frame.cursor.fact;
    frame.cursor = facts_.next(frame.cursor);
    if (!match_fact(goal.arguments, frame.base, fact)) {
      bindings_.undo(frame.mark);
      continue;
    }
    note_support(fact);
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

bool Prover::match_fact(std::span<const Term> arguments, Base base, FactIndex fact) {
  const std::span<const Term> values = facts_.arguments(fact);
  if (values.size() != arguments.size()) return false;
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (arguments[at] == values[at]) continue;
    const Term argument = bindings_.resolve(arguments[at], base);
    if (argument.is(TermKind::kVariable)) {
      bindings_.bind(argument, values[at]);
    } else if (argument != values[at] &&
               (store_.ground(argument) || !bindings_.unify(argument, base, values[at], 0))) {
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
    frame.answers_middle = answers_so_far();
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
  if (!last_tail && !ends_test(after)) {
    continuations_.push_back({ContinuationKind::kCut, self, 0, nullptr, 0, after});
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
  if (frame.answers_middle > frame.answers_first && answers_so_far() > frame.answers_middle) {
    set(queries_.back().set).rotate(frame.answers_first, frame.answers_middle);
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
