// SPDX-License-Identifier: Apache-2.0
// What breaks the network of a plan, in sentences about its tasks.
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

/// When a node comes in the execution to be: soonest and latest; absent: nobody knows.
using ForeseenOf = std::function<std::optional<mission::Interval>(const temporal::NodeName& node)>;

/// Of a network that is not controllable. `foreseen` gives the figures.
std::vector<Conflict> explain(const std::vector<BrokenBound>& bounds, bool consistent,
                              const ForeseenOf& foreseen, MissionTime now);

}  // namespace skein::supervisor
