// SPDX-License-Identifier: Apache-2.0
// The supervisor as a component.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "component.hpp"

namespace skein::decision_node {

class Core;

/// Without a planning domain there is no supervisor: events are not passed on, and requests that
/// need one are refused.
class Deliberation final : public Component {
 public:
  explicit Deliberation(Core& core);

  void take(const Command& command) override;
  void task_changed(const executive::TaskEvent& event) override;
  void vehicle_told(const world::Telemetry& telemetry) override;
  void place_told(const mission::ChangeWorld& told) override;
  void begin(const Started& started);
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

  /// Whether there is a supervisor.
  bool possible() const { return supervisor_.has_value(); }
  bool engaged() const { return supervisor_ && supervisor_->engaged(); }
  void engage(const supervisor::Engage& engage) { tell(engage); }
  void disengage(const std::string& cause);
  void job_finished(const supervisor::JobFinished& done) { tell(done); }
  void request_answered(const executive::Reply& reply);
  /// Plans a task of the team like a user's mission; the answer goes to team().mission_answered().
  void take_for_team(const mission::UnitMission& mission);
  void cancel_for_team(mission::GoalId goal, const std::string& why);
  void partners_seen(const supervisor::PartnersSeen& seen) { tell(seen); }
  void orders_seen(const supervisor::OrdersSeen& seen) { tell(seen); }
  void joint_task_answered(const supervisor::JointTaskAnswered& answer) { tell(answer); }
  /// The executive starts a joint task, or interrupts it.
  void joint_task_due(executive::TaskId task, bool interrupt);

  std::vector<mission::GoalStatus> goals() const;
  /// Precondition: possible().
  const mission::PlanReport& report() const { return supervisor_->report(); }
  /// The world as the supervisor believes it. Precondition: possible().
  std::shared_ptr<const world::World> world() const { return supervisor_->world(); }
  /// The plan goes on without the task, which ended or was lost: nobody is to begin it any more.
  bool has_given_up(executive::TaskId task) const {
    return supervisor_ && supervisor_->has_given_up(task);
  }
  /// The goal that an executive's task serves; 0: none.
  mission::GoalId origin_of(executive::TaskId task) const;
  /// Records that a task of a role serves the goal of its joint task.
  void serves(executive::TaskId role_task, executive::TaskId joint) {
    origins_[role_task] = origin_of(joint);
  }
  /// The tasks handed over at the last disengagement; returned once.
  std::vector<mission::HeldTask> take_handed_over();

 private:
  /// Who gets the supervisor's answer.
  struct Asker {
    std::optional<Command> command;
    std::optional<mission::MissionId> team;  ///< a mission of the team's
  };
  void tell(supervisor::Input input, Asker asker = {});
  std::string why_not_planned() const;

  void carry_out(const supervisor::Answer& effect, const Asker& asker);
  void carry_out(const supervisor::ToExecutive& effect, const Asker&);
  void carry_out(const supervisor::GoalChanged& effect, const Asker&);
  void carry_out(const supervisor::PlanChanged& effect, const Asker&);
  void carry_out(const supervisor::HandedOver& effect, const Asker&);
  void carry_out(const supervisor::NotGivenBack& effect, const Asker& asker);
  void carry_out(const supervisor::LoadJointTask& effect, const Asker&);
  void carry_out(const supervisor::FrontierChanged& effect, const Asker&);
  void carry_out(const supervisor::Notice& effect, const Asker&);
  /// Every other effect leaves the node unchanged.
  template <class Other>
  void carry_out(const Other& effect, const Asker&);

  Core& core_;
  std::optional<supervisor::Supervisor> supervisor_;
  std::map<executive::TaskId, mission::GoalId> origins_;
  std::vector<mission::HeldTask> handed_over_;
  std::map<std::string, world::Vector3>
      planned_with_;  ///< last planned positions of moving objects
};

}  // namespace skein::decision_node
