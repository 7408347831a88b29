// SPDX-License-Identifier: Apache-2.0
// Operator 6 before its job: what a contingency stops, and what keeps the UAV safe meanwhile.
#include <algorithm>

#include "core.hpp"

namespace skein::supervisor {

namespace {

constexpr Duration kPause = Duration::milliseconds(5000);  // a longer one between tasks is said

}  // namespace

// Goals lose their tasks. Returns those that the executive has to be told to stop, the highest id
// first; what was only planned is forgotten.
std::vector<TaskId> Supervisor::Core::withdraw(const std::set<GoalId>& goals) {
  std::vector<TaskId> result;
  for (auto it = book_.tasks.rbegin(); it != book_.tasks.rend(); ++it) {
    Entry& entry = it->second;
    if (goals.count(entry.task.origin) == 0 || !entry.live()) continue;
    if (entry.in_hand()) result.push_back(it->first);
    entry.withdrawn = true;
  }
  return result;
}

void Supervisor::Core::stop(const std::vector<TaskId>& tasks) {
  for (const TaskId id : tasks) {
    book_.tasks.at(id).stopping = true;
    send(executive::Abort{id});
  }
}

void Supervisor::Core::retire(const std::set<GoalId>& goals) { stop(withdraw(goals)); }

void Supervisor::Core::need(std::optional<GoalId> failed, bool refine, const std::string& cause) {
  if (!need_) {
    need_ = Need{failed, refine, cause, now_, 0, false, now_};
    return;
  }
  hurry();
  need_->cause += "; " + cause;
  if (need_->failed || !failed) return;
  need_->failed = failed;
  need_->refine = refine;
}

// What was refused alike before is planned again after a pause; whatever else happens ends it.
void Supervisor::Core::pause_need(const Entry& entry, int refused) {
  const Duration pause = pause_after(refused);
  if (pause <= Duration()) return;
  need_->not_before = now_ + pause;
  notice(named(entry.task.origin) + ": its " + entry.task.type + " was refused " +
         std::to_string(refused) + " times alike (" + entry.why + "); it is planned again in " +
         to_text(pause) + " s");
}

void Supervisor::Core::hurry() {
  if (need_) need_->not_before = now_;
}

void Supervisor::Core::fail_task(const Entry& entry, const std::string& cause) {
  fail_goal(entry.task.origin, cause);
}

// The goal is refined again from here as often as that is allowed.
void Supervisor::Core::fail_goal(GoalId id, const std::string& cause) {
  if (book_.is_given(id)) retire(book_.falling_with({id}));
  Goal& goal = book_.goals.at(id);
  const bool refine = goal.refined < config_.refinements;
  if (need_ && need_->failed && *need_->failed != id && !refine) {
    retire({id});
    set_state(goal, GoalState::kFailed, cause);
    return need(std::nullopt, false, cause);
  }
  if (refine) ++goal.refined;
  need(id, refine, cause);
}

// Operator 2 from the executive's side: somebody had the task aborted there.
void Supervisor::Core::operator_aborted(const Entry& entry) {
  const TaskId task = entry.task.id;
  const GoalId id = entry.task.origin;
  const std::string cause = "task " + to_text(task) + " aborted on request";
  cancel_goal(id, cause);
}

void Supervisor::Core::cancel_goal(GoalId id, const std::string& cause) {
  retire(book_.falling_with({id}));
  set_state(book_.goals.at(id), GoalState::kCancelled, cause);
  reschedule();
  const std::vector<GoalId> left = book_.free_goals();
  decide({"2 cancel", cause, "goals " + to_text(id),
          left.empty() ? "nothing is to be planned anew" : list_of("to plan anew:", left), now_});
  if (!left.empty()) need(std::nullopt, false, cause);
}

// ---- devices ----

void Supervisor::Core::check_devices(const std::set<std::string>& newly) {
  const auto failed = [&](const Entry* entry) {
    if (!book_.counts(*entry)) return std::string();
    const auto devices = devices_of(entry->task);
    const auto hit = std::find_if(devices.begin(), devices.end(),
                                  [&](const auto& one) { return newly.count(one) != 0; });
    return hit == devices.end() ? std::string() : *hit;
  };
  for (const GoalId id : std::vector<GoalId>(book_.order)) {
    const auto tasks = book_.of(id);
    const auto hit = std::find_if(tasks.begin(), tasks.end(),
                                  [&](const Entry* entry) { return !failed(entry).empty(); });
    if (hit == tasks.end()) continue;
    fail_goal(id, "device " + failed(*hit) + " of task " + to_text((*hit)->task.id) + " failed");
  }
}

// ---- safety ----

// In the air, the UAV has a task that is under way or begins at once, or it is said that it has
// none. It waits in safe mode until what the executive has may begin, unless that is soon.
void Supervisor::Core::keep_safe() {
  if (const auto end = end_of_safe_wait(); end && *end <= now_) stop_safe_waits();
  if (!vehicle_.airborne || book_.has_occupation(now_ + config_.horizon)) {
    const bool pauses = vehicle_.airborne && !book_.has_occupation(now_ + kPause);
    if (pauses && !told_idle_) notice("in the air without a task for a moment: " + why_idle());
    told_idle_ = pauses;
    return;
  }
  if (!ever_gave_) {
    if (!told_idle_) notice("in the air without a task: " + why_idle());
    told_idle_ = true;
    return;
  }
  if (wait_again_ && now_ < *wait_again_) {
    if (!told_idle_)
      notice("in the air without a task: its safe wait was refused or aborted; " + why_idle());
    told_idle_ = true;
    return;
  }
  wait_safely();
}

// What is being decided on, else what became of its last goal.
std::string Supervisor::Core::why_idle() const {
  if (need_) return "its plan is to be repaired: " + need_->cause;
  if (job_ && !job_->mission) return "its plan is being repaired: " + job_->need.cause;
  if (job_) return "mission " + to_text(*job_->mission) + " is being planned";
  if (!pending_.empty()) return "mission " + to_text(pending_.front().id) + " is to be planned";
  const Goal* last = nullptr;
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    if (!is_settled(goal.state) && goal.state != GoalState::kHandedOver)
      return named(id) + " waits: nothing of it may begin " + begins_from(id);
    if (last == nullptr || goal.settled >= last->settled) last = &goal;
  }
  if (last == nullptr) return "no mission was given to it";
  const std::string why = last->why.empty() ? "" : " (" + last->why + ")";
  return "nothing follows " + named(last->task.id) + ", " + std::string(to_text(last->state)) + why;
}

// "before 180 s", or "yet".
std::string Supervisor::Core::begins_from(GoalId id) const {
  MissionTime first = MissionTime::max();
  for (const Entry* entry : book_.of(id)) {
    if (!entry->over()) first = std::min(first, entry->dates.earliest_start);
  }
  const bool dated = first > now_ && first != MissionTime::max() && !is_undated(id);
  return dated ? "before " + to_text(first) + " s" : "yet";
}

// What the executive has begins when this is over.
void Supervisor::Core::wait_safely() {
  wait_again_.reset();
  const TaskId id = book_.next_id;
  book_.next_id = TaskId(id.value() + 1);
  executive::Task task;
  task.id = id;
  task.type = "wait";
  book_.loose[id] = {"wait", true, true, false, false};
  send(executive::Start{std::move(task), executive::InsertionMode::kVut});
  for (const auto& [task_id, entry] : book_.tasks) {
    const bool held = entry.in_hand() && !entry.seen.started && !entry.by_others;
    if (held && holds_vehicle(entry.task)) send_preconditions(entry);
  }
  notice("in the air with nothing to do: waits in safe mode, task " + to_text(id) + "; " +
         why_idle());
}

void Supervisor::Core::stop_safe_waits() {
  for (auto it = book_.loose.rbegin(); it != book_.loose.rend(); ++it) {
    if (!it->second.ours || it->second.stopping) continue;
    it->second.stopping = true;
    send(executive::Abort{it->first});
  }
}

}  // namespace skein::supervisor
