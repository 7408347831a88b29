// SPDX-License-Identifier: Apache-2.0
// A mission for the whole team, in the words of the planning domain.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/auction/ledger.hpp"
#include "skein/mission/vocabulary.hpp"
#include "skein/team/roster.hpp"

namespace skein::team {

/// Stands in a statement for the UAVs that the task is sold to, where it wants a list of them.
inline constexpr std::string_view kMembers = "members";

/// A high-level task that the team shares out.
struct GlobalTask {
  mission::HighLevelTask task;           ///< its id is unique among those of all global missions
  std::uint32_t members = 1;             ///< more than one: a joint task, all of them or none
  std::vector<mission::GoalId> after{};  ///< of this mission: are done before it begins
  std::optional<std::string> by{};       ///< the operator pins it to this UAV
  std::set<std::string> not_by{};        ///< the operator forbids it to these
  bool repeatable = false;  ///< may be done twice: is not waited for when its owner is silent
  auction::Place at{};      ///< about where it is, to tell which tasks lie near each other [m] ENU
};

/// Given to the team through any of its members; its number is the same however often it is given.
/// Source: spec 6.3.
struct GlobalMission {
  mission::MissionId id;
  std::vector<GlobalTask> tasks;
  std::string asked_by;
};

/// The task as these UAVs are asked for it, in their order.
mission::HighLevelTask for_members(mission::HighLevelTask task,
                                   const std::vector<std::string>& members);
/// The alarms that it names (mission::name_of_alarm), whether known or not.
std::vector<std::string> alarms_in(const mission::HighLevelTask& task);

/// What a task of the market comes down to.
struct Order : auction::Work {
  Order(mission::HighLevelTask asked, std::string by)
      : task(std::move(asked)), asked_by(std::move(by)) {}
  mission::HighLevelTask task;
  std::string asked_by;
};
/// Null: nothing that a UAV of this system could do.
const Order* order_of(const auction::Task& task);

/// Every reason why the mission makes no sense whoever does it, in sentences: what
/// mission::problems_of says of its tasks (devices apart), numbers that the market has no room for,
/// tasks before it that are not in it, UAVs that are not in the team, pinned and forbidden, more
/// members than UAVs, or fewer than two where its statement has several, tasks that contradict each
/// other in time. Alarms need not be known. `around.uavs` are those of the team.
std::vector<std::string> problems_of(const GlobalMission& mission, const Roster& roster,
                                     const mission::Vocabulary& vocabulary,
                                     const mission::Surroundings& around, MissionTime now);

/// As the market is given it. A task lasts as long as its durations say together; windows come from
/// its time constraints. What comes after tasks that are not in it waits for those all the same.
/// Precondition: no problems.
auction::GivenMission given(const GlobalMission& mission, const Roster& roster,
                            const mission::Vocabulary& vocabulary);

}  // namespace skein::team
