// SPDX-License-Identifier: Apache-2.0
// Links as in both of our JSON formats: {"from": "a", "to": "b", "min": 1.5, "max": null}.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "json_document.hpp"
#include "link_tables.hpp"

namespace skein::temporal {

/// Reads a link; nothing, and problems, if a field is missing or wrong.
std::optional<Arc> arc_from(const JsonNode& node, const NameTable& nodes);

/// The JSON text of a link, without a line end.
std::string arc_text(const Arc& arc, const std::vector<std::string>& nodes);

/// A JSON array with one element on each line.
std::string lines_text(const std::vector<std::string>& elements);

}  // namespace skein::temporal
