// SPDX-License-Identifier: Apache-2.0
// Edits of the text of a scenario file.
#pragma once

#include <string>

#include "skein/foundation/result.hpp"

namespace skein::scenario_text {

/// The text with the same meaning in another folder: names of existing files (models, domains,
/// rasters) become relative to `to_folder`; all else stays, byte for byte. (If such a name is
/// written with an anchor or with escapes, the document is written anew and comments are lost.)
/// Precondition: `yaml` is valid YAML.
std::string moved(const std::string& yaml, const std::string& from_folder,
                  const std::string& to_folder);

/// The text with another radio: the keys under `radio` of the document `faults` replace those of
/// the scenario, except `cuts`, which are added. Comments are lost; the notation of values is kept.
/// Fails, naming the document, if either has no such form.
Result<std::string, Failure> with_radio(const std::string& yaml, const std::string& faults);

}  // namespace skein::scenario_text
