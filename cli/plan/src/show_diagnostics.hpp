// SPDX-License-Identifier: Apache-2.0
// What is wrong or suspicious in files, each with its line of text, underlined.
#pragma once

#include <iosfwd>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn/text_style.hpp"

namespace skein::plan_tool {

enum class Severity { kError, kWarning };

/// In the order found; `definitions` has the texts.
void show(const Diagnostics& diagnostics, Severity severity, const htn::Definitions& definitions,
          const htn::TextStyle& style, std::ostream& err);

}  // namespace skein::plan_tool
