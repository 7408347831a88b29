// SPDX-License-Identifier: Apache-2.0
#include "skein/config/value.hpp"

namespace skein::config {

const Value* Value::find(std::string_view key) const {
  for (const auto& [name, value] : entries) {
    if (name == key) return &value;
  }
  return nullptr;
}

std::string describe(const Value& value) {
  switch (value.kind) {
    case Value::Kind::kMap:
      return "a map";
    case Value::Kind::kSequence:
      return "a list";
    case Value::Kind::kScalar:
      return "'" + value.scalar.substr(0, 60) + "'";
    case Value::Kind::kNull:
      break;
  }
  return "nothing";
}

}  // namespace skein::config
