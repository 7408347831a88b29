// SPDX-License-Identifier: Apache-2.0
// The wind that a vehicle feels against the wind that the functional simulator makes.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "skein/sim/simulator.hpp"
#include "testing/planning_lab.hpp"
#include "watch/wind_estimator.hpp"

namespace skein::supervisor {
namespace {

using testing::vehicle_of;
using testing::world_of;
using world::Vector3;

constexpr Duration kStep = Duration::milliseconds(500);

/// Flies a square of 200 m at 60 m, twice, and looks at itself twice a second.
WindEstimator felt(const world::VehicleModel& model, const world::Wind& wind, std::uint64_t seed) {
  const world::World world = world_of("scenarios/domains/seeds.yaml");
  sim::SimulatorConfig config{world.terrain};
  config.wind = wind;
  config.radio = world.radio;
  config.vehicles = {{"uav", model, world::Vector2::Zero(), 0, 1}};
  config.seed = seed;
  sim::Simulator simulator(config);
  WindEstimator estimator(model, {0, 0, wind.gusts});
  MissionTime now;
  std::uint64_t task = 0;
  const auto fly = [&](const std::string& type, const char* key, std::vector<double> numbers) {
    functional::Parameters parameters;
    parameters.add(key, std::move(numbers));
    auto effects = simulator.handle(
        sim::FunctionalRequest{
            "uav", {functional::Verb::kDispatch, functional::TaskId(++task), type, parameters}},
        now);
    for (int i = 0; i < 2000; ++i) {
      for (const sim::Effect& one : effects) {
        const auto* told = std::get_if<sim::FunctionalStatus>(&one);
        if (told != nullptr && told->status.id == functional::TaskId(task) &&
            told->status.state == functional::TaskState::kEnded)
          return;
      }
      now = now + kStep;
      effects = simulator.handle(sim::Tick{}, now);
      estimator.see(*simulator.find_vehicle("uav"), now);
    }
    FAIL() << type << " never ends";
  };
  fly("takeoff", "altitude", {60});
  for (int i = 0; i < 8; ++i) {
    const double x = i % 4 == 1 || i % 4 == 2 ? 200 : 0, y = i % 4 >= 2 ? 200 : 0;
    fly("goto", "waypoints", {x, y, 60});
  }
  return estimator;
}

struct Wind {
  double toward, speed;
};
void PrintTo(const Wind& wind, std::ostream* out) { *out << wind.speed << " m/s"; }

class FeltWind : public ::testing::TestWithParam<Wind> {};

// A blimp gives way to four tenths of the wind.
TEST_P(FeltWind, OfABlimpIsTheWindOfTheSimulator) {
  const world::Wind wind{GetParam().toward, GetParam().speed, 0.5};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const WindEstimator estimator =
        felt(vehicle_of("scenarios/comets/models/karma.yaml"), wind, seed);

    const double error =
        (world::mean_velocity(estimator.wind()) - world::mean_velocity(wind)).norm();
    EXPECT_LT(error, 1) << "seed " << seed;
    EXPECT_LT(error, 3 * estimator.spread()) << "it knows how well it knows, seed " << seed;
  }
}

// An autopilot that takes out nearly all of the wind leaves next to nothing to feel.
TEST_P(FeltWind, OfAHelicopterThatHoldsAgainstItIsNotClaimedToBeKnown) {
  const world::Wind wind{GetParam().toward, GetParam().speed, 0.5};

  const WindEstimator estimator = felt(vehicle_of("scenarios/comets/models/marvin.yaml"), wind, 1);

  EXPECT_GT(estimator.spread(), 0.6);
}

INSTANTIATE_TEST_SUITE_P(Simulator, FeltWind,
                         ::testing::Values(Wind{0, 0}, Wind{0.6, 2}, Wind{3.5, 3}, Wind{-1.2, 4}));

}  // namespace
}  // namespace skein::supervisor
