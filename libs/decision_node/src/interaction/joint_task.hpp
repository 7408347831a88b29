// SPDX-License-Identifier: Apache-2.0
// The life of one joint task at one of its UAVs.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interaction/area_share.hpp"
#include "interaction/joint_host.hpp"
#include "interaction/places.hpp"
#include "interaction/role_play.hpp"
#include "interaction/sightings.hpp"
#include "skein/decision_node/messages.hpp"
#include "skein/interaction/joint_task_status.hpp"
#include "skein/interaction/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

class Interaction;

inline constexpr const char* kAreaSharing = "area-sharing";

///   from      on                                                   to
///   loading   roles and start are agreed                           loaded
///   loading   neither is agreed when it is to start at the latest  not-loaded
///   loaded    a partner left, or cannot begin then any more        loading
///   loaded    the executive wants it carried out                   running
///   running   its role ends                                        ended
///   any       interrupted, a partner left or is lost               leaving, aborted
///
/// A role that listens to "member lost" goes on without a partner that left or is lost.
///
/// What failed to be agreed is negotiated again until it is to start at the latest. Roles that are
/// agreed to be others while it runs are begun anew, once what runs of the old one is over. Source:
/// T IV.3, T V.3, spec 7.2 to 7.4.
class JointTask {
 public:
  JointTask(JointHost& host, Interaction& interaction, Joint joint,
            std::vector<mission::Interval> preferences, const Sightings& sightings);

  const Joint& joint() const { return joint_; }
  interaction::JointPhase phase() const { return phase_; }
  bool over() const { return interaction::is_over(phase_); }

  /// It is loading or loaded.
  bool is_to_begin() const;
  void load();
  /// The plan has it with another number, or it can begin at other times.
  void ask_again(executive::TaskId task, std::vector<mission::Interval> preferences);
  /// The executive wants it carried out.
  void due();
  /// It is to end here; partners are told.
  void leave(const std::string& why);
  /// The same, without waiting for what is being stopped.
  void leave_at_once(const std::string& why);
  std::vector<std::string> partners() const;

  // ---- negotiation ----
  bool is_about(const std::string& subject) const;
  void invited(const interaction::Terms& terms);
  Result<interaction::Rows, Failure> offer_for(const interaction::Terms& terms) const;
  /// At the end of a session, or later when what was undecided is known.
  void decided(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);

  // ---- what happens ----
  void task_changed(const executive::TaskEvent& event);
  /// Something was seen: are the constraints kept?
  void watch();
  void partner_told(const interaction::JointTaskStatus& status, MissionTime at);
  void partner_in_reach(const std::string& uav, bool reachable);
  void time_passes();
  std::optional<MissionTime> next_wakeup() const;

 private:
  MissionTime now() const;
  Outlook outlook() const;
  SweepSetting sweep_setting(const std::string& role) const;
  const std::string& self() const;

  void wait_for_partners();
  void answer();
  void negotiate_roles();
  void negotiate_start();
  void roles_agreed(const interaction::Terms& terms, const interaction::Rows& result);
  void start_agreed(const interaction::Rows& result);
  void not_agreed(const std::string& why);
  void not_loaded(const std::string& why);
  void load_again(const std::string& why);
  void reallocated(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);

  void begin_if_due();
  void play(const std::string& role);
  void tell(const interaction::Input& input);
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
  std::vector<std::string> parties_of(const std::string& action) const;
  void lost(const std::string& uav, const std::string& why);
  // joint_places.cpp
  void negotiate_places(const std::string& action);
  void take_place_alone(const interaction::BeginNegotiation& begin);
  void places_agreed(const interaction::Terms& terms,
                     const interaction::NegotiationOutcome& outcome);
  // joint_sharing.cpp
  void share_area(const std::string& action);
  void area_shared(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);
  std::vector<world::Polygon> areas_to_share(const std::string& action) const;
  void map_area(const std::string& componel);
  void look_changed(const executive::TaskEvent& event);
  double passing_distance() const;
  void finish(interaction::JointPhase phase);
  void note_done(const std::string& componel);
  void forget_failures_in(const std::string& componel);
  void announce();

  JointHost& host_;
  Interaction& interaction_;
  Joint joint_;
  std::vector<mission::Interval> preferences_;
  const Sightings& sightings_;

  interaction::JointPhase phase_ = interaction::JointPhase::kLoading;
  std::string why_;
  bool dispatched_ = false;  ///< the executive has it under way
  MissionTime try_until_;
  std::optional<MissionTime> again_at_;  ///< to negotiate again
  bool answered_ = false;                ///< the supervisor was told that it is loaded
  bool roles_known_ = false;
  Holders holders_;
  std::string allocation_;  ///< the session in which they were agreed
  MissionTime agreed_at_;
  Duration ahead_;  ///< of what it can do first, in the start it offers
  std::optional<MissionTime> agreed_start_;
  MissionTime start_agreed_at_;
  std::map<std::string, MissionTime> silent_since_;  ///< partners

  std::optional<RolePlay> play_;
  std::uint64_t plays_ = 0;
  std::optional<std::string> next_role_;            ///< once the one now is over
  std::map<executive::TaskId, std::string> tasks_;  ///< componels of those that are not over
  std::map<std::string, Duration> done_;            ///< of perceptions, by componel
  std::map<std::string, MissionTime> running_since_;
  std::map<std::string, std::string> actions_;  ///< subject by action, negotiated now
  std::set<executive::TaskId> interrupted_;     ///< as the role asked
  AreaShare share_;
  struct SharingAgain {
    std::string action;
    MissionTime at, until;
  };
  std::optional<SharingAgain> sharing_again_;  ///< what was not agreed is negotiated again
  std::map<executive::TaskId, executive::TaskId> looks_;  ///< the flight of each that is not over
  std::map<std::string, std::string> failed_;  ///< why, by task of the role; not done since
  std::optional<interaction::JointTaskStatus> told_;
};

}  // namespace skein::decision_node
