// SPDX-License-Identifier: Apache-2.0
// All kinds of lines with their fields: what docs/journal.md describes and scenarios may expect.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal {

/// Of the type of a field of a line: it is left out when there is nothing to say.
template <class T>
inline constexpr bool kMayBeLeftOut = detail::kIsOptional<T>;

struct Kind {
  struct Field {
    std::string name;
    bool optional = false;  ///< left out when there is nothing to say
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

/// Every kind there is.
const std::vector<Kind>& kinds();
/// Null: there is none of that name.
const Kind* find_kind(std::string_view name);

}  // namespace skein::journal
