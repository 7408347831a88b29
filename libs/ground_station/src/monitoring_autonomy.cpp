// SPDX-License-Identifier: Apache-2.0
// High-level tasks, plans, hand-over and changes of degree on the status board.
#include <utility>

#include "skein/ground_station/monitoring.hpp"

namespace skein::ground_station {

namespace {

void append(const std::vector<MissionProgress::Change>& changes,
            std::vector<Monitoring::Effect>& effects) {
  for (const MissionProgress::Change& change : changes) {
    std::visit([&](const auto& it) { effects.emplace_back(it); }, change);
  }
}

}  // namespace

// ---- degrees ----

void Monitoring::on(const ChangeHands& input, MissionTime now, Effects& effects) {
  Record* record = find(input.uav, "change of hands", effects);
  if (record == nullptr) return;
  mission::ChangeDegree change;
  if (input.way == ChangeHands::Way::kTake) {
    const Degree before = commands_.last_degree_of(record->waiting)
                              .value_or(record->change.expected(record->board.degree));
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
  if (const auto seen = record.change.settle()) set_degree(record, *seen, effects);
  effects.emplace_back(ChangeSettled{record.board.name});
}

void Monitoring::on(const HandOverReceived& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "hand-over", effects);
  if (record == nullptr) return;
  const mission::HandOver& hand_over = input.hand_over;
  const Degree before = record->board.degree;
  const auto meaning = record->change.handed_over(hand_over.degree, before, input.at);
  set_degree(*record, hand_over.degree, effects);
  UavOnBoard& board = record->board;
  append(record->missions.take(board.name, board.goals, hand_over.goals, input.at), effects);
  effects.emplace_back(HandedOver{input.uav, hand_over, meaning.resumes});
  if (meaning.unasked) effects.emplace_back(PlanInterrupted{input.uav});
  if (meaning.wanted) settle(*record, effects);
}

// ---- missions ----

void Monitoring::on(const MissionPlanReceived& input, MissionTime, Effects& effects) {
  Record* record = find(input.uav, "plan", effects);
  if (record == nullptr) return;
  UavOnBoard& board = record->board;
  board.plan = input.plan;
  append(record->missions.take(board.name, board.goals, input.plan.goals, input.at), effects);
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
  if (auto change = record->missions.stage(input.uav, input.outcome.mission, stage)) {
    effects.emplace_back(std::move(*change));
  }
}

}  // namespace skein::ground_station
