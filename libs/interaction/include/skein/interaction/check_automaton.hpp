// SPDX-License-Identifier: Apache-2.0
// What an automaton can never do, found before it is run.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/interaction/automaton.hpp"

namespace skein::interaction {

/// Reports blocks that can never be activated, conditions that can never hold, and loops without a
/// way out: no exit of their own, nor of a block around them, nor the end of an immediate block
/// beside them (the main block's exit on messages alone is an interruption, no way out). What is
/// reported is certain: whatever tasks, negotiations, messages and time do, it cannot be.
/// Cost: O(componels × conditions) for each round of what makes what possible. Source: spec 7.1.
void check_automaton(const Automaton& automaton, const std::string& file, Diagnostics& problems);

}  // namespace skein::interaction
