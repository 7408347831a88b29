// SPDX-License-Identifier: Apache-2.0
// The text of a scenario file, changed.
#pragma once

#include <string>

#include "skein/foundation/result.hpp"

namespace skein::scenario_text {

/// As it must be to mean the same in another folder: names of files that there are (models,
/// domains, rasters) lead to them from there; all else stays, byte for byte. (Where such a name is
/// written with an anchor or with escapes, the document is written anew and comments are lost.)
/// Precondition: it is YAML.
std::string moved(const std::string& yaml, const std::string& from_folder,
                  const std::string& to_folder);

/// With another radio: `faults` is a document whose keys under `radio` take the place of the
/// scenario's, but for `cuts`, which come beside it. Comments are lost; how a value is written is
/// not. The failure says what is no such document.
Result<std::string, Failure> with_radio(const std::string& yaml, const std::string& faults);

}  // namespace skein::scenario_text
