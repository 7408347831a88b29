// SPDX-License-Identifier: Apache-2.0
// The ground station's part in a team: it votes, gives missions, and sees who has what.
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

/// From a member of the team.
struct TeamHeard {
  std::string from;
  auction::TeamMessage message;
};
struct TeamTell {
  std::string to;
  auction::TeamMessage message;
};
/// Of a sale that is held here.
struct TeamSaleTold {
  auction::SaleEffect what;
};
struct TeamTokenChanged {
  bool held = false;
  std::uint64_t term = 0;
};

/// A place that tasks may name is known from now on: that of an alarm.
struct PlaceKnown {
  std::string name;
};

/// A member of the team without a vehicle. What it is given it says until the team's book has it,
/// so a mission is given even while the holder of the token is out of reach. Tasks that name an
/// alarm wait here until it is raised. Deterministic; not safe to share between threads. Source:
/// spec 6.3; docs/decisions/0018-degree-5.md.
class TeamDesk {
 public:
  using Input =
      std::variant<TeamHeard, GiveGlobalMission, DeclareLost, PlaceKnown, DegreeChanged, Tick>;
  using Effect = std::variant<TeamTell, TeamTaskChanged, GlobalMissionChanged, TeamSaleTold,
                              TeamTokenChanged, Anomaly>;

  /// `self` is in the roster; `uavs` are those of the mission.
  TeamDesk(const team::Config& config, const std::string& self, MissionKnowledge knowledge,
           std::vector<std::string> uavs);

  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const { return member_.next_wakeup(); }
  const team::Roster& roster() const { return roster_; }
  /// As far as it is known here.
  const std::map<mission::GoalId, team::TaskStanding>& standings() const {
    return ownership_.known();
  }

 private:
  using Effects = std::vector<Effect>;
  void accept(const GiveGlobalMission& given, MissionTime now, Effects& out);
  void accept(const DeclareLost& lost, MissionTime now, Effects& out);
  void accept(const PlaceKnown& known, MissionTime now, Effects& out);
  void accept(const DegreeChanged& changed, MissionTime now, Effects& out);
  std::string why_pinned_does_not_bid(mission::GoalId task) const;
  std::set<mission::GoalId> not_yet(const team::GlobalMission& mission) const;
  void give_what_may(mission::MissionId id, MissionTime now, Effects& out);
  void tell_member(const auction::TeamInput& input, MissionTime now, Effects& out);
  void count_refusals(team::TaskStanding& standing);
  void tell_news(Effects& out);
  void tell_hopeless(Effects& out);
  std::set<mission::GoalId> hopeless_of(const std::set<mission::GoalId>& open) const;

  team::Roster roster_;
  MissionKnowledge knowledge_;
  std::vector<std::string> uavs_;
  auction::TeamMember member_;
  team::Ownership ownership_;
  std::map<mission::MissionId, std::set<mission::GoalId>> open_;   ///< of missions given here
  std::map<mission::GoalId, std::vector<mission::GoalId>> after_;  ///< what a task comes after
  std::map<mission::GoalId, std::string> pinned_;  ///< to this UAV alone, by the operator
  std::map<std::string, Degree> degrees_;          ///< of those that do not bid for it
  std::map<mission::GoalId, int> refused_;         ///< how often nobody could, one after another
  std::set<mission::MissionId> hopeless_;          ///< of which it is said that nobody can
  std::set<mission::MissionId> given_;
  /// What of them names alarms that are not known yet, and what comes after that.
  std::map<mission::MissionId, team::GlobalMission> waiting_;
  std::map<mission::MissionId, std::uint64_t> lots_;  ///< given of each
  std::set<mission::GoalId> tasks_;                   ///< ever given here
  std::set<std::string> alarms_;                      ///< that are known
};

}  // namespace skein::ground_station
