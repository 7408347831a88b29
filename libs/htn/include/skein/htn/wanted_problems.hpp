// SPDX-License-Identifier: Apache-2.0
// Of files with many problems, the wanted ones.
#pragma once

#include <string>
#include <vector>

#include "skein/htn/definitions.hpp"

namespace skein::htn {

struct WantedProblems {
  std::vector<std::string> names;        ///< none: all problems are wanted
  std::vector<std::string> passed_over;  ///< of those that were not, in the order of the texts
};

/// What is found while reading; where `warnings` is null, what is merely suspicious is not looked
/// for.
struct Findings {
  Diagnostics& errors;
  Diagnostics* warnings = nullptr;
};

/// As read_definitions without it, but of the top-level forms (defproblem NAME …) only those with a
/// wanted name are read, whatever its case. The others are passed over by their parentheses, and
/// nothing in them is looked at; where parentheses do not match, all is read.
void read_definitions(SourceFile file, TermStore& store, const IncludeReader& include,
                      Definitions& definitions, Findings findings, WantedProblems& wanted);

}  // namespace skein::htn
