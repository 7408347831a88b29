// SPDX-License-Identifier: Apache-2.0
// A small log with deliberation: Karma goes to P1, late; a second goal is dropped.
#pragma once

#include "builders.hpp"

namespace skein::report::testing {

inline GoalRecord goal(double at, std::uint64_t id, std::string state, std::string why = {}) {
  return {stamp(at, "karma"),
          "karma",
          id,
          7,
          id == 701 ? "general-gotoxyz P1" : "perform-mapping Z",
          std::move(state),
          std::move(why),
          "step detection"};
}

inline PlannedRecord planned(double at, std::uint64_t revision, std::uint64_t task,
                             std::uint64_t goal, double start, double end) {
  PlannedRecord p;
  p.stamp = stamp(at, "karma");
  p.uav = "karma";
  p.revision = revision;
  p.task = task;
  p.type = "goto";
  p.goal = goal;
  p.earliest_start = start;
  p.latest_start = start + 2;
  p.earliest_end = end;
  p.latest_end = end + 10;
  p.after = "ended 100";
  p.methods = "general-gotoxyz > fly";
  p.committed = true;
  p.way = {{0, 0, 40}, {100, 0, 40}};
  return p;
}

inline DecisionRecord decision(double at, std::uint64_t number, std::string applied,
                               std::string cause, std::string inputs, std::string outcome) {
  return {
      stamp(at, "karma"), "karma", number, std::move(applied), std::move(cause), std::move(inputs),
      std::move(outcome), 0.05};
}

inline Journal deliberated() {
  Journal j;
  for (int t = 0; t <= 60; t += 10) j.telemetry.push_back(telemetry(t, "karma", {10.0 * t, 0, 30}));
  j.goals = {goal(1, 701, "received"),  goal(1, 702, "received"),
             goal(2, 701, "planned"),   goal(2, 702, "planned"),
             goal(5, 701, "under-way"), goal(31, 702, "failed", "no way to Z"),
             goal(40, 701, "achieved")};
  j.plans = {{stamp(2, "karma"), "karma", 1, 2}, {stamp(31, "karma"), "karma", 2, 1}};
  j.planned = {planned(2, 1, 101, 701, 4, 20), planned(2, 1, 102, 702, 20, 50),
               planned(31, 2, 101, 701, 5, 32)};
  j.tasks = {task(3, "karma", 101, TaskState::kScheduled),
             task(5, "karma", 101, TaskState::kStarted), task(6, "karma", 101, TaskState::kRunning),
             task(40, "karma", 101, TaskState::kEnded)};
  j.decisions = {
      decision(1, 1, "0 user request", "mission 7", "goals 701 702", "accepted"),
      decision(31, 2, "6 repair: drop", "task 101 overdue by 1.0 s", "goal 702", "1 task left")};
  return j;
}

}  // namespace skein::report::testing
