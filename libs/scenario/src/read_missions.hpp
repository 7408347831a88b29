// SPDX-License-Identifier: Apache-2.0
// Readers of script actions for UAVs that plan: missions, degrees, hand-over, closed air.
#pragma once

#include <string>
#include <vector>

#include "read_tasks.hpp"

namespace skein::scenario {

using ReadAction = ground_station::Action (*)(const config::Reader&, TaskContext&);
struct MissionAction {
  const char* key;
  ReadAction read;
};
/// The readers of these actions, each with the action's key in a script.
const std::vector<MissionAction>& mission_actions();

/// Reads one action of a list and reports its errors. Nothing: the kind of action is unknown.
std::optional<ground_station::Action> read_action(const config::Reader& reader,
                                                  TaskContext& context);

/// Reads the id of a mission or high-level task that the script must send somewhere
/// (check_references).
mission::MissionId read_mission_id(const config::Reader& reader, const std::string& uav,
                                   TaskContext& context);
mission::GoalId read_goal_id(const config::Reader& reader, const std::string& uav,
                             TaskContext& context);
/// Reads {id, task, …} of a global mission.
ground_station::Action read_global_mission(const config::Reader& reader, TaskContext& context);
/// Whether the UAV is one of the scenario's team.
bool is_of_team(const std::string& uav, const TaskContext& context);
ground_station::Action read_declare_lost(const config::Reader& reader, TaskContext& context);
ground_station::Action read_declare_found(const config::Reader& reader, TaskContext& context);
ground_station::OnTeamTask read_on_team_task(const config::Reader& reader, TaskContext& context);
ground_station::OnGlobalMission read_on_global_mission(const config::Reader& reader,
                                                       TaskContext& context);
/// Reads the name and arguments of a task; arguments that refer to the alarm are added to `targets`
/// for task `number`.
void read_statement(const config::Reader& reader, mission::HighLevelTask& task, std::size_t number,
                    std::vector<ground_station::ArgumentTarget>& targets);
mission::TimeConstraints read_time_constraints(const config::Reader& reader);
int read_degree_number(const config::Reader& reader);

/// Reports references to missions and tasks that are never sent. Precondition: the whole script has
/// been read.
void check_references(const TaskContext& context);

}  // namespace skein::scenario
