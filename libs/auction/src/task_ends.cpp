// SPDX-License-Identifier: Apache-2.0
#include "task_ends.hpp"

#include <algorithm>

namespace skein::auction {

void TaskEnds::said(MemberNumber owner, const DoneClaim& done) {
  ends_[{done.claim, owner}] = done.at;
}

TaskEnd TaskEnds::of(const LedgerEntry& entry, MissionTime now) const {
  TaskEnd end;
  bool is_known = true;
  for (const MemberNumber owner : entry.owners) {
    const auto said = ends_.find({{entry.task.number, entry.sale}, owner});
    is_known = is_known && said != ends_.end();
    if (said != ends_.end()) end.after = std::max(end.after.value_or(said->second), said->second);
  }
  end.by = is_known && end.after ? *end.after : now;
  return end;
}

void bound_start(Task& then, const Delay& delay, const TaskEnd& first) {
  then.earliest = std::max(then.earliest, first.by.to_seconds() + delay.least);
  if (!delay.bounds_above()) return;
  const double begun =
      first.after ? first.after->to_seconds() + delay.most : first.by.to_seconds() - 1;
  then.deadline = std::min(then.deadline, begun + then.duration);
}

}  // namespace skein::auction
