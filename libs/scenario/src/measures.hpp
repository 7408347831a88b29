// SPDX-License-Identifier: Apache-2.0
// Figures of a whole run, computed from its event log.
#pragma once

#include "skein/foundation/result.hpp"
#include "skein/scenario/expectation.hpp"

namespace skein::scenario {

/// A figure, and what a person needs to understand it: " m (marvin and heliv at 617 s)".
struct Measured {
  double value = 0;
  std::string context;  ///< unit, who and when; follows the number
};

/// The figure, or why it cannot be computed. Without UAVs: all that have telemetry.
tl::expected<Measured, std::string> measure(const ExpectMeasure& wanted,
                                            const std::vector<journal::Record>& records);

}  // namespace skein::scenario
