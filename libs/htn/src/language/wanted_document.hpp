// SPDX-License-Identifier: Apache-2.0
// Reads a text of which not all problems are wanted.
#pragma once

#include "skein/htn/syntax.hpp"
#include "skein/htn/wanted_problems.hpp"

namespace skein::htn {

/// As without `wanted`; problems that are not go to its `passed_over`.
Document read_document(std::string file, std::string text, TermStore& store, Diagnostics& problems,
                       WantedProblems& wanted);

}  // namespace skein::htn
