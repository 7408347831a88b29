// SPDX-License-Identifier: Apache-2.0
// Reading of selected problems from files with many.
#pragma once

#include <string>
#include <vector>

#include "skein/htn/definitions.hpp"

namespace skein::htn {

struct WantedProblems {
  std::vector<std::string> names;        ///< none: all problems are wanted
  std::vector<std::string> passed_over;  ///< names of the other problems, in the order of the texts
};

/// Diagnostics of reading; if `warnings` is null, checks that only give warnings are skipped.
struct Findings {
  Diagnostics& errors;
  Diagnostics* warnings = nullptr;
};

/// Like read_definitions without `wanted`, but reads only the top-level forms (defproblem NAME …)
/// with a wanted name (ignoring case). The others are skipped by matching parentheses, unchecked;
/// if parentheses do not match, everything is read.
void read_definitions(SourceFile file, TermStore& store, const IncludeReader& include,
                      Definitions& definitions, Findings findings, WantedProblems& wanted);

}  // namespace skein::htn
