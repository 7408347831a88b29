// SPDX-License-Identifier: Apache-2.0
// The narrowest link of a scenario's radio.
#pragma once

#include <algorithm>
#include <optional>

#include "skein/scenario/scenario.hpp"

namespace skein::scenario {

/// The least capacity that a link has at some time [bit/s]; none: all are unlimited.
inline std::optional<double> narrowest(const RadioSpec& radio) {
  std::optional<double> least;
  const auto note = [&](double capacity) {
    if (capacity > 0) least = std::min(least.value_or(capacity), capacity);
  };
  note(radio.model.capacity);
  for (const LinkSpec& link : radio.links) note(link.capacity.value_or(0));
  return least;
}

}  // namespace skein::scenario
