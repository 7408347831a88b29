// SPDX-License-Identifier: Apache-2.0
// Requests for planning, over the worlds, vehicles and the domain of scenarios/.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor::testing {

/// A file below the root of the source tree.
std::string file_text(const std::string& path);

world::World world_of(const std::string& path);
world::VehicleModel vehicle_of(const std::string& path);

/// "zero" of scenarios/domains/seeds.yaml, its vehicle, the domain of COMETS.
class PlanningLab {
 public:
  PlanningLab();

  PlanningLab& uav(const std::string& name, std::vector<std::string> team);
  PlanningLab& vehicle(world::VehicleModel model);
  PlanningLab& domain(std::string text);
  PlanningLab& flying_at(const world::Vector3& position);
  PlanningLab& first_id(std::uint64_t id);
  PlanningLab& task(std::uint64_t id, const std::string& name,
                    std::vector<mission::Argument> arguments = {},
                    mission::TimeConstraints time = {});

  PlanningRequest request() const;
  Result<mission::ElementaryPlan, PlanningFailure> plan() const { return plan_tasks(request()); }
  /// The plan of a request that has one, in the form of the seeds; else why not.
  std::string taskreq() const;
  /// All reasons, in one text.
  std::string reasons() const;

  world::World world;
  Knowledge knowledge;
  Situation situation;
  std::vector<mission::HighLevelTask> tasks;
};

}  // namespace skein::supervisor::testing
