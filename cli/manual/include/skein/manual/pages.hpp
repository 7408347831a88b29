// SPDX-License-Identifier: Apache-2.0
// Manual pages and shell completion of a program.
#pragma once

#include <string>
#include <vector>

#include "skein/manual/command.hpp"

namespace skein::manual {

struct Page {
  std::string file;  ///< "skein-run.1"
  std::string text;  ///< in the macros of man(7)
};

/// One of the program, and one of each of its commands with those below it. `section`: 1 of
/// commands, 8 of daemons.
std::vector<Page> man_pages(const Command& program, const std::string& version, int section = 1);

/// Scripts that complete commands, options and those values of which all are known; other values
/// as names of files.
std::string bash_completion(const Command& program);
std::string zsh_completion(const Command& program);
std::string fish_completion(const Command& program);

/// By its name: "bash", "zsh", "fish"; nothing of another.
std::string completion(const Command& program, const std::string& shell);

}  // namespace skein::manual
