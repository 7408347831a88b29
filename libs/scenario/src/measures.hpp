// SPDX-License-Identifier: Apache-2.0
// Figures of a whole run, computed from its event log.
#pragma once

#include "skein/foundation/result.hpp"
#include "skein/scenario/expectation.hpp"

namespace skein::scenario {

/// The figure, or why it cannot be computed. `uavs` empty: all that have telemetry.
tl::expected<double, std::string> measure(ExpectMeasure::Quantity quantity,
                                          const std::vector<std::string>& uavs,
                                          const std::vector<journal::Record>& records);

}  // namespace skein::scenario
