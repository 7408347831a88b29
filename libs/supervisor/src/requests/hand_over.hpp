// SPDX-License-Identifier: Apache-2.0
// Hand-over of the authority over the plan, and its return. Source: spec 1.2, T II.1.1.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "safety/safe_mode.hpp"

namespace skein::supervisor {

/// Keeps whether the supervisor has the authority over the UAV's plan. Lifetime: refers to its
/// arguments.
class HandOver {
 public:
  HandOver(SafeMode& safe_mode, Committer& committer, Agenda& agenda, Outbox& out, Book& book)
      : safe_mode_(safe_mode), committer_(committer), agenda_(agenda), out_(out), book_(book) {}

  /// Whether the supervisor has the authority; false before the first take().
  bool engaged() const { return engaged_; }
  void give_up(const Disengage& input);
  void take(const Engage& input);
  /// A task that another executive had is back in this one's, or over.
  void came_back(TaskId task);
  /// Gives up tasks that did not come back in time.
  void time_passes();
  /// When time_passes() gives up; absent: no task is awaited.
  std::optional<MissionTime> next_wakeup() const;
  /// Hands the goal over if it is open; a goal that is wholly with the executive stays under way.
  void hand_over_goal(GoalId id);

 private:
  /// What another executive has of the plan. Goals that lost a task are planned anew once what is
  /// missing of them is back, since tasks of another executive cannot be aborted.
  struct Return {
    std::set<GoalId> goals;  ///< that lost a task
    std::set<TaskId> missing;
    std::set<TaskId> carried_out;  ///< of these, by the vehicle, which tells their end
    std::string cause;
    bool resume = true;
    std::optional<MissionTime> until;  ///< absent: of what is missing the vehicle tells
  };

  MissionTime now() const { return out_.now(); }
  std::vector<GoalId> take_back(const std::set<GoalId>& goals);
  std::set<GoalId> not_awaited() const;
  void lose(Entry& entry);
  void stays_away(Entry& entry);
  void lose_what_stays_away();
  void await_return(const Engage& input);
  std::set<GoalId> returned();
  void plan_returned();
  void forget_but(const std::set<TaskId>& kept);
  void await(const std::vector<TaskId>& elsewhere);
  /// What another executive has and has not given back: tasks of no goal are let go of.
  void await_no_longer();

  SafeMode& safe_mode_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  bool engaged_ = false;
  std::optional<Return> returning_;
  std::optional<MissionTime> awaited_until_;  ///< until when Book::elsewhere is awaited
};

}  // namespace skein::supervisor
