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
#include "interaction/aborts.hpp"
#include "interaction/joint_host.hpp"
#include "interaction/joint_task.hpp"
#include "interaction/partner_refusals.hpp"
#include "interaction/sightings.hpp"
#include "interaction/strange_requests.hpp"
#include "skein/foundation/rising.hpp"
#include "skein/foundation/tally.hpp"

namespace skein::decision_node {

/// Refuses every joint task if there are no interaction models.
class Interaction final : public Component {
 public:
  explicit Interaction(JointHost& host);

  /// To be called first: promises made in an earlier life of the node are not known.
  void start();
  /// Operator 4: negotiates roles and start, then answers the supervisor.
  void load(const supervisor::LoadJointTask& asked);
  /// The executive starts a joint task, or interrupts it.
  void due(executive::TaskId task, bool interrupt);
  /// Ends a joint task on this UAV; partners are told.
  void leave(executive::TaskId task, const std::string& why);
  /// A goal of this UAV is not reached: if it is a joint task, its partners are told, now and when
  /// they ask for it, that this UAV takes no part.
  void given_up(const mission::HighLevelTask& goal, const std::string& why);
  bool is_over(executive::TaskId task) const;
  /// Whether the vehicle may move away without breaking a constraint of the joint task: it is not
  /// agreed or not due yet, or no constraint holds in the current state of the role.
  bool needs_no_place(executive::TaskId task) const;
  /// Leaves all joint tasks, since this node stops deciding; partners are told.
  void leave_all(const std::string& why);

  void task_changed(const executive::TaskEvent& event) override;
  void vehicle_told(const world::Telemetry& telemetry) override;
  void place_told(const mission::ChangeWorld& told) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;
  void hear(const interaction::SessionMessage& message);
  void hear(const PartnerSeen& seen);
  void hear(const JointTaskTold& told);
  void reckoned(const ReckoningFinished& done);

  // ---- for its joint tasks ----

  /// Begins a negotiation. Members and model default to those of the joint task. False: refused;
  /// the refusal is journaled.
  bool begin(const Joint& joint, interaction::BeginNegotiation negotiation);
  void withdraw(const std::string& subject, const std::string& why);
  Partners& partners() { return host_.partners(); }
  PartnerRefusals& refusals() { return refusals_; }
  /// What partners ask for that is not asked for here.
  const StrangeRequests& strange() const { return strange_; }
  /// Until when at most this UAV waits for joint tasks that come before this one in its plan and
  /// are not agreed on; absent: there is none.
  std::optional<MissionTime> engaged_until(executive::TaskId task) const;
  /// A joint task is agreed on, is not any more, or is over: later ones may wait for it.
  void phase_changed();
  /// Of the tasks of all roles.
  Aborts& aborts() { return aborts_; }
  /// The id for a new task of a role.
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
  void forget_what_is_over();
  EarlierAttempts attempts_at(const std::string& subject) const;
  void give_up_closed_ways(const world::VehicleState& state);
  JointTask* about(const std::string& subject);

  JointHost& host_;
  Sightings sightings_;
  std::optional<interaction::NegotiationManager> manager_;
  std::map<executive::TaskId, std::unique_ptr<JointTask>> tasks_;
  PartnerRefusals refusals_;
  StrangeRequests strange_;
  std::map<executive::TaskId, world::Vector3> flights_;  ///< of roles, under way, and from where
  Aborts aborts_;
  Rising ids_;  ///< of tasks of roles, from the first one on
  std::map<std::uint64_t, interaction::SessionId> reckonings_;  ///< by job
  std::uint64_t last_reckoning_ = 0;
  Tally<std::pair<std::string, std::string>> rejected_{64};  ///< messages, by sender and reason
};

}  // namespace skein::decision_node
