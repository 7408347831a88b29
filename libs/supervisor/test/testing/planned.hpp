// SPDX-License-Identifier: Apache-2.0
// Plans of the planning lab, for tests of what they consist of.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "testing/planning_lab.hpp"

namespace skein::supervisor::testing {

/// Of the tasks, in their order, without the "task-" before each.
inline std::vector<std::string> names_of(const mission::ElementaryPlan& plan) {
  std::vector<std::string> names;
  for (const mission::ElementaryTask& task : plan.tasks)
    names.push_back(task.name.substr(std::string("task-").size()));
  return names;
}

/// An empty plan, and a failure of the test, when there is none.
inline mission::ElementaryPlan planned(const PlanningLab& lab) {
  auto plan = lab.plan();
  if (plan) return std::move(*plan);
  ADD_FAILURE() << lab.reasons();
  return {};
}

/// At (0, 0, 40), 250 m west of a tree; tasks are numbered from 1.
inline PlanningLab flying() {
  PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  lab.world.places["tree"] = world::Vector3(250, 0, 0);
  return lab;
}

}  // namespace skein::supervisor::testing
