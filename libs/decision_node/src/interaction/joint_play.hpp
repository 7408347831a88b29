// SPDX-License-Identifier: Apache-2.0
// Playing a role of a joint task.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interaction/area_mapping.hpp"
#include "interaction/pursuit.hpp"
#include "interaction/role_course.hpp"
#include "interaction/role_record.hpp"
#include "interaction/role_talks.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

/// Carries out what a role asks for: tasks, places, negotiations in flight. When another role is
/// agreed, it begins once the running tasks of the old role are over.
class JointPlay final : private RoleCourse {
 public:
  explicit JointPlay(const PlaySurroundings& of);

  void begin(const std::string& role);
  /// The role that is played; null: none has begun.
  RolePlay* role() { return play_ ? &*play_ : nullptr; }
  const RolePlay* role() const { return play_ ? &*play_ : nullptr; }
  void tell(const interaction::Input& input) override;
  /// What places and costs are computed with.
  Outlook outlook() const override;
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
  /// Begins such tasks that are under way anew: meetings without those who hold no role any more,
  /// mappings over what is left of the own part.
  void begin_anew(bool (*is_meant)(const interaction::Task& task));
  AreaMapping& mapping() { return mapping_; }
  const AreaMapping& mapping() const { return mapping_; }
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
  RolePlay& play() override { return *play_; }
  executive::TaskId give(const std::string& componel, executive::Task task,
                         std::optional<executive::TaskId> along = {}) override;
  void fail(const std::string& componel, const std::string& why) override;
  /// A task of the role: to the executive, or over at once.
  void run(const std::string& componel);
  /// Tries a task anew that the vehicle gave up after it `ran`; false: it does not.
  bool begin_again(const std::string& componel, Duration ran);
  /// Leaves a role that has nothing more to do after this task was given up.
  void leave_if_stuck(const std::string& componel, const std::string& why);
  void carry_out(const interaction::StateChanged& effect);
  void carry_out(const interaction::Compute& effect);
  void carry_out(const interaction::Run& effect) {
    record_.asked_for(effect.task);
    run(effect.task);
  }
  void carry_out(const interaction::Negotiate& effect) { talks_.negotiate(effect.action); }
  void carry_out(const interaction::Interrupt& effect);
  void carry_out(const interaction::Withdraw& effect) { talks_.withdraw(effect.action); }
  void carry_out(const interaction::ModelOver& effect);
  /// After a flight that got no air once all partners had ended: the role is over, or left.
  void stay_without_air(const std::string& componel, const std::string& why);
  /// Leaves the joint task after a task that failed as soon as it began.
  void leave_if_in_vain(const std::string& componel, const std::string& why);
  /// A flight after what is followed.
  void flew_after(const executive::TaskEvent& event, const std::string& componel);
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
  std::map<executive::TaskId, executive::TaskId>
      looks_;  ///< unfinished perceptions to their flights
  AreaMapping mapping_;
  Pursuit pursuit_;
  RoleTalks talks_;
  mutable interaction::RefusedViews refused_views_;
};

}  // namespace skein::decision_node
