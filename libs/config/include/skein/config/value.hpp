// SPDX-License-Identifier: Apache-2.0
// A parsed YAML document as a plain tree that remembers where each value stood.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace skein::config {

struct Entry;

/// One value of a document. Scalars keep their text; what it means (number, boolean, text) is the
/// reader's decision, so that `012` is never taken for ten and `no` never for false.
struct Value {
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind = Kind::kNull;
  std::string scalar;          ///< kScalar
  bool quoted = false;         ///< kScalar: written with quotes
  std::vector<Value> items;    ///< kSequence
  std::vector<Entry> entries;  ///< kMap, in the order written
  int line = 0;                ///< from 1; 0: unknown
  int column = 0;              ///< from 1; 0: unknown

  /// The value of the first entry with this key, or null. Cost: linear.
  const Value* find(std::string_view key) const;
};

/// A key of a map and its value.
struct Entry {
  std::string key;
  Value value;
};

/// "a map", "a list", "text 'abc'", "nothing": for messages.
std::string describe(const Value& value);

}  // namespace skein::config
