// SPDX-License-Identifier: Apache-2.0
#include "safety/energy_use.hpp"

#include <algorithm>

namespace skein::supervisor {

namespace {

// Fraction of its expected use that a task has still to take. Range: [0, 1].
double energy_share(const Entry& entry, MissionTime now) {
  if (entry.over()) return 0;
  if (!entry.running) return 1;  // it may wait for its air
  const mission::Interval& d = entry.task.duration;
  const double most = d.most == Duration::max() ? d.least.to_seconds() : d.most.to_seconds();
  const double mean = (d.least.to_seconds() + most) / 2;
  if (mean <= 0) return 1;
  return std::clamp(1 - (now - *entry.running).to_seconds() / mean, 0.0, 1.0);
}

}  // namespace

double energy_to_come(const Entry& entry, const Beliefs& beliefs, const Retreat& retreat,
                      MissionTime now) {
  const double expected = entry.task.energy * energy_share(entry, now);
  const bool flies = entry.task.type == "goto" && !entry.task.way.empty();
  if (!flies || !entry.under_way()) return expected;
  return std::max(expected, retreat.flight({beliefs.vehicle().position, entry.task.way.back()}));
}

}  // namespace skein::supervisor
