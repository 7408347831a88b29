// SPDX-License-Identifier: Apache-2.0
// All kinds of lines with their fields, as docs/journal.md describes them and scenarios name them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal {

/// Whether a field of this type is left out of the line when it is empty or absent.
template <class T>
inline constexpr bool kMayBeLeftOut = detail::kIsOptional<T>;

struct Kind {
  struct Field {
    std::string name;
    bool optional = false;  ///< left out when it is empty or absent
    /// All that a field of words may say; empty: it is another type, or its words are not counted.
    std::vector<std::string> words = {};
  };
  std::string name;
  std::vector<Field> fields;  ///< in the order of the line
};

template <class Line>
Kind kind_of() {
  Kind kind{std::string(Line::kKind), {}};
  Line line;
  Line::fields(line, [&]<class T>(const char* name, T&) {
    kind.fields.push_back({name, kMayBeLeftOut<T>});
  });
  return kind;
}

/// All kinds.
const std::vector<Kind>& kinds();
/// The kind with this name, or null.
const Kind* find_kind(std::string_view name);

}  // namespace skein::journal
