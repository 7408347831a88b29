// SPDX-License-Identifier: Apache-2.0
#include "replay/operator.hpp"

#include <algorithm>

namespace skein::htn::replay {

namespace {

/// Works out the lists of changes of one application.
class Changes {
 public:
  Changes(ProofContext& context, std::uint32_t base, bool action)
      : context_(context), base_(base), in_order_(action) {}

  void collect(const std::vector<Effect>& effects) {
    for (const Effect& effect : effects) collect(effect);
  }
  std::vector<Term> deletions;
  std::vector<Term> additions;

 private:
  void collect(const Effect& effect) {
    const Term pattern = context_.bindings.instance(effect.pattern, base_);
    switch (effect.kind) {
      case EffectKind::kAdd:
        put(pattern, additions);
        break;
      case EffectKind::kDelete:
        put(pattern, deletions);
        break;
      case EffectKind::kAddItems:
        for (const Term item : context_.store.items(pattern)) put(item, additions);
        break;
      case EffectKind::kDeleteItems:
        for (const Term item : context_.store.items(pattern)) put(item, deletions);
        break;
      case EffectKind::kForall:
      case EffectKind::kWhen:
        conditional(effect);
        break;
    }
  }
  void conditional(const Effect& effect) {
    const Bindings::Mark mark = context_.bindings.mark();
    Proof proof(context_, effect.condition, base_);
    while (proof.next()) {
      collect(effect.parts);
      if (effect.kind == EffectKind::kWhen) break;
    }
    context_.bindings.undo(mark);
  }
  // The lists of an operator are gone through from the last to the first item.
  void put(Term atom, std::vector<Term>& list) const {
    if (in_order_) {
      list.push_back(atom);
      return;
    }
    std::erase(list, atom);
    list.insert(list.begin(), atom);
  }

  ProofContext& context_;
  std::uint32_t base_;
  bool in_order_;
};

Application application_now(ProofContext& context, const OperatorClause& clause,
                            std::uint32_t base) {
  Changes changes(context, base, clause.action);
  changes.collect(clause.effects);
  Application out;
  out.action = context.bindings.instance(clause.head, base);
  out.deletions = std::move(changes.deletions);
  out.additions = std::move(changes.additions);
  out.cost = real(1.0);
  if (clause.cost == kNoCode) return out;
  const Term cost = evaluate(context, clause.cost, base);
  if (cost.is(TermKind::kNumber)) out.cost = context.store.value(cost);
  return out;
}

/// (:protection goal), or nothing.
std::optional<Term> protected_goal(TermStore& store, Term atom) {
  if (!atom.is(TermKind::kPair) || store.car(atom) != store.symbol(":protection")) return {};
  const Term rest = store.cdr(atom);
  if (!rest.is(TermKind::kPair)) return {};
  return store.car(rest);
}

std::vector<const Goal*> conjuncts(const std::vector<Goal>& goals) {
  std::vector<const Goal*> out;
  for (const Goal& goal : goals) {
    if (goal.kind != GoalKind::kAnd) {
      out.push_back(&goal);
      continue;
    }
    for (const Goal* inner : conjuncts(goal.parts.at(0))) out.push_back(inner);
  }
  return out;
}

std::optional<std::string> change_facts(ProofContext& context, World& world,
                                        const Application& application) {
  for (const Term atom : application.deletions) {
    if (const auto goal = protected_goal(context.store, atom)) {
      world.release(*goal);
    } else {
      world.remove(atom);
    }
  }
  for (const Term atom : application.additions) {
    if (protected_goal(context.store, atom)) continue;
    if (!context.store.ground(atom)) {
      return "would add " + context.store.to_text(atom) + ", which has a variable";
    }
    world.add(atom);
  }
  for (const Term goal : world.protections()) {
    if (!provable(context, goal)) {
      return "protection violated: " + context.store.to_text(goal);
    }
  }
  for (const Term atom : application.additions) {
    const auto goal = protected_goal(context.store, atom);
    if (!goal) continue;
    if (!provable(context, *goal)) {
      return "would protect " + context.store.to_text(*goal) + ", which does not hold";
    }
    world.protect(*goal);
  }
  return {};
}

}  // namespace

std::vector<Application> applications(ProofContext& context, const OperatorClause& clause,
                                      Term action, std::size_t limit) {
  std::vector<Application> out;
  const Bindings::Mark mark = context.bindings.mark();
  const std::uint32_t base = context.bindings.fresh(clause.slots);
  if (context.bindings.unify(context.bindings.instance(clause.head, base), action)) {
    Proof proof(context, clause.precondition.goals, base);
    while (out.size() < limit && proof.next()) {
      Application found = application_now(context, clause, base);
      if (context.error) break;
      if (std::find(out.begin(), out.end(), found) == out.end()) out.push_back(std::move(found));
    }
  }
  context.bindings.undo(mark);
  return out;
}

std::string goal_text(const ProofContext& context, const Goal& goal, std::uint32_t base) {
  if (goal.kind == GoalKind::kAtom) {
    const Term known = context.bindings.instance(goal.pattern, base);
    if (context.store.ground(known)) return context.store.to_text(known);
  }
  if (!goal.where) return "a condition";
  const Node& node = *goal.where;
  return goal.where.document->text.substr(node.begin, node.end - node.begin);
}

std::string unmet_conjunct(ProofContext& context, const OperatorClause& clause, Term action) {
  const std::vector<const Goal*> all = conjuncts(clause.precondition.goals);
  const Bindings::Mark mark = context.bindings.mark();
  const std::uint32_t base = context.bindings.fresh(clause.slots);
  std::string text = "the arguments";
  if (context.bindings.unify(context.bindings.instance(clause.head, base), action)) {
    std::vector<Goal> so_far;
    for (const Goal* goal : all) {
      so_far.push_back(*goal);
      text = goal_text(context, *goal, base);
      if (!provable(context, so_far, base)) break;
    }
  }
  context.bindings.undo(mark);
  return text;
}

std::optional<std::string> apply(ProofContext& context, World& world,
                                 const Application& application) {
  const std::size_t mark = world.mark();
  std::optional<std::string> reason = change_facts(context, world, application);
  if (reason) world.undo(mark);
  return reason;
}

}  // namespace skein::htn::replay
