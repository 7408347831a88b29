// SPDX-License-Identifier: Apache-2.0
// Values as one would write them by hand.
#pragma once

#include <string>

#include "skein/config/value.hpp"

namespace skein::yaml_edit {

/// How far to the right a line is written.
inline constexpr std::size_t kWidth = 120;

/// A scalar with quotes where it needs them.
std::string scalar_text(const std::string& text, bool quoted);
/// In one line: `{task: t1, params: {to: p}}`.
std::string flow_text(const config::Value& value);
/// Whether it is written in one line that begins at this column: it is short, and no list of
/// several maps.
bool is_short(const config::Value& value, std::size_t column);
/// In lines of their own, each indented by `column`, but for the first, which is where it is to be
/// put already; without an end of line. Precondition: a collection that is not empty.
std::string block_text(const config::Value& value, std::size_t column);

}  // namespace skein::yaml_edit
