// SPDX-License-Identifier: Apache-2.0
// Mappings that are flown in parts.
#include <algorithm>

#include "book/book.hpp"
#include "book/progress.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {
namespace {

using world::Vector3;

constexpr double kSamePlace = 0.01;  // [m]

/// The lanes among the tasks that the goal has now; nothing when it flies none.
std::optional<TaskId> lanes_of(const Book& book, GoalId goal) {
  for (const Entry* entry : book.of(goal))
    if (const Entry* along = flown_along(book, *entry)) return along->task.id;
  return std::nullopt;
}

/// The mapping comes to its lanes from before the place where its part leaves them.
std::vector<Vector3> from_there_on(const std::vector<Vector3>& way, const Vector3& place) {
  const auto there = std::find_if(
      way.begin(), way.end(), [&](const Vector3& at) { return (at - place).norm() < kSamePlace; });
  return {there, way.end()};
}

}  // namespace

std::vector<GoalId> Book::parts_of(GoalId whole) const {
  std::vector<GoalId> parts;
  for (const auto& [id, goal] : goals)
    if (whole_of(goal.task) == whole) parts.push_back(id);
  return parts;
}

void Book::note_parts() {
  for (const auto& [id, goal] : goals) {
    const auto whole = whole_of(goal.task);
    if (!whole || is_settled(goal.state) || !is_planned(id)) continue;
    const auto first = lanes_of(*this, id), rest = lanes_of(*this, *whole);
    if (!first) continue;
    Entry& part = tasks.at(*first);
    part.beyond.clear();
    if (rest) part.beyond = from_there_on(tasks.at(*rest).task.way, part.task.way.back());
  }
}

}  // namespace skein::supervisor
