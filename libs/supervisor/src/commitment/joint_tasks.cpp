// SPDX-License-Identifier: Apache-2.0
#include "commitment/joint_tasks.hpp"

#include <algorithm>

#include "schedule/plan_links.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein::supervisor {

namespace {

constexpr Duration kLate = Duration::milliseconds(15'000);  // less is waited for by partners

}  // namespace

bool JointTasks::Joint::is_overtaken_by(MissionTime earliest) const {
  const bool failed = answered && !loaded;
  return !failed && !due && earliest > (loaded ? agreed : asked) + kLate;
}

bool JointTasks::is_wanted(const Entry& entry) const {
  return executive::is_joint(entry.task.type) && book_.counts(entry) && !entry.by_others &&
         !entry.seen.started;
}

// What is asked for is looked for first among what was: it may be the same with another number. No
// date is asked for where it comes after what never comes.
void JointTasks::renew() {
  for (auto& [id, entry] : book_.tasks) {
    if (!is_wanted(entry) || is_never(entry.dates.earliest_start)) continue;
    const auto known = joints_.find(id);
    if (known == joints_.end() || known->second.is_overtaken_by(entry.dates.earliest_start))
      load(entry);
  }
  std::erase_if(joints_, [this](const auto& one) {
    const Entry* entry = book_.find(one.first);
    const bool gone = entry == nullptr || (!entry->live() && !entry->given());
    if (!gone) return false;
    LoadJointTask unwanted;
    unwanted.task.id = one.first;
    out_.add(std::move(unwanted));
    return true;
  });
}

void JointTasks::begin_anew() {
  std::erase_if(joints_, [](const auto& one) { return !one.second.due; });
}

void JointTasks::load(const Entry& entry) {
  joints_[entry.task.id] = Joint{.asked = entry.dates.earliest_start};
  LoadJointTask request;
  request.task = entry.task;
  const MissionTime first = entry.dates.earliest_start;
  for (const MissionTime last : {entry.dates.latest_start, entry.window.latest_start}) {
    const mission::Interval one{first - MissionTime(), last - MissionTime()};
    if (request.preferences.empty() || !(request.preferences.back() == one)) {
      request.preferences.push_back(one);
    }
  }
  out_.decide({"4 load joint task", "commitment", "task " + to_text(entry.task.id),
               "starts between " + in_seconds(entry.dates.earliest_start) + " and " +
                   in_seconds(entry.dates.latest_start),
               now()});
  out_.add(std::move(request));
}

void JointTasks::report(TaskId id, const std::string& why) {
  out_.send(executive::FunctionalStatus{id, TaskState::kAborted, why});
}

void JointTasks::due(const JointTaskDue& input) {
  const auto found = joints_.find(input.task);
  if (found == joints_.end()) {
    return report(input.task, "the supervisor does not know this joint task");
  }
  Joint& joint = found->second;
  if (joint.loaded) return;
  if (input.interrupt) return report(input.task, "interrupted before it was loaded");
  joint.due = true;
  if (joint.answered) report(input.task, joint.why);
}

bool JointTasks::answered(const JointTaskAnswered& input) {
  const auto found = joints_.find(input.task);
  Entry* entry = book_.find(input.task);
  if (found == joints_.end() || entry == nullptr || entry->over()) return false;
  Joint& joint = found->second;
  joint.answered = true;
  joint.loaded = input.loaded;
  joint.why = input.why;
  if (!input.loaded) {
    if (joint.due) report(input.task, joint.why);
    return false;
  }
  joint.agreed = MissionTime() + input.agreed.least;
  if (entry->task.gathering) entry->task.gathering->agreed = true;
  entry->task.time.start_after = MissionTime() + input.agreed.least;
  if (input.agreed.most != Duration::max()) {
    entry->task.time.start_before = MissionTime() + input.agreed.most;
  }
  if (input.takes) {
    entry->task.energy = input.takes->energy;
    entry->task.duration.most = std::max(entry->task.duration.most, input.takes->expected);
  }
  return true;
}

}  // namespace skein::supervisor
