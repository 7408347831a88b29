// SPDX-License-Identifier: Apache-2.0
// The life of one joint task at one of its UAVs.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interaction/joint_host.hpp"
#include "interaction/joint_play.hpp"
#include "interaction/places.hpp"
#include "interaction/sightings.hpp"
#include "skein/decision_node/messages.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

class Interaction;

///   from      on                                                   to
///   loading   roles and start are agreed                           loaded
///   loading   neither is agreed when it is to start at the latest  not-loaded
///   loaded    a partner left, or cannot begin then any more        loading
///   loaded    the executive wants it carried out                   running
///   running   its role ends                                        ended
///   any       interrupted, a partner left or is lost               leaving, aborted
///
/// A role that listens to "member lost" goes on without a partner that left or is lost. Who is out
/// of reach for a minute while it loads is done without, where a variant is for those who are left.
///
/// What failed to be agreed is negotiated again until it is to start at the latest. Roles that are
/// agreed to be others while it runs are begun anew, once what runs of the old one is over. Source:
/// T IV.3, T V.3, spec 7.2 to 7.4.
class JointTask {
 public:
  JointTask(JointHost& host, Interaction& interaction, Joint joint,
            std::vector<mission::Interval> preferences, const Sightings& sightings);

  const Joint& joint() const { return my_.joint; }
  /// Among all who are asked for it.
  const Joint& asked() const { return asked_; }
  interaction::JointPhase phase() const { return my_.phase; }
  bool over() const { return interaction::is_over(my_.phase); }

  /// It is loading or loaded.
  bool is_to_begin() const;
  /// Nor does its role keep a place now.
  bool needs_no_place() const { return is_to_begin() || play_.needs_no_place(); }
  /// `again`: it has run here, and failed.
  void load(bool again);
  bool has_run() const { return play_.has_begun(); }
  /// The plan has it with another number, or it can begin at other times.
  void ask_again(executive::TaskId task, std::vector<mission::Interval> preferences);
  /// The executive wants it carried out.
  void due();
  /// It is to end here; partners are told.
  void leave(const std::string& why);
  /// The same, without waiting for what is being stopped.
  void leave_at_once(const std::string& why);
  /// All who are asked for it, but oneself.
  std::vector<std::string> partners() const;
  /// This one is asked for it.
  bool asks(const std::string& uav) const;
  /// What the initialisers of places, and costs, are reckoned from.
  Outlook outlook() const;
  /// Its role is over, or it is not begun.
  void finish(interaction::JointPhase phase);
  /// What has changed is told, to partners too.
  void announce();

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
  const std::string& self() const;

  /// Of this UAV: as the plan has it then, before it has begun; now, once it has.
  world::VehicleState where_it_begins() const;
  double cost_of_change(const std::string& role) const;
  void wait_for_partners();
  void answer();
  void do_without_the_silent();
  void negotiate_roles();
  void negotiate_start();
  void roles_agreed(const interaction::Terms& terms, const interaction::Rows& result);
  void start_agreed(const interaction::Rows& result);
  void not_agreed(const std::string& why);
  void not_loaded(const std::string& why);
  void load_again(const std::string& why);
  void begin_if_due();
  void lost(const std::string& uav, const std::string& why);

  JointHost& host_;
  Interaction& interaction_;
  const Sightings& sightings_;
  std::vector<mission::Interval> preferences_;
  const Joint asked_;  ///< among all
  Membership my_;
  JointPlay play_;
  bool dispatched_ = false;  ///< the executive has it under way
  bool again_ = false;       ///< it has run before
  MissionTime try_until_;
  std::optional<MissionTime> again_at_;  ///< to negotiate again
  bool answered_ = false;                ///< the supervisor was told that it is loaded
  bool roles_known_ = false;
  MissionTime agreed_at_;
  Duration ahead_;  ///< of what it can do first, in the start it offers
  std::optional<MissionTime> agreed_start_;
  MissionTime start_agreed_at_;
  std::map<std::string, MissionTime> silent_since_;  ///< partners
  /// Why it is not agreed on, since when that has been so.
  struct Kept {
    std::string why;
    MissionTime since;
    bool said = false;

    /// To be said now, once: what passes by itself, as with a partner that adopts its mission a
    /// little later, is not worth a word.
    bool is_worth_a_word(const std::string& reason, MissionTime now);
  };
  Kept kept_;

  std::optional<interaction::JointTaskStatus> told_;
};

}  // namespace skein::decision_node
