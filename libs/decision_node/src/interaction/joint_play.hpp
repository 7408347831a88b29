// SPDX-License-Identifier: Apache-2.0
// The role of a joint task, as it is played.
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
#include "interaction/sightings.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

class Interaction;
class JointTask;

inline constexpr const char* kAreaSharing = "area-sharing";

/// Who holds which role in a joint task, and where this UAV stands in it.
struct Membership {
  Joint joint;
  interaction::JointPhase phase = interaction::JointPhase::kLoading;
  std::string why = {};
  Holders holders = {};
  std::string allocation = {};  ///< the session in which they were agreed

  /// `self`, who plays `role`, and all who hold a role of which an action belongs to that one, in
  /// the order of their names.
  std::vector<std::string> parties_of(const std::string& role, const std::string& action,
                                      const std::string& self) const;
};

/// What a role asks for is carried out: tasks, places, negotiations in flight. Roles that are
/// agreed to be others are begun anew, once what runs of the old one is over.
class JointPlay {
 public:
  /// All of them outlive it.
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
  /// Its role hears it after all that was asked before.
  void tell(const interaction::Input& input);
  void leave();
  void abort_tasks();

  // ---- others ----
  /// Its role can do without one that left.
  bool goes_on_without() const;
  void lose(const std::string& uav);
  void partner_has_left(const std::string& uav, const interaction::Rows& rest) {
    share_.told(uav, rest);
  }
  Result<interaction::Rows, Failure> offer_of_area() const;
  void decided(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);

  // ---- what happens ----
  void task_changed(const executive::TaskEvent& event);
  /// Precondition: it is known where this UAV is. False: nothing is played.
  bool watch();
  void time_passes();
  std::optional<MissionTime> next_wakeup() const;
  void tell_of(interaction::JointTaskStatus& status) const;

 private:
  MissionTime now() const;
  Outlook outlook() const;
  void tell_status(const std::string& componel, interaction::Status::Word word);
  /// Its number.
  executive::TaskId give(const std::string& componel, executive::Task task,
                         std::optional<executive::TaskId> along = {});
  void carry_out(const interaction::StateChanged& effect);
  void carry_out(const interaction::Compute& effect);
  void carry_out(const interaction::Run& effect);
  void carry_out(const interaction::Negotiate& effect);
  void carry_out(const interaction::Interrupt& effect);
  void carry_out(const interaction::Withdraw& effect);
  void carry_out(const interaction::Read&) {}
  void carry_out(const interaction::ModelOver& effect);
  void roles_agreed(const interaction::Terms& terms,
                    const interaction::NegotiationOutcome& outcome);
  /// For how long it ran.
  Duration note_done(const std::string& componel);
  /// Of a task that failed as it began.
  void leave_if_in_vain(const std::string& componel, const std::string& why);
  void negotiate_roles(const std::string& action, const std::string& modality);
  // joint_places.cpp
  void negotiate_places(const std::string& action);
  void take_place_alone(const interaction::BeginNegotiation& begin);
  void places_agreed(const interaction::Terms& terms,
                     const interaction::NegotiationOutcome& outcome);
  /// Of a task that cannot be carried out.
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
  std::optional<std::string> next_role_;            ///< once the one now is over
  std::map<executive::TaskId, std::string> tasks_;  ///< componels of those that are not over
  std::map<std::string, Duration> done_;            ///< of perceptions, by componel
  std::map<std::string, MissionTime> running_since_;
  std::map<std::string, std::string> actions_;  ///< subject by action, negotiated now
  /// Members have just agreed that all keep their roles: nobody asks them again so soon.
  std::optional<MissionTime> roles_stand_until_;
  std::set<executive::TaskId> interrupted_;  ///< as the role asked
  /// What it follows, and where it stays meanwhile.
  struct Following {
    std::string target;
    interaction::Position side{};     ///< of it, on the level [m]
    interaction::Position seen_at{};  ///< when it was last flown after
    double height = 0;                ///< over the ground [m]
    bool flies = false;
  };
  std::map<std::string, Following> following_;  ///< by componel
  AreaShare share_;
  /// What was not agreed is negotiated again.
  struct Again {
    std::string action;
    std::optional<MissionTime> at;  ///< absent: it is being negotiated
    MissionTime until;
    bool is_due(MissionTime now) const { return at && *at <= now; }
  };
  std::optional<Again> sharing_again_, places_again_;
  std::set<std::string> fails_at_once_;  ///< tasks of the role, when they last began
  std::map<executive::TaskId, executive::TaskId> looks_;  ///< the flight of each that is not over
  std::map<std::string, std::string> failed_;  ///< why, by task of the role; not done since
};

}  // namespace skein::decision_node
