// SPDX-License-Identifier: Apache-2.0
// Decimal seconds in files to and from integer nanoseconds, without a detour through doubles.
#pragma once

#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

enum class BadSeconds {
  kNotANumber,  ///< not [+-]digits[.digits][e[+-]digits]; also nan, inf
  kOverflow,    ///< beyond ±kLargest
  kTooFine,     ///< not a whole number of nanoseconds
};

/// What to do with digits below the nanosecond: our formats refuse them, in those of others the
/// nearest nanosecond is taken (halves away from zero).
enum class BelowNanosecond { kRefuse, kRound };

/// Exact for any decimal text. Cost: linear in its length, whatever its exponent.
Result<Ticks, BadSeconds> seconds_from(std::string_view decimal, BelowNanosecond below);

/// Shortest plain decimal, exact. `ticks` is finite.
std::string seconds_text(Ticks ticks);

}  // namespace skein::temporal
