// SPDX-License-Identifier: Apache-2.0
// Explains why the network of a plan is inconsistent or not controllable.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "schedule/plan_links.hpp"
#include "skein/temporal/stnu_controllability.hpp"

namespace skein::supervisor {

/// One bound of the conflict.
struct BrokenBound {
  const PlanLink* link = nullptr;
  temporal::LinkBound bound = temporal::LinkBound::kMin;
};

/// The forecast dates of a node, soonest and latest; absent: unknown.
using ForeseenOf = std::function<std::optional<mission::Interval>(const temporal::NodeName& node)>;

/// The conflicts that `bounds`, which cannot be kept together, mean for tasks; with figures from
/// `foreseen`.
std::vector<Conflict> explain(const std::vector<BrokenBound>& bounds, bool consistent,
                              const ForeseenOf& foreseen, MissionTime now);

}  // namespace skein::supervisor
