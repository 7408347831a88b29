// SPDX-License-Identifier: Apache-2.0
#include "jobs/jobs.hpp"

#include <algorithm>
#include <utility>

namespace skein::supervisor {

Jobs::Jobs(const Rooms& rooms)
    : situations_(rooms.situations),
      beliefs_(rooms.beliefs),
      own_goals_(rooms.own_goals),
      committer_(rooms.committer),
      results_(rooms.results),
      agenda_(rooms.agenda),
      out_(rooms.out),
      book_(rooms.book) {}

Premises Jobs::premises_of_insertion(const Pending& pending) const {
  std::set<TaskId> interrupted;
  if (pending.placement == mission::Placement::kFirst && pending.interrupt)
    interrupted = urgently_interrupted(book_);
  else if (pending.in_parts)
    interrupted = interrupted_between_parts(book_);
  Premises result = premises_of(book_, beliefs_, interrupted);
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    if (goal.queued && goal.mission == pending.id) result.added.push_back(id);
  }
  return result;
}

void Jobs::start() {
  if (agenda_.repair_is_due()) start_repair();
  if (agenda_.job() || agenda_.needed()) return;
  if (!agenda_.pending().empty()) return start_insertion(agenda_.pending().front());
  if (!agenda_.evaluations().empty()) start_evaluation(agenda_.evaluations().front());
}

PlanningRequest Jobs::base(const Standing& standing, const std::set<TaskId>& withdrawn) const {
  return situations_.base_request(standing, withdrawn, agenda_.next_job(), now());
}

InsertionRequest Jobs::insertion(const Premises& premises,
                                 const std::vector<mission::HighLevelTask>& added,
                                 mission::Placement placement, bool any) const {
  InsertionRequest request;
  request.standing = book_.standing(premises.withdrawn);
  request.standing.bounds = book_.bounds(added);
  request.base = base(request.standing, premises.withdrawn);
  request.planned = book_.tasks_of(premises.goals);
  request.added = added;
  request.placement = placement;
  request.any = any;
  if (const auto part = own_goals_.next(kMapPart)) request.part = part->id;
  return request;
}

void Jobs::start_insertion(const Pending& pending) {
  committer_.reschedule();
  Job job;
  job.mission = pending.id;
  job.premises = premises_of_insertion(pending);
  InsertionRequest request =
      insertion(job.premises, book_.tasks_of(job.premises.added), pending.placement, pending.any);
  agenda_.run(std::move(job), std::move(request));
}

void Jobs::start_evaluation(const Evaluation& evaluation) {
  committer_.reschedule();
  const mission::UnitMission& mission = evaluation.mission;
  Job job;
  job.mission = mission.id;
  job.evaluation = true;
  job.premises = premises_of_insertion({mission.id,
                                        mission.placement,
                                        mission.interrupt,
                                        mission.any,
                                        {},
                                        now(),
                                        0,
                                        evaluation.in_parts});
  InsertionRequest request = insertion(job.premises, mission.tasks, mission.placement, mission.any);
  agenda_.run(std::move(job), std::move(request));
}

void Jobs::start_repair() {
  Need need = agenda_.take_need();
  committer_.reschedule();
  Job job;
  job.premises = premises_of(book_, beliefs_);
  const std::vector<GoalId>& goals = job.premises.goals;
  if (goals.empty() && !(need.home && beliefs_.vehicle().airborne)) {
    return out_.decide({"6 repair", need.cause, "no goals", "nothing is left to plan", need.since});
  }
  RepairRequest request;
  request.standing = book_.standing();
  request.base = base(request.standing, {});
  request.refine_failed = need.refine;
  request.failed_goes_behind = need.behind;
  std::vector<GoalId> remaining = goals;
  const auto failed =
      need.failed ? std::find(remaining.begin(), remaining.end(), *need.failed) : remaining.end();
  if (failed != remaining.end()) {
    request.failed = book_.goals.at(*failed).task;
    request.failed_at = static_cast<std::size_t>(failed - remaining.begin());
    const mission::MissionId mission = book_.goals.at(*failed).mission;
    remaining.erase(failed);
    for (const GoalId id : remaining)
      if (book_.goals.at(id).mission == mission) request.given_with_failed.insert(id);
  }
  request.remaining = book_.tasks_of(remaining);
  if (request.base.situation.airborne) request.retreat = own_goals_.next(kComeDown);
  job.retreat = request.retreat;
  job.need = std::move(need);
  agenda_.run(std::move(job), std::move(request));
}

void Jobs::finished(const JobFinished& input) {
  const std::optional<Job> job = agenda_.finished(input.job);
  if (!job) return;
  const auto* insertion = std::get_if<InsertionOutcome>(&input.result);
  if (job->evaluation && insertion != nullptr) return results_.answer_evaluation(*job, *insertion);
  const Pending* pending = job->mission ? agenda_.find(*job->mission) : nullptr;
  if (job->mission && pending == nullptr) return;
  const bool expected = (insertion != nullptr) == job->mission.has_value();
  const Premises now =
      pending != nullptr ? premises_of_insertion(*pending) : premises_of(book_, beliefs_);
  if (!expected || agenda_.needed() || !hold(job->premises, now, book_)) {
    agenda_.again(*job, "its premises no longer hold");
    return;
  }
  std::visit([&](const auto& outcome) { results_.finish(*job, outcome); }, input.result);
}

}  // namespace skein::supervisor
