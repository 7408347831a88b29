// SPDX-License-Identifier: Apache-2.0
// The life cycle of one joint task on one of its UAVs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interaction/companions.hpp"
#include "interaction/joint_host.hpp"
#include "interaction/joint_play.hpp"
#include "interaction/loading_time.hpp"
#include "interaction/newcomers.hpp"
#include "interaction/retries.hpp"
#include "interaction/sightings.hpp"
#include "skein/decision_node/messages.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

class Interaction;

/// Whether a joint task is loading or loaded.
constexpr bool is_to_begin(interaction::JointPhase phase) {
  return phase == interaction::JointPhase::kLoading || phase == interaction::JointPhase::kLoaded;
}

///   from      on                                                   to
///   loading   roles and start are agreed                           loaded
///   loading   neither is agreed when it is to start at the latest  not-loaded
///   loaded    a partner left, or cannot begin then any more        loading
///   loaded    the executive wants it carried out                   running
///   running   its role ends                                        ended
///   any       interrupted, a partner left or is lost               leaving, aborted
///
/// A role that listens to "member lost" goes on without a partner that left or is lost. While the
/// task loads, a member that is out of reach, or says that it takes no part, for a minute is left
/// out if the model has a variant for the remaining members. Else one that is out of reach is
/// waited for until it is given up (Partners); where it takes no part, the task is not loaded.
///
/// A member that holds no role and asks for the joint task while it runs may be taken in
/// (Newcomers).
///
/// A role whose flight gets no air is left, but once all partners have ended it ends where the
/// vehicle is.
///
/// While an earlier joint task of this UAV's plan is not agreed on, it offers no start for this
/// one, and tells its partners until when it waits at most: they wait as long.
///
/// A failed negotiation is repeated until the latest start (Retries). If other roles are agreed
/// while the task runs, the new role begins once the running tasks of the old one are over. Source:
/// T IV.3, T V.3, spec 7.2 to 7.4.
class JointTask {
 public:
  JointTask(JointHost& host, Interaction& interaction, Joint joint,
            std::vector<mission::Interval> preferences, const Sightings& sightings);

  const Joint& joint() const { return my_.joint; }
  /// The joint task with all members that were asked for it.
  const Joint& asked() const { return asked_; }
  interaction::JointPhase phase() const { return my_.phase; }
  bool over() const { return interaction::is_over(my_.phase); }
  /// Since when it is over; absent: it is not.
  std::optional<MissionTime> over_since() const { return over_since_; }

  /// Until when at most it waits to be agreed on; absent: it is agreed on, or has ended.
  std::optional<MissionTime> not_agreed_until() const;
  /// Joint tasks before this one may be agreed on now, or not any more.
  void look_at_earlier();
  /// Whether the vehicle may move away without breaking a constraint of the role.
  bool needs_no_place() const {
    const RolePlay* role = play_.role();
    return is_to_begin(my_.phase) || (role != nullptr && !role->is_bound());
  }
  void load(const EarlierAttempts& before);
  /// What it is to one that is loaded now, after it.
  EarlierAttempts before() const;
  /// The plan changed: the task has another id, or other possible start times.
  void ask_again(executive::TaskId task, std::vector<mission::Interval> preferences);
  /// The executive starts it.
  void due();
  /// The executive interrupts it. Of one that was never loaded the supervisor tells the executive.
  void interrupted();
  /// Ends it on this UAV; partners are told.
  void leave(const std::string& why);
  /// The same, without waiting for tasks that are being aborted.
  void leave_at_once(const std::string& why);
  const Companions& companions() const { return companions_; }
  /// Ends it in this phase. Precondition: its role is over, or not begun.
  void finish(interaction::JointPhase phase);
  /// Emits the status if it changed, for partners too.
  void announce();

  // ---- negotiation ----
  void invited(const interaction::Terms& terms);
  Result<interaction::Rows, Failure> offer_for(const interaction::Terms& terms) const;
  /// A session ended with this outcome, or an undecided outcome became known.
  void decided(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);

  // ---- what happens ----
  void task_changed(const executive::TaskEvent& event);
  /// Checks the constraints after a position was seen.
  void watch();
  void partner_told(const interaction::JointTaskStatus& status, MissionTime at);
  void time_passes();
  std::optional<MissionTime> next_wakeup() const;

 private:
  MissionTime now() const;

  /// This UAV's state at the planned beginning; its present state once the task has begun.
  world::VehicleState where_it_begins() const;
  void answer();
  void do_without_the_absent();
  void give_up_on_partners();
  void roles_agreed(const interaction::Terms& terms, const interaction::Rows& result);
  void start_agreed(const interaction::Rows& result);
  void not_agreed(const std::string& why);
  void not_loaded(const std::string& why);
  void go_on_apart(const interaction::JointTaskStatus& status);
  void load_again(const std::string& why);
  void begin_if_due();
  void lost(const std::string& uav, const std::string& why);

  JointHost& host_;
  Interaction& interaction_;
  const Sightings& sightings_;
  const std::string& self_;
  std::vector<mission::Interval> preferences_;
  const Joint asked_;  ///< with all members that were asked
  Membership my_;
  Companions companions_;
  JointPlay play_;
  Newcomers newcomers_;
  bool dispatched_ = false;  ///< the executive has started it
  LoadingTime time_;
  MissionTime asked_at_;  ///< when it, or the first of the attempts before, was loaded
  Retries retries_;
  bool answered_ = false;  ///< the supervisor was told that it is loaded
  bool roles_known_ = false;
  MissionTime agreed_at_;
  Duration ahead_;  ///< time before the role's first action, added to the offered start
  std::optional<MissionTime> agreed_start_;
  MissionTime start_agreed_at_;
  std::optional<MissionTime> over_since_;
  std::optional<interaction::JointTaskStatus> told_;
};

}  // namespace skein::decision_node
