// SPDX-License-Identifier: Apache-2.0
// Integers of 128 bits, for results before they are known to fit.
#pragma once

#include <cstdint>
#include <limits>

namespace skein::htn {

__extension__ using WideInteger = __int128;

inline bool fits_64_bits(WideInteger value) {
  return value >= std::numeric_limits<std::int64_t>::min() &&
         value <= std::numeric_limits<std::int64_t>::max();
}

}  // namespace skein::htn
