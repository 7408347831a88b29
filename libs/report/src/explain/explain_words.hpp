// SPDX-License-Identifier: Apache-2.0
// Lines of an explanation: a label and its text.
#pragma once

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "text.hpp"

namespace skein::report {

/// An instant of mission time, rounded to 0.1 s: "12.3 s".
inline std::string instant_text(double seconds) { return fixed_number(seconds, 1) + " s"; }

inline std::string actual_text(const std::optional<double>& t) {
  return t ? instant_text(*t) : "not";
}

/// Writes one line; none when `text` is empty.
inline void write_line(std::ostream& out, std::string_view label, std::string_view text) {
  if (text.empty()) return;
  std::string head(label);
  head.resize(std::max<std::size_t>(head.size(), 10), ' ');
  out << "    " << head << " " << text << "\n";
}

}  // namespace skein::report
