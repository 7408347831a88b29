// SPDX-License-Identifier: Apache-2.0
// Tasks and conditions of a scenario's plans.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "reading.hpp"
#include "skein/world/terrain.hpp"

namespace skein::scenario {

/// What tasks may refer to.
struct TaskContext {
  const Scenario& scenario;
  Names names;
  const world::Terrain& terrain;
  /// Tasks planned so far, by UAV and id.
  std::set<std::pair<std::string, executive::TaskId>> planned;
};

/// A task for a UAV; empty: for one that is not known.
ground_station::PlannedTask read_task(const config::Reader& reader, const std::string& uav,
                                      TaskContext& context);
executive::Formula read_formula(const config::Reader& reader);
executive::TaskId read_task_id(const config::Reader& reader);
executive::TaskState read_task_state(const config::Reader& reader);

}  // namespace skein::scenario
