// SPDX-License-Identifier: Apache-2.0
// Where what is wrong with a scenario and its fault scripts was written.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"

namespace skein::scenario_text {

/// A file with what it holds.
struct NamedText {
  std::string file;
  std::string text;
};

/// What is wrong with the files as YAML (a key given twice, for one), all at once.
Diagnostics problems_of(const std::vector<NamedText>& files);

/// Errors of the document `joined`, which `with_radio` made of a scenario and fault scripts
/// (`files`, in that order): each with the file, line and path where the value was written. What is
/// of another file, or nowhere to be found, stays as it is. Precondition: problems_of(files) is
/// empty.
Diagnostics as_written(const Diagnostics& errors, const std::string& joined,
                       const std::vector<NamedText>& files);

}  // namespace skein::scenario_text
