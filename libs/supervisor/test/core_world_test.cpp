// SPDX-License-Identifier: Apache-2.0
// The world as believed: the wind that is felt.
#include <cmath>

#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using world::Vector3;

const world::World& world_of(const Desk& desk) { return *desk.insertion().base.world; }

TEST(SupervisorWorld, TheWindThatIsFeltIsPlannedWithOnceItIsKnown) {
  Config config = config_for_tests();
  auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
  knowledge->vehicle.hovers = false;
  knowledge->vehicle.cruise_speed = 8;
  knowledge->vehicle.wind_drift = 1;
  config.knowledge = knowledge;
  Desk desk = Desk::engaged(config);
  std::vector<std::string> said;
  for (int s = 0; s < 200; ++s) {
    world::VehicleState state;
    state.airborne = true;
    state.heading = world::wrapped(0.1 * s);
    state.velocity = 8 * Vector3(std::cos(0.1 * s), std::sin(0.1 * s), 0) + Vector3(3, 0, 0);
    desk.at(s).give(VehicleSeen{state, {}});
    for (const std::string& text : desk.notices())
      if (text.find("wind") != std::string::npos) said.push_back(text);
  }

  desk.add(a_mission(1, {701}));

  EXPECT_THAT(said, ::testing::SizeIs(::testing::AllOf(::testing::Ge(1U), ::testing::Le(4U))));
  ASSERT_TRUE(desk.job_started());
  EXPECT_NEAR(world::mean_velocity(world_of(desk).wind).x(), 3, 0.8);
}

}  // namespace
}  // namespace skein::supervisor
