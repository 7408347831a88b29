// SPDX-License-Identifier: Apache-2.0
// The network of a plan, with what each of its links is about.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "skein/supervisor/schedule.hpp"
#include "skein/temporal/stnu_fault.hpp"

namespace skein::supervisor {

enum class BoundKind : std::uint8_t {
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
struct Cause {
  executive::TaskId task;
  BoundKind kind = BoundKind::kNow;
  executive::TaskId other;
  MissionTime instant;  ///< of kNow, kFact and time constraints
};

struct TaskNodes {
  temporal::NodeIndex start = 0, end = 0;
};

/// Arcs have either a lower bound, with or without an upper one between the same nodes, or an upper
/// one alone.
struct PlanNetwork {
  temporal::Stnu stnu;
  std::vector<Cause> arcs, contingent;  ///< of each link
  std::map<executive::TaskId, TaskNodes> nodes;
  /// Ends that no figure bounds from above: open-ended, or under way for longer than foreseen.
  std::vector<temporal::NodeIndex> endless;

  const Cause& cause_of(temporal::LinkRef link) const;
};

PlanNetwork build_network(const std::vector<mission::ElementaryTask>& tasks,
                          const Observations& seen, MissionTime now);

}  // namespace skein::supervisor
