// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/lateness.hpp"

#include <algorithm>

#include "skein/foundation/rounded_seconds.hpp"

namespace skein::auction {

namespace {

std::string at(double second) { return in_seconds(MissionTime::seconds(second)); }

}  // namespace

bool is_too_late(const Task& task, MissionTime now) {
  return std::max(task.earliest, now.to_seconds()) + task.duration > task.deadline;
}

std::string why_too_late(const Task& task) {
  const double latest = task.deadline - task.duration;
  std::string why = "nobody can do it in time any more: its deadline is " + at(task.deadline) +
                    ", and it had to begin by " + at(latest);
  if (task.earliest > latest) why += ", not before " + at(task.earliest);
  return why;
}

}  // namespace skein::auction
