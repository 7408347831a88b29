// SPDX-License-Identifier: Apache-2.0
// Needs become jobs, one at a time; a result whose premises no longer hold is made again.
#include <algorithm>

#include "core.hpp"

namespace skein::supervisor {

namespace {

constexpr int kManyAttempts = 5;
constexpr double kMovedAway = 25;  // [m] from where a plan was to begin

}  // namespace

std::set<GoalId> Supervisor::Core::goals_of(const std::set<TaskId>& tasks) const {
  std::set<GoalId> result;
  for (const TaskId id : tasks) result.insert(book_.tasks.at(id).task.origin);
  return result;
}

// ---- premises ----

Supervisor::Core::Premises Supervisor::Core::premises(const std::set<TaskId>& withdrawn) const {
  Premises result;
  result.withdrawn = withdrawn;
  bool moves = !withdrawn.empty();
  for (const TaskId id : book_.in_hand()) {
    if (withdrawn.count(id) != 0) continue;
    result.standing.push_back(id);
    moves = moves || holds_vehicle(book_.tasks.at(id).task);
  }
  for (const GoalId id : book_.order) {
    if (goals_of(withdrawn).count(id) != 0) result.goals.push_back(id);
  }
  for (const GoalId id : book_.free_goals()) result.goals.push_back(id);
  result.world = world_revision_;
  result.broken = broken_;
  result.next_id = book_.next_id;
  if (!moves) result.position = vehicle_.position;
  return result;
}

Supervisor::Core::Premises Supervisor::Core::premises_of_insertion(const Pending& pending) const {
  Premises result = premises(to_interrupt(pending));
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    if (goal.queued && goal.mission == pending.id) result.added.push_back(id);
  }
  return result;
}

Supervisor::Core::Premises Supervisor::Core::premises_of_repair() const { return premises({}); }

// An urgent mission interrupts what is in hand, but no takeoff and no landing that has begun, and
// nothing that the ground decides on.
std::set<TaskId> Supervisor::Core::to_interrupt(const Pending& pending) const {
  if (pending.placement != mission::Placement::kFirst || !pending.interrupt) return {};
  std::set<GoalId> kept;
  for (const auto& [id, entry] : book_.tasks) {
    const bool critical = type_of(entry.task).leaves != functional::Leaves::kAsItWas;
    const GoalId goal = entry.task.origin;
    const bool theirs = book_.goals.at(goal).state == GoalState::kHandedOver;
    if (theirs || (critical && entry.under_way())) kept.insert(goal);
  }
  std::set<TaskId> result;
  for (const TaskId id : book_.in_hand()) {
    if (kept.count(book_.tasks.at(id).task.origin) == 0) result.insert(id);
  }
  return result;
}

// Nothing new is there, and what is missing has ended well.
bool Supervisor::Core::all_done(const std::vector<TaskId>& then,
                                const std::vector<TaskId>& now) const {
  if (!std::includes(then.begin(), then.end(), now.begin(), now.end())) return false;
  return std::all_of(then.begin(), then.end(), [&](TaskId id) {
    return std::binary_search(now.begin(), now.end(), id) || book_.tasks.at(id).done;
  });
}

bool Supervisor::Core::hold(const Premises& then, const Premises& now) const {
  const auto listed = [](const std::set<TaskId>& ids) {
    return std::vector<TaskId>(ids.begin(), ids.end());
  };
  const bool moved =
      then.position && now.position && (*then.position - *now.position).norm() > kMovedAway;
  return all_done(then.standing, now.standing) &&
         all_done(listed(then.withdrawn), listed(now.withdrawn)) && then.goals == now.goals &&
         then.added == now.added && then.world == now.world && then.broken == now.broken &&
         then.next_id == now.next_id && !moved;
}

// ---- jobs ----

void Supervisor::Core::start_job() {
  give_way();
  if (job_) return;
  if (need_ && need_->not_before <= now_) start_repair();
  if (job_ || need_) return;
  if (!pending_.empty()) return start_insertion(pending_.front());
  if (!evaluations_.empty()) start_evaluation(evaluations_.front());
}

// A repair is not kept waiting by an insertion, nor either of them by an evaluation: these are
// begun again afterwards.
void Supervisor::Core::give_way() {
  if (!job_ || !job_->mission) return;
  if (need_ || (job_->evaluation && !pending_.empty())) abandon_job();
}

// What it says when it comes back counts for nothing.
void Supervisor::Core::abandon_job() {
  out_.push_back(StopDeliberation{job_->id});
  abandoned_.insert(job_->id);
  job_.reset();
}

void Supervisor::Core::run(Job job, DeliberationRequest request) {
  job.id = ++last_job_;
  auto shared = std::make_shared<const DeliberationRequest>(std::move(request));
  out_.push_back(StartDeliberation{job.id, std::move(shared)});
  job_ = std::move(job);
}

void Supervisor::Core::start_insertion(const Pending& pending) {
  reschedule();
  Job job;
  job.mission = pending.id;
  job.premises = premises_of_insertion(pending);
  InsertionRequest request;
  request.standing = book_.standing(job.premises.withdrawn);
  request.base = base_request(request.standing, job.premises.withdrawn);
  request.planned = book_.tasks_of(job.premises.goals);
  request.added = book_.tasks_of(job.premises.added);
  request.placement = pending.placement;
  request.any = pending.any;
  run(std::move(job), std::move(request));
}

void Supervisor::Core::start_evaluation(const Evaluation& evaluation) {
  reschedule();
  const mission::UnitMission& mission = evaluation.mission;
  Job job;
  job.mission = mission.id;
  job.evaluation = true;
  const Pending as_if{mission.id, mission.placement, mission.interrupt, mission.any, {}, now_};
  job.premises = premises_of_insertion(as_if);
  InsertionRequest request;
  request.standing = book_.standing(job.premises.withdrawn);
  request.standing.bounds = book_.bounds(mission.tasks);
  request.base = base_request(request.standing, job.premises.withdrawn);
  request.planned = book_.tasks_of(job.premises.goals);
  request.added = mission.tasks;
  request.placement = mission.placement;
  request.any = mission.any;
  run(std::move(job), std::move(request));
}

// What keeps it safe meanwhile is numbered before the plan that is to be made.
void Supervisor::Core::start_repair() {
  keep_safe();
  Need need = std::move(*need_);
  need_.reset();
  reschedule();
  Job job;
  job.premises = premises_of_repair();
  const std::vector<GoalId>& goals = job.premises.goals;
  if (goals.empty() && !(need.home && vehicle_.airborne)) {
    return decide({"6 repair", need.cause, "no goals", "nothing is left to plan", need.since});
  }
  RepairRequest request;
  request.standing = book_.standing();
  request.base = base_request(request.standing, {});
  request.refine_failed = need.refine;
  std::vector<GoalId> remaining = goals;
  const auto failed =
      need.failed ? std::find(remaining.begin(), remaining.end(), *need.failed) : remaining.end();
  if (failed != remaining.end()) {
    request.failed = book_.goals.at(*failed).task;
    request.failed_at = static_cast<std::size_t>(failed - remaining.begin());
    remaining.erase(failed);
  }
  request.remaining = book_.tasks_of(remaining);
  if (request.base.situation.airborne) request.retreat = own_task(kComeDown);
  job.retreat = request.retreat;
  job.need = std::move(need);
  run(std::move(job), std::move(request));
}

// False when it was tried so often that its result counts as none.
bool Supervisor::Core::again(const Job& job, const std::string& why) {
  int attempts = 0;
  if (job.mission) {
    const auto one = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const Pending& p) { return p.id == *job.mission; });
    if (one != pending_.end()) attempts = ++one->attempts;
  } else {
    Need merged = job.need;
    if (need_) {
      merged.cause += "; " + need_->cause;
      if (!merged.failed) merged.refine = need_->refine;
      if (!merged.failed) merged.failed = need_->failed;
      merged.home = merged.home || need_->home;
      merged.not_before = need_->not_before;
    }
    attempts = ++merged.attempts;
    need_ = std::move(merged);
  }
  if (attempts > kManyAttempts) {
    notice("job " + std::to_string(job.id) + " is made again for the " + std::to_string(attempts) +
           "th time: " + why);
  }
  return attempts <= kManyAttempts;
}

void Supervisor::Core::on(const JobFinished& input) {
  if (abandoned_.erase(input.job) != 0) return;
  if (!job_ || job_->id != input.job) {
    return notice("result of job " + std::to_string(input.job) + ", which nobody waits for");
  }
  const Job job = std::move(*job_);
  job_.reset();
  const auto* insertion = std::get_if<InsertionOutcome>(&input.result);
  if (job.evaluation && insertion != nullptr) return answer_evaluation(*insertion);
  const auto pending = std::find_if(pending_.begin(), pending_.end(),
                                    [&](const Pending& one) { return one.id == job.mission; });
  if (job.mission && pending == pending_.end()) return;
  const bool expected =
      std::holds_alternative<InsertionOutcome>(input.result) == job.mission.has_value();
  const Premises now = job.mission ? premises_of_insertion(*pending) : premises_of_repair();
  if (!expected || need_ || !hold(job.premises, now)) {
    again(job, "its premises no longer hold");
    return;
  }
  std::visit([&](const auto& outcome) { finish(job, outcome); }, input.result);
}

}  // namespace skein::supervisor
