// SPDX-License-Identifier: Apache-2.0
// The truth values of literals, and the standing of conditions given the facts.
#pragma once

#include <cstdint>

#include "skein/executive/condition.hpp"

namespace skein::executive {

/// The value of a literal, a clause or a formula. Source: spec 2.2.
enum class Truth : std::uint8_t {
  kFalse,  ///< for now
  kTrue,
  kNever,  ///< false for ever
};

/// The standing of a condition, independent of the negation and modality of its literal.
enum class Standing : std::uint8_t {
  kHolds,         ///< true, may become false
  kHoldsForEver,  ///< true for ever
  kNotNow,        ///< false, may become true
  kNeverAgain,    ///< false for ever
};

/// The standing of CE(T', wanted) while T' is in state `current`. While T' is aborting, `ended` is
/// not yet false for ever, so that a successor never starts while its predecessor still moves.
Standing standing_of_task(TaskState current, TaskState wanted);

constexpr Standing standing_of_message(bool received) {
  return received ? Standing::kHoldsForEver : Standing::kNotNow;
}

/// The standing of CT(l, passed) or, with `wants_passed` false, of CT(l, not-yet-passed).
constexpr Standing standing_of_time(bool has_passed, bool wants_passed) {
  if (wants_passed) return has_passed ? Standing::kHoldsForEver : Standing::kNotNow;
  return has_passed ? Standing::kNeverAgain : Standing::kHolds;
}

/// The value of a literal. The modality applies to the literal as a whole, after negation.
constexpr Truth truth_of(Standing standing, bool negated, Modality modality) {
  const bool holds = standing == Standing::kHolds || standing == Standing::kHoldsForEver;
  const bool settled = standing == Standing::kHoldsForEver || standing == Standing::kNeverAgain;
  if (holds != negated) return Truth::kTrue;
  if (!settled) return Truth::kFalse;
  return modality == Modality::kOptional ? Truth::kTrue : Truth::kNever;
}

}  // namespace skein::executive
