// SPDX-License-Identifier: Apache-2.0
// What a script does with UAVs that plan: missions, degrees, hand-over, closed air.
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
/// By their keys in a list of actions.
const std::vector<MissionAction>& mission_actions();

/// One action of a list; reports what it says wrongly. Nothing: it is of no kind that scripts have.
std::optional<ground_station::Action> read_action(const config::Reader& reader,
                                                  TaskContext& context);

/// Of a mission or high-level task that must be one the script sends: see check_references.
mission::MissionId read_mission_id(const config::Reader& reader, const std::string& uav,
                                   TaskContext& context);
mission::GoalId read_goal_id(const config::Reader& reader, const std::string& uav,
                             TaskContext& context);
/// {id, task, …} of a global mission; reads what is common to all high-level tasks.
ground_station::Action read_global_mission(const config::Reader& reader, TaskContext& context);
ground_station::Action read_declare_lost(const config::Reader& reader, TaskContext& context);
ground_station::OnTeamTask read_on_team_task(const config::Reader& reader, TaskContext& context);
ground_station::OnGlobalMission read_on_global_mission(const config::Reader& reader,
                                                       TaskContext& context);
/// The name of the task and its arguments; those about the alarm become targets of task `number`.
void read_statement(const config::Reader& reader, mission::HighLevelTask& task, std::size_t number,
                    std::vector<ground_station::ArgumentTarget>& targets);
mission::TimeConstraints read_time_constraints(const config::Reader& reader);
int read_degree_number(const config::Reader& reader);

/// Reports what was referred to and is never sent. Once all of the script is read.
void check_references(const TaskContext& context);

}  // namespace skein::scenario
