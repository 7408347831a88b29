// SPDX-License-Identifier: Apache-2.0
// Look-up of rows by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/negotiation/terms.hpp"

namespace skein::interaction {

/// The only row of that name; null if there is none, or more than one.
inline const Row* only_row(const Rows& rows, const std::string& name) {
  const Row* found = nullptr;
  for (const Row& row : rows) {
    if (row.name != name) continue;
    if (found != nullptr) return nullptr;
    found = &row;
  }
  return found;
}

/// Why `rows` do not hold exactly one row of that name with so many numbers; absent: they do.
inline std::optional<std::string> missing_row(const Rows& rows, const std::string& name,
                                              std::size_t numbers) {
  const Row* row = only_row(rows, name);
  if (row != nullptr && row->numbers.size() == numbers) return std::nullopt;
  return "not one '" + name + "' with " + std::to_string(numbers) + " numbers";
}

}  // namespace skein::interaction
