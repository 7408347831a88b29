// SPDX-License-Identifier: Apache-2.0
// Reads model files together with all files that they use.
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

/// All errors of all files at once. Each file is read once, even if several use it.
Result<Loaded, Diagnostics> load_models(const std::vector<std::string>& files);
/// The same with the files' texts given by `read`.
Result<Loaded, Diagnostics> load_models(const std::vector<std::string>& files,
                                        const interaction::ReadFile& read);

}  // namespace skein::model_tool
