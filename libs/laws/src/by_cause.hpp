// SPDX-License-Identifier: Apache-2.0
// The order of an event log whose nodes wrote by clocks of their own.
#pragma once

#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/journal/record.hpp"

namespace skein::laws {

/// Messages and words of synchronisations that are received before they were sent, by no more than
/// `skew`, come right after their sending, at its time; all else stays. A node that restarts numbers
/// its messages anew: what it sent before does not count then. Cost: n log n.
std::vector<journal::Record> by_cause(const std::vector<journal::Record>& records, Duration skew);

}  // namespace skein::laws
