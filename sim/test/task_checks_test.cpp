// SPDX-License-Identifier: Apache-2.0
#include "skein/elementary/task_checks.hpp"

#include <gmock/gmock.h>

#include "skein/functional/task_types.hpp"
#include "testing.hpp"

namespace skein::sim {
namespace {

using elementary::checked_task;
using elementary::TakeoffTask;
using testing::altitude;
using testing::at;
using testing::device;
using ::testing::HasSubstr;
using testing::model_of;
using ::testing::Not;
using testing::way;
using testing::with_hill;

/// A request to a vehicle in some state; gives the reasons for refusal, or "accepted".
struct Asked {
  world::VehicleModel model = model_of("marvin");
  world::Terrain terrain = with_hill(500, 0, 80, 200);
  world::VehicleState state = {};
  bool engine_works = true;

  Asked& in_the_air() {
    state.airborne = true;
    state.position = {0, 0, 40};
    return *this;
  }
  std::string operator()(const std::string& type,
                         const functional::Parameters& parameters = {}) const {
    const auto task = checked_task(type, parameters, {model, terrain, state, engine_works});
    return task ? "accepted" : task.error().why;
  }
};

TEST(TaskChecks, AcceptsWhatIsPossible) {
  Asked on_ground, in_air;
  in_air.in_the_air();

  EXPECT_EQ(on_ground("takeoff", altitude(40)), "accepted");
  EXPECT_EQ(on_ground("takeshot", device("visible")), "accepted");
  EXPECT_EQ(on_ground("wait"), "accepted");
  EXPECT_EQ(in_air("land"), "accepted");
  EXPECT_EQ(in_air("goto", way({{100, 0, 40}})), "accepted");
  EXPECT_EQ(in_air("goto", way({{100, 0, 40}}).add("speed", 3)), "accepted");
  EXPECT_EQ(in_air("wait", functional::Parameters().add("duration", 60)), "accepted");
  EXPECT_EQ(in_air("takeshot", device("visible").add("target", {500, 0, 80}).add("shots", 3)),
            "accepted");
}

TEST(TaskChecks, UnknownTypesAreRefusedWithTheNearest) {
  EXPECT_EQ(Asked()("takeof"), "unknown task type 'takeof'; did you mean 'takeoff'?");
  EXPECT_EQ(Asked()("somersault"), "unknown task type 'somersault'");
}

TEST(TaskChecks, UnknownDevicesAreRefusedWithTheNearest) {
  EXPECT_EQ(Asked()("takeshot", device("visibel")),
            "no device 'visibel' on board; did you mean 'visible'?");
  EXPECT_EQ(Asked()("takeshot"), "device is missing");
}

TEST(TaskChecks, TakeoffNeedsTheGroundAndAHeightItCanReach) {
  EXPECT_EQ(Asked().in_the_air()("takeoff", altitude(40)), "already in the air");
  EXPECT_EQ(Asked()("takeoff"), "altitude is missing");
  EXPECT_EQ(Asked()("takeoff", altitude(301)),
            "altitude 301 m is not between 2 m and the ceiling of 300 m above ground");
  EXPECT_EQ(Asked()("takeoff", altitude(0)),
            "altitude 0 m is not between 2 m and the ceiling of 300 m above ground");
}

TEST(TaskChecks, TakeoffHeightIsAboveTheGroundThere) {
  Asked asked;
  asked.state.position = {500, 0, 80};

  const auto task =
      checked_task("takeoff", altitude(30), {asked.model, asked.terrain, asked.state, true});

  ASSERT_TRUE(task);
  EXPECT_NEAR(std::get<TakeoffTask>(*task).height, 110, 1e-9);
}

TEST(TaskChecks, WaypointsMustBeWithinTheWorldOverTheGroundAndUnderTheCeiling) {
  const Asked asked = Asked().in_the_air();

  EXPECT_EQ(asked("goto", way({{5000, 0, 40}})), "way-point 1 is outside the terrain");
  EXPECT_EQ(asked("goto", way({{0, 50, -3}})), "way-point 1 is 3 m under the ground");
  EXPECT_EQ(asked("goto", way({{0, 50, 1}})),
            "way-point 1 is only 1 m above the ground, less than 2 m");
  EXPECT_EQ(asked("goto", way({{0, 50, 40}, {0, 50, 400}})),
            "way-point 2 is 400 m above the ground, over the ceiling of 300 m");
}

TEST(TaskChecks, AWayThroughAHillIsRefused) {
  const Asked asked = Asked().in_the_air();

  EXPECT_EQ(asked("goto", way({{1000, 0, 40}})).rfind("the way to way-point 1 meets the ground", 0),
            0u);
  EXPECT_EQ(asked("goto", way({{0, 300, 40}, {1000, 300, 40}})), "accepted");
  EXPECT_EQ(asked("goto", way({{0, 0, 90}, {1000, 0, 90}})), "accepted");
}

TEST(TaskChecks, NoMotionBeforeTakeoff) {
  EXPECT_EQ(Asked()("goto", way({{10, 0, 40}})),
            "goto before takeoff: the vehicle is on the ground");
  EXPECT_EQ(Asked()("land"), "already on the ground");
}

TEST(TaskChecks, NoLandingOnASlope) {
  Asked asked = Asked().in_the_air();
  asked.state.position = {400, 0, 100};

  EXPECT_NE(asked("land").find("too steep to land"), std::string::npos);
}

TEST(TaskChecks, SpeedsMustBeFlyable) {
  Asked asked = Asked().in_the_air();

  EXPECT_NE(asked("goto", way({{10, 0, 40}}).add("speed", 20)), "accepted");
  EXPECT_NE(asked("goto", way({{10, 0, 40}}).add("speed", 0)), "accepted");
  asked.model = model_of("karma");
  EXPECT_EQ(asked("goto", way({{10, 0, 40}}).add("speed", 1)),
            "speed 1 m/s is not within what it can fly, 2 to 11 m/s");
}

TEST(TaskChecks, AWayThatTakesMoreThanIsLeftAboveTheReserveIsRefused) {
  Asked asked = Asked().in_the_air();
  asked.state.energy = asked.model.energy.reserve + 0.002;

  EXPECT_EQ(asked("goto", way({{0, 20, 40}})), "accepted");
  EXPECT_EQ(asked("goto", way({{0, 1900, 40}})),
            "energy too low for the way: it takes 356.25 kJ, 13 kJ are left above the reserve");
  EXPECT_EQ(asked("land"), "accepted") << "landing is what the reserve is for";
  asked.state.airborne = false;
  asked.state.energy = asked.model.energy.reserve - 0.01;
  EXPECT_NE(asked("takeoff", altitude(10)).find("energy too low for the takeoff"),
            std::string::npos);
}

TEST(TaskChecks, WithoutEngineNothingMoves) {
  Asked asked;
  asked.engine_works = false;

  EXPECT_EQ(asked("takeoff", altitude(10)), "engine failure");
  EXPECT_EQ(asked("wait"), "engine failure");
}

TEST(TaskChecks, GivesAllReasonsNotTheFirst) {
  EXPECT_EQ(Asked()("goto", way({{5000, 0, 40}, {0, 0, -1}}).add("speed", -1).add("colour", 1)),
            "unknown parameter 'colour'; speed -1 m/s is not within what it can fly, more than 0 "
            "to 14 m/s; way-point 1 is outside the terrain; way-point 2 is 1 m under the ground; "
            "goto before takeoff: the vehicle is on the ground");
}

TEST(TaskChecks, APerceptionHasATimeAndMonitoringHasNone) {
  const Asked asked;
  EXPECT_EQ(asked("perceive", device("visible").add("duration", 60)), "accepted");
  EXPECT_EQ(asked("perceive", device("visible")), "duration is missing");
  EXPECT_EQ(asked("monitor", device("visible").add("target", {500, 0, 80})), "accepted");
  EXPECT_EQ(asked("monitor", device("visible").add("duration", 60)),
            "unknown parameter 'duration'");
  EXPECT_EQ(asked("perceive", device("visibel").add("duration", 60)),
            "no device 'visibel' on board; did you mean 'visible'?");
}

TEST(TaskChecks, EveryTypeOfTheFunctionalLayerHasABehaviour) {
  using functional::CarriedOutBy;
  for (const auto& type : functional::TaskTypes::shipped().names(CarriedOutBy::kFunctionalLayer))
    EXPECT_THAT(Asked()(type), Not(HasSubstr("unknown task type"))) << type;
}

TEST(TaskChecks, TakeshotParametersAreChecked) {
  const Asked asked;
  EXPECT_EQ(asked("takeshot", device("visible").add("shots", 1.5)),
            "shots must be a whole number from 1 to 1000000");
  EXPECT_EQ(asked("takeshot", device("visible").add("duration", 0)),
            "duration must be greater than 0 s and at most 1000000 s");
  EXPECT_EQ(asked("takeshot", device("visible").add("target", {1, 2, 3, 4, 5, 6})),
            "target must be one point");
  EXPECT_EQ(asked("takeshot", device("visible").add("target", {9000, 0, 0})),
            "target is outside the terrain");
}

}  // namespace
}  // namespace skein::sim
