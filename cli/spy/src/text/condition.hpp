// SPDX-License-Identifier: Apache-2.0
// Conditions on samples: "task.id > 3 && uav == 'marvin'".
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "path.hpp"

namespace skein::spy_tool {

/// Grammar, closest first:
///   comparison  PATH (== | != | < | <= | > | >=) VALUE, or PATH alone: true, or there at all
///   !  &&  ||   with ( and )
///   VALUE       a number, true, false, 'text', "text", or a word: running
/// Numbers compare as numbers, other values as text; a missing value satisfies no comparison, and
/// of several values (a list without an index) one is enough.
class Condition {
 public:
  /// The failure says at which column what was expected.
  static Result<Condition, Failure> parse(std::string_view text);
  Condition(Condition&&) noexcept;
  Condition& operator=(Condition&&) noexcept;
  ~Condition();

  bool holds(const nlohmann::ordered_json& sample) const;
  /// The paths in the condition, as written.
  const std::vector<std::string>& paths() const { return paths_; }

  struct Node;

 private:
  Condition();
  std::unique_ptr<Node> root_;
  std::vector<std::string> paths_;
};

}  // namespace skein::spy_tool
