// SPDX-License-Identifier: Apache-2.0
#include "proof/prover.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace skein::htn {

namespace {

void collect_cells(Bindings& bindings, const Condition& condition, Base base, Answers& answers) {
  for (const std::uint32_t slot : condition.slots) {
    const Term value = bindings.resolve(Term(TermKind::kSlot, slot), base);
    if (!bindings.plain(value)) bindings.collect_unbound(value, base, answers.cells);
  }
  for (const Term variable : condition.variables) {
    bindings.collect_unbound(variable, base, answers.cells);
  }
}

}  // namespace

bool Prover::solve(ConditionIndex condition, Base base, bool just_one, Answers& out) {
  out.clear();
  if (condition == kAbsent) {
    out.locals.push_back(0);
    if (stack_.recording) out.support.emplace_back();
    return true;
  }
  const Condition& wanted = domain_.conditions[condition];
  Query query;
  query.base = base;
  begin(Purpose::kTop, condition, just_one || wanted.first, query);
  if (!run()) return false;
  std::swap(out, stack_.sets[0]);
  stack_.sets_open = 0;
  return !wanted.sorted || evaluator_.sort(wanted, base, out);
}

bool Prover::solve_part(ConditionIndex condition, std::size_t goals, Base base, Answers& out) {
  const auto [known, fresh] = parts_.try_emplace({condition, goals}, kAbsent);
  if (fresh) {
    Condition part = domain_.conditions[condition];
    part.goals.resize(goals);
    part.sorted = false;
    domain_.conditions.push_back(std::move(part));
    known->second = static_cast<ConditionIndex>(domain_.conditions.size() - 1);
  }
  return solve(known->second, base, false, out);
}

bool Prover::holds(Term atom) {
  if (facts_.holds(atom)) return true;
  if (!domain_.axioms.contains(store_.car(atom))) return false;
  const std::optional<ConditionIndex> condition = value_goals_.condition_of_atom(atom);
  if (!condition) return false;
  Answers answers;
  const bool recording = std::exchange(stack_.recording, false);
  solve(*condition, 0, true, answers);
  stack_.recording = recording;
  return answers.count() > 0;
}

// Back to where the proof began, whatever stopped it.
bool Prover::run() {
  Move move = Move::kForward;
  while (move != Move::kDone && move != Move::kStop) {
    move = move == Move::kForward ? forward() : back();
  }
  if (move == Move::kDone) return true;
  bindings_.undo(stack_.frames.front().mark);
  stack_.clear();
  return false;
}

Prover::Move Prover::forward() {
  const Continuation& here = stack_.continuations[stack_.current];
  switch (here.kind) {
    case ContinuationKind::kEmit:
      return emit();
    case ContinuationKind::kCut:
      stack_.frames[here.position].committed = true;
      stack_.current = here.next;
      return Move::kForward;
    case ContinuationKind::kGoals:
      break;
  }
  if (!budget_.infer()) return Move::kStop;
  const std::vector<GoalIndex>& goals = *here.goals;
  const Base base = here.base;
  const std::uint32_t ahead =
      stack_.queries.back().any_order
          ? matcher_.pick(std::span(goals).subspan(here.position), here.done, base)
          : 0;
  const GoalIndex goal = goals[here.position + ahead];
  std::uint32_t after = 0;
  if (ahead == 0) {
    after = stack_.push_goals(goals, here.position + 1, base, here.next, here.done);
  } else {
    const std::uint32_t done = here.done | 1U << (ahead - 1);
    stack_.continuations.push_back(
        Continuation{here.kind, here.position, done, &goals, base, here.next});
    after = static_cast<std::uint32_t>(stack_.continuations.size() - 1);
  }
  return execute(goal, base, after);
}

Prover::Move Prover::back() {
  const Frame& top = stack_.frames.back();
  stack_.restore(top);
  switch (top.kind) {
    case FrameKind::kQuery:
      return stack_.queries.back().test ? finish_test(false) : finish_query();
    case FrameKind::kAtom:
      return retry_atom();
    case FrameKind::kRows:
      return next_row();
    case FrameKind::kOr:
      return next_alternative();
    case FrameKind::kForall:
    case FrameKind::kExists:
      return quantifier_part();
    case FrameKind::kItems:
      return next_item();
  }
  return Move::kStop;
}

// A proof of the innermost query is complete.
Prover::Move Prover::emit() {
  const Query& query = stack_.queries.back();
  if (query.test) {
    stack_.pop_frames(query.frame + 1);
    stack_.restore(stack_.frames.back());
    return finish_test(true);
  }
  const Frame& barrier = stack_.frames[query.frame];
  Answers& answers = stack_.set(query.set);
  answers.record(bindings_, barrier.mark.cells);
  if (stack_.recording) {
    answers.support.emplace_back(stack_.support.begin() + barrier.support, stack_.support.end());
  }
  if (query.just_one) {
    stack_.pop_frames(query.frame + 1);
    stack_.restore(stack_.frames.back());
    return finish_query();
  }
  if (stack_.once_frames == 0) return Move::kBack;
  for (std::size_t at = query.frame + 1; at < stack_.frames.size(); ++at) {
    if (!stack_.frames[at].once) continue;
    stack_.pop_frames(at + 1);
    stack_.frames[at].once = false;
    stack_.frames[at].committed = true;
    --stack_.once_frames;
    break;
  }
  return Move::kBack;
}

Prover::Move Prover::execute(GoalIndex index, Base base, std::uint32_t after) {
  const Goal& goal = domain_.goals[index];
  if (goal.kind == GoalKind::kAtom) return atom(index, base, after);
  Query query;
  query.after = after;
  query.goal = index;
  query.base = base;
  switch (goal.kind) {
    case GoalKind::kAtom:
      break;
    case GoalKind::kAnd:
    case GoalKind::kImply:
      if (one_is_enough(goal, after)) {
        stack_.current =
            stack_.push_goals(domain_.conditions[goal.conditions[0]].goals, 0, base, after);
        return Move::kForward;
      }
      return begin(Purpose::kEach, goal.conditions[0], false, query);
    case GoalKind::kOr:
      stack_.push_frame(FrameKind::kOr, index, base, after);
      return next_alternative();
    case GoalKind::kNot:
      return negated(goal, query);
    case GoalKind::kForall:
      return begin(Purpose::kForallBounds, goal.conditions[0], false, query);
    case GoalKind::kExists:
      return begin(Purpose::kExistsBounds, goal.conditions[0], false, query);
    case GoalKind::kEval:
      return evaluate(goal, base, after);
    case GoalKind::kAssign:
      return assign(goal, base, after);
    case GoalKind::kAssignEach:
      return assign_each(index, base, after);
    case GoalKind::kSetOf:
    case GoalKind::kBagOf:
      return begin(Purpose::kCollect, goal.conditions[0], false, query);
    case GoalKind::kEnforce:
      return begin(Purpose::kEnforce, goal.conditions[0], false, query);
    case GoalKind::kVariable:
      return value_as_goal(goal, base, after);
  }
  return Move::kStop;
}

// ---- queries ---------------------------------------------------------------------------------

Prover::Move Prover::begin(Purpose purpose, ConditionIndex condition, bool just_one, Query query) {
  const Condition& wanted = domain_.conditions[condition];
  query.purpose = purpose;
  query.frame = static_cast<std::uint32_t>(stack_.frames.size());
  query.set = stack_.open_set();
  stack_.push_frame(FrameKind::kQuery, query.goal, query.base, query.after);
  const bool asked_alone = purpose == Purpose::kNot || purpose == Purpose::kForallPart ||
                           purpose == Purpose::kExistsPart;
  if (!asked_alone) collect_cells(bindings_, wanted, query.base, stack_.set(query.set));
  // Where no variable gets a value, one proof tells all.
  const bool no_values = stack_.set(query.set).cells.empty();
  query.just_one = just_one || no_values;
  const bool rows = purpose == Purpose::kEach || purpose == Purpose::kAlternative;
  query.test = !stack_.recording && (asked_alone || (rows && no_values));
  query.any_order = query.test && wanted.finite;
  stack_.queries.push_back(query);
  stack_.continuations.push_back({});
  stack_.current = stack_.push_goals(wanted.goals, 0, query.base,
                                     static_cast<std::uint32_t>(stack_.continuations.size() - 1));
  return Move::kForward;
}

// All proofs of the innermost query are found, or as many as were wanted.
Prover::Move Prover::finish_query() {
  const Query query = stack_.queries.back();
  stack_.queries.pop_back();
  stack_.frames.pop_back();
  Answers& answers = stack_.set(query.set);
  switch (query.purpose) {
    case Purpose::kTop:
      answers.finish(seen_);
      stack_.continuations.clear();
      stack_.support.clear();
      return Move::kDone;
    case Purpose::kNot: {
      const bool holds = answers.count() > 0;
      stack_.sets_open = query.set;
      if (holds) return Move::kBack;
      if (stack_.recording) note_absence(domain_.goals[query.goal], query.base);
      stack_.current = query.after;
      return Move::kForward;
    }
    case Purpose::kEach:
    case Purpose::kAlternative:
    case Purpose::kEnforce:
      return finish_rows(query);
    case Purpose::kCollect:
      return finish_collection(query);
    case Purpose::kForallBounds:
    case Purpose::kExistsBounds:
      return finish_quantifier_bounds(query);
    case Purpose::kForallPart:
    case Purpose::kExistsPart: {
      const bool holds = answers.count() > 0;
      stack_.sets_open = query.set;
      return finish_quantifier_part(
          holds, holds && stack_.recording ? answers.support.front() : std::vector<CausalLink>{});
    }
    case Purpose::kHolds:
      break;
  }
  return Move::kStop;
}

// The innermost query, of which only this was asked, is answered.
Prover::Move Prover::finish_test(bool holds) {
  const Query query = stack_.queries.back();
  stack_.queries.pop_back();
  stack_.frames.pop_back();
  stack_.sets_open = query.set;
  if (query.purpose == Purpose::kForallPart || query.purpose == Purpose::kExistsPart) {
    return finish_quantifier_part(holds, {});
  }
  if (holds == (query.purpose == Purpose::kNot)) return Move::kBack;
  stack_.current = query.after;
  return Move::kForward;
}

Prover::Move Prover::finish_rows(const Query& query) {
  Answers& answers = stack_.set(query.set);
  answers.finish(seen_);
  if (answers.count() == 0) {
    stack_.sets_open = query.set;
    const Goal& goal = domain_.goals[query.goal];
    if (query.purpose != Purpose::kEnforce) return Move::kBack;
    return fail(goal, goal.text.empty() ? "an enforced condition does not hold" : goal.text);
  }
  Frame& frame = stack_.push_frame(FrameKind::kRows, query.goal, query.base, query.after);
  frame.set = query.set;
  return next_row();
}

Prover::Move Prover::next_row() {
  Frame& frame = stack_.frames.back();
  const Answers& answers = stack_.set(frame.set);
  if (frame.at == answers.count()) {
    stack_.pop_frame();
    return Move::kBack;
  }
  const std::uint32_t row = frame.at++;
  answers.apply(row, bindings_);
  if (stack_.recording) {
    stack_.support.insert(stack_.support.end(), answers.support[row].begin(),
                          answers.support[row].end());
  }
  stack_.current = frame.after;
  if (frame.at == answers.count()) stack_.pop_frame();
  return Move::kForward;
}

// Whether the parts of a connective need no query of their own, all of whose answers would be found
// before the first is used. Where axioms lead back to themselves only at the end of a test: there
// no proof is tried that would not have been tried anyway.
bool Prover::one_is_enough(const Goal& goal, std::uint32_t after) const {
  return stack_.queries.back().any_order || (goal.logical && stack_.ends_test(after));
}

Prover::Move Prover::next_alternative() {
  Frame& frame = stack_.frames.back();
  const Goal& goal = domain_.goals[frame.goal];
  if (frame.at == goal.conditions.size()) {
    stack_.pop_frame();
    return Move::kBack;
  }
  const ConditionIndex alternative = goal.conditions[frame.at++];
  if (one_is_enough(goal, frame.after)) {
    stack_.current =
        stack_.push_goals(domain_.conditions[alternative].goals, 0, frame.base, frame.after);
    return Move::kForward;
  }
  Query query;
  query.after = frame.after;
  query.goal = frame.goal;
  query.base = frame.base;
  return begin(Purpose::kAlternative, alternative, false, query);
}

// ---- stacks ----------------------------------------------------------------------------------

// (not atom) rests on the step that deleted the atom.
void Prover::note_absence(const Goal& goal, Base base) {
  const std::vector<GoalIndex>& inner = domain_.conditions[goal.conditions[0]].goals;
  if (inner.size() != 1 || domain_.goals[inner[0]].kind != GoalKind::kAtom) return;
  const Term atom = bindings_.instance(domain_.goals[inner[0]].pattern, base);
  if (!store_.ground(atom)) return;
  const StepIndex step = facts_.deleter(atom);
  if (step == kInitialState) return;
  const std::array<Term, 2> negation{store_.symbol("not"), atom};
  stack_.support.push_back({store_.list(negation), step});
}

Prover::Move Prover::fail(const Goal& goal, const std::string& why) {
  budget_.fail(place_text(goal.where) + ": " + why);
  return Move::kStop;
}

}  // namespace skein::htn
