// SPDX-License-Identifier: Apache-2.0
// What every service answers: a refined task with what it costs, or why there is none.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::refiners {

/// Why a query has no solution.
enum class RefusalKind : std::uint8_t {
  kBadQuery,        ///< a figure of the query makes no sense (NaN, negative speed, crossed polygon)
  kBlocked,         ///< a place asked for is in the ground, in a volume or outside the airspace
  kUnreachable,     ///< every way is closed
  kBeyondVehicle,   ///< the vehicle cannot: too high, too steep, no such sensor, too little energy
  kNoContact,       ///< radio contact cannot be kept, or made
  kNotPerceivable,  ///< nothing there can be seen with that sensor
  kBudgetExhausted,  ///< nothing found before the budget was used up: there may be a solution
};
/// "bad-query", "blocked", …: the names used in results.
std::string_view to_text(RefusalKind kind);

/// Facts of a refusal.
struct Refusal {
  RefusalKind kind = RefusalKind::kBadQuery;
  std::string field;  ///< of the query, as in its files: "to", "members.2.speed"; may be empty
  std::string why;    ///< a sentence for people, with the figures
  bool operator==(const Refusal&) const = default;
};

inline tl::unexpected<Refusal> refuse(RefusalKind kind, std::string field, std::string why) {
  return tl::unexpected<Refusal>(Refusal{kind, std::move(field), std::move(why)});
}

/// Bounds of what it will take, and what is most likely. How flights give them: flight.hpp.
struct DurationInterval {
  Duration least, expected, most;
  bool operator==(const DurationInterval&) const = default;
};

/// What the search did.
struct Effort {
  std::uint64_t steps = 0;  ///< in the unit of the service
  bool cut_short = false;   ///< by the clock: with more time it might be better
  bool operator==(const Effort&) const = default;
};

/// A feasible answer. `cost` is in the unit that the service names: less is better.
template <class Task>
struct Refined {
  Task task;
  double cost = 0;
  DurationInterval duration;
  Effort effort;
};

template <class Task>
using Outcome = Result<Refined<Task>, Refusal>;

}  // namespace skein::refiners
