// SPDX-License-Identifier: Apache-2.0
// High-level tasks, plans, hand-over and changes of degree on the status board.
#include <algorithm>
#include <utility>

#include "skein/ground_station/monitoring.hpp"

namespace skein::ground_station {

using mission::GoalState;
using mission::GoalStatus;
using mission::MissionId;

// ---- degrees ----

// What the board will show once all changes asked for are made.
Degree Monitoring::expected_degree(const Record& record) const {
  Degree degree = record.change ? record.change->wanted.degree : record.board.degree;
  for (const CommandNumber number : record.waiting) {
    const auto pending = pending_.find(number);
    if (pending == pending_.end()) continue;
    const auto* change = std::get_if<mission::ChangeDegree>(&pending->second.request);
    if (change != nullptr) degree = change->degree;
  }
  return degree;
}

void Monitoring::on(const ChangeHands& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "change of hands", effects);
  if (record == nullptr) return;
  mission::ChangeDegree change;
  if (input.way == ChangeHands::Way::kTake) {
    const Degree before = expected_degree(*record);
    if (!runs_at_ground(before)) record->board.degree_before_taken = before;
    change.degree = mission::kLeastDegree;
    change.interrupt = input.interrupt;
  } else if (record->board.degree_before_taken) {
    change.degree = *record->board.degree_before_taken;
  } else {
    effects.emplace_back(
        Anomaly{input.uav + " was not taken in hand: it cannot be given back", input.asked_by});
    return;
  }
  on(IssueCommand{input.uav, change, input.expires, input.asked_by}, now, effects);
}

void Monitoring::set_degree(Record& record, Degree degree, Effects& effects) {
  if (degree == record.board.degree) return;
  record.board.degree = degree;
  effects.emplace_back(DegreeChanged{record.board.name, degree});
}

void Monitoring::settle(Record& record, Effects& effects) {
  const std::optional<Degree> seen = record.change->seen;
  record.change.reset();
  if (seen) set_degree(record, *seen, effects);
  effects.emplace_back(ChangeSettled{record.board.name});
}

// What is accepted and makes a difference is settled by the hand-over that follows.
void Monitoring::settle_if_closed(Record& record, CommandNumber number, CommandState state,
                                  Effects& effects) {
  if (!record.change || record.change->command != number) return;
  if (state == CommandState::kExpired) record.unanswered = record.change->wanted;
  const bool acknowledged = state == CommandState::kAcknowledged;
  const bool hand_over_follows =
      acknowledged && record.change->wanted.degree != record.board.degree;
  record.tells_again = acknowledged && !hand_over_follows;
  if (!hand_over_follows) settle(record, effects);
}

void Monitoring::on(const HandOverReceived& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "hand-over", effects);
  if (record == nullptr) return;
  const mission::HandOver& hand_over = input.hand_over;
  if (input.at) record->degree_at = std::max(*input.at, record->degree_at.value_or(*input.at));
  const bool is_wanted = record->change && record->change->wanted.degree == hand_over.degree;
  const std::optional<mission::ChangeDegree> asked =
      is_wanted ? record->change->wanted : record->unanswered;
  const bool resumes = mission::deliberates(hand_over.degree) && asked &&
                       asked->degree == hand_over.degree && asked->resume;
  const bool told_again = std::exchange(record->tells_again, false);
  const bool unasked = !asked && !told_again && hand_over.degree == record->board.degree;
  record->unanswered.reset();
  set_degree(*record, hand_over.degree, effects);
  take_goals(*record, hand_over.goals, input.at, effects);
  effects.emplace_back(HandedOver{input.uav, hand_over, resumes});
  if (unasked) effects.emplace_back(PlanInterrupted{input.uav});
  if (!is_wanted) return;
  record->change->seen.reset();
  settle(*record, effects);
}

// ---- missions ----

void Monitoring::on(const MissionPlanReceived& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "plan", effects);
  if (record == nullptr) return;
  record->board.plan = input.plan;
  take_goals(*record, input.plan.goals, input.at, effects);
}

void Monitoring::on(const DecisionReceived& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "decision", effects);
  if (record == nullptr) return;
  std::deque<mission::Decision>& decisions = record->board.decisions;
  decisions.push_back(input.decision);
  if (decisions.size() > UavOnBoard::kDecisionsKept) decisions.pop_front();
}

void Monitoring::on(const MissionOutcomeReceived& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "outcome of a mission", effects);
  if (record == nullptr) return;
  const MissionStage feasible =
      input.outcome.evaluated ? MissionStage::kEvaluated : MissionStage::kPlanned;
  const MissionStage stage = input.outcome.planned ? feasible : MissionStage::kRefused;
  if (input.outcome.evaluated) record->board.evaluations[input.outcome.mission] = input.outcome;
  tell_stage(*record, input.outcome.mission, stage, effects);
}

// Plans and hand-overs come by different ways: the one that tells of a later instant counts.
void Monitoring::take_goals(Record& record, const std::vector<GoalStatus>& goals,
                            std::optional<MissionTime> at, Effects& effects) {
  if (at && record.goals_at && *at < *record.goals_at) return;
  if (at) record.goals_at = at;
  std::map<mission::GoalId, GoalState> before;
  for (const GoalStatus& goal : record.board.goals) before[goal.id] = goal.state;
  record.board.goals = goals;
  for (const GoalStatus& goal : goals) {
    const auto known = before.find(goal.id);
    if (known != before.end() && known->second == goal.state) continue;
    effects.emplace_back(GoalChanged{record.board.name, goal.id, goal.state});
  }
  tell_stages(record, effects);
}

void Monitoring::tell_stages(Record& record, Effects& effects) {
  struct Count {
    bool open = false, achieved = false, failed = false;
  };
  std::map<MissionId, Count> missions;
  for (const GoalStatus& goal : record.board.goals) {
    Count& count = missions[goal.mission];
    count.open = count.open || !mission::is_settled(goal.state);
    count.achieved = count.achieved || goal.state == GoalState::kAchieved;
    count.failed = count.failed || goal.state == GoalState::kFailed;
  }
  for (const auto& [mission, count] : missions) {
    if (count.open || !(count.failed || count.achieved)) continue;
    const MissionStage stage = count.failed ? MissionStage::kFailed : MissionStage::kAchieved;
    tell_stage(record, mission, stage, effects);
  }
}

void Monitoring::tell_stage(Record& record, MissionId mission, MissionStage stage,
                            Effects& effects) {
  const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(stage));
  const std::uint8_t told = record.told_missions.of(mission.value());
  if ((told & bit) != 0) return;
  record.told_missions.set(mission.value(), told | bit);
  effects.emplace_back(MissionChanged{record.board.name, mission, stage});
}

}  // namespace skein::ground_station
