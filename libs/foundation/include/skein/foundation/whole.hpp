// SPDX-License-Identifier: Apache-2.0
// Numbers of others as whole ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "skein/foundation/contract.hpp"

namespace skein {

/// Without its fraction; out of range saturates; NaN is a broken contract.
inline std::int64_t whole(double number) {
  SKEIN_EXPECTS(!std::isnan(number));
  constexpr double kBeyond = 0x1p63;
  if (number >= kBeyond) return std::numeric_limits<std::int64_t>::max();
  if (number < -kBeyond) return std::numeric_limits<std::int64_t>::min();
  return static_cast<std::int64_t>(number);
}

}  // namespace skein
