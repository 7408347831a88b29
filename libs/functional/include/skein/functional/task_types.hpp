// SPDX-License-Identifier: Apache-2.0
// The one registry of task types: who asks what a task does to the vehicle asks here.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/functional/task_type.hpp"

namespace skein::functional {

/// Types by name, and families: a name that ends with `*` stands for all that begin so.
class TaskTypes {
 public:
  /// Those of scenarios/task-types.yaml. Immutable; any thread.
  static const TaskTypes& shipped();

  /// Adds or replaces.
  void declare(TaskType type);
  /// The type of that very name, else of the family with the longest name; or nullptr. Valid until
  /// the next declare(). Cost: logarithmic, and the number of families.
  const TaskType* find(std::string_view name) const;
  /// As find(); a type that was not declared asks nothing of the vehicle.
  const TaskType& of(std::string_view name) const;
  /// Without families, in alphabetical order.
  std::vector<std::string> names() const;
  std::vector<std::string> names(CarriedOutBy by) const;

 private:
  std::map<std::string, TaskType, std::less<>> types_;
  std::map<std::string, TaskType, std::less<>> families_;  ///< by what they begin with
};

/// Reads the format of scenarios/task-types.yaml. `file` is for messages. Every error at once.
Result<TaskTypes, Diagnostics> read_task_types(std::string_view text, const std::string& file);

}  // namespace skein::functional
