// SPDX-License-Identifier: Apache-2.0
// Paths of fields in a sample: "task.parameters[0].name".
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"

namespace skein::spy_tool {

struct Step {
  std::string name;                  ///< of a field; empty: an element
  std::optional<std::size_t> index;  ///< of an element
  bool operator==(const Step&) const = default;
};
using Path = std::vector<Step>;

Result<Path, Failure> parse_path(std::string_view text);

/// The values at a path. A list without an index stands for all its elements, so there may be
/// several values, or none.
std::vector<const nlohmann::ordered_json*> values_at(const nlohmann::ordered_json& document,
                                                     const Path& path);

/// Checks that samples of one of these slots can have a value at the path; otherwise a diagnostic
/// with the nearest name. Elements of lists that are empty in a default sample are not checked.
Diagnostics check_path(const Path& path, const std::string& text,
                       const std::vector<wire::Slot>& slots);

}  // namespace skein::spy_tool
