// SPDX-License-Identifier: Apache-2.0
// The registry of task types.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/functional/task_type.hpp"

namespace skein::functional {

/// Types by name, and families: a name that ends with `*` stands for all names with that prefix.
class TaskTypes {
 public:
  /// The types of scenarios/task-types.yaml at build time. Immutable; any thread.
  static const TaskTypes& shipped();

  /// Adds a type or a family, or replaces the one of the same name.
  void declare(TaskType type);
  /// The type with exactly this name, otherwise the matching family with the longest prefix, or
  /// nullptr. Valid until the next declare(). Cost: logarithmic, plus the number of families.
  const TaskType* find(std::string_view name) const;
  /// As find(), with a type without demands on the vehicle for names that are not declared.
  const TaskType& of(std::string_view name) const;
  /// The names of the types, without families, in alphabetical order.
  std::vector<std::string> names() const;
  std::vector<std::string> names(CarriedOutBy by) const;

 private:
  std::map<std::string, TaskType, std::less<>> types_;
  std::map<std::string, TaskType, std::less<>> families_;  ///< by prefix
};

/// Reads the format of scenarios/task-types.yaml. `file` is for messages. Returns all errors.
Result<TaskTypes, Diagnostics> read_task_types(std::string_view text, const std::string& file);

}  // namespace skein::functional
