// SPDX-License-Identifier: Apache-2.0
// The result type of all services: a refined task with its cost, or a refusal with the reason.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::refiners {

/// Why a query has no solution.
enum class RefusalKind : std::uint8_t {
  kBadQuery,        ///< invalid query (NaN, negative speed, self-intersecting polygon)
  kBlocked,         ///< a place of the query is in the ground, in a volume or outside the airspace
  kUnreachable,     ///< no free path exists
  kBeyondVehicle,   ///< exceeds the vehicle: too high, too steep, no such sensor, too little energy
  kNoContact,       ///< radio contact cannot be kept, or established
  kNotPerceivable,  ///< the target cannot be perceived with that sensor
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

/// Bounds and expected value of a duration. Definition for flights: flight.hpp.
struct DurationInterval {
  Duration least, expected, most;
  bool operator==(const DurationInterval&) const = default;
};

/// Effort of a search.
struct Effort {
  std::uint64_t steps = 0;  ///< in the unit of the service
  bool cut_short = false;   ///< ended by the clock: more time might give a better result
  bool operator==(const Effort&) const = default;
};

/// A feasible result. `cost` is in the unit that the service documents; less is better.
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
