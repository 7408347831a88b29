// SPDX-License-Identifier: Apache-2.0
// The interaction manager as a component: joint tasks, and the negotiations about them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "component.hpp"
#include "interaction/joint_host.hpp"
#include "interaction/joint_task.hpp"
#include "interaction/sightings.hpp"
#include "skein/foundation/tally.hpp"

namespace skein::decision_node {

/// Without interaction models, every joint task is refused.
class Interaction final : public Component {
 public:
  explicit Interaction(JointHost& host);

  /// This life begins: what was vowed in one before is not known.
  void start();
  /// Operator 4: negotiates roles and start, then answers the supervisor.
  void load(const supervisor::LoadJointTask& asked);
  /// The executive wants it carried out, or interrupted.
  void due(executive::TaskId task, bool interrupt);
  /// It is to end here; partners are told.
  void leave(executive::TaskId task, const std::string& why);
  bool is_over(executive::TaskId task) const;
  /// It is not agreed on yet, or not due; or where its role has the vehicle now, no constraint
  /// keeps it. What the role does there is not asked.
  bool needs_no_place(executive::TaskId task) const;
  /// Nobody decides here any more: all joint tasks are left, and their partners told.
  void leave_all(const std::string& why);

  void task_changed(const executive::TaskEvent& event) override;
  void vehicle_told(const world::Telemetry& telemetry) override;
  void place_told(const mission::ChangeWorld& told) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;
  void contact(const Contact& contact);
  void hear(const interaction::SessionMessage& message);
  void hear(const PartnerSeen& seen);
  void hear(const JointTaskTold& told);
  void reckoned(const ReckoningFinished& done);

  // ---- for its joint tasks ----

  /// Members and model are those of the joint task where none are named. False: refused, and said.
  bool begin(const Joint& joint, interaction::BeginNegotiation negotiation);
  void withdraw(const std::string& subject, const std::string& why);
  /// Since when it is out of reach; absent: it is in reach.
  std::optional<MissionTime> silent_since(const std::string& uav) const;
  /// The number of a new task of a role.
  executive::TaskId next_id();

 private:
  bool negotiate(const interaction::NegotiationInput& input);
  void carry_out(const interaction::SendSessionMessage& effect);
  void carry_out(const interaction::InvitedToNegotiate& effect);
  void carry_out(const interaction::PrepareOffer& effect);
  void carry_out(const interaction::ReckonResult& effect);
  void carry_out(const interaction::NegotiationEnded& effect);
  void carry_out(const interaction::NegotiationSettled& effect);
  void carry_out(const interaction::MessageRejected& effect);
  void stop_reckoning(const std::string& subject);
  void give_up_closed_ways(const world::VehicleState& state);
  JointTask* about(const std::string& subject);

  JointHost& host_;
  Sightings sightings_;
  std::optional<interaction::NegotiationManager> manager_;
  std::map<executive::TaskId, std::unique_ptr<JointTask>> tasks_;
  MissionTime born_;
  std::map<std::string, std::optional<MissionTime>> silent_since_;  ///< of whom contact was told
  std::uint64_t next_id_ = 0;
  std::map<std::uint64_t, interaction::SessionId> reckonings_;  ///< by job
  std::uint64_t last_reckoning_ = 0;
  Tally<std::pair<std::string, std::string>> rejected_{64};  ///< by who said it, and why
};

}  // namespace skein::decision_node
