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
  Answers& answers = stack_.set(query.set);
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
  stack_.sets_open = query.set;
  if (collected.empty()) return Move::kBack;
  for (const std::vector<CausalLink>& support : answers.support) {
    stack_.support.insert(stack_.support.end(), support.begin(), support.end());
  }
  if (!evaluator_.bind(goal.pattern, query.base, store_.list(collected))) return Move::kBack;
  stack_.current = query.after;
  return Move::kForward;
}

// forall and exists: the bounds are known, now the condition under each of them.
Prover::Move Prover::finish_quantifier_bounds(const Query& query) {
  Answers& answers = stack_.set(query.set);
  answers.finish(seen_);
  const bool all = query.purpose == Purpose::kForallBounds;
  Frame& frame = stack_.push_frame(all ? FrameKind::kForall : FrameKind::kExists, query.goal,
                                   query.base, query.after);
  frame.set = query.set;
  return quantifier_part();
}

Prover::Move Prover::quantifier_part() {
  Frame& frame = stack_.frames.back();
  const Answers& answers = stack_.set(frame.set);
  const bool all = frame.kind == FrameKind::kForall;
  if (frame.at == answers.count()) {
    stack_.current = frame.after;
    stack_.pop_frame();
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
  Frame& frame = stack_.frames.back();
  const bool all = frame.kind == FrameKind::kForall;
  stack_.restore(frame);
  if (holds && stack_.recording) stack_.keep_support(frame, support);
  if (holds == all) return quantifier_part();
  stack_.current = frame.after;
  stack_.pop_frame();
  return holds ? Move::kForward : Move::kBack;
}

}  // namespace skein::htn
