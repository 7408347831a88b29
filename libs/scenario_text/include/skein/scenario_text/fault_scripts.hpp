// SPDX-License-Identifier: Apache-2.0
// Error positions in a scenario that was joined with fault scripts.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"

namespace skein::scenario_text {

/// A file name and the text of the file.
struct NamedText {
  std::string file;
  std::string text;
};

/// YAML errors of the files (for instance duplicate keys), all at once.
Diagnostics problems_of(const std::vector<NamedText>& files);

/// Errors of the document `joined`, which `with_radio` made of a scenario and fault scripts
/// (`files`, in that order): each with the file, line and path where the value was written. Errors
/// of other files, or whose value is not found, stay unchanged. Precondition: problems_of(files) is
/// empty.
Diagnostics as_written(const Diagnostics& errors, const std::string& joined,
                       const std::vector<NamedText>& files);

}  // namespace skein::scenario_text
