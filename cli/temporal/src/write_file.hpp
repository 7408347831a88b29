// SPDX-License-Identifier: Apache-2.0
// Files of the experiment.
#pragma once

#include <optional>
#include <string>

#include "skein/foundation/result.hpp"

namespace skein::temporal_tool {

/// Replaces the file. Absent: done.
std::optional<Failure> write_file(const std::string& path, const std::string& text);

}  // namespace skein::temporal_tool
