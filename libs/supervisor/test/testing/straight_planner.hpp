// SPDX-License-Identifier: Apache-2.0
// A planner of straight flights in an empty world, in the place of the real one: one step a task,
// so that a test sees at once what became of an order.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "insertion/judge.hpp"

namespace skein::supervisor::testing {

/// Tasks: take-off; land; visit PLACE SECONDS (with a camera); stay SECONDS; meet SYNC PLACE;
/// join UAVS PLACE (a joint task);
/// map ZONE; tour PLACES; await-orders.
class StraightPlanner {
 public:
  Result<mission::ElementaryPlan, PlanningFailure> plan(const PlanningRequest& request);
  /// Lifetime: refers to this.
  Planner planner() {
    return [this](const PlanningRequest& request) { return plan(request); };
  }

  std::set<std::string> blocked;                      ///< places that cannot be flown to
  std::vector<std::vector<std::uint64_t>> requested;  ///< the orders that were asked for
};

/// Helicopter at 10 m/s; places "P<x>_<y>" are made by place(); home at (0, 0).
class InsertionLab {
 public:
  InsertionLab();

  InsertionLab& place(const std::string& name, double x, double y);
  InsertionLab& flying();
  InsertionLab& energy(double left);
  /// Takes a name, a number of seconds where the task has one, and constraints.
  static mission::HighLevelTask visit(std::uint64_t id, const std::string& place,
                                      mission::TimeConstraints time = {});
  static mission::HighLevelTask simple(std::uint64_t id, const std::string& name);
  static mission::HighLevelTask stay(std::uint64_t id, double seconds);
  static mission::HighLevelTask meet(std::uint64_t id, double sync, const std::string& place,
                                     mission::TimeConstraints time = {});
  static mission::HighLevelTask join(std::uint64_t id, const std::string& place,
                                     mission::TimeConstraints time = {});

  PlanningRequest base() const;
  InsertionRequest insertion(Goals planned, Goals added,
                             mission::Placement placement = mission::Placement::kBest) const;

  world::World world;
  Knowledge knowledge;
  Situation situation;
  StraightPlanner straight;
};

std::vector<std::uint64_t> ids(const Goals& goals);
mission::TimeConstraints ends_before(double seconds);
mission::TimeConstraints starts_after(double seconds);

}  // namespace skein::supervisor::testing
