// SPDX-License-Identifier: Apache-2.0
#include "testing/drawn_area.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/foundation/random.hpp"
#include "skein/supervisor/area_sweep.hpp"
#include "skein/world/geometry.hpp"
#include "testing/mission.hpp"

namespace skein::testing {

namespace {

constexpr double kLeast = 1.0e6, kMost = 2.2e6;  // [m²]
constexpr double kApart = 150;                   // [m] starts from each other

/// On an ellipse, so convex.
world::Polygon drawn_polygon(Random& random, const world::Vector2& middle) {
  const double a = random.uniform(500, 1100), b = random.uniform(400, 800);
  const double turned = random.uniform(0, std::numbers::pi);
  std::vector<double> angles;
  for (std::uint64_t corners = 4 + random.below(5); corners > 0; --corners)
    angles.push_back(random.uniform(0, 2 * std::numbers::pi));
  std::sort(angles.begin(), angles.end());
  world::Polygon polygon;
  for (const double angle : angles) {
    const double x = a * std::cos(angle), y = b * std::sin(angle);
    polygon.emplace_back(middle.x() + x * std::cos(turned) - y * std::sin(turned),
                         middle.y() + x * std::sin(turned) + y * std::cos(turned));
  }
  return polygon;
}

world::Vector2 drawn_start(Random& random, const std::vector<world::Vector2>& others) {
  while (true) {
    const world::Vector2 at(random.uniform(-200, 2400), random.uniform(-200, 1900));
    const bool apart = std::all_of(others.begin(), others.end(), [&](const world::Vector2& other) {
      return (other - at).norm() > kApart;
    });
    if (apart) return at;
  }
}

scenario::Scenario drawn(const std::string& name, std::uint64_t seed) {
  Random random(seed, "drawn-area");
  scenario::Scenario scenario = scenario_at(name, with(seed));
  const world::Vector2 middle(1150, 850);
  world::Polygon polygon;
  while (polygon.size() < 4 || world::area(polygon) < kLeast || world::area(polygon) > kMost)
    polygon = drawn_polygon(random, middle);
  for (world::Zone& zone : scenario.world.zones)
    if (zone.name == "field") zone.polygon = polygon;
  scenario.world.places["middle"] = {middle.x(), middle.y(), 0};
  std::vector<world::Vector2> starts;
  for (scenario::UavSpec& uav : scenario.uavs) {
    uav.start = drawn_start(random, starts);
    starts.push_back(uav.start);
  }
  return scenario;
}

}  // namespace

scenario::Scenario drawn_area(std::uint64_t seed) { return drawn("area-sharing/negotiated", seed); }

scenario::Scenario drawn_central_area(std::uint64_t seed) {
  scenario::Scenario scenario = drawn("area-sharing/central", seed);
  for (const refiners::Part& part : divided(scenario, refiners::ShareMode::kBalanced).parts)
    for (world::Zone& zone : scenario.world.zones)
      if (zone.name == "part-" + part.uav) zone.polygon = part.polygon;
  return scenario;
}

refiners::Partition divided(const scenario::Scenario& scenario, refiners::ShareMode mode,
                            supervisor::Sweeping sweeping) {
  const bool shared = sweeping == supervisor::Sweeping::kShared;
  refiners::PartitionQuery query;
  query.mode = mode;
  query.apart = 0;
  for (const world::Zone& zone : scenario.world.zones)
    if (zone.name == "field") query.area = zone.polygon;
  const deliberation_setup::CommonKnowledge common(scenario);
  for (const scenario::UavSpec& uav : scenario.uavs) {
    const supervisor::Knowledge knowledge = *common.of(uav.name);
    refiners::Member member;
    member.uav = uav.name;
    member.vehicle = uav.model;
    member.start = uav.start.head<2>();
    member.altitude = knowledge.altitude;
    member.swath = (shared ? supervisor::shared_swath_of(knowledge, "mapping")
                           : supervisor::swath_of(knowledge, "mapping"))
                       .value();
    member.busy = shared ? 0 : knowledge.altitude / uav.model.climb_rate;
    query.members.push_back(std::move(member));
  }
  const auto world = common.world();
  query.flown = [&](const refiners::Member& member, double altitude, const world::Polygon& part) {
    return supervisor::seconds_of_sweep({member.vehicle, altitude, member.swath, member.start},
                                        part, world, sweeping);
  };
  return refine(query, refiners::Setting{*world, {}}).value().task;
}

}  // namespace skein::testing
