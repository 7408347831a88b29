// SPDX-License-Identifier: Apache-2.0
// The ground station as a member of the team: it votes, gives global missions, and follows them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "skein/ground_orders/messages.hpp"
#include "skein/ground_station/mission_checks.hpp"

namespace skein::ground_station {

/// A message from a member of the team.
struct TeamHeard {
  std::string from;
  auction::TeamMessage message;
};
struct TeamTell {
  std::string to;
  auction::TeamMessage message;
};
/// An effect of a sale that is held at the ground station.
struct TeamSaleTold {
  auction::SaleEffect what;
};
struct TeamTokenChanged {
  bool held = false;
  std::uint64_t term = 0;
};

/// The place of an alarm is known from now on, and tasks may name it.
struct PlaceKnown {
  std::string name;
};

/// A member of the team without a vehicle. It repeats a mission given to it until the team's book
/// has it, so that a mission can be given while the token holder is out of reach. Tasks that name
/// an alarm wait here until the alarm is raised. Deterministic; not safe to share between threads.
/// Source: spec 6.3; docs/decisions/0018-degree-5.md.
class TeamDesk {
 public:
  using Input = std::variant<TeamHeard, GiveGlobalMission, DeclareLost, DeclareFound, PlaceKnown,
                             DegreeChanged, Tick>;
  using Effect = std::variant<TeamTell, TeamTaskChanged, GlobalMissionChanged, TeamSaleTold,
                              TeamTokenChanged, Anomaly>;

  /// `self` is in the roster; `uavs` are those of the mission.
  TeamDesk(const team::Config& config, const std::string& self, MissionKnowledge knowledge,
           std::vector<std::string> uavs);

  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const { return member_.next_wakeup(); }
  const team::Roster& roster() const { return roster_; }
  /// The standings of the team's tasks, as far as they are known here.
  const std::map<mission::GoalId, team::TaskStanding>& standings() const {
    return ownership_.known();
  }

 private:
  using Effects = std::vector<Effect>;
  void accept(const GiveGlobalMission& given, MissionTime now, Effects& out);
  void accept(const DeclareLost& lost, MissionTime now, Effects& out);
  void accept(const DeclareFound& found, MissionTime now, Effects& out);
  template <class Declared>
  void declare(const std::string& uav, MissionTime now, Effects& out);
  void accept(const PlaceKnown& known, MissionTime now, Effects& out);
  void accept(const DegreeChanged& changed, MissionTime now, Effects& out);
  std::string why_pinned_does_not_bid(const team::TaskStanding& standing) const;
  bool is_pinned_in_hand(mission::GoalId task) const;
  std::string why_unsold(const team::TaskStanding& standing) const;
  std::set<mission::GoalId> not_yet(const team::GlobalMission& mission) const;
  void give_what_may(mission::MissionId id, MissionTime now, Effects& out);
  void tell_member(const auction::TeamInput& input, MissionTime now, Effects& out);
  const auction::Task* too_late(mission::GoalId task, MissionTime now) const;
  void count_refusals(team::TaskStanding& standing, MissionTime now);
  void tell_news(MissionTime now, Effects& out);
  void tell_hopeless(MissionTime now, Effects& out);
  std::set<mission::GoalId> hopeless_of(const std::set<mission::GoalId>& open,
                                        MissionTime now) const;

  team::Roster roster_;
  MissionKnowledge knowledge_;
  std::vector<std::string> uavs_;
  auction::TeamMember member_;
  team::Ownership ownership_;
  std::map<mission::MissionId, std::set<mission::GoalId>> open_;   ///< of missions given here
  std::map<mission::GoalId, std::vector<mission::GoalId>> after_;  ///< predecessors of a task
  std::map<mission::GoalId, std::string> pinned_;  ///< UAV that the operator reserved the task for
  std::map<std::string, Degree> degrees_;   ///< of the UAVs whose degree keeps them from bidding
  std::set<std::string> lost_;              ///< UAVs that the operator declared lost
  std::map<mission::GoalId, int> refused_;  ///< successive sales of the task without a winner
  std::set<mission::MissionId> hopeless_;   ///< missions reported as impossible for all UAVs
  std::set<mission::MissionId> given_;
  /// Tasks of given missions that name unknown alarms, and their successors.
  std::map<mission::MissionId, team::GlobalMission> waiting_;
  std::map<mission::MissionId, std::uint64_t> lots_;  ///< how many lots of the mission were given
  std::set<mission::GoalId> tasks_;                   ///< all tasks ever given here
  std::set<std::string> alarms_;                      ///< that are known
};

}  // namespace skein::ground_station
