// SPDX-License-Identifier: Apache-2.0
// What each scripted action asks of the other components.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/ground_station/mission_planning.hpp"

namespace skein::ground_station {

/// The actions of one step, or of an operator, done in their order.
class ScriptActions {
 public:
  struct Context {
    std::string asked_by;
    MissionTime expires;   ///< of their commands
    const Alarm* subject;  ///< that targets refer to; null: there is none
    const world::Terrain& terrain;
  };
  /// `effects`: where what they ask for is added.
  ScriptActions(Context of, std::vector<MissionPlanning::Effect>& effects)
      : of_(std::move(of)), effects_(effects) {}

  void perform(const Action& action) {
    std::visit([this](const auto& one) { on(one); }, action);
  }
  /// Whether the mission was ended by one.
  bool finished() const { return finished_; }

 private:
  void on(const SendPlan& action);
  void on(const AbortTasks& action);
  void on(const SendMessage& action);
  void on(const UpdateConditions& action);
  void on(const SendMission& action);
  void on(const CancelMission& action);
  void on(const SetDegree& action);
  void on(const TakeInHand& action);
  void on(const GiveBack& action);
  void on(const ResumePlan& action);
  void on(const DropPlan& action);
  void on(const CloseAir& action);
  void on(const OpenAir& action);
  void on(const TellWorld& action);
  void on(const SendGlobalMission& action);
  // The team and the partners are told them as they are.
  void on(const DeclareLost& action) { effects_.emplace_back(action); }
  void on(const DeclareFound& action) { effects_.emplace_back(action); }
  void on(const PlayRole& action);
  void on(const Finish& action);

  void issue(const std::string& uav, Request request);
  void tell(const mission::ChangeWorld& change, const std::vector<std::string>& uavs);
  /// Replaces arguments by their resolved targets; returns why that fails, empty if it does not.
  std::string put_targets(const std::vector<ArgumentTarget>& targets,
                          const std::vector<mission::HighLevelTask*>& tasks) const;

  Context of_;
  std::vector<MissionPlanning::Effect>& effects_;
  bool finished_ = false;
};

}  // namespace skein::ground_station
