// SPDX-License-Identifier: Apache-2.0
// Worlds, zones and refiners for patterns that the simulator flies.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "refinery/refinery.hpp"
#include "skein/foundation/random.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor::testing {

using world::Vector2;

inline constexpr double kRangeStep = 0.1;  // [s] of the range

inline world::World windy(Random& random) {
  world::World world = world_of("scenarios/domains/seeds.yaml");
  world.wind = {random.uniform(-3, 3), random.uniform(0, 3), random.uniform(0, 0.7)};
  return world;
}

/// A quadrilateral, at times far longer than wide.
inline world::Zone a_zone(Random& random, double least, double most) {
  const Vector2 centre(random.uniform(-120, 120), random.uniform(-120, 120));
  const double width = random.uniform(least, most), height = random.uniform(least, most);
  const double turned = random.uniform(0, 3);
  world::Zone zone;
  zone.name = "zone";
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const double u = x * width / 2 * random.uniform(0.8, 1), v = y * height / 2;
    zone.polygon.emplace_back(centre.x() + u * std::cos(turned) - v * std::sin(turned),
                              centre.y() + u * std::sin(turned) + v * std::cos(turned));
  }
  return zone;
}

inline world::Zone a_square(Random& random, double side) {
  const double turned = random.uniform(0, 3);
  world::Zone zone;
  zone.name = "zone";
  for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    zone.polygon.emplace_back(side * (u * std::cos(turned) - v * std::sin(turned)),
                              side * (u * std::sin(turned) + v * std::cos(turned)));
  }
  return zone;
}

inline Refinery refinery_of(const world::World& world, const world::VehicleModel& model,
                            double altitude) {
  Knowledge knowledge;
  knowledge.vehicle = model;
  knowledge.altitude = altitude;
  return Refinery(Gazetteer(std::make_shared<const Knowledge>(knowledge),
                            std::make_shared<const world::World>(world)),
                  {}, 1);
}

inline functional::Parameters altitude_of(double metres) {
  functional::Parameters parameters;
  parameters.add("altitude", metres);
  return parameters;
}

inline functional::Parameters seconds_of(double seconds) {
  functional::Parameters parameters;
  parameters.add("duration", seconds);
  return parameters;
}

}  // namespace skein::supervisor::testing
