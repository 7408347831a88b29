// SPDX-License-Identifier: Apache-2.0
// Prints errors and warnings of files, each with its line of text, underlined.
#pragma once

#include <iosfwd>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn_tools/text_style.hpp"

namespace skein::plan_tool {

enum class Severity { kError, kWarning };

/// In the order found; `definitions` has the texts.
void show(const Diagnostics& diagnostics, Severity severity, const htn::Definitions& definitions,
          const htn::TextStyle& style, std::ostream& err);

/// What is wrong, for programs: {"result":"error","why":…,"errors":[{"file":…,"line":…,"column":…,
/// "message":…,"expected":…,"nearest":…},…]}, absent parts left out. `why` is the first of them as
/// people read it. With the end of its line.
std::string to_json_line(const Diagnostics& errors);

}  // namespace skein::plan_tool
