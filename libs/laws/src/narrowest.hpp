// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

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

}  // namespace skein::laws
