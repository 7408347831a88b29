// SPDX-License-Identifier: Apache-2.0
// Description of a program's command line, from its CLI11 definitions.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace skein::manual {

struct Option {
  std::vector<std::string> names;    ///< "--count", "-n"; of a positional one: its name alone
  std::string value;                 ///< what stands for its value: "TEXT"; empty: a flag
  std::vector<std::string> choices;  ///< all values there are; empty: any
  std::string usual;                 ///< its default; empty: none is said
  std::string help;
  bool positional = false;
  bool required = false;
};

struct Command {
  std::string name;
  std::string path;  ///< with those above it: "skein spy echo"
  std::string help;
  std::string footer;  ///< examples, exit codes; preformatted
  std::vector<Option> options;
  std::vector<Command> commands;
};

/// The description of a program with all its commands; hidden ones (without group) are left out.
Command command_of(const CLI::App& app);

}  // namespace skein::manual
