// SPDX-License-Identifier: Apache-2.0
// What a sale makes small.
#pragma once

#include <cstdint>

namespace skein::auction {

/// How much the work is to be spread. 0: the sum of all costs counts; 1: the end of the last
/// member; between: (1 - equity) sum + equity * end. What ties is told apart by the other of the
/// two. The end of the last, not a factor on the price: a factor does nothing to a price near zero.
/// Source: spec 6.3; [Lemaire 04].
struct Aim {
  double equity = 0;
};

/// How good a state of the books is: fewer unsold tasks first, then the aim. All trades lower it,
/// so they end.
struct Value {
  std::uint32_t unsold = 0;
  double first = 0;
  double second = 0;
};

inline Value value_of(const Aim& aim, std::uint32_t unsold, double cost, double end) {
  const double blend = (1 - aim.equity) * cost + aim.equity * end;
  return {unsold, blend, aim.equity < 0.5 ? end : cost};
}

/// Whether it gains more than rounding: what a trade must.
inline bool better(const Value& one, const Value& other) {
  constexpr double kLeast = 1e-6;
  if (one.unsold != other.unsold) return one.unsold < other.unsold;
  if (one.first < other.first - kLeast) return true;
  return one.first <= other.first + kLeast && one.second < other.second - kLeast;
}

}  // namespace skein::auction
