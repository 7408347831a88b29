// SPDX-License-Identifier: Apache-2.0
// Where the nodes of a YAML text stand in it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/yaml_edit/edit.hpp"

namespace skein::yaml_edit {

/// A stretch of bytes.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< behind the last
};

/// A node as written. Of a block collection the span begins with its first dash or key and ends
/// with its last node: comments and blank lines below are not of it.
struct Place {
  enum class Kind { kScalar, kList, kMap };
  Kind kind = Kind::kScalar;
  bool flow = false;    ///< of a collection: in brackets
  bool shared = false;  ///< has an anchor, or is an alias
  Span span;
  std::size_t column = 0;          ///< of the span's begin, from 0
  std::vector<Place> nodes;        ///< items, or values of entries
  std::vector<Span> keys;          ///< of a map
  std::vector<std::string> names;  ///< of its keys

  bool is_block() const { return kind != Kind::kScalar && !flow; }
};

/// Of the one document in it. Fails as the YAML library does, with line and column.
Result<Place, Failure> layout_of(std::string_view text);

/// Null if there is none.
const Place* find(const Place& top, const Path& path, std::size_t depth);

}  // namespace skein::yaml_edit
