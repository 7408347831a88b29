// SPDX-License-Identifier: Apache-2.0
// Playing a role of a joint task.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interaction/area_share.hpp"
#include "interaction/joint_host.hpp"
#include "interaction/places.hpp"
#include "interaction/role_play.hpp"
#include "interaction/role_record.hpp"
#include "interaction/sightings.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

class Interaction;
class JointTask;

inline constexpr const char* kAreaSharing = "area-sharing";

/// The holders of the roles of a joint task, and this UAV's phase in it.
struct Membership {
  Joint joint;
  interaction::JointPhase phase = interaction::JointPhase::kLoading;
  std::string why = {};
  Holders holders = {};
  std::string allocation = {};  ///< the session in which the roles were agreed

  /// The parties of a coordination action: `self`, which plays `role`, and all holders of roles
  /// that share the action, by name.
  std::vector<std::string> parties_of(const std::string& role, const std::string& action,
                                      const std::string& self) const;
};

/// Carries out what a role asks for: tasks, places, negotiations in flight. When another role is
/// agreed, it begins once the running tasks of the old role are over.
class JointPlay {
 public:
  /// References that must outlive the JointPlay.
  struct Surroundings {
    JointHost& host;
    Interaction& interaction;
    const Sightings& sightings;
    JointTask& task;
    Membership& my;
  };
  explicit JointPlay(const Surroundings& of);

  void begin(const std::string& role);
  bool has_begun() const { return play_.has_value(); }
  bool needs_no_place() const { return play_ && !play_->is_bound(); }
  /// Queues an input for the role, behind those already queued.
  void tell(const interaction::Input& input);
  void leave();
  /// All that are not over; where the role has done what it was for they do not fail it.
  void abort_tasks(bool is_done);

  // ---- others ----
  /// Whether the role can go on without a member that left.
  bool goes_on_without() const;
  /// Whether a task of the role was done for as long as was asked.
  bool has_done_its_part() const;
  /// Whether what the role was for is done: it has only flights left.
  bool has_only_flights_left() const;
  /// The same, and its partners have ended their roles.
  bool nothing_is_left_together() const;
  void lose(const std::string& uav);
  void partner_has_left(const std::string& uav, const interaction::Rows& rest) {
    share_.told(uav, rest);
  }
  /// A partner goes on without this UAV, and with what it has of an area.
  void leave_share_to(const std::string& uav) { share_.leave_to(uav); }
  Result<interaction::Rows, Failure> offer_of_area() const;
  void decided(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);

  // ---- what happens ----
  void task_changed(const executive::TaskEvent& event);
  /// Checks conditions against the vehicle's state; false: no role is being played. Precondition:
  /// the position of this UAV is known.
  bool watch();
  void time_passes();
  std::optional<MissionTime> next_wakeup() const;
  void tell_of(interaction::JointTaskStatus& status) const;

 private:
  MissionTime now() const;
  Outlook outlook() const;
  void tell_status(const std::string& componel, interaction::Status::Word word);
  /// Gives the executive a task of the role; returns its id.
  executive::TaskId give(const std::string& componel, executive::Task task,
                         std::optional<executive::TaskId> along = {});
  /// A task of the role: to the executive, or over at once.
  void run(const std::string& componel);
  /// Tries a task anew that the vehicle gave up after it `ran`; false: it does not.
  bool begin_again(const std::string& componel, Duration ran);
  /// Begins meetings that are under way anew, without those who hold no role any more.
  void meet_without_the_lost();
  /// Leaves a role that has nothing more to do after this task was given up.
  void leave_if_stuck(const std::string& componel, const std::string& why);
  void carry_out(const interaction::StateChanged& effect);
  void carry_out(const interaction::Compute& effect);
  void carry_out(const interaction::Run& effect) {
    record_.asked_for(effect.task);
    run(effect.task);
  }
  void carry_out(const interaction::Negotiate& effect);
  void carry_out(const interaction::Interrupt& effect);
  void carry_out(const interaction::Withdraw& effect);
  void carry_out(const interaction::Read&) {}
  void carry_out(const interaction::ModelOver& effect);
  void roles_agreed(const interaction::Terms& terms,
                    const interaction::NegotiationOutcome& outcome);
  /// After a flight that got no air once all partners had ended: the role is over, or left.
  void stay_without_air(const std::string& componel, const std::string& why);
  /// Leaves the joint task after a task that failed as soon as it began.
  void leave_if_in_vain(const std::string& componel, const std::string& why);
  void negotiate_roles(const std::string& action, const std::string& modality);
  // joint_places.cpp
  void negotiate_places(const std::string& action);
  void take_place_alone(const interaction::BeginNegotiation& begin);
  void places_agreed(const interaction::Terms& terms,
                     const interaction::NegotiationOutcome& outcome);
  /// Ends a componel whose task cannot be carried out.
  void fail(const std::string& componel, const std::string& why);
  // joint_follow.cpp
  void follow(const std::string& componel);
  std::optional<std::string> fly_after(const std::string& componel);
  void look_after_followed();
  bool flew_after(const executive::TaskEvent& event, const std::string& componel);
  // joint_sharing.cpp
  SweepSetting sweep_setting(const std::string& role) const;
  void share_area(const std::string& action);
  void area_shared(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);
  void map_area(const std::string& componel);
  void look_changed(const executive::TaskEvent& event);

  JointHost& host_;
  Interaction& interaction_;
  const Sightings& sightings_;
  JointTask& task_;
  Membership& my_;
  const std::string& self_;

  std::optional<RolePlay> play_;
  std::uint64_t plays_ = 0;
  std::optional<std::string> next_role_;            ///< the role after the current one
  std::map<executive::TaskId, std::string> tasks_;  ///< unfinished tasks to their componels
  RoleRecord record_;
  std::map<std::string, std::string> actions_;  ///< actions under negotiation, to their subjects
  /// After the members agreed that all keep their roles, no new role negotiation before this.
  std::optional<MissionTime> roles_stand_until_;
  /// A target that is followed, and the place beside it.
  struct Following {
    std::string target;
    interaction::Position side{};     ///< horizontal offset from the target [m]
    interaction::Position seen_at{};  ///< the target's position at the last flight after it
    double height = 0;                ///< above the ground [m]
    bool flies = false;
  };
  std::map<std::string, Following> following_;  ///< by componel
  AreaShare share_;
  /// A negotiation to be repeated since nothing was agreed.
  struct Again {
    std::string action;
    std::optional<MissionTime> at;  ///< absent: under negotiation
    MissionTime until;
    std::string why = {};  ///< nothing was agreed the last time
    bool is_due(MissionTime now) const { return at && *at <= now; }
  };
  std::optional<Again> sharing_again_, places_again_;
  std::map<executive::TaskId, executive::TaskId>
      looks_;  ///< unfinished perceptions to their flights
};

}  // namespace skein::decision_node
