// SPDX-License-Identifier: Apache-2.0
#include "proof/prover.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace skein::htn {

std::string place_text(Expression where) {
  if (where.document == nullptr) return "";
  if (!where) return where.document->file;
  const Place place = place_of(*where.document, (*where).begin);
  return where.document->file + ":" + std::to_string(place.line) + ":" +
         std::to_string(place.column);
}

bool Prover::solve(ConditionIndex condition, Base base, bool just_one, Answers& out) {
  out.clear();
  if (condition == kAbsent) {
    out.locals.push_back(0);
    if (recording_) out.support.emplace_back();
    return true;
  }
  const Condition& wanted = domain_.conditions[condition];
  Query query;
  query.base = base;
  begin(Purpose::kTop, condition, just_one || wanted.first, query);
  if (!run()) return false;
  std::swap(out, sets_[0]);
  sets_open_ = 0;
  return !wanted.sorted || sort(wanted, base, out);
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
  const std::optional<ConditionIndex> condition = condition_of_atom(atom);
  if (!condition) return false;
  Answers answers;
  const bool recording = std::exchange(recording_, false);
  solve(*condition, 0, true, answers);
  recording_ = recording;
  return answers.count() > 0;
}

std::optional<ConditionIndex> Prover::condition_of_atom(Term atom) {
  const auto known = domain_.conditions_of_atoms.find(atom);
  if (known != domain_.conditions_of_atoms.end()) return known->second;
  const std::optional<ConditionIndex> made = condition_of_terms(store_.pair(atom, kNil), Goal{});
  if (made) domain_.conditions_of_atoms.emplace(atom, *made);
  return made;
}

// Back to where the proof began, whatever stopped it.
bool Prover::run() {
  Move move = Move::kForward;
  while (move != Move::kDone && move != Move::kStop) {
    move = move == Move::kForward ? forward() : back();
  }
  if (move == Move::kDone) return true;
  bindings_.undo(frames_.front().mark);
  frames_.clear();
  queries_.clear();
  continuations_.clear();
  support_.clear();
  sets_open_ = 0;
  once_frames_ = 0;
  return false;
}

Prover::Move Prover::forward() {
  const Continuation& here = continuations_[current_];
  switch (here.kind) {
    case ContinuationKind::kEmit:
      return emit();
    case ContinuationKind::kCut:
      frames_[here.position].committed = true;
      current_ = here.next;
      return Move::kForward;
    case ContinuationKind::kGoals:
      break;
  }
  if (!budget_.infer()) return Move::kStop;
  const std::vector<GoalIndex>& goals = *here.goals;
  const Base base = here.base;
  const std::uint32_t ahead = queries_.back().any_order ? pick(here) : 0;
  const GoalIndex goal = goals[here.position + ahead];
  std::uint32_t after = 0;
  if (ahead == 0) {
    after = push_goals(goals, here.position + 1, base, here.next, here.done);
  } else {
    const std::uint32_t done = here.done | 1U << (ahead - 1);
    continuations_.push_back(Continuation{here.kind, here.position, done, &goals, base, here.next});
    after = static_cast<std::uint32_t>(continuations_.size() - 1);
  }
  return execute(goal, base, after);
}

bool Prover::facts_alone(GoalIndex index) const {
  const Goal& goal = domain_.goals[index];
  return goal.kind == GoalKind::kAtom && goal.flat && goal.axioms == nullptr;
}

// Of atoms asked for one after the other that facts alone tell of, the one that fewest match comes
// first: how far it stands ahead.
std::uint32_t Prover::pick(const Continuation& here) {
  const std::span<const GoalIndex> goals = std::span(*here.goals).subspan(here.position);
  if (goals.size() < 2 || !facts_alone(goals[0]) || !facts_alone(goals[1])) return 0;
  std::uint32_t best = 0;
  std::uint32_t fewest = matching(domain_.goals[goals[0]], here.base);
  const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(goals.size(), kMostPicked));
  for (std::uint32_t ahead = 1; ahead < last && fewest > kFewEnough; ++ahead) {
    if (!facts_alone(goals[ahead])) break;
    if ((here.done >> (ahead - 1) & 1U) != 0) continue;
    const std::uint32_t count = matching(domain_.goals[goals[ahead]], here.base);
    if (count >= fewest) continue;
    best = ahead;
    fewest = count;
  }
  return best;
}

Prover::Move Prover::back() {
  const Frame& top = frames_.back();
  restore(top);
  switch (top.kind) {
    case FrameKind::kQuery:
      return queries_.back().test ? finish_test(false) : finish_query();
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
  const Query& query = queries_.back();
  if (query.test) {
    pop_frames(query.frame + 1);
    restore(frames_.back());
    return finish_test(true);
  }
  const Frame& barrier = frames_[query.frame];
  Answers& answers = set(query.set);
  answers.record(bindings_, barrier.mark.cells);
  if (recording_) {
    answers.support.emplace_back(support_.begin() + barrier.support, support_.end());
  }
  if (query.just_one) {
    pop_frames(query.frame + 1);
    restore(frames_.back());
    return finish_query();
  }
  if (once_frames_ == 0) return Move::kBack;
  for (std::size_t at = query.frame + 1; at < frames_.size(); ++at) {
    if (!frames_[at].once) continue;
    pop_frames(at + 1);
    frames_[at].once = false;
    frames_[at].committed = true;
    --once_frames_;
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
        current_ = push_goals(domain_.conditions[goal.conditions[0]].goals, 0, base, after);
        return Move::kForward;
      }
      return begin(Purpose::kEach, goal.conditions[0], false, query);
    case GoalKind::kOr:
      push_frame(FrameKind::kOr, index, base, after);
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
  query.frame = static_cast<std::uint32_t>(frames_.size());
  query.set = open_set();
  push_frame(FrameKind::kQuery, query.goal, query.base, query.after);
  const bool asked_alone = purpose == Purpose::kNot || purpose == Purpose::kForallPart ||
                           purpose == Purpose::kExistsPart;
  if (!asked_alone) collect_cells(wanted, query.base, set(query.set));
  // Where no variable gets a value, one proof tells all.
  const bool no_values = set(query.set).cells.empty();
  query.just_one = just_one || no_values;
  const bool rows = purpose == Purpose::kEach || purpose == Purpose::kAlternative;
  query.test = !recording_ && (asked_alone || (rows && no_values));
  query.any_order = query.test && wanted.finite;
  queries_.push_back(query);
  continuations_.push_back({});
  current_ = push_goals(wanted.goals, 0, query.base,
                        static_cast<std::uint32_t>(continuations_.size() - 1));
  return Move::kForward;
}

void Prover::collect_cells(const Condition& condition, Base base, Answers& answers) {
  for (const std::uint32_t slot : condition.slots) {
    const Term value = bindings_.resolve(Term(TermKind::kSlot, slot), base);
    if (!bindings_.plain(value)) bindings_.collect_unbound(value, base, answers.cells);
  }
  for (const Term variable : condition.variables) {
    bindings_.collect_unbound(variable, base, answers.cells);
  }
}

// All proofs of the innermost query are found, or as many as were wanted.
Prover::Move Prover::finish_query() {
  const Query query = queries_.back();
  queries_.pop_back();
  frames_.pop_back();
  Answers& answers = set(query.set);
  switch (query.purpose) {
    case Purpose::kTop:
      answers.finish(seen_);
      continuations_.clear();
      support_.clear();
      return Move::kDone;
    case Purpose::kNot: {
      const bool holds = answers.count() > 0;
      sets_open_ = query.set;
      if (holds) return Move::kBack;
      if (recording_) note_absence(domain_.goals[query.goal], query.base);
      current_ = query.after;
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
      sets_open_ = query.set;
      return finish_quantifier_part(
          holds, holds && recording_ ? answers.support.front() : std::vector<CausalLink>{});
    }
    case Purpose::kHolds:
      break;
  }
  return Move::kStop;
}

// The innermost query, of which only this was asked, is answered.
Prover::Move Prover::finish_test(bool holds) {
  const Query query = queries_.back();
  queries_.pop_back();
  frames_.pop_back();
  sets_open_ = query.set;
  if (query.purpose == Purpose::kForallPart || query.purpose == Purpose::kExistsPart) {
    return finish_quantifier_part(holds, {});
  }
  if (holds == (query.purpose == Purpose::kNot)) return Move::kBack;
  current_ = query.after;
  return Move::kForward;
}

Prover::Move Prover::finish_rows(const Query& query) {
  Answers& answers = set(query.set);
  answers.finish(seen_);
  if (answers.count() == 0) {
    sets_open_ = query.set;
    const Goal& goal = domain_.goals[query.goal];
    if (query.purpose != Purpose::kEnforce) return Move::kBack;
    return fail(goal, goal.text.empty() ? "an enforced condition does not hold" : goal.text);
  }
  Frame& frame = push_frame(FrameKind::kRows, query.goal, query.base, query.after);
  frame.set = query.set;
  return next_row();
}

Prover::Move Prover::next_row() {
  Frame& frame = frames_.back();
  const Answers& answers = set(frame.set);
  if (frame.at == answers.count()) {
    pop_frames(frames_.size() - 1);
    return Move::kBack;
  }
  const std::uint32_t row = frame.at++;
  answers.apply(row, bindings_);
  if (recording_) {
    support_.insert(support_.end(), answers.support[row].begin(), answers.support[row].end());
  }
  current_ = frame.after;
  if (frame.at == answers.count()) pop_frames(frames_.size() - 1);
  return Move::kForward;
}

// Whether the parts of a connective need no query of their own, all of whose answers would be found
// before the first is used. Where axioms lead back to themselves only at the end of a test: there
// no proof is tried that would not have been tried anyway.
bool Prover::one_is_enough(const Goal& goal, std::uint32_t after) const {
  return queries_.back().any_order || (goal.logical && ends_test(after));
}

Prover::Move Prover::next_alternative() {
  Frame& frame = frames_.back();
  const Goal& goal = domain_.goals[frame.goal];
  if (frame.at == goal.conditions.size()) {
    pop_frames(frames_.size() - 1);
    return Move::kBack;
  }
  const ConditionIndex alternative = goal.conditions[frame.at++];
  if (one_is_enough(goal, frame.after)) {
    current_ = push_goals(domain_.conditions[alternative].goals, 0, frame.base, frame.after);
    return Move::kForward;
  }
  Query query;
  query.after = frame.after;
  query.goal = frame.goal;
  query.base = frame.base;
  return begin(Purpose::kAlternative, alternative, false, query);
}

// ---- stacks ----------------------------------------------------------------------------------

// Keeps the first `count` frames. Rows that nobody goes through any more are given back, those of
// an innermost query apart.
void Prover::pop_frames(std::size_t count) {
  while (frames_.size() > count) {
    const Frame& frame = frames_.back();
    if (frame.once) --once_frames_;
    const bool owns_rows = frame.kind == FrameKind::kRows || frame.kind == FrameKind::kForall ||
                           frame.kind == FrameKind::kExists;
    if (owns_rows) sets_open_ = frame.set;
    frames_.pop_back();
  }
}

std::uint32_t Prover::open_set() {
  if (sets_open_ == sets_.size()) sets_.emplace_back();
  sets_[sets_open_].clear();
  return sets_open_++;
}

// (not atom) rests on the step that deleted the atom.
void Prover::note_absence(const Goal& goal, Base base) {
  const std::vector<GoalIndex>& inner = domain_.conditions[goal.conditions[0]].goals;
  if (inner.size() != 1 || domain_.goals[inner[0]].kind != GoalKind::kAtom) return;
  const Term atom = bindings_.instance(domain_.goals[inner[0]].pattern, base);
  if (!store_.ground(atom)) return;
  const StepIndex step = facts_.deleter(atom);
  if (step == kInitialState) return;
  const std::array<Term, 2> negation{store_.symbol("not"), atom};
  support_.push_back({store_.list(negation), step});
}

Prover::Move Prover::fail(const Goal& goal, const std::string& why) {
  budget_.fail(place_text(goal.where) + ": " + why);
  return Move::kStop;
}

std::size_t Prover::memory_bytes() const {
  std::size_t bytes = continuations_.capacity() * sizeof(Continuation) +
                      frames_.capacity() * sizeof(Frame) + support_.capacity() * sizeof(CausalLink);
  for (const Answers& answers : sets_) bytes += answers.memory_bytes();
  return bytes;
}

}  // namespace skein::htn
