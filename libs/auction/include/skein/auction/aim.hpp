// SPDX-License-Identifier: Apache-2.0
// The objective that a sale minimises.
#pragma once

#include <cstdint>

namespace skein::auction {

/// How much the work is to be spread over the members. 0: minimise the sum of all costs; 1: the
/// time at which the last member ends (makespan); between: (1 - equity) * sum + equity * makespan.
/// Ties are broken by the other of the two. The makespan is used rather than a factor on each bid,
/// since a factor has no effect on a bid near zero. Source: spec 6.3; [Lemaire 04].
struct Aim {
  double equity = 0;
};

/// The value of an allocation, compared lexicographically: fewer unsold tasks first, then the aim,
/// then earlier ends: where a member comes home, a route and its reverse have equal aims.
/// Every trade lowers it, so trading terminates.
struct Value {
  std::uint32_t unsold = 0;
  double first = 0;
  double second = 0;
  double ends = 0;  ///< sum of the ends of all tasks [s]; 0 in the value of a placing
};

inline Value value_of(const Aim& aim, std::uint32_t unsold, double cost, double end) {
  const double blend = (1 - aim.equity) * cost + aim.equity * end;
  return {unsold, blend, aim.equity < 0.5 ? end : cost, 0};
}

/// Whether `one` is better than `other` by more than rounding errors: required of every trade.
inline bool better(const Value& one, const Value& other) {
  constexpr double kLeast = 1e-6;
  if (one.unsold != other.unsold) return one.unsold < other.unsold;
  for (const auto part : {&Value::first, &Value::second, &Value::ends}) {
    if (one.*part < other.*part - kLeast) return true;
    if (one.*part > other.*part + kLeast) return false;
  }
  return false;
}

}  // namespace skein::auction
