// SPDX-License-Identifier: Apache-2.0
// Static check of an automaton: what it can never do.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/interaction/automaton.hpp"

namespace skein::interaction {

/// Reports blocks that can never be activated, conditions that can never be true, and loops that
/// nothing ends: neither their own exit, nor the exit of a block around them, nor the end of an
/// immediate block beside them (the main block's exit on messages alone counts as an interruption).
/// There are no false reports: no behaviour of tasks, negotiations, messages and time makes the
/// reported thing possible. Cost: O(componels × conditions) per iteration of the fixed point.
/// Source: spec 7.1.
void check_automaton(const Automaton& automaton, const std::string& file, Diagnostics& problems);

}  // namespace skein::interaction
