// SPDX-License-Identifier: Apache-2.0
#include "skein/functional/task_types.hpp"

#include <utility>

#include "shipped_text.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::functional {

const TaskTypes& TaskTypes::shipped() {
  static const TaskTypes types = [] {
    auto read = read_task_types(shipped_text(), "task-types.yaml");
    SKEIN_EXPECTS(read.has_value());
    return std::move(*read);
  }();
  return types;
}

void TaskTypes::declare(TaskType type) {
  if (type.name.ends_with('*')) {
    std::string beginning = type.name.substr(0, type.name.size() - 1);
    families_[std::move(beginning)] = std::move(type);
  } else {
    types_[type.name] = std::move(type);
  }
}

const TaskType* TaskTypes::find(std::string_view name) const {
  if (const auto found = types_.find(name); found != types_.end()) return &found->second;
  const TaskType* longest = nullptr;
  for (const auto& [beginning, type] : families_) {
    if (!name.starts_with(beginning)) continue;
    if (longest == nullptr || type.name.size() > longest->name.size()) longest = &type;
  }
  return longest;
}

const TaskType& TaskTypes::of(std::string_view name) const {
  static const TaskType nothing;
  const TaskType* found = find(name);
  return found == nullptr ? nothing : *found;
}

std::vector<std::string> TaskTypes::names() const {
  std::vector<std::string> result;
  for (const auto& [name, type] : types_) result.push_back(name);
  return result;
}

std::vector<std::string> TaskTypes::names(CarriedOutBy by) const {
  std::vector<std::string> result;
  for (const auto& [name, type] : types_) {
    if (type.by == by) result.push_back(name);
  }
  return result;
}

}  // namespace skein::functional
