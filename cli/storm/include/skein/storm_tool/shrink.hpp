// SPDX-License-Identifier: Apache-2.0
// Minimisation of a failing input (delta debugging).
#pragma once

#include <cstddef>
#include <utility>

namespace skein::storm_tool {

/// Leaves out what can be left out, one part at a time, as long as it still `fails`, until no part
/// can be. `smaller` gives the thing with one part less, in every way there is, always in the same
/// order. Cost: a trial for each part of what is left, and one more round for each that changed it.
template <class Thing, class Smaller, class Fails>
Thing shrunk(Thing thing, const Smaller& smaller, const Fails& fails) {
  for (bool changed = true; changed;) {
    changed = false;
    auto candidates = smaller(thing);
    for (std::size_t i = 0; i < candidates.size();) {
      if (!fails(candidates[i])) {
        ++i;
        continue;
      }
      thing = std::move(candidates[i]);
      candidates = smaller(thing);  // what was tried before stays tried in this round
      changed = true;
    }
  }
  return thing;
}

}  // namespace skein::storm_tool
