// SPDX-License-Identifier: Apache-2.0
// YAML text to a tree of values.
#pragma once

#include <string>
#include <string_view>

#include "skein/config/value.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"

namespace skein::config {

/// Parses one YAML document. Refused, with line and column: syntax errors, a key given twice, keys
/// that are not scalars, more than one document, nesting deeper than 64, more than a million
/// values after aliases are expanded, text over 16 MiB.
/// `file` is only used in the messages. Source: docs/decisions/0002-errors.md.
Result<Value, Diagnostics> parse_yaml(std::string_view text, const std::string& file);

/// Reads and parses a file; that it cannot be read is a diagnostic like any other.
Result<Value, Diagnostics> parse_yaml_file(const std::string& path);

}  // namespace skein::config
