// SPDX-License-Identifier: Apache-2.0
// Where something is in a sample: "task.parameters[0].name".
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

/// What is there. A list that the path names no element of stands for all of them, so that there
/// may be many; there may be nothing.
std::vector<const nlohmann::ordered_json*> values_at(const nlohmann::ordered_json& document,
                                                     const Path& path);

/// Whether samples of one of these slots may have something there; the nearest name otherwise. What
/// is in empty lists of a fresh sample is not known and may be there.
Diagnostics check_path(const Path& path, const std::string& text,
                       const std::vector<wire::Slot>& slots);

}  // namespace skein::spy_tool
