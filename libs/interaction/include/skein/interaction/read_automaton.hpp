// SPDX-License-Identifier: Apache-2.0
// Reads an execution automaton from its document.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skein/config/reader.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/interaction/automaton.hpp"

namespace skein::interaction {

/// The automaton with this main block. Errors of form are added to the reader's diagnostics
/// (unknown keys and names, duplicate ids, empty contents, loops without tasks, `continue` outside
/// of loops, invalid times); the result must not be used then. Behaviour is not checked here, but
/// by check_automaton(). `times`: parameters that a condition may take its seconds from.
/// Source: spec 7.8.
Automaton read_automaton(const config::Reader& main_block,
                         const std::vector<std::string>& times = {});

/// The same from a text, YAML or JSON. `file` is for messages.
Result<Automaton, Diagnostics> read_automaton(std::string_view text, const std::string& file);

}  // namespace skein::interaction
