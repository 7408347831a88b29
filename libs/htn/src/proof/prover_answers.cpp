// SPDX-License-Identifier: Apache-2.0
// The prover's work on the answers of a query that is over: collected, under each of them something
// more is asked, or sorted.
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

#include "proof/prover.hpp"

namespace skein::htn {

Prover::Move Prover::finish_collection(const Query& query) {
  const Goal& goal = domain_.goals[query.goal];
  Answers& answers = set(query.set);
  answers.finish(seen_);
  std::vector<Term> collected;
  for (std::size_t row = 0; row < answers.count(); ++row) {
    const Bindings::Mark mark = bindings_.mark();
    answers.apply(row, bindings_);
    const Term value = bindings_.instance(goal.term, query.base);
    bindings_.undo(mark);
    const bool again = std::find(collected.begin(), collected.end(), value) != collected.end();
    if (goal.kind == GoalKind::kBagOf || !again) collected.push_back(value);
  }
  sets_open_ = query.set;
  if (collected.empty()) return Move::kBack;
  for (const std::vector<CausalLink>& support : answers.support) {
    support_.insert(support_.end(), support.begin(), support.end());
  }
  if (!bind_value(goal.pattern, query.base, store_.list(collected))) return Move::kBack;
  current_ = query.after;
  return Move::kForward;
}

// forall and exists: the bounds are known, now the condition under each of them.
Prover::Move Prover::finish_quantifier_bounds(const Query& query) {
  Answers& answers = set(query.set);
  answers.finish(seen_);
  const bool all = query.purpose == Purpose::kForallBounds;
  Frame& frame = push_frame(all ? FrameKind::kForall : FrameKind::kExists, query.goal, query.base,
                            query.after);
  frame.set = query.set;
  return quantifier_part();
}

Prover::Move Prover::quantifier_part() {
  Frame& frame = frames_.back();
  const Answers& answers = set(frame.set);
  const bool all = frame.kind == FrameKind::kForall;
  if (frame.at == answers.count()) {
    current_ = frame.after;
    pop_frames(frames_.size() - 1);
    return all ? Move::kForward : Move::kBack;
  }
  answers.apply(frame.at++, bindings_);
  Query query;
  query.goal = frame.goal;
  query.base = frame.base;
  const ConditionIndex condition = domain_.goals[frame.goal].conditions[1];
  return begin(all ? Purpose::kForallPart : Purpose::kExistsPart, condition, true, query);
}

Prover::Move Prover::finish_quantifier_part(bool holds, const std::vector<CausalLink>& support) {
  Frame& frame = frames_.back();
  const bool all = frame.kind == FrameKind::kForall;
  restore(frame);
  if (holds && recording_) keep_support(frame, support);
  if (holds == all) return quantifier_part();
  current_ = frame.after;
  pop_frames(frames_.size() - 1);
  return holds ? Move::kForward : Move::kBack;
}

// What a part of a quantifier rests on outlives the part.
void Prover::keep_support(Frame& frame, const std::vector<CausalLink>& support) {
  support_.insert(support_.end(), support.begin(), support.end());
  frame.support = static_cast<std::uint32_t>(support_.size());
}

// :sort-by, stable as in SBCL: rows by the value of an expression under each of them.
bool Prover::sort(const Condition& condition, Base base, Answers& answers) {
  std::vector<Term> keys;
  for (std::size_t row = 0; row < answers.count(); ++row) {
    const Bindings::Mark mark = bindings_.mark();
    answers.apply(row, bindings_);
    const std::optional<Term> key = value_of(condition.sort_key, base);
    bindings_.undo(mark);
    if (!key) return false;
    keys.push_back(*key);
  }
  std::vector<std::size_t> order(answers.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t left, std::size_t right) {
    return before(condition, keys[left], keys[right]);
  });
  if (budget_.stopped()) return false;
  answers.reorder(order);
  return true;
}

bool Prover::before(const Condition& condition, Term left, Term right) {
  if (condition.compare == kNoCode) {
    if (left.is(TermKind::kNumber) && right.is(TermKind::kNumber)) {
      return less_value(store_.value(left), store_.value(right));
    }
    budget_.fail(place_text(condition.where) + ": :sort-by compares numbers, not " +
                 store_.to_text(left) + " and " + store_.to_text(right));
    return false;
  }
  const std::array<Term, 2> arguments{left, right};
  const auto result =
      domain_.lisp.apply(condition.compare, arguments, [](std::uint32_t) { return kNil; });
  if (!result) {
    budget_.fail(place_text(result.error().where) + ": " + result.error().why);
    return false;
  }
  return *result != kNil;
}

}  // namespace skein::htn
