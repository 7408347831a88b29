// SPDX-License-Identifier: Apache-2.0
// `skein model check` and `skein model draw`: models from files.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace skein::model_tool {

struct CheckOptions {
  std::vector<std::string> files;  ///< read together, with all that they use
  bool json = false;
};

/// Prints the content of the models to `out`, errors to `err`, or with `json` to `out`. A file of
/// one block is checked as an automaton. 0: no errors; 2: errors, all at once.
int check_models(const CheckOptions& options, std::ostream& out, std::ostream& err);

struct DrawOptions {
  std::string file;
  std::string output;  ///< empty: standard output
};

/// An SVG picture of all variants of all models in the file. 0: drawn; 2: the file is wrong;
/// 3: the picture cannot be written.
int draw_models(const DrawOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::model_tool
