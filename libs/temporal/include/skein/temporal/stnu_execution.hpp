// SPDX-License-Identifier: Apache-2.0
// Plays an execution of a network with uncertainty: a dispatcher against given durations.
#pragma once

#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/temporal/dispatcher.hpp"

namespace skein::temporal {

/// When to execute a node that may be executed: all keep the promise of the dispatcher.
enum class StartPolicy : std::uint8_t { kEarliest, kLatest, kRandom };

struct ExecutionEvent {
  NodeIndex node = 0;
  MissionTime at;
  bool observed = false;  ///< a contingent end; otherwise executed by choice
  bool operator==(const ExecutionEvent&) const = default;
};

struct Execution {
  std::vector<ExecutionEvent> events;  ///< in order; the origin is first, at 0
  std::vector<Contingency> contingencies;
  std::vector<LinkRef>
      violated;  ///< requirements that the dates break, of those both of whose nodes have one
  bool complete = false;  ///< every node has a date
  bool operator==(const Execution&) const = default;
};

/// Durations of all contingent links: each at min, at max, or uniform between, a third of the time.
std::vector<Ticks> draw_durations(const Stnu& network, Random& random);

/// Precondition: one duration for each contingent link of the plan. They need not be within bounds.
Execution execute(const DispatchableNetwork& network, const std::vector<Ticks>& durations,
                  StartPolicy policy, Random& random);

/// The requirements (arcs, and contingent links as given) that complete dates break; `dates` has
/// one for each node.
std::vector<LinkRef> find_violations(const Stnu& network,
                                     const std::vector<std::optional<Ticks>>& dates);

}  // namespace skein::temporal
