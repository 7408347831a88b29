// SPDX-License-Identifier: Apache-2.0
// Reads roles, spatial constraint models and interaction models from their documents.
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

/// The files that a document names under `uses`, as written: relative to the document.
std::vector<std::string> uses_of(const Document& document);

/// Reads one file.
using ReadFile = std::function<Result<config::Value, Diagnostics>(const std::string& path)>;
/// These files and, transitively, the files that they use, each read once; or every error of
/// reading.
Result<std::vector<Document>, Diagnostics> documents_of(const std::vector<std::string>& files,
                                                        const ReadFile& read);

/// The library of all documents, in any order; each may use definitions of the others. Checks that
/// names exist and are unique, types fit, correspondences are symmetric and of one modality,
/// arities can be satisfied, SCMs are used and satisfiable, and runs check_automaton(). Returns
/// every error at once. Source: spec 7.1.
Result<Library, Diagnostics> read_library(const std::vector<Document>& documents);

}  // namespace skein::interaction
