// SPDX-License-Identifier: Apache-2.0
// Small facts about elementary tasks.
#include "skein/mission/elementary_plan.hpp"

#include "words.hpp"

namespace skein::mission {

namespace {

constexpr Words<DependenceKind, 3> kKinds{{{DependenceKind::kEnded, "ended"},
                                           {DependenceKind::kRunning, "running"},
                                           {DependenceKind::kOver, "over"}}};
static_assert(kKinds.size() == static_cast<std::size_t>(DependenceKind::kCount));

}  // namespace

std::string_view to_text(DependenceKind kind) { return word_of(kKinds, kind); }
std::optional<DependenceKind> dependence_kind_from(std::string_view text) {
  return value_of(kKinds, text);
}

const functional::TaskType& type_of(const ElementaryTask& task) {
  return functional::TaskTypes::shipped().of(task.type);
}

bool holds_vehicle(const ElementaryTask& task) { return type_of(task).holds_vehicle(); }

std::vector<std::string> devices_of(const ElementaryTask& task) {
  std::vector<std::string> devices;
  for (const std::string& name : type_of(task).devices) {
    if (const auto* parameter = task.parameters.find(name)) devices.push_back(parameter->text);
  }
  return devices;
}

}  // namespace skein::mission
