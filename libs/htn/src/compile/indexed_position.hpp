// SPDX-License-Identifier: Apache-2.0
// Positions of goals by which facts may be looked up.
#pragma once

#include <cstdint>

#include "skein/htn/term.hpp"

namespace skein::htn {

/// Where an index looks into a fact: argument `outer`, or item `inner` of it when it is a list.
struct Path {
  static constexpr std::uint8_t kWhole = 0xFF;
  std::uint8_t outer = 0;
  std::uint8_t inner = kWhole;
  bool operator==(const Path&) const = default;
};

/// A position of a goal whose value may be known when the goal comes up.
struct IndexedPosition {
  Path path;
  Term pattern;  ///< a slot or a constant
};

}  // namespace skein::htn
