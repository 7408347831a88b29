// SPDX-License-Identifier: Apache-2.0
// Energy that tasks of the plan still need.
#pragma once

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// Expected energy from `now` to the end of the task, as a fraction of the full capacity; for a
/// flight that is late, at least that of the rest of its way.
double energy_to_come(const Entry& entry, const Beliefs& beliefs, const Retreat& retreat,
                      MissionTime now);

}  // namespace skein::supervisor
