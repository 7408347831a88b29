// SPDX-License-Identifier: Apache-2.0
// Files and all that they use, read together.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/interaction/model.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::model_tool {

/// A library, or a single automaton with its file.
struct Loaded {
  interaction::Library library;
  std::vector<interaction::Automaton> automata;  ///< of files that are one block
  std::vector<std::string> automaton_files;
};

/// Every error of all files at once. A file is read once, whoever uses it.
Result<Loaded, Diagnostics> load_models(const std::vector<std::string>& files);
/// Likewise, of what `read` says that the files are.
Result<Loaded, Diagnostics> load_models(const std::vector<std::string>& files,
                                        const interaction::ReadFile& read);

}  // namespace skein::model_tool
