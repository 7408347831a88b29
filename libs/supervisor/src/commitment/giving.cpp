// SPDX-License-Identifier: Apache-2.0
// Operators 4 and 5: high-level tasks go to the executive as a whole as they come near.
#include "skein/supervisor/commitment.hpp"

#include <algorithm>

#include "core.hpp"
#include "flight/flight_times.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein::supervisor {

using mission::Dependence;
using mission::DependenceKind;

// ---- when ----

std::optional<GoalId> Supervisor::Core::next_to_give() const {
  for (const GoalId id : book_.order) {
    const GoalState state = book_.goals.at(id).state;
    if (is_settled(state) || state == GoalState::kHandedOver) continue;
    if (book_.is_planned(id)) return id;
  }
  return std::nullopt;
}

// It begins some time after the end of another goal, which is to come.
bool Supervisor::Core::is_undated(GoalId goal) const {
  const auto& after = book_.goals.at(goal).task.after;
  return std::any_of(after.begin(), after.end(), [&](const auto& bound) {
    const auto other = book_.goals.find(bound.goal);
    return !bound.on_end && bound.least > Duration() && other != book_.goals.end() &&
           !is_settled(other->second.state);
  });
}

// What comes behind a wait for orders comes when it may start at once, since it ends the wait;
// never before the wait is under way. So does what comes behind a safe wait, but for the instant
// that this takes to end. While a job runs, what it plans is not taken from it early. What is to
// begin some time after another goal has no date until that is over.
std::optional<MissionTime> Supervisor::Core::due(GoalId goal) const {
  MissionTime first = MissionTime::max();
  for (const Entry* entry : book_.of(goal)) first = std::min(first, entry->dates.earliest_start);
  const auto waits = book_.waits_for_orders();
  for (const Entry* wait : waits) {
    if (!wait->seen.started) return std::nullopt;
  }
  if (!waits.empty()) return first;
  if (is_undated(goal)) return std::nullopt;
  if (book_.waits_safely()) return first - safe_wait_ends_within();
  return job_ && !job_->evaluation ? first : first - config_.horizon;
}

void Supervisor::Core::commit() {
  while (!repairing()) {
    const auto goal = next_to_give();
    if (!goal) return;
    const auto at = due(*goal);
    if (!at || *at > now_) return;
    give(*goal);
  }
}

// ---- what ----

// Tasks beside the plan that have what this one is the first of its goal to need.
std::set<TaskId> Supervisor::Core::loose_before(const mission::ElementaryTask& task) const {
  const auto is_first = [&](auto&& uses) {
    return std::none_of(task.dependences.begin(), task.dependences.end(),
                        [&](const Dependence& one) {
                          const Entry* other = book_.find(one.task);
                          return other != nullptr && other->live() &&
                                 other->task.origin == task.origin && uses(other->task);
                        });
  };
  std::set<TaskId> result;
  if (holds_vehicle(task) && is_first(mission::holds_vehicle)) result = book_.loose_motion(task.id);
  for (const std::string& device : devices_of(task)) {
    const auto uses = [&](const mission::ElementaryTask& other) {
      const auto devices = devices_of(other);
      return std::find(devices.begin(), devices.end(), device) != devices.end();
    };
    if (is_first(uses)) result.merge(book_.loose_users_of(device));
  }
  return result;
}

mission::ElementaryTask Supervisor::Core::as_given(const mission::ElementaryTask& task) const {
  mission::ElementaryTask result = task;
  auto& on = result.dependences;
  const auto unknown = [this](const Dependence& one) {
    const Entry* other = book_.find(one.task);
    return (other == nullptr || !other->given) && book_.loose.count(one.task) == 0 &&
           forgotten_.count(one.task) == 0;
  };
  on.erase(std::remove_if(on.begin(), on.end(), unknown), on.end());
  for (const TaskId id : loose_before(result)) {
    const bool named =
        std::any_of(on.begin(), on.end(), [&](const auto& d) { return d.task == id; });
    if (id != task.id && !named) on.push_back({DependenceKind::kOver, id});
  }
  return result;
}

void Supervisor::Core::give(GoalId goal) {
  std::vector<TaskId> ids;
  std::vector<mission::ElementaryTask> tasks;
  std::map<TaskId, mission::TaskDates> windows;
  end_waits_.clear();
  for (const Entry* wait : book_.waits_for_orders()) end_waits_.push_back(wait->task.id);
  for (const Entry* one : book_.of(goal)) {
    Entry& entry = book_.tasks.at(one->task.id);
    tasks.push_back(as_given(entry.task));
    entry.given = true;
    ids.push_back(entry.task.id);
    windows[entry.task.id] = entry.window;
    if (executive::is_joint(entry.task.type)) load(entry);
  }
  Holds holds;
  for (const TaskId id : ids) {
    Entry& entry = book_.tasks.at(id);
    entry.holds = holds_of(id);
    if (!entry.holds.empty()) holds[id] = entry.holds;
  }
  for (executive::Input& request : to_requests(tasks, windows, book_.ending_by_order(), holds)) {
    send(std::move(request));
  }
  ever_gave_ = true;
  end_waits();
  decide({"5 execute", "commitment horizon", "goals " + to_text(goal), list_of("given: tasks", ids),
          now_});
}

// Orders have come: waits for them, and safe waits, end.
void Supervisor::Core::end_waits() {
  for (auto it = end_waits_.rbegin(); it != end_waits_.rend(); ++it) {
    book_.find(*it)->ordered = true;
    stop({*it});
  }
  stop_safe_waits();
}

Duration Supervisor::Core::safe_wait_ends_within() const {
  return kStopReaction + Duration::seconds(longest_reaction(config_.knowledge->vehicle));
}

// When it is to end, so that the first of the tasks that the executive has may begin in time.
std::optional<MissionTime> Supervisor::Core::end_of_safe_wait() const {
  std::optional<MissionTime> first;
  if (!book_.waits_safely()) return first;
  for (const auto& [id, entry] : book_.tasks) {
    if (!entry.in_hand() || entry.seen.started || entry.by_others || entry.stopping) continue;
    first = earliest(first, entry.dates.earliest_start - safe_wait_ends_within());
  }
  return first;
}

// ---- joint tasks ----

void Supervisor::Core::load(const Entry& entry) {
  joints_[entry.task.id] = {};
  LoadJointTask request;
  request.task = entry.task;
  const MissionTime first = entry.dates.earliest_start;
  for (const MissionTime last : {entry.dates.latest_start, entry.window.latest_start}) {
    const mission::Interval one{first - MissionTime(), last - MissionTime()};
    if (request.preferences.empty() || !(request.preferences.back() == one)) {
      request.preferences.push_back(one);
    }
  }
  decide({"4 load joint task", "commitment", "task " + to_text(entry.task.id),
          "starts between " + in_seconds(entry.dates.earliest_start) + " and " +
              in_seconds(entry.dates.latest_start),
          now_});
  out_.push_back(std::move(request));
}

void Supervisor::Core::report_joint(TaskId id, const std::string& why) {
  send(executive::FunctionalStatus{id, TaskState::kAborted, why});
}

void Supervisor::Core::on(const JointTaskDue& input) {
  const auto found = joints_.find(input.task);
  if (found == joints_.end()) {
    return report_joint(input.task, "the supervisor does not know this joint task");
  }
  Joint& joint = found->second;
  if (joint.loaded) return;
  if (input.interrupt) return report_joint(input.task, "interrupted before it was loaded");
  joint.due = true;
  if (joint.answered) report_joint(input.task, joint.why);
}

void Supervisor::Core::on(const JointTaskAnswered& input) {
  const auto found = joints_.find(input.task);
  Entry* entry = book_.find(input.task);
  if (found == joints_.end() || entry == nullptr || entry->over()) return;
  Joint& joint = found->second;
  joint.answered = true;
  joint.loaded = input.loaded;
  joint.why = input.why;
  if (!input.loaded) {
    if (joint.due) report_joint(input.task, joint.why);
    return;
  }
  entry->task.time.start_after = MissionTime() + input.agreed.least;
  if (input.agreed.most != Duration::max()) {
    entry->task.time.start_before = MissionTime() + input.agreed.most;
  }
  reschedule();
  if (entry->seen.started || !entry->live()) return;
  send_preconditions(*entry);
  absorb_or_shift("joint task " + to_text(input.task) + " agreed");
}

}  // namespace skein::supervisor
