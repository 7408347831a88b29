// SPDX-License-Identifier: Apache-2.0
// Task types as the executive needs them: resources, and who carries a task out.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/executive/task.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::executive {

/// The resource of whatever moves the vehicle, or keeps it where it is.
inline constexpr std::string_view kMotion = "motion";

/// Type name → names of the exclusive resources: those that the registry of task types says, or
/// those declared here beside it. A task that lacks the parameter that names its device uses the
/// one unnamed resource "". What others carry out for a joint task takes resources, the joint task
/// itself none. Source: spec 2.5.
class TypeTable {
 public:
  explicit TypeTable(functional::TaskTypes types) : types_(std::move(types)) {}
  /// The shipped types.
  static TypeTable elementary() { return TypeTable(functional::TaskTypes::shipped()); }

  /// Adds a type, or replaces its resources. A resource written `$name` stands for the text of the
  /// task's parameter `name`.
  void declare(std::string type, std::vector<std::string> resources);
  /// Joint types count as declared.
  bool is_declared(std::string_view type) const;
  /// A type that was declared here only asks nothing of the vehicle.
  const functional::TaskType& of(std::string_view type) const { return types_.of(type); }
  /// Sorted, without repetition; empty for a type that is not declared.
  std::vector<std::string> resources_of(const std::string& type,
                                        const Parameters& parameters) const;

 private:
  functional::TaskTypes types_;
  std::map<std::string, std::vector<std::string>, std::less<>> declared_;
};

}  // namespace skein::executive
