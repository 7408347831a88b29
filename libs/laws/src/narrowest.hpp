// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "skein/foundation/time.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::laws {

/// The least capacity that a link has at some time [bit/s]; none: all are unlimited.
inline std::optional<double> narrowest(const scenario::RadioSpec& radio) {
  std::optional<double> least;
  const auto note = [&](double capacity) {
    if (capacity > 0) least = std::min(least.value_or(capacity), capacity);
  };
  note(radio.model.capacity);
  for (const scenario::LinkSpec& link : radio.links) note(link.capacity.value_or(0));
  return least;
}

/// Time on the narrowest link of an event, and as much again of what shares it; 0: all are
/// unlimited.
inline Duration airtime_of_an_event(const scenario::RadioSpec& radio) {
  constexpr double kEvent = 8.0 * 2 * 300;  // [bit] with its frame
  const auto least = narrowest(radio);
  return least ? Duration::seconds(kEvent / *least) : Duration();
}

}  // namespace skein::laws
