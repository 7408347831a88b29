// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "skein/foundation/time.hpp"
#include "skein/scenario/narrowest.hpp"

namespace skein::laws {

/// Time on the narrowest link of an event, and as much again of what shares it; 0: all are
/// unlimited.
inline Duration airtime_of_an_event(const scenario::RadioSpec& radio) {
  constexpr double kEvent = 8.0 * 2 * 300;  // [bit] with its frame
  const auto least = scenario::narrowest(radio);
  return least ? Duration::seconds(kEvent / *least) : Duration();
}

}  // namespace skein::laws
