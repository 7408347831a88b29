// SPDX-License-Identifier: Apache-2.0
#include "proof/fact_matcher.hpp"

namespace skein::htn {

bool FactMatcher::some_fact(const Goal& goal, Base base) {
  if (!facts_.any(goal.predicate)) return false;
  Values values;
  const Bindings::Known known = values_of(goal, base, values);
  if (known == Bindings::Known::kNever) return false;
  const std::span<const Term> arguments = std::span(values).first(goal.arguments.size());
  if (known == Bindings::Known::kTerm) return facts_.find(goal.predicate, arguments) != kNoFact;
  const Bindings::Mark mark = bindings_.mark();
  for (FactBase::Cursor cursor = candidates(goal, values, base).first; cursor.fact != kNoFact;
       cursor = facts_.next(cursor)) {
    const bool matches = match(arguments, base, cursor.fact);
    bindings_.undo(mark);
    if (matches) return true;
  }
  return false;
}

std::uint32_t FactMatcher::matching(const Goal& goal, Base base) {
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

std::uint32_t FactMatcher::pick(std::span<const GoalIndex> goals, std::uint32_t done, Base base) {
  if (goals.size() < 2 || !facts_alone(domain_.goals[goals[0]]) ||
      !facts_alone(domain_.goals[goals[1]]))
    return 0;
  std::uint32_t best = 0;
  std::uint32_t fewest = matching(domain_.goals[goals[0]], base);
  const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(goals.size(), kMostPicked));
  for (std::uint32_t ahead = 1; ahead < last && fewest > kFewEnough; ++ahead) {
    if (!facts_alone(domain_.goals[goals[ahead]])) break;
    if ((done >> (ahead - 1) & 1U) != 0) continue;
    const std::uint32_t count = matching(domain_.goals[goals[ahead]], base);
    if (count >= fewest) continue;
    best = ahead;
    fewest = count;
  }
  return best;
}

}  // namespace skein::htn
