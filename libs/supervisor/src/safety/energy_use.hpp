// SPDX-License-Identifier: Apache-2.0
// What tasks of the plan still take of the energy.
#pragma once

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// Of a flight that takes longer than it should, at least what is left of its way. Fraction of what
/// is held when full.
double energy_to_come(const Entry& entry, const Beliefs& beliefs, const Retreat& retreat,
                      MissionTime now);

}  // namespace skein::supervisor
