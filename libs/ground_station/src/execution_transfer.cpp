// SPDX-License-Identifier: Apache-2.0
// Tasks go from a UAV's executive to the one here and back; what was only planned waits.
#include "skein/ground_station/ground_control.hpp"

#include "request_facts.hpp"
#include "transfer_requests.hpp"

namespace skein::ground_station {

using mission::GoalId;
using mission::HeldTask;

std::vector<Request> GroundControl::requests_for(const std::string& uav,
                                                 std::vector<HeldTask> tasks) const {
  TransferFacts facts;
  facts.state_of = [&](executive::TaskId id) -> std::optional<executive::TaskState> {
    const std::optional<TaskOnBoard> task = monitoring_.find_task(uav, id);
    if (!task || task->lost) return std::nullopt;
    return task->state;
  };
  facts.messages = monitoring_.messages_of(uav);
  return requests_to_start(std::move(tasks), facts);
}

// A task that was over before a transfer is unknown to the executive that got the rest.
Request GroundControl::for_receiver(const SendRequest& request, bool is_here) const {
  const auto mle = local_.find(request.uav);
  return without_settled(
      request.request, [&](executive::TaskId id) -> std::optional<executive::TaskState> {
        const std::optional<TaskOnBoard> task = monitoring_.find_task(request.uav, id);
        if (!task || task->lost || !executive::is_terminal(task->state)) return {};
        const bool is_known =
            is_here ? mle != local_.end() && mle->second.executive.find(id) : !task->at_ground;
        if (is_known || monitoring_.is_being_started(request.uav, id)) return {};
        return task->state;
      });
}

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
  for (const auto& [key, last] : syncs_[uav]) {
    do_errand(LocalInput{uav, last, std::nullopt}, now, out);
  }
  for (const HeldTask& task : executed) {
    if (task.origin != GoalId()) local(uav).origins[task.task.id] = task.origin;
  }
  for (const Request& request : requests_for(uav, std::move(executed))) {
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

// The UAV's executive asks for what is under way once more, so nothing is interrupted here.
void GroundControl::send_up(const std::string& uav, MissionTime now, Effects& out) {
  const auto mle = local_.find(uav);
  if (mle == local_.end()) return;
  const executive::Executive& executive = mle->second.executive;
  std::vector<HeldTask> tasks;
  for (const executive::TaskStatus& status : executive.tasks()) {
    if (executive::is_terminal(status.state) || status.id >= executive::kFirstBackgroundId)
      continue;
    const executive::TaskView view = *executive.find(status.id);
    HeldTask held;
    held.task = {view.id,
                 view.type,
                 view.parameters,
                 executive.preconditions(view.id),
                 executive.exit_conditions(view.id),
                 std::nullopt};
    if (view.synchronisation != nullptr) held.task.synchronisation = *view.synchronisation;
    held.state = view.state;
    held.in_executive = true;
    tasks.push_back(std::move(held));
  }
  local_.erase(mle);
  send_kept_syncs(uav, out);
  for (Request& request : requests_for(uav, std::move(tasks))) {
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
  for (Request& start : requests_for(request.uav, std::move(tasks))) {
    errands_.emplace_back(Monitoring::Input(
        IssueCommand{request.uav, std::move(start), request.expires, request.asked_by}));
  }
}

// The UAV cannot stop what is carried out here, or held.
void GroundControl::give_up(const std::string& uav, GoalId goal, Effects& out) {
  const std::size_t count = held_.drop(uav, goal);
  if (count > 0) out.emplace_back(HeldPlanChanged{uav, count, HeldState::kDropped});
  const auto mle = local_.find(uav);
  if (mle == local_.end()) return;
  for (const auto& [task, origin] : mle->second.origins) {
    const auto view = mle->second.executive.find(task);
    if (origin == goal && view && !executive::is_terminal(view->state))
      errands_.emplace_back(LocalInput{uav, executive::Abort{task}, std::nullopt});
  }
}

void GroundControl::drop(const std::string& uav, Effects& out) {
  const std::size_t count = held_.drop(uav);
  if (count > 0) out.emplace_back(HeldPlanChanged{uav, count, HeldState::kDropped});
}

}  // namespace skein::ground_station
