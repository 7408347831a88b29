// SPDX-License-Identifier: Apache-2.0
// An execution automaton from its document.
#pragma once

#include <string>
#include <string_view>

#include "skein/config/reader.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/interaction/automaton.hpp"

namespace skein::interaction {

/// The automaton whose main block this is; what is wrong with its form is added to the reader's
/// diagnostics (unknown keys and names, ids that are there twice, empty contents, loops without
/// anything to do, `continue` outside of loops, times that are none) and then the result must not
/// be used. What it would do is not looked at: check_role() does. Source: spec 7.8.
Automaton read_automaton(const config::Reader& main_block);

/// The same from a text, YAML or JSON. `file` is for messages.
Result<Automaton, Diagnostics> read_automaton(std::string_view text, const std::string& file);

}  // namespace skein::interaction
