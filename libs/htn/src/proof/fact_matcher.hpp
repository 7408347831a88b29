// SPDX-License-Identifier: Apache-2.0
// Matches atoms of conditions against the facts in force.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "compile/compiled_domain.hpp"
#include "proof/bindings.hpp"
#include "proof/fact_base.hpp"

namespace skein::htn {

/// Whether facts alone decide a goal: an atom of a name and arguments without axioms.
inline bool facts_alone(const Goal& goal) {
  return goal.kind == GoalKind::kAtom && goal.flat && goal.axioms == nullptr;
}

class FactMatcher {
 public:
  FactMatcher(const CompiledDomain& domain, Bindings& bindings, FactBase& facts)
      : domain_(domain), store_(domain.store), bindings_(bindings), facts_(facts) {}

  using Values = std::array<Term, kMostFlatArguments>;
  /// The values of the arguments as far as they are known: any kOpen one may be followed by others
  /// that are not looked at.
  Bindings::Known values_of(const Goal& goal, Base base, Values& values) {
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
  /// The shortest list of facts that may match.
  FactBase::Candidates candidates(const Goal& goal, const Values& values, Base base) {
    return facts_.candidates(goal.predicate, goal.positions, [&](const IndexedPosition& position) {
      const bool whole = position.path.inner == Path::kWhole;
      const Term value =
          whole ? values[position.path.outer] : bindings_.resolve(position.pattern, base);
      return store_.ground(value) ? std::optional<Term>(value) : std::nullopt;
    });
  }
  /// Whether the arguments of an atom can be those of a fact; binds variables, also when not.
  bool match(std::span<const Term> arguments, Base base, FactIndex fact) {
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
  /// Whether some fact matches, without computing the values of the variables.
  bool some_fact(const Goal& goal, Base base);
  /// Chooses the next of successive atoms that facts alone decide: the offset from the first of the
  /// one with the fewest matching facts. `done`: bits of later ones that were already tried.
  std::uint32_t pick(std::span<const GoalIndex> goals, std::uint32_t done, Base base);

 private:
  /// Upper bound on the number of matching facts.
  std::uint32_t matching(const Goal& goal, Base base);

  static constexpr std::uint32_t kFewEnough = 2;   ///< matching facts: no better goal is looked for
  static constexpr std::uint32_t kMostPicked = 8;  ///< goals among which one is picked

  const CompiledDomain& domain_;
  const TermStore& store_;
  Bindings& bindings_;
  FactBase& facts_;
};

}  // namespace skein::htn
