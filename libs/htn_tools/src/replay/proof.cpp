// SPDX-License-Identifier: Apache-2.0
#include "replay/proof.hpp"

#include <algorithm>

namespace skein::htn::replay {

namespace {

constexpr int kDeepestNesting = 300;

template <class Test>
bool nested(ProofContext& context, const Test& test) {
  if (context.error) return false;
  if (context.nesting >= kDeepestNesting) {
    context.error = "negations and quantifiers nested too deeply";
    return false;
  }
  ++context.nesting;
  const Bindings::Mark mark = context.bindings.mark();
  const bool result = test();
  context.bindings.undo(mark);
  --context.nesting;
  return result;
}

// What the goals say under the present bindings: proofs that agree in it are one answer.
Term answer_key(const ProofContext& context, const std::vector<Goal>& goals, std::uint32_t base) {
  std::vector<Term> out;
  for (const Goal& goal : goals) {
    if (goal.kind == GoalKind::kForall) continue;
    out.push_back(context.bindings.instance(goal.pattern, base));
    for (const std::vector<Goal>& part : goal.parts) {
      out.push_back(answer_key(context, part, base));
    }
  }
  return context.store.list(out);
}

}  // namespace

bool provable(ProofContext& context, const std::vector<Goal>& goals, std::uint32_t base) {
  return nested(context, [&] { return Proof(context, goals, base).next(); });
}

bool provable(ProofContext& context, Term goal) {
  return nested(context, [&] { return Proof(context, goal).next(); });
}

Term evaluate(ProofContext& context, CodeIndex code, std::uint32_t base) {
  if (code == kNoCode) {
    if (!context.error) context.error = "a term cannot be evaluated";
    return kNil;
  }
  const auto value = context.lisp.evaluate(code, [&](std::uint32_t slot) {
    return context.bindings.instance({TermKind::kSlot, slot}, base);
  });
  if (value) return *value;
  if (!context.error) context.error = value.error().why;
  return kNil;
}

Proof::Proof(ProofContext& context, const std::vector<Goal>& goals, std::uint32_t base)
    : context_(context) {
  current_ = chain(goals, base, kEnd);
}

Proof::Proof(ProofContext& context, Term goal) : context_(context) {
  pendings_.push_back({Kind::kTerm, nullptr, goal, 0, kEnd});
  current_ = 0;
}

std::uint32_t Proof::chain(const std::vector<Goal>& goals, std::uint32_t base, std::uint32_t next) {
  for (auto at = goals.rbegin(); at != goals.rend(); ++at) {
    pendings_.push_back({Kind::kGoal, &*at, {}, base, next});
    next = static_cast<std::uint32_t>(pendings_.size() - 1);
  }
  return next;
}

bool Proof::next() {
  if (started_ && !backtrack()) return false;
  started_ = true;
  while (current_ != kEnd) {
    if (!context_.error && context_.steps_left-- == 0) {
      context_.steps_left = 0;
      context_.error = "too many inferences";
    }
    if (context_.error) return false;
    if (!step() && !backtrack()) return false;
  }
  keep_once();
  return !context_.error;
}

void Proof::keep_once() {
  const auto once = std::find_if(choices_.begin(), choices_.end(),
                                 [](const Choice& choice) { return choice.once; });
  if (once == choices_.end()) return;
  once->committed = true;
  choices_.erase(once + 1, choices_.end());
}

bool Proof::step() {
  const Pending pending = pendings_[current_];
  if (pending.kind == Kind::kCommit) {
    choices_[pending.base].committed = true;
    current_ = pending.next;
    return true;
  }
  return pending.kind == Kind::kTerm ? step_term(pending) : step_goal(pending);
}

bool Proof::step_goal(const Pending& pending) {
  const Goal& goal = *pending.goal;
  const std::uint32_t base = pending.base;
  bool holds = true;
  switch (goal.kind) {
    case GoalKind::kAtom:
      return choose(context_.bindings.instance(goal.pattern, base), {});
    case GoalKind::kVariable:
      return step_term(
          {Kind::kTerm, nullptr, context_.bindings.instance(goal.pattern, base), 0, pending.next});
    case GoalKind::kAnd:
    case GoalKind::kEnforce:
      current_ = chain(goal.parts[0], base, pending.next);
      return true;
    case GoalKind::kOr:
    case GoalKind::kImply:
      return choose({}, {});
    case GoalKind::kAssignEach:
      return choose({}, context_.store.items(evaluate(context_, goal.code, base)));
    case GoalKind::kNot:
      holds = goal.parts.empty() || !provable(context_, goal.parts[0], base);
      break;
    case GoalKind::kForall:
    case GoalKind::kExists:
      holds = nested(context_, [&] { return quantified(goal, base); });
      break;
    case GoalKind::kAssign:
      holds = assigned(goal, base);
      break;
    case GoalKind::kEval:
      holds = evaluate(context_, goal.code, base) != kNil;
      break;
    case GoalKind::kSetof:
    case GoalKind::kBagof:
      holds = collected(goal, base);
      break;
  }
  current_ = pending.next;
  return holds;
}

// A goal that came into being in the search: an atom, a list of goals, or one of and, not.
bool Proof::step_term(const Pending& pending) {
  const TermStore& store = context_.store;
  Term goal = pending.term;
  current_ = pending.next;
  if (goal == kNil) return true;
  const Term head = predicate_of(store, goal);
  const std::string_view name = head.is(TermKind::kSymbol) ? store.name(head) : "";
  if (name == "not") {
    const Term negated = store.cdr(goal);
    return !provable(context_, negated.is(TermKind::kPair) ? store.car(negated) : kNil);
  }
  if (name != "and" && !head.is(TermKind::kPair)) {
    pendings_.push_back(pending);
    current_ = static_cast<std::uint32_t>(pendings_.size() - 1);
    return choose(goal, {});
  }
  std::vector<Term> items = store.items(name == "and" ? store.cdr(goal) : goal);
  std::uint32_t next = pending.next;
  for (auto at = items.rbegin(); at != items.rend(); ++at) {
    pendings_.push_back({Kind::kTerm, nullptr, *at, 0, next});
    next = static_cast<std::uint32_t>(pendings_.size() - 1);
  }
  current_ = next;
  return true;
}

bool Proof::choose(Term atom, std::vector<Term> items) {
  Choice choice;
  choice.pending = current_;
  choice.mark = context_.bindings.mark();
  choice.pendings = pendings_.size();
  choice.atom = atom;
  choice.items = std::move(items);
  choices_.push_back(std::move(choice));
  return backtrack();
}

// Takes the next alternative of the latest choice that has one.
bool Proof::backtrack() {
  while (!choices_.empty() && !context_.error) {
    context_.bindings.undo(choices_.back().mark);
    pendings_.resize(choices_.back().pendings);
    if (advance(choices_.back())) return true;
    context_.bindings.undo(choices_.back().mark);
    choices_.pop_back();
  }
  return false;
}

bool Proof::advance(Choice& choice) {
  const Pending pending = pendings_[choice.pending];
  if (pending.kind == Kind::kTerm || pending.goal->kind == GoalKind::kAtom ||
      pending.goal->kind == GoalKind::kVariable) {
    return advance_atom(choice, pending.next);
  }
  const Goal& goal = *pending.goal;
  if (goal.kind == GoalKind::kAssignEach) {
    const Bindings::Mark mark = context_.bindings.mark();
    while (choice.at < choice.items.size()) {
      const Term variable = context_.bindings.instance(goal.pattern, pending.base);
      current_ = pending.next;
      if (context_.bindings.unify(variable, choice.items[choice.at++])) return true;
      context_.bindings.undo(mark);
    }
    return false;
  }
  if (goal.kind == GoalKind::kImply && choice.at == 0) {
    ++choice.at;
    current_ = pending.next;
    if (!provable(context_, goal.parts.at(0), pending.base)) return true;
  }
  if (choice.at >= goal.parts.size()) return false;
  current_ = chain(goal.parts[choice.at++], pending.base, pending.next);
  return true;
}

bool Proof::advance_atom(Choice& choice, std::uint32_t next) {
  Bindings& bindings = context_.bindings;
  const std::vector<Term>& facts = context_.world.facts(predicate_of(context_.store, choice.atom));
  if (choice.at < facts.size() && context_.store.ground(choice.atom)) {
    choice.at = facts.size();
    current_ = next;
    if (context_.world.holds(choice.atom)) return true;
  }
  while (choice.at < facts.size()) {
    const Term fact = facts[facts.size() - ++choice.at];
    current_ = next;
    if (bindings.unify(choice.atom, fact)) return true;
    bindings.undo(choice.mark);
  }
  return advance_axiom(choices_.size() - 1, next);
}

bool Proof::advance_axiom(std::size_t index, std::uint32_t next) {
  Choice& choice = choices_[index];
  const std::vector<AxiomClause>& axioms =
      context_.clauses.axioms_for(predicate_of(context_.store, choice.atom));
  while (choice.axiom < axioms.size()) {
    const AxiomClause& axiom = axioms[choice.axiom];
    if (choice.committed || choice.tail == axiom.tails.size()) {
      ++choice.axiom;
      choice.tail = 0;
      choice.committed = false;
      choice.once = false;
      continue;
    }
    const Condition& tail = axiom.tails[choice.tail++];
    choice.once = tail.first;
    const std::uint32_t base = context_.bindings.fresh(axiom.slots);
    if (context_.bindings.unify(choice.atom, context_.bindings.instance(axiom.head, base))) {
      pendings_.push_back({Kind::kCommit, nullptr, {}, static_cast<std::uint32_t>(index), next});
      current_ = chain(tail.goals, base, static_cast<std::uint32_t>(pendings_.size() - 1));
      return true;
    }
    context_.bindings.undo(choice.mark);
    choice.tail = axiom.tails.size();
  }
  return false;
}

bool Proof::quantified(const Goal& goal, std::uint32_t base) {
  Proof bounds(context_, goal.parts.at(0), base);
  const bool wanted = goal.kind == GoalKind::kExists;
  while (bounds.next()) {
    if (provable(context_, goal.parts.at(1), base) == wanted) return wanted && !context_.error;
  }
  return !wanted && !context_.error;
}

bool Proof::collected(const Goal& goal, std::uint32_t base) {
  std::vector<std::pair<Term, Term>> found;  // what tells answers apart, and what is collected
  nested(context_, [&] {
    Proof each(context_, goal.parts.at(0), base);
    while (each.next()) {
      const Term collected = context_.bindings.instance(goal.pattern, base);
      const Term answer = answer_key(context_, goal.parts.at(0), base);
      found.emplace_back(goal.kind == GoalKind::kBagof ? answer : collected, collected);
    }
    return true;
  });
  // The order is that of the whole set of answers: the last found comes first.
  std::vector<Term> known;
  std::vector<Term> listed;
  for (auto at = found.rbegin(); at != found.rend(); ++at) {
    if (std::find(known.begin(), known.end(), at->first) != known.end()) continue;
    known.push_back(at->first);
    listed.push_back(at->second);
  }
  if (listed.empty()) return false;
  const Term target = context_.bindings.instance(goal.result, base);
  // The order of answers is the planner's affair: a list that is given may have any.
  if (!context_.store.ground(target)) {
    return context_.bindings.unify(target, context_.store.list(listed));
  }
  const std::vector<Term> given = context_.store.items(target);
  return std::is_permutation(given.begin(), given.end(), listed.begin(), listed.end());
}

bool Proof::assigned(const Goal& goal, std::uint32_t base) {
  const Term value = evaluate(context_, goal.code, base);
  if (context_.error) return false;
  const Term target = context_.bindings.instance(goal.pattern, base);
  if (context_.store.loose(target) == context_.store.loose(value)) return true;
  return context_.bindings.unify(target, value);
}

}  // namespace skein::htn::replay
