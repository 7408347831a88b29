// SPDX-License-Identifier: Apache-2.0
// Records of deliberation: high-level tasks, plans, decisions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/report/records.hpp"

namespace skein::report {

/// A high-level task entered a state: received, planned, under-way, achieved, failed, …
struct GoalRecord {
  Stamp stamp;
  std::string uav;
  std::uint64_t goal = 0;  ///< unique within the UAV
  std::uint64_t mission = 0;
  std::string statement;
  std::string state;
  std::string why;
  std::string asked_by;
};

/// A new revision of a UAV's plan; its tasks follow as PlannedRecords.
struct PlanRecord {
  Stamp stamp;
  std::string uav;
  std::uint64_t revision = 0;
  std::uint64_t tasks = 0;
};

/// One task of a revision, with the dates that its temporal network gives it [s].
struct PlannedRecord {
  Stamp stamp;
  std::string uav;
  std::uint64_t revision = 0;
  std::uint64_t task = 0;
  std::string type;
  std::uint64_t goal = 0;
  double earliest_start = 0.0;
  std::optional<double> latest_start;  ///< absent: unbounded
  double earliest_end = 0.0;
  std::optional<double> latest_end;
  std::string after;    ///< start condition, "ended 100, running 102"; empty: none
  std::string stop;     ///< stop condition, "ended 102"; empty: none
  std::string methods;  ///< "general-takeoff > fly"
  bool committed = false;
  std::vector<Position> way;
};

/// An operator of a UAV's supervisor was applied. Source: spec 6.2.
struct DecisionRecord {
  Stamp stamp;
  std::string uav;
  std::uint64_t number = 0;
  std::string applied;
  std::string cause;
  std::string inputs;
  std::string outcome;
  double took = 0.0;  ///< [s] of mission time
};

}  // namespace skein::report
