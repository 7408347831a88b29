// SPDX-License-Identifier: Apache-2.0
// A stand-in for "marvin", whose partner is "heliv".
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "skein/decision_node/stand_in.hpp"
#include "skein/world/world_builder.hpp"
#include "testing/level_ground.hpp"
#include "testing/watch_and_relay.hpp"

namespace skein::decision_node::testing {

inline mission::HighLevelTask watching_task(std::uint64_t id = 22) {
  mission::HighLevelTask task;
  task.id = mission::GoalId(id);
  task.name = "watching";
  task.arguments = {std::string("fire"), world::Vector3(0, 0, 5), 60.0,
                    std::vector<std::string>{"marvin", "heliv"}};
  return task;
}

/// Of which it may play the role `by_ground`; empty: none.
inline Config stood_in_config(const std::string& by_ground) {
  auto library = std::make_shared<interaction::Library>(*watching_library());
  if (!by_ground.empty()) {
    library->models.at("watching").variants.front().by_ground.insert(by_ground);
  }
  Config config;
  config.uav = "marvin";
  config.others = {"heliv"};
  auto knowledge = std::make_shared<supervisor::Knowledge>();
  knowledge->uav = "marvin";
  knowledge->vehicle.hovers = true;
  knowledge->vehicle.cruise_speed = 10;
  config.knowledge = knowledge;
  config.world = std::make_shared<world::World>(world::build_world(level_ground()).value());
  config.interaction = library;
  return config;
}

}  // namespace skein::decision_node::testing
