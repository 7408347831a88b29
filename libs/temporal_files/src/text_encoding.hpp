// SPDX-License-Identifier: Apache-2.0
// Texts that are not UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problems.hpp"

namespace skein::temporal {

/// Told by the mark before it, or by zero bytes around its first character.
bool is_utf16(std::string_view text);

/// The text in UTF-8, without the mark; nothing, and a problem, when it breaks off or has half a
/// surrogate pair. Precondition: is_utf16(text).
std::optional<std::string> utf8_from_utf16(std::string_view text, Problems& problems);

}  // namespace skein::temporal
