// SPDX-License-Identifier: Apache-2.0
// Air that is closed across ways, over waits and around the UAV. Source: spec 6.2 (6).
#include "testing/core_harness.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

WorldChanged closed(std::string name, world::Polygon polygon, world::TimeWindow when = {}) {
  return {{{std::move(name), std::move(polygon), 0, 100, when}, false}};
}
const world::Polygon kAhead{{200, -50}, {300, -50}, {300, 50}, {200, 50}};
const world::Polygon kBehind{{-300, -50}, {-200, -50}, {-200, 50}, {-300, 50}};
const world::Polygon kHere{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
const world::Polygon kOnPlanned{{400, 200}, {600, 200}, {600, 300}, {400, 300}};

/// Knows how to leave closed air.
Config that_leaves() {
  Config config = config_for_tests();
  Knowledge knowledge = *config.knowledge;
  knowledge.vocabulary.tasks["leave-closed-air"] = {"leave-closed-air", {}, {}};
  config.knowledge = std::make_shared<Knowledge>(knowledge);
  return config;
}

/// Waits at (0, 0, 40) for orders, goal 701.
Desk waiting(Config config = that_leaves()) {
  Desk desk = Desk::engaged(std::move(config));
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "wait", 701).until_orders()}));
  desk.flies();
  desk.runs(100);
  return desk;
}

TEST(SupervisorWorld, ClosedAheadStopsWhatFliesThere) {
  Desk desk = flying();

  desk.at(30).give(closed("fire", kAhead));

  EXPECT_TRUE(desk.of<Answer>()[0].accepted);
  EXPECT_THAT(desk.requests(), ElementsAre("ABORT 101", "START 103"));
  EXPECT_EQ(desk.repair().failed->id, GoalId{701});
  EXPECT_EQ(desk.repair().base.world->volumes.size(), 1U);
}

/// It is carried past corners though it brakes for them.
Config of_a_helicopter() {
  Config config = config_for_tests();
  Knowledge slow = *config.knowledge;
  slow.vehicle.cruise_speed = 8;
  slow.vehicle.acceleration = 1;
  config.knowledge = std::make_shared<Knowledge>(slow);
  return config;
}

world::Polygon beyond(double edge) { return {{edge, -50}, {300, -50}, {300, 50}, {edge, 50}}; }

TEST(SupervisorWorld, ClosedJustBeyondACornerStopsWhatFliesThere) {
  const auto stopped_by = [](double edge) {
    Desk desk = Desk::engaged(of_a_helicopter());
    desk.add(a_mission(1, {701}));
    desk.finish(inserted({701}, {TaskOf(100, "goto", 701)
                                     .takes(100, 120)
                                     .way({{0, 0, 40}, {200, 0, 40}, {200, 200, 40}})}));
    desk.runs(100);
    world::VehicleState state;
    state.position = {190, 0, 40};
    state.velocity = {8, 0, 0};
    state.airborne = true;
    desk.give(VehicleSeen{state, {}});
    desk.at(30).give(closed("fire", beyond(edge)));
    return desk.job_started();
  };

  EXPECT_TRUE(stopped_by(202));
  EXPECT_FALSE(stopped_by(240));
}

// While the way was planned, the air beyond its corner was open.
TEST(SupervisorWorld, ClosedJustBeyondACornerOfAWayToComeMakesThatPlannedAnew) {
  const auto planned_anew_by = [](double edge) {
    Desk desk = Desk::engaged(of_a_helicopter());
    desk.add(a_mission(1, {701, 702}));
    desk.finish(inserted({701, 702},
                         {TaskOf(100, "goto", 701).takes(50, 60).way({{-400, 0, 40}, {0, 0, 40}}),
                          TaskOf(101, "goto", 702)
                              .after(100)
                              .takes(100, 120)
                              .way({{0, 0, 40}, {100, 0, 40}, {200, 0, 40}, {200, 200, 40}})}));
    desk.flies({-400, 0, 40});
    desk.runs(100);
    desk.at(30).give(closed("fire", beyond(edge)));
    return desk.job_started();
  };

  EXPECT_TRUE(planned_anew_by(202));
  EXPECT_FALSE(planned_anew_by(240));
}

TEST(SupervisorWorld, ClosedWhereItHasBeenOrBeforeItComesStopsNothing) {
  Desk desk = flying();
  desk.flies({350, 0, 40});

  desk.at(60).give(closed("passed", kAhead));
  EXPECT_FALSE(desk.job_started());
  desk.give(closed("elsewhere", kBehind));
  EXPECT_FALSE(desk.job_started());
  desk.give(closed("short", kOnPlanned, {at(60), at(90)}));
  EXPECT_FALSE(desk.job_started());
}

TEST(SupervisorWorld, ClosedOnAPlannedWayMakesThatPlannedAnewOnly) {
  Desk desk = flying();

  desk.at(30).give(closed("fire", kOnPlanned));

  EXPECT_THAT(desk.requests(), IsEmpty());
  EXPECT_EQ(desk.repair().failed->id, GoalId{702});
  EXPECT_EQ(desk.repair().standing.tasks.size(), 1U);
}

TEST(SupervisorWorld, MadeOfNonsenseIsRefused) {
  Desk desk = flying();

  desk.give(closed("", {{0, 0}}));
  EXPECT_EQ(desk.of<Answer>()[0].reasons.size(), 2U);
  desk.give(WorldChanged{{{"never closed", {}, 0, 1, {}}, true}});
  EXPECT_FALSE(desk.of<Answer>()[0].accepted);
}

TEST(SupervisorWorld, ClosedAroundAUavThatWaitsIsLeftFirst) {
  Desk desk = waiting();

  desk.at(30).give(closed("fire", kHere));

  EXPECT_THAT(desk.notices(), Contains(HasSubstr("closed (volume 'fire'): it leaves at once")));
  EXPECT_THAT(desk.requests(), Contains("ABORT 100"));
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().failed->id, GoalId{701});
  ASSERT_EQ(desk.repair().remaining.size(), 1U);
  EXPECT_EQ(desk.repair().remaining[0].name, "leave-closed-air");
  EXPECT_EQ(desk.repair().failed_at, 1U);
}

// Found by a storm (contingencies/air-closes-on-perception 308): pauses grew to 40 s.
TEST(SupervisorWorld, WhichAVehicleRefusesToLeaveIsTriedAgainEveryTenSeconds) {
  Desk desk = waiting();
  desk.at(30).give(closed("fire", kHere));
  desk.aborted_as_asked(100);
  const std::uint64_t leaving = desk.repair().remaining.at(0).id.value();

  std::vector<Duration> pauses;
  for (std::uint64_t id = 200; id < 800; id += 100) {
    desk.finish(repaired(RepairStep::kRefine, {leaving, 701}, {TaskOf(id, "goto", leaving)}));
    const MissionTime refused = desk.now;
    desk.aborted(id, "no");
    for (int i = 0; i < 60 && !desk.job_started(); ++i) {
      desk.now = desk.now + secs(1);
      desk.give(Tick{});
    }
    ASSERT_TRUE(desk.job_started());
    EXPECT_TRUE(desk.repair().refine_failed) << "it is not given up";
    pauses.push_back(desk.now - refused);
  }

  EXPECT_THAT(pauses, ElementsAre(secs(0), secs(5), secs(10), secs(10), secs(10), secs(10)));
}

// It braked towards it when it closed, and has come to rest inside.
TEST(SupervisorWorld, ThatItWasCarriedIntoIsLeft) {
  Desk desk = waiting();
  desk.at(30).give(closed("fire", kAhead));
  ASSERT_FALSE(desk.job_started());

  desk.at(40).flies({210, 0, 40});

  EXPECT_THAT(desk.notices(), Contains(HasSubstr("it leaves at once")));
  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining[0].name, "leave-closed-air");
}

TEST(SupervisorWorld, ClosedOverAWaitElsewhereConcernsThatGoalOnly) {
  Desk desk = Desk::engaged(that_leaves());
  desk.add(a_mission(1, {701, 702}));
  desk.finish(
      inserted({701, 702}, {TaskOf(100, "goto", 701).takes(100, 110).way({{0, 0, 40}, {0, 20, 40}}),
                            TaskOf(101, "wait", 702).after(100).takes(50, 50)}));
  desk.flies({500, 0, 40});
  desk.runs(100);
  desk.flies({500, 0, 40});

  desk.at(30).give(closed("fire", {{-20, 19}, {20, 19}, {20, 60}, {-20, 60}}));

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().failed->id, GoalId{701}) << "it flies there";
  EXPECT_THAT(desk.notices(), ::testing::Each(::testing::Not(HasSubstr("leaves at once"))));
}

TEST(SupervisorWorld, ClosedForATimeThatIsOverWhenItWouldBeMetStopsNothing) {
  Desk desk = waiting();
  desk.at(30).give(closed("past", kHere, {at(5), at(29)}));
  EXPECT_FALSE(desk.job_started());
}

TEST(SupervisorWorld, ThatIsToCloseIsLeftAMinuteBefore) {
  Desk desk = waiting();
  desk.at(30).give(closed("later", kHere, {at(300), at(400)}));
  EXPECT_FALSE(desk.job_started());
  EXPECT_EQ(desk.supervisor.next_wakeup(), at(240));

  desk.at(240).give(Tick{});

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining[0].name, "leave-closed-air");
}

TEST(SupervisorWorld, TheWayOutDoesNotCountAsAWayIn) {
  Desk desk = waiting();
  desk.at(30).give(closed("fire", kHere));
  const std::uint64_t own = desk.repair().remaining[0].id.value();
  RepairOutcome outcome =
      repaired(RepairStep::kDrop, {own}, {TaskOf(110, "goto", own).way({{0, 0, 40}, {70, 0, 40}})});
  desk.finish(outcome);
  desk.runs(110);

  desk.at(31).give(closed("elsewhere", kBehind));
  EXPECT_FALSE(desk.job_started());
  desk.at(32).give(closed("on the way out", {{60, -50}, {150, -50}, {150, 50}, {60, 50}}));
  EXPECT_TRUE(desk.job_started());
}

TEST(SupervisorWorld, AroundAUavOnTheGroundIsNotLeft) {
  Desk desk = Desk::engaged(that_leaves());
  desk.add(a_mission(1, {701}));
  desk.finish(inserted({701}, {TaskOf(100, "wait", 701).takes(600, 600)}));
  desk.runs(100);

  desk.at(30).give(closed("fire", kHere));

  EXPECT_FALSE(desk.job_started());
}

// An operator flew it there at a lower degree, and gave it to itself without a mission.
TEST(SupervisorWorld, ClosedAroundAUavThatWasNeverGivenAMissionIsLeft) {
  Desk told_of_it = Desk::engaged(that_leaves()), was_in_it = Desk::engaged(that_leaves());
  told_of_it.flies();
  was_in_it.give(closed("fire", kHere));

  told_of_it.at(30).give(closed("fire", kHere));
  was_in_it.at(30).flies();

  for (Desk* desk : {&told_of_it, &was_in_it}) {
    ASSERT_TRUE(desk->job_started());
    EXPECT_EQ(desk->repair().remaining[0].name, "leave-closed-air");
  }
}

/// It cannot hover, and circles 40 m wide.
Config of_a_blimp() {
  Config config = that_leaves();
  Knowledge knowledge = *config.knowledge;
  world::VehicleModel& vehicle = knowledge.vehicle;
  vehicle.hovers = false;
  vehicle.orbit_radius = 40;
  vehicle.min_turn_radius = 20;
  vehicle.cruise_speed = vehicle.max_speed = 8;
  vehicle.min_speed = 2;
  vehicle.acceleration = 0.5;
  vehicle.climb_rate = vehicle.descent_rate = 1;
  vehicle.position_precision = 1;
  knowledge.home = {-500, 0, 0};
  config.knowledge = std::make_shared<Knowledge>(knowledge);
  return config;
}

/// Flies to (0, 0, 40), then on to (400, 0, 40).
Desk on_two_ways(Config config) {
  Desk desk = Desk::engaged(std::move(config));
  desk.add(a_mission(1, {701, 702}));
  desk.finish(inserted(
      {701, 702},
      {TaskOf(100, "goto", 701).takes(20, 60).way({{-300, 0, 40}, {0, 0, 40}}),
       TaskOf(101, "goto", 702).after(100).takes(50, 90).way({{0, 0, 40}, {400, 0, 40}})}));
  desk.flies({-300, 0, 40});
  desk.runs(100);
  desk.flies({-200, 0, 40});
  return desk;
}

// It sets out from anywhere on its circle, up to 40 m beside its way.
TEST(SupervisorWorld, ClosedBesideAWayToComeCountsAsFarAsFlightsAlongItStray) {
  const world::Polygon beside{{100, 12}, {200, 12}, {200, 80}, {100, 80}};
  Desk blimp = on_two_ways(of_a_blimp()), far = on_two_ways(of_a_blimp());

  blimp.at(30).give(closed("smoke", beside));
  far.at(30).give(closed("smoke", {{100, 90}, {200, 90}, {200, 180}, {100, 180}}));

  ASSERT_TRUE(blimp.job_started());
  EXPECT_EQ(blimp.repair().failed->id, GoalId{702});
  EXPECT_FALSE(far.job_started());
}

TEST(SupervisorWorld, ClosedWhereItIsToCircleStopsTheWayThere) {
  const world::Polygon near_its_end{{-10, 30}, {10, 30}, {10, 60}, {-10, 60}};
  Desk blimp = on_two_ways(of_a_blimp()), hovers = on_two_ways(that_leaves());

  blimp.at(30).give(closed("smoke", near_its_end));
  hovers.at(30).give(closed("smoke", near_its_end));

  ASSERT_TRUE(blimp.job_started());
  EXPECT_EQ(blimp.repair().failed->id, GoalId{701});
  EXPECT_FALSE(hovers.job_started());
}

// Stopped, it would circle where it is.
TEST(SupervisorWorld, ClosedAheadSoNearThatItWouldCircleThereIsLeftBeforeAnythingElse) {
  const world::Polygon ahead{{-165, -20}, {-100, -20}, {-100, 20}, {-165, 20}};
  Desk blimp = on_two_ways(of_a_blimp()), hovers = on_two_ways(that_leaves());

  blimp.at(30).give(closed("smoke", ahead));
  hovers.at(30).give(closed("smoke", ahead));

  ASSERT_TRUE(blimp.job_started());
  EXPECT_EQ(blimp.repair().remaining[0].name, "leave-closed-air");
  EXPECT_TRUE(blimp.repair().base.situation.flies_on);
  ASSERT_TRUE(hovers.job_started());
  EXPECT_NE(hovers.repair().remaining[0].name, "leave-closed-air");
  EXPECT_FALSE(hovers.repair().base.situation.flies_on);
}

/// At degree 4 with nothing to do, after a flight to (0, 0, 40) that it circles over, 40 m wide.
Desk circling(const world::Vector3& now_at) {
  Config config = that_leaves();
  Knowledge knowledge = *config.knowledge;
  knowledge.vehicle.hovers = false;
  knowledge.vehicle.orbit_radius = 40;
  config.knowledge = std::make_shared<Knowledge>(knowledge);
  Desk desk = Desk::engaged(std::move(config));
  desk.add(a_mission(1, {701}));
  desk.finish(
      inserted({701}, {TaskOf(100, "goto", 701).takes(20, 60).way({{-200, 0, 40}, {0, 0, 40}})}));
  desk.flies({-200, 0, 40});
  desk.runs(100);
  desk.flies({0, 0, 40});
  desk.at(30).ends(100);
  desk.flies(now_at);
  return desk;
}
const world::Polygon kWestOfTheCircle{{-60, -20}, {-30, -20}, {-30, 20}, {-60, 20}};

TEST(SupervisorWorld, ClosedOnTheOtherSideOfTheCircleThatItWaitsOnIsLeft) {
  Desk desk = circling({40, 0, 40});

  desk.at(60).give(closed("smoke", kWestOfTheCircle));

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining[0].name, "leave-closed-air");
  EXPECT_EQ(desk.repair().base.situation.position, world::Vector3(0, 0, 40));
  EXPECT_FALSE(desk.repair().base.situation.flies_on);
}

TEST(SupervisorWorld, FarFromWhereItWasSentItIsWhereItIs) {
  Desk desk = circling({200, 0, 40});

  desk.at(60).give(closed("smoke", kWestOfTheCircle));

  EXPECT_FALSE(desk.job_started());
}

/// On the circle over (0, 0, 40) still: its flight on was started, and waits for reserved air.
Desk circling_until_the_air_is_granted(const world::Vector3& now_at) {
  Desk desk = on_two_ways(of_a_blimp());
  desk.flies({0, 0, 40});
  desk.at(30).ends(100);
  desk.seen(101, TaskState::kStarted);
  desk.flies(now_at);
  return desk;
}

TEST(SupervisorWorld, ClosedOnTheCircleOfOneWhoseFlightWaitsForAirIsLeft) {
  Desk desk = circling_until_the_air_is_granted({40, 0, 40});

  desk.at(60).give(closed("smoke", kWestOfTheCircle));

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining[0].name, "leave-closed-air");
  EXPECT_EQ(desk.repair().base.situation.position, world::Vector3(0, 0, 40));
}

TEST(SupervisorWorld, AClosedCircleThatItComesToWhileItsFlightWaitsForAirIsLeft) {
  Desk desk = circling_until_the_air_is_granted({200, 0, 40});
  desk.at(60).give(closed("smoke", kWestOfTheCircle));
  ASSERT_FALSE(desk.job_started());

  desk.at(90).flies({40, 0, 40});

  ASSERT_TRUE(desk.job_started());
  EXPECT_EQ(desk.repair().remaining[0].name, "leave-closed-air");
}

TEST(SupervisorWorld, AFlightThatHasJustBegunIsNotTakenForOneThatWaitsForAir) {
  Desk desk = circling_until_the_air_is_granted({200, 0, 40});
  desk.at(60).give(closed("smoke", kWestOfTheCircle));
  desk.seen(101, TaskState::kRunning);

  desk.at(90).flies({40, 0, 40});

  EXPECT_FALSE(desk.job_started());
}

}  // namespace
}  // namespace skein::supervisor
