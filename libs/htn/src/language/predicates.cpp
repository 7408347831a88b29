// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/predicates.hpp"

#include "language/condition_checker.hpp"
#include "language/effect_checker.hpp"

namespace skein::htn {

Predicates predicates_of(Definitions& definitions, const DomainDefinition& domain,
                         const ProblemDefinition& problem, TermStore& store) {
  Diagnostics ignored;  // all of it was read before
  const Words words(store);
  const IncludeReader none;
  const ReadContext context{store, words, none, definitions, ignored, ignored};
  ConditionChecker conditions(context);
  EffectChecker effects(context);
  check_conditions_and_effects(domain, conditions, effects);
  Predicates out;
  const auto take = [&](Expression atom) {
    if (context.head(atom) != kNil) {
      out.arities[context.name(context.head(atom))].insert(count(atom) - 1);
    }
  };
  for (const AxiomDefinition& made : domain.axioms) take(made.head);
  for (const Expression atom : conditions.atoms()) take(atom);
  for (const Expression atom : effects.condition_atoms()) take(atom);
  for (const Expression atom : effects.atoms()) take(atom);
  for (Expression fact = first(problem.facts); fact; fact = next(fact)) take(fact);
  out.any = effects.anything() || domain.pddl;
  return out;
}

}  // namespace skein::htn
