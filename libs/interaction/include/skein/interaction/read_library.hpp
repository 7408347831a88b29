// SPDX-License-Identifier: Apache-2.0
// Roles, spatial constraint models and interaction models from their documents.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "skein/config/value.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// A parsed file. Format: docs/interaction.md.
struct Document {
  std::string file;
  config::Value value;
};

/// Files that a document names under `uses`, as written: relative to its own.
std::vector<std::string> uses_of(const Document& document);

/// What reads one file.
using ReadFile = std::function<Result<config::Value, Diagnostics>(const std::string& path)>;
/// These files and all that they use, each read once, whoever uses it; or every error of reading:
/// without one of them half of the names would be unknown.
Result<std::vector<Document>, Diagnostics> documents_of(const std::vector<std::string>& files,
                                                        const ReadFile& read);

/// Reads documents together, in any order: what one defines the others may use. Everything is
/// checked: names exist and are there once, types fit, correspondences are of one modality and
/// symmetric, arities can be satisfied, SCMs hold somewhere and are possible, and what
/// check_automaton() finds. Every error at once. Source: spec 7.1.
Result<Library, Diagnostics> read_library(const std::vector<Document>& documents);

}  // namespace skein::interaction
