// SPDX-License-Identifier: Apache-2.0
// The right to decide is given up, and taken again. Source: spec 1.2, T II.1.1.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "safety/safe_mode.hpp"

namespace skein::supervisor {

/// Who decides on the plan of the UAV. Lifetime: refers to its arguments.
class HandOver {
 public:
  HandOver(SafeMode& safe_mode, Committer& committer, Agenda& agenda, Outbox& out, Book& book)
      : safe_mode_(safe_mode), committer_(committer), agenda_(agenda), out_(out), book_(book) {}

  /// The supervisor decides. Not before it is told so.
  bool engaged() const { return engaged_; }
  void give_up(const Disengage& input);
  void take(const Engage& input);
  /// A task that another executive had has come back from it, or is over.
  void came_back(TaskId task);
  /// Gives up for lost what does not come back.
  void time_passes();
  /// When it does; nothing: nothing is to come back.
  std::optional<MissionTime> next_wakeup() const;
  /// What is open of it is no longer the supervisor's; goals that are wholly with the executive
  /// stay under way.
  void hand_over_goal(GoalId id);

 private:
  /// Goals that have lost a task while another executive had the rest of them: they are planned
  /// anew once that is back, since what is not here cannot be aborted.
  struct Return {
    std::set<GoalId> goals;
    std::set<TaskId> missing;
    std::string cause;
    MissionTime until;
  };

  MissionTime now() const { return out_.now(); }
  std::vector<GoalId> take_back();
  void lose(Entry& entry);
  void await_return(const std::string& cause);
  void plan_returned();
  void forget_but(const std::set<TaskId>& kept);

  SafeMode& safe_mode_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  bool engaged_ = false;
  std::optional<Return> returning_;
};

}  // namespace skein::supervisor
