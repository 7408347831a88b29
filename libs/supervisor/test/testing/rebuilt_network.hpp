// SPDX-License-Identifier: Apache-2.0
// The network of a plan, built from scratch by rules written once more: the oracle of PlanNetwork.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "skein/supervisor/schedule.hpp"
#include "skein/temporal/stnu_fault.hpp"

namespace skein::supervisor {

enum class RuleKind : std::uint8_t {
  kNow,         ///< the present: neither started before, nor over
  kFact,        ///< a date that was seen
  kDuration,    ///< how long the task may take
  kOrder,       ///< it does not end before it starts
  kAfterEnd,    ///< it waits for the end of `other`
  kAfterStart,  ///< it waits for the start of `other`
  kWithin,      ///< it starts before the end of `other`
  kBeforeStop,  ///< it starts before what stops it, of `other`
  kStop,        ///< it ends with what stops it, of `other`
  kStartAfter,  ///< time constraints
  kStartBefore,
  kEndAfter,
  kEndBefore,
};

/// What a link is about.
struct Rule {
  executive::TaskId task;
  RuleKind kind = RuleKind::kNow;
  executive::TaskId other;
  MissionTime instant;  ///< of kNow, kFact and time constraints
};

struct TaskNodes {
  temporal::NodeIndex start = 0, end = 0;
};

/// Arcs have either a lower bound, with or without an upper one between the same nodes, or an upper
/// one alone.
struct RebuiltNetwork {
  temporal::Stnu stnu;
  std::vector<Rule> arcs, contingent;  ///< of each link
  std::map<executive::TaskId, TaskNodes> nodes;
  /// Ends that no figure bounds from above: open-ended, or under way for longer than foreseen.
  std::vector<temporal::NodeIndex> endless;
};

RebuiltNetwork build_network(const std::vector<mission::ElementaryTask>& tasks,
                             const Observations& seen, MissionTime now);

/// Node 0 is mission time zero; each task has a start and an end node ("103 start", "103 end").
temporal::Stnu network_of(const std::vector<mission::ElementaryTask>& tasks,
                          const Observations& seen, MissionTime now);

}  // namespace skein::supervisor
