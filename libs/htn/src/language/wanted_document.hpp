// SPDX-License-Identifier: Apache-2.0
// Reads a text, skipping unwanted problems.
#pragma once

#include "skein/htn/syntax.hpp"
#include "skein/htn/wanted_problems.hpp"

namespace skein::htn {

/// Reads a document; the names of unwanted problems go to `passed_over` of `wanted`.
Document read_document(std::string file, std::string text, TermStore& store, Diagnostics& problems,
                       WantedProblems& wanted);

}  // namespace skein::htn
