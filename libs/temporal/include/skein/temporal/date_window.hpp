// SPDX-License-Identifier: Apache-2.0
// Earliest and latest date of a node.
#pragma once

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Earliest and latest date of a node [ns].
struct DateWindow {
  Ticks earliest = kMinusInfinite;
  Ticks latest = kInfinite;
  bool operator==(const DateWindow&) const = default;
};

}  // namespace skein::temporal
