// SPDX-License-Identifier: Apache-2.0
// The exclusive resources of task types.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/executive/task.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::executive {

/// The resource of all tasks that move the vehicle or hold it in place.
inline constexpr std::string_view kMotion = "motion";

/// Maps task types to the names of their exclusive resources, from the registry of task types or
/// from declare(). A task without the parameter that should name its device uses the resource "". A
/// joint task itself uses no resources; the elementary tasks that its roles ask for do. Source:
/// spec 2.5.
class TypeTable {
 public:
  explicit TypeTable(functional::TaskTypes types) : types_(std::move(types)) {}
  /// The shipped types.
  static TypeTable elementary() { return TypeTable(functional::TaskTypes::shipped()); }

  /// Adds a type, or replaces its resources. A resource written `$name` stands for the text of the
  /// task's parameter `name`.
  void declare(std::string type, std::vector<std::string> resources);
  /// Whether the type is known; joint types always are.
  bool is_declared(std::string_view type) const;
  /// The registry's entry; for a type that is known by declare() only, one without demands on the
  /// vehicle.
  const functional::TaskType& of(std::string_view type) const { return types_.of(type); }
  /// Sorted, without repetition; empty for a type that is not declared.
  std::vector<std::string> resources_of(const std::string& type,
                                        const Parameters& parameters) const;

 private:
  functional::TaskTypes types_;
  std::map<std::string, std::vector<std::string>, std::less<>> declared_;
};

}  // namespace skein::executive
