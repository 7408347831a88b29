// SPDX-License-Identifier: Apache-2.0
// Tasks and conditions of a scenario's plans.
#pragma once

#include <map>
#include <vector>

#include "reading.hpp"
#include "skein/world/terrain.hpp"

namespace skein::scenario {

/// What tasks may refer to.
struct TaskContext {
  const Scenario& scenario;
  Names names;
  const world::Terrain& terrain;
};

ground_station::PlannedTask read_task(const config::Reader& reader, const TaskContext& context);
executive::Formula read_formula(const config::Reader& reader);
executive::TaskId read_task_id(const config::Reader& reader);
executive::TaskState read_task_state(const config::Reader& reader);

}  // namespace skein::scenario
