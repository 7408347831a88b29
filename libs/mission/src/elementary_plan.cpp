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

bool uses_motion(const ElementaryTask& task) {
  return task.type == "takeoff" || task.type == "goto" || task.type == "land" ||
         task.type == "wait";
}

}  // namespace skein::mission
