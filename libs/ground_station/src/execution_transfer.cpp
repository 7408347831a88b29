// SPDX-License-Identifier: Apache-2.0
// Tasks go from a UAV's executive to the one here and back; what was only planned waits.
#include "skein/ground_station/ground_control.hpp"

#include "request_facts.hpp"
#include "task_places.hpp"

namespace skein::ground_station {

using mission::GoalId;
using mission::HeldTask;

// What was only planned is not carried out by anybody, at whatever degree below 4.
void GroundControl::take_over(const HandedOver& hand_over, MissionTime now, Effects& out) {
  const std::string& uav = hand_over.uav;
  std::vector<HeldTask> executed, planned;
  for (const HeldTask& task : hand_over.hand_over.tasks) {
    (task.in_executive ? executed : planned).push_back(task);
  }
  if (hand_over.resumes) {
    drop(uav, out);
  } else if (!planned.empty()) {
    hold(uav, std::move(planned), out);
  }
  if (!runs_at_ground(hand_over.hand_over.degree)) return;
  for (const executive::SyncReceived& last : syncs_.of(uav)) {
    do_errand(LocalInput{uav, last, std::nullopt}, now, out);
  }
  for (const HeldTask& task : executed) {
    if (task.origin != GoalId()) mles_.note_origin(uav, task.task.id, task.origin);
  }
  for (const Request& request : TaskPlaces(monitoring_, mles_).starting(uav, std::move(executed))) {
    do_errand(LocalInput{uav, *to_executive(request), std::nullopt}, now, out);
  }
}

// What its policy interrupted is over on board, and so are the ids of those tasks.
void GroundControl::hold(const std::string& uav, std::vector<HeldTask> tasks, Effects& out) {
  stand_ins_.stand_in(uav, tasks, [&](executive::TaskId id) {
    const std::optional<TaskOnBoard> task = monitoring_.find_task(uav, id);
    return task && !task->lost;
  });
  out.emplace_back(HeldPlanChanged{uav, held_.hold(uav, tasks), HeldState::kHeld});
}

// The UAV's executive asks for what is under way once more, so nothing is interrupted here. Who
// deliberates awaits what it knows to be under way before its plan goes on: that comes last, so
// that it has all the rest then.
void GroundControl::send_up(const std::string& uav, MissionTime now, Effects& out) {
  if (!mles_.runs(uav)) return;
  std::vector<HeldTask> tasks = mles_.let_go(uav);
  for (SendSync& kept : syncs_.for_sending(uav)) out.emplace_back(std::move(kept));
  const bool awaits = mission::deliberates(monitoring_.degree_of(uav));
  const FirstGiven first = awaits ? FirstGiven::kWaiting : FirstGiven::kUnderWay;
  const TaskPlaces places(monitoring_, mles_);
  for (Request& request : places.starting(uav, std::move(tasks), first)) {
    errands_.emplace_back(Monitoring::Input(
        IssueCommand{uav, std::move(request), now + transfer_lifetime_, "hand-over", true}));
  }
}

void GroundControl::resume(const ResumeHeld& request, Effects& out) {
  const std::size_t before = held_.of(request.uav).size();
  if (before == 0) {
    report({"no plan of '" + request.uav + "' is held that could be resumed", request.asked_by},
           out);
    return;
  }
  std::vector<HeldTask> tasks = held_.take(request.uav, request.without);
  const std::size_t dropped = before - tasks.size();
  if (dropped > 0) out.emplace_back(HeldPlanChanged{request.uav, dropped, HeldState::kDropped});
  if (!tasks.empty()) {
    out.emplace_back(HeldPlanChanged{request.uav, tasks.size(), HeldState::kResumed});
  }
  const TaskPlaces places(monitoring_, mles_);
  for (Request& start : places.starting(request.uav, std::move(tasks))) {
    errands_.emplace_back(Monitoring::Input(
        IssueCommand{request.uav, std::move(start), request.expires, request.asked_by}));
  }
}

// The UAV cannot stop what is carried out here, or held.
void GroundControl::give_up(const std::string& uav, GoalId goal, Effects& out) {
  const std::size_t count = held_.drop(uav, goal);
  if (count > 0) out.emplace_back(HeldPlanChanged{uav, count, HeldState::kDropped});
  for (const executive::TaskId task : mles_.open_tasks_of(uav, goal)) {
    errands_.emplace_back(LocalInput{uav, executive::Abort{task}, std::nullopt});
  }
}

void GroundControl::drop(const std::string& uav, Effects& out) {
  const std::size_t count = held_.drop(uav);
  if (count > 0) out.emplace_back(HeldPlanChanged{uav, count, HeldState::kDropped});
}

}  // namespace skein::ground_station
