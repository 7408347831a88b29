// SPDX-License-Identifier: Apache-2.0
// A mission for the whole team, in terms of the planning domain.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/auction/ledger.hpp"
#include "skein/interaction/requirement.hpp"
#include "skein/mission/vocabulary.hpp"
#include "skein/team/roster.hpp"

namespace skein::team {

/// Placeholder in a statement for the list of UAVs that win the task.
inline constexpr std::string_view kMembers = "members";

/// A high-level task to be allocated within the team.
struct GlobalTask {
  mission::HighLevelTask task;        ///< with an id unique among all global missions
  std::uint32_t members = 1;          ///< more than one: a joint task, for a whole group or none
  interaction::Requirements needs{};  ///< of each of its members
  /// Tasks of this mission that must be done before. Bounds on the time between the end of one of
  /// these and the beginning of each part of this one are in `task.after`.
  std::vector<mission::GoalId> after{};
  std::optional<std::string> by{};  ///< pinned to this UAV by the operator
  std::set<std::string> not_by{};   ///< forbidden to these UAVs by the operator
  bool repeatable = false;  ///< may be done twice, so it is sold again when its owner is silent
  auction::Place at{};      ///< approximate place, to tell which tasks are near each other [m] ENU
};

/// A mission given to the team through any of its members. The number identifies it, however often
/// it is given.
/// Source: spec 6.3.
struct GlobalMission {
  mission::MissionId id;
  std::vector<GlobalTask> tasks;
  std::string asked_by;
};

/// The task with the placeholder kMembers replaced by these UAVs, in their order.
mission::HighLevelTask for_members(mission::HighLevelTask task,
                                   const std::vector<std::string>& members);
/// The alarms that the task refers to by name (mission::name_of_alarm), known or not.
std::vector<std::string> alarms_in(const mission::HighLevelTask& task);

/// The work behind a task of the auction.
struct Order : auction::Work {
  Order(mission::HighLevelTask asked, std::string by, interaction::Requirements of_each = {})
      : task(std::move(asked)), asked_by(std::move(by)), needs(std::move(of_each)) {}
  mission::HighLevelTask task;
  std::string asked_by;
  interaction::Requirements needs;  ///< of each of its members
};
/// The bounds that the order of a task has on the time after the end of `first`.
auction::Delay delay_after(auction::TaskNumber first, const mission::HighLevelTask& task);
/// The order of a granted task with what its delays come to in mission time, which the ledger's
/// task has, in place of the bounds after tasks of other UAVs.
mission::HighLevelTask in_time(mission::HighLevelTask task, const auction::Task& granted);
/// Null: the task carries no order, so no UAV of this system can do it.
const Order* order_of(const auction::Task& task);

/// All errors of the mission that do not depend on who does it, as sentences: those of
/// mission::problems_of for its tasks (devices apart), ids out of the auction's range, unknown
/// predecessors, UAVs that are not in the team, UAVs both pinned and forbidden, more members than
/// UAVs, fewer than two members where the statement has several, tasks whose times contradict each
/// other. Alarms need not be known. `around.uavs` are those of the team.
std::vector<std::string> problems_of(const GlobalMission& mission, const Roster& roster,
                                     const mission::Vocabulary& vocabulary,
                                     const mission::Surroundings& around, MissionTime now);

/// The mission in the auction's terms. The duration of a task is the sum of its durations; its
/// window comes from its time constraints. Precedences of tasks in other missions are kept.
/// Precondition: no problems.
auction::GivenMission given(const GlobalMission& mission, const Roster& roster,
                            const mission::Vocabulary& vocabulary);

}  // namespace skein::team
