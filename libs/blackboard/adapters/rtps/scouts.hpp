// SPDX-License-Identifier: Apache-2.0
// Readers of nothing, which a discovery server needs to tell of writers.
#pragma once

#include <optional>
#include <vector>

#include "adapters/rtps/link.hpp"

namespace skein::blackboard::rtps {

/// A server tells a participant of the writers of those topics only that it has an endpoint of.
/// Readers that wait for a writer would wait for ever; so one reader a slot does not wait, in a
/// partition where nobody writes. None where no server introduces, or no reader waits.
std::optional<LinkPlan> scouts_of(const std::vector<LinkPlan>& links, const DdsConfig& config);

}  // namespace skein::blackboard::rtps
