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

/// Says what is there on `out`; what is wrong on `err`, or with `json` on `out`. A file that is one
/// block is checked as an automaton by itself. 0: right; 2: not, with every error.
int check_models(const CheckOptions& options, std::ostream& out, std::ostream& err);

struct DrawOptions {
  std::string file;
  std::string output;  ///< empty: standard output
};

/// An SVG picture of all variants of all models in the file. 0: drawn; 2: the file is wrong;
/// 3: the picture cannot be written.
int draw_models(const DrawOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::model_tool
