// SPDX-License-Identifier: Apache-2.0
// `skein model run`: plays a trace through the execution automaton of a role.
#pragma once

#include <iosfwd>
#include <map>
#include <optional>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein::model_tool {

struct RunOptions {
  std::string automaton;              ///< file, YAML or JSON (spec 7.8), or a library with roles
  std::string role;                   ///< --role NAME: of a library with several
  std::map<std::string, double> set;  ///< --set NAME=S: parameters that conditions on time name [s]
  std::optional<MissionTime> until;   ///< --until S: play on to S after the last line
  std::string input_name;             ///< for messages; empty: standard input
};

/// Reads inputs as JSON lines from `in`, answers each at once with lines of effects on `out`
/// (formats: docs/interaction.md), and repeats errors of lines on `err`. 0: done; 1: some line was
/// refused (the others were played); 2: the automaton cannot be used.
int run_model(const RunOptions& options, std::istream& in, std::ostream& out, std::ostream& err);

}  // namespace skein::model_tool
