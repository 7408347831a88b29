// SPDX-License-Identifier: Apache-2.0
// Task types and the exclusive resources they use.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "skein/executive/task.hpp"

namespace skein::executive {

/// The resource of whatever moves the vehicle.
inline constexpr std::string_view kMotion = "motion";

/// Type name → names of the exclusive resources. A resource written `$name` stands for the text of
/// the task's parameter `name` (so `takeshot` uses `$device`); a task without that parameter uses
/// the one unnamed resource "". Source: spec 2.5.
class TypeTable {
 public:
  /// The elementary types of spec 2.5.
  static TypeTable elementary();

  /// Adds or replaces.
  void declare(std::string type, std::vector<std::string> resources);
  /// Joint types count as declared.
  bool is_declared(std::string_view type) const;
  /// Sorted, without repetition; empty for a type that is not declared.
  std::vector<std::string> resources_of(const std::string& type,
                                        const Parameters& parameters) const;

 private:
  std::map<std::string, std::vector<std::string>, std::less<>> types_;
};

}  // namespace skein::executive
