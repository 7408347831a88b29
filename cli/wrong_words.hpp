// SPDX-License-Identifier: Apache-2.0
// What a command line that was refused may have meant.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace skein::cli {

/// The first word that is no command where one is expected, or no option of its command, with the
/// nearest that is one, in a sentence; empty: there is none. `words`: without the program's name.
std::string wrong_word(const CLI::App& app, std::span<const char* const> words);

}  // namespace skein::cli
