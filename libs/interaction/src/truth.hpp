// SPDX-License-Identifier: Apache-2.0
// Three-valued truth of literals, clauses and formulas. Source: T III.1.3, spec 2.2, 7.8.
#pragma once

#include <cstdint>

#include "skein/interaction/condition.hpp"

namespace skein::interaction {

enum class Truth : std::uint8_t {
  kFalse,
  kTrue,
  kImpossible,  ///< false, and nothing can make it true any more
};

/// The truth of a literal whose condition `holds`, or not, at present; `for_ever`: that is final.
constexpr Truth truth_of(const Literal& literal, bool holds, bool for_ever) {
  if (holds != literal.negated) return Truth::kTrue;
  if (!for_ever) return Truth::kFalse;
  return literal.modality == Modality::kOptional ? Truth::kTrue : Truth::kImpossible;
}

/// The truth of a clause, or of a formula; `value` gives the truth of a literal.
template <class Value>
Truth truth_of(const Clause& clause, const Value& value) {
  Truth all = Truth::kImpossible;
  for (const Literal& literal : clause) {
    const Truth one = value(literal);
    if (one == Truth::kTrue) return Truth::kTrue;
    if (one == Truth::kFalse) all = Truth::kFalse;
  }
  return all;
}

template <class Value>
Truth truth_of(const Formula& formula, const Value& value) {
  Truth all = Truth::kTrue;
  for (const Clause& clause : formula) {
    const Truth one = truth_of(clause, value);
    if (one == Truth::kImpossible) return Truth::kImpossible;
    if (one == Truth::kFalse) all = Truth::kFalse;
  }
  return all;
}

}  // namespace skein::interaction
