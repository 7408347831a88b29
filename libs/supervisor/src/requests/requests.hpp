// SPDX-License-Identifier: Apache-2.0
// Operators 0 and 2: requests of users. Source: T IV.4.2 (SCD-0, SCD-2), spec 6.2.
#pragma once

#include <string>
#include <vector>

#include "requests/hand_over.hpp"
#include "watch/contingencies.hpp"

namespace skein::supervisor {

/// Handles missions, cancellations and changes of the world; answers each in the same call.
/// Lifetime: refers to its Rooms.
class Requests {
 public:
  struct Rooms {
    Beliefs& beliefs;
    HandOver& hand_over;
    Contingencies& contingencies;
    Committer& committer;
    Agenda& agenda;
    Outbox& out;
    Book& book;
  };
  explicit Requests(const Rooms& rooms);

  void add(const mission::UnitMission& mission);
  void cancel(const CancelMission& input);
  /// True when air was closed.
  bool change_world(const mission::ChangeWorld& change);

 private:
  MissionTime now() const { return out_.now(); }
  std::vector<std::string> problems_of_mission(const mission::UnitMission& mission) const;
  std::vector<std::string> problems_of_goals(const mission::UnitMission& mission) const;
  std::vector<std::string> problems_of_volume(const mission::ChangeWorld& change) const;
  void enter(const mission::UnitMission& mission, const std::string& cause);
  std::vector<GoalId> goals_named(const mission::CancelGoals& named,
                                  std::vector<std::string>& problems) const;
  void cancel(const std::vector<GoalId>& goals, bool interrupt, const std::string& cause);
  std::vector<GoalId> left_to_plan(const std::vector<GoalId>& gone) const;
  void drop_cancelled_missions();
  /// Emits the answer and the decision; true if there are no problems.
  bool answer(const std::string& cause, const std::string& inputs,
              const std::vector<std::string>& problems);

  Beliefs& beliefs_;
  HandOver& hand_over_;
  Contingencies& contingencies_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  ByteBook missions_;  ///< 1 for each accepted mission
};

}  // namespace skein::supervisor
