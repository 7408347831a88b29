// SPDX-License-Identifier: Apache-2.0
// The three values of a literal, and what facts make of a condition.
#pragma once

#include <cstdint>

#include "skein/executive/condition.hpp"

namespace skein::executive {

/// Of a literal, and so of a clause and of a formula. Source: spec 2.2.
enum class Truth : std::uint8_t {
  kFalse,  ///< for now
  kTrue,
  kNever,  ///< false for ever
};

/// How a condition stands, whatever literal it is in.
enum class Standing : std::uint8_t {
  kHolds,         ///< may cease to
  kHoldsForEver,  ///< settled
  kNotNow,        ///< may come to hold
  kNeverAgain,    ///< settled
};

/// CE(T', wanted) while T' is in state `current`. While T' is aborting nothing is settled about
/// `ended`, so that a successor never starts while its predecessor still moves.
Standing standing_of_task(TaskState current, TaskState wanted);

constexpr Standing standing_of_message(bool received) {
  return received ? Standing::kHoldsForEver : Standing::kNotNow;
}

/// CT(l, passed) or, with `wants_passed` false, CT(l, not-yet-passed).
constexpr Standing standing_of_time(bool has_passed, bool wants_passed) {
  if (wants_passed) return has_passed ? Standing::kHoldsForEver : Standing::kNotNow;
  return has_passed ? Standing::kNeverAgain : Standing::kHolds;
}

/// The modality is the literal's: it says what becomes of a literal, negated or not, that can no
/// longer be satisfied.
constexpr Truth truth_of(Standing standing, bool negated, Modality modality) {
  const bool holds = standing == Standing::kHolds || standing == Standing::kHoldsForEver;
  const bool settled = standing == Standing::kHoldsForEver || standing == Standing::kNeverAgain;
  if (holds != negated) return Truth::kTrue;
  if (!settled) return Truth::kFalse;
  return modality == Modality::kOptional ? Truth::kTrue : Truth::kNever;
}

}  // namespace skein::executive
