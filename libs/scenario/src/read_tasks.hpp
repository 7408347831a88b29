// SPDX-License-Identifier: Apache-2.0
// Tasks and conditions of a scenario's plans.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "reading.hpp"
#include "skein/world/terrain.hpp"

namespace skein::scenario {

/// A reference in the script to a mission or high-level task.
struct Reference {
  config::Reader at;
  std::string uav;
  std::uint64_t id = 0;
  bool is_goal = false;
};

/// The names and ids that tasks may refer to.
struct TaskContext {
  const Scenario& scenario;
  Names names;
  const world::Terrain& terrain;
  /// Tasks planned so far, by UAV and id.
  std::set<std::pair<std::string, executive::TaskId>> planned = {};
  /// Missions and high-level tasks sent so far, by UAV and id.
  std::set<std::pair<std::string, mission::MissionId>> missions = {};
  TaskMarks goals = {};
  TaskMarks played = {};
  /// Global missions and their tasks sent so far, by id.
  std::set<mission::MissionId> global_missions = {};
  std::set<mission::GoalId> team_tasks = {};
  std::vector<Reference> references = {};
  bool live = false;  ///< a request during the mission: ids sent earlier are not known here
};

/// Reads a task for `uav` (empty: the UAV is not known).
ground_station::PlannedTask read_task(const config::Reader& reader, const std::string& uav,
                                      TaskContext& context);
executive::Formula read_formula(const config::Reader& reader);
executive::TaskId read_task_id(const config::Reader& reader);
executive::TaskState read_task_state(const config::Reader& reader);
/// The points [m] ENU of `to` (a place, a point, or a list of these), with `altitude`, if given,
/// over the ground there.
std::vector<world::Vector3> read_points(const config::Reader& params, const TaskContext& context);
/// {bearing, distance, altitude}.
ground_station::NearAlarm read_near_alarm(const config::Reader& reader);
/// The value of a scalar if it is a number; reports no error otherwise.
std::optional<double> number_in(const config::Reader& reader);

}  // namespace skein::scenario
