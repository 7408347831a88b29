// SPDX-License-Identifier: Apache-2.0
// What each high-level task of the COMETS domain comes down to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flight/closed_air.hpp"
#include "flight/flight_times.hpp"
#include "testing/planned.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using mission::Dependence;
using mission::DependenceKind;
using mission::ElementaryTask;
using ::testing::ElementsAre;
using testing::flying;
using ::testing::IsEmpty;
using testing::names_of;
using testing::planned;
using testing::PlanningLab;
using world::Vector3;
using Names = std::vector<std::string>;

Dependence ended(std::uint64_t id) { return {DependenceKind::kEnded, executive::TaskId(id)}; }
Dependence running(std::uint64_t id) { return {DependenceKind::kRunning, executive::TaskId(id)}; }

TEST(PlanningMethods, TakeoffInTheAirAndLandingOnTheGroundAreNothingToDo) {
  PlanningLab in_the_air = flying(), on_the_ground;
  in_the_air.task(1, "general-takeoff");
  on_the_ground.task(1, "general-land");

  EXPECT_THAT(planned(in_the_air).tasks, IsEmpty());
  EXPECT_THAT(planned(on_the_ground).tasks, IsEmpty());
}

TEST(PlanningMethods, TakeoffRisesToTheUsualAltitudeOverTheGround) {
  PlanningLab lab;
  lab.knowledge.altitude = 55;
  lab.task(1, "general-takeoff");

  const auto plan = planned(lab);

  ASSERT_EQ(plan.tasks.size(), 1U);
  EXPECT_EQ(plan.tasks[0].type, "takeoff");
  EXPECT_EQ(plan.tasks[0].parameters,
            executive::Parameters({executive::Parameter{"altitude", "", {55}}}));
  EXPECT_THAT(plan.tasks[0].way, ElementsAre(Vector3(0, 0, 0), Vector3(0, 0, 55)));
}

TEST(PlanningMethods, LandingComesBackOverItsPlaceOnlyWhenItIsNotThere) {
  PlanningLab above = flying(), away = flying();
  above.task(1, "general-land");
  away.flying_at({100, 0, 40}).task(1, "general-land");

  EXPECT_THAT(names_of(planned(above)), ElementsAre("land"));
  EXPECT_THAT(names_of(planned(away)), ElementsAre("gotoxyz", "land"));
  EXPECT_EQ(planned(away).tasks[0].way.back(), Vector3(0, 0, 40));
}

TEST(PlanningMethods, WhoIsOnTheGroundTakesOffFirst) {
  const std::vector<std::pair<std::string, std::vector<mission::Argument>>> all = {
      {"general-gotoxyz", {"P1"s}},
      {"general-combined-goto-and-takeshot", {"P1"s, 5.0}},
      {"perceive", {"P1"s, 5.0}},
      {"perform-detection", {"Z2"s, "P2"s, 60.0}},
      {"perform-mapping", {"Z2"s}},
      {"perform-tour", {Names{"P1", "P2"}}},
      {"perform-monitoring", {"P1"s, 60.0}},
      {"monitoring-with-relay", {"P1"s, "P2"s, "P1"s, 60.0, Names{"heliv"}}}};
  for (const auto& [name, arguments] : all) {
    PlanningLab lab;
    lab.task(1, name, arguments);

    const auto plan = planned(lab);

    ASSERT_FALSE(plan.tasks.empty()) << name;
    EXPECT_EQ(plan.tasks.front().type, "takeoff") << name;
    EXPECT_EQ(plan.tasks.front().origin, mission::GoalId(1)) << name;
  }
}

TEST(PlanningMethods, GoingWhereItIsAlreadyIsNothingToDo) {
  PlanningLab lab = flying();
  lab.task(1, "general-gotoxyz", {Vector3(0.5, 0, 40)});

  EXPECT_THAT(planned(lab).tasks, IsEmpty());
}

TEST(PlanningMethods, APlaceOnTheGroundIsFlownToAtTheUsualAltitude) {
  PlanningLab lab = flying();
  lab.task(1, "general-gotoxyz", {"tree"s});

  const auto plan = planned(lab);

  ASSERT_EQ(plan.tasks.size(), 1U);
  EXPECT_EQ(plan.tasks[0].way.back(), Vector3(250, 0, 40));
}

TEST(PlanningMethods, APlaceOnTheGroundIsLookedAtFromAViewpoint) {
  PlanningLab lab = flying();
  lab.task(1, "general-combined-goto-and-takeshot", {"tree"s, 5.0});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("gotoxyz", "wait", "takeshot"));
  EXPECT_GT(plan.tasks[0].way.back().z(), 5);
  const auto* target = plan.tasks[2].parameters.find("target");
  ASSERT_NE(target, nullptr);
  EXPECT_THAT(target->numbers, ElementsAre(250, 0, 0));
}

TEST(PlanningMethods, APlaceInTheAirIsFlownToAndHasNoTarget) {
  PlanningLab lab = flying();
  lab.task(1, "general-combined-goto-and-takeshot", {Vector3(50, 0, 60), 5.0});

  const auto plan = planned(lab);

  EXPECT_EQ(plan.tasks[0].way.back(), Vector3(50, 0, 60));
  EXPECT_EQ(plan.tasks[2].parameters.find("target"), nullptr);
}

TEST(PlanningMethods, PerceivingIsOneTaskOfThatTimeThatHoldsTheVehicle) {
  PlanningLab lab = flying();
  lab.task(1, "perceive", {"P1"s, 60.0}).task(2, "wait-for-orders");

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("gotoxyz", "perception", "wait"));
  EXPECT_EQ(plan.tasks[1].type, "perceive");
  EXPECT_TRUE(holds_vehicle(plan.tasks[1]));
  EXPECT_EQ(plan.tasks[1].duration.least, Duration::seconds(60));
  EXPECT_THAT(plan.tasks[1].stop, IsEmpty());
  EXPECT_THAT(plan.tasks[2].dependences, ElementsAre(ended(2)));
}

TEST(PlanningMethods, WaitingForOrdersIsOpenEnded) {
  PlanningLab lab = flying();
  lab.task(1, "wait-for-orders");

  const ElementaryTask wait = planned(lab).tasks.at(0);

  EXPECT_EQ(wait.type, "wait");
  EXPECT_TRUE(wait.open_ended);
  EXPECT_TRUE(wait.parameters.all().empty());
  EXPECT_EQ(wait.duration.most, Duration::max());
}

TEST(PlanningMethods, AWaitTakesItsTime) {
  PlanningLab lab;
  lab.task(1, "general-wait", {12.5});

  const auto plan = planned(lab);

  ASSERT_EQ(plan.tasks.size(), 1U);
  EXPECT_FALSE(plan.tasks[0].open_ended);
  EXPECT_EQ(plan.tasks[0].duration,
            (mission::Interval{Duration::seconds(12.5), Duration::seconds(12.5)}));
}

TEST(PlanningMethods, AWaitOfAPilotMayBeginLate) {
  PlanningLab lab;
  lab.vehicle(testing::vehicle_of("scenarios/comets/models/heliv.yaml"));
  lab.task(1, "general-wait", {10.0});

  const auto plan = planned(lab);

  EXPECT_EQ(plan.tasks.at(0).duration.least, Duration::seconds(10));
  EXPECT_GT(plan.tasks[0].duration.most, Duration::seconds(11));
}

TEST(PlanningMethods, PicturesWhileWaitingEndWithTheWait) {
  PlanningLab lab = flying();
  lab.task(1, "takeshot-while-waiting", {30.0});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "takeshot"));
  EXPECT_THAT(plan.tasks[1].dependences, ElementsAre(running(1)));
  EXPECT_THAT(plan.tasks[1].stop, ElementsAre(ended(1)));
}

TEST(PlanningMethods, AWaitUntilSynchroEndsWithIt) {
  PlanningLab lab = flying();
  lab.uav("karma", {"karma", "heliv"});
  lab.task(1, "wait-until-synchro", {7.0, Names{"karma", "heliv"}, Names{"karma", "heliv"}});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("wait", "synchro"));
  EXPECT_THAT(plan.tasks[0].stop, ElementsAre(ended(2)));
  EXPECT_FALSE(plan.tasks[0].open_ended);
  EXPECT_THAT(plan.tasks[1].dependences, ElementsAre(running(1)));
  ASSERT_TRUE(plan.tasks[1].synchronisation);
  EXPECT_EQ(plan.tasks[1].synchronisation->id, 7U);
  EXPECT_EQ(plan.tasks[1].type, "synchronise");
}

TEST(PlanningMethods, NamesOfUavsComeBackInTheirLetters) {
  PlanningLab lab = flying();
  lab.uav("UAV-One", {"UAV-One", "Other One"});
  lab.task(1, "synchro", {7.0, Names{"UAV-One"}, Names{"Other One"}});

  const auto plan = planned(lab);

  ASSERT_TRUE(plan.tasks.at(0).synchronisation);
  EXPECT_THAT(plan.tasks[0].synchronisation->senders, ElementsAre("UAV-One"));
  EXPECT_THAT(plan.tasks[0].synchronisation->receivers, ElementsAre("Other One"));
}

TEST(PlanningMethods, ASignalIsSentByThisUavAfterWhatItDid) {
  PlanningLab lab = flying();
  lab.task(1, "takeshot-while-waiting", {5.0});
  lab.task(2, "send-signal", {1.0, Names{"heliv", "marvin"}});

  const auto plan = planned(lab);

  const ElementaryTask& signal = plan.tasks.back();
  EXPECT_EQ(signal.type, "rendezvous");
  EXPECT_THAT(signal.synchronisation->senders, ElementsAre("karma"));
  EXPECT_THAT(signal.synchronisation->receivers, ElementsAre("heliv", "marvin"));
  EXPECT_THAT(signal.dependences, ElementsAre(ended(2), ended(1)));
}

TEST(PlanningMethods, PartnersLookFromDifferentSides) {
  const auto viewpoint = [](const std::string& me) {
    PlanningLab lab = flying();
    lab.vehicle(testing::vehicle_of("scenarios/comets/models/marvin.yaml"));
    lab.uav(me, {"a", "b"});
    lab.task(1, "monitor-until", {"tree"s, 2.0, Names{me == "a" ? "b" : "a"}, 3.0, "c"s});
    return planned(lab).tasks.at(0).way.back();
  };

  const Vector3 a = viewpoint("a") - Vector3(250, 0, 0), b = viewpoint("b") - Vector3(250, 0, 0);

  const double cosine = a.head<2>().dot(b.head<2>()) / (a.head<2>().norm() * b.head<2>().norm());
  EXPECT_LE(cosine, std::cos(1.0));
}

TEST(PlanningMethods, MonitoringGoesRoundThePlace) {
  PlanningLab lab = flying();
  lab.vehicle(testing::vehicle_of("scenarios/comets/models/marvin.yaml"));
  lab.task(1, "perform-monitoring", {"tree"s, 90.0});

  const auto plan = planned(lab);

  EXPECT_THAT(names_of(plan), ElementsAre("gotoxyz", "wait", "takeshot", "gotoxyz", "wait",
                                          "takeshot", "gotoxyz", "wait", "takeshot"));
  EXPECT_EQ(plan.tasks[1].duration.least, Duration::seconds(30));
}

TEST(PlanningMethods, ATourVisitsEveryPlaceTheShortWayRound) {
  PlanningLab lab = flying();
  for (const auto& [name, x] : {std::pair{"far", 300.0}, {"near", 100.0}, {"middle", 200.0}})
    lab.world.places[name] = Vector3(x, 0, 40);
  lab.task(1, "perform-tour", {Names{"far", "near", "middle"}});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("gotoxyz", "gotoxyz", "gotoxyz"));
  EXPECT_EQ(plan.tasks[0].way.back().x(), 100);
  EXPECT_EQ(plan.tasks[1].way.back().x(), 200);
  EXPECT_EQ(plan.tasks[2].way.back().x(), 300);
}

TEST(PlanningMethods, MappingSweepsFromItsFirstLaneOnWithTheDeviceRunning) {
  PlanningLab lab = flying();
  lab.task(1, "perform-mapping", {"Z2"s});

  const auto plan = planned(lab);

  ASSERT_THAT(names_of(plan), ElementsAre("gotoxyz", "gotoxyz", "takeshot"));
  EXPECT_EQ(plan.tasks[0].way.back(), plan.tasks[1].way.front());
  EXPECT_THAT(plan.tasks[2].dependences, ElementsAre(running(2)));
  EXPECT_THAT(plan.tasks[2].stop, ElementsAre(ended(2)));
}

/// Part of the zone that a sensor of that half angle, looking straight down, never has in view.
double unseen_part(const std::vector<Vector3>& way, double aperture, const world::Polygon& zone,
                   const world::Terrain& terrain) {
  const auto sees = [&](const Vector3& from, const Vector3& place) {
    return (from - place).head<2>().norm() <= (from.z() - place.z()) * std::tan(aperture);
  };
  const auto is_seen = [&](const Vector3& place) {
    for (std::size_t i = 1; i < way.size(); ++i)
      for (double share = 0; share <= 1; share += 0.05)
        if (sees(way[i - 1] + share * (way[i] - way[i - 1]), place)) return true;
    return false;
  };
  int all = 0, unseen = 0;
  for (double x = zone[0].x() + 5; x < zone[2].x(); x += 10)
    for (double y = zone[0].y() + 5; y < zone[2].y(); y += 10, ++all)
      unseen += is_seen({x, y, terrain.elevation(x, y)}) ? 0 : 1;
  return static_cast<double>(unseen) / all;
}

TEST(PlanningMethods, WhereTheGroundRisesBesideALaneLanesAreCloser) {
  const world::Polygon zone{{400, 200}, {900, 200}, {900, 600}, {400, 600}};
  const auto lane_count = [&](std::vector<world::HillSpec> hills) {
    PlanningLab lab = flying();
    lab.vehicle(testing::vehicle_of("scenarios/comets/models/karma.yaml"));
    lab.flying_at({300, 200, 110});
    lab.knowledge.altitude = 110;
    lab.world.terrain = world::Terrain({-300, -300, 1200, 900, 20, 0, std::move(hills), {}});
    lab.world.zones = {{"Z2", zone}};
    lab.task(1, "perform-mapping", {"Z2"s});
    const auto plan = planned(lab);
    const std::vector<Vector3>& way = plan.tasks.at(1).way;
    EXPECT_LT(unseen_part(way, 0.5, zone, lab.world.terrain), 0.002);
    return std::count_if(way.begin() + 1, way.end(),
                         [&](const Vector3& at) { return at.x() < zone[0].x(); });
  };

  EXPECT_LT(lane_count({}), lane_count({{{700, 650}, 60, 120}}));
}

// Found by missions of an outsider (368): a corner of the volume was between the places of its
// circle that were asked for, so it stayed for good, and said that it leaves once a minute.
TEST(PlanningMethods, WhoCannotHoverLeavesClosedAirFarEnoughForAllOfItsCircle) {
  const world::Volume smoke{"smoke", {{-152, 0}, {0, 0}, {0, 46}, {-152, 46}}, 0, 178, {}};
  for (double x = 0; x <= 49; x += 7) {
    PlanningLab lab = flying();
    lab.vehicle(testing::vehicle_of("scenarios/comets/models/karma.yaml"));
    lab.knowledge.vehicle.orbit_radius = 60;
    lab.knowledge.vehicle.min_turn_radius = 40;
    lab.knowledge.vehicle.position_precision = 1;
    lab.knowledge.vehicle.wind_drift = 0.1;
    const Vector3 at(x, -std::sqrt(58 * 58 - x * x), 80);
    lab.flying_at(at);
    lab.world.volumes = {smoke};
    lab.task(1, "leave-closed-air", {});
    const auto plan = planned(lab);
    const Vector3 stays = plan.tasks.empty() ? at : plan.tasks.back().way.back();
    EXPECT_FALSE(is_near(smoke, stays, stay_radius(lab.knowledge.vehicle))) << x;
  }
}

TEST(PlanningMethods, AJointTaskTakesItsDurationAtLeastAndLeavesTheVehicleOverTheControlCentre) {
  PlanningLab lab = flying();
  lab.task(1, "monitoring-with-relay", {"P1"s, "P2"s, "P1"s, 60.0, Names{"heliv", "marvin"}});
  lab.task(2, "general-land");

  const auto plan = planned(lab);

  const ElementaryTask& joint = plan.tasks.at(0);
  EXPECT_EQ(joint.type, "joint:monitoring-with-relay");
  EXPECT_EQ(joint.duration.least, Duration::seconds(60));
  EXPECT_GT(joint.duration.most, Duration::seconds(660));
  EXPECT_LT(joint.duration.most, Duration::max());
  EXPECT_GT(joint.energy, 0);
  EXPECT_EQ(joint.parameters.find("p3")->numbers, std::vector<double>{60});
  EXPECT_EQ(joint.parameters.find("p0")->text, "P1");  // in the letters of the world
  EXPECT_EQ(joint.parameters.find("p4")->text, "heliv marvin");
  EXPECT_EQ(plan.tasks.at(1).type, "goto");
  EXPECT_EQ(plan.tasks.at(1).start.most, joint.start.most + joint.duration.most);
}

TEST(PlanningMethods, MethodsAreTheBranchesFromTheHighLevelTaskDown) {
  PlanningLab lab = flying();
  lab.task(1, "general-combined-goto-and-takeshot", {"P1"s, 5.0});

  const auto plan = planned(lab);

  EXPECT_THAT(plan.tasks.at(0).methods, ElementsAre("goto-and-takeshot", "fly"));
  EXPECT_THAT(plan.tasks.at(2).methods,
              ElementsAre("goto-and-takeshot", "wait-and-takeshot", "takeshot-until-it-ends"));
}

TEST(PlanningMethods, TheBestDeviceThatWorksIsTaken) {
  PlanningLab lab = flying();
  lab.vehicle(testing::vehicle_of("scenarios/comets/models/heliv.yaml"));
  lab.task(1, "takeshot-while-waiting", {5.0});
  const auto device = [](const mission::ElementaryPlan& plan) {
    return plan.tasks.at(1).parameters.find("device")->text;
  };

  EXPECT_EQ(device(planned(lab)), "visible");
  lab.situation.broken = {"visible"};
  EXPECT_EQ(device(planned(lab)), "ir");
}

TEST(PlanningMethods, EnergyAndCostAreThoseOfTheTasks) {
  PlanningLab lab = flying();
  lab.task(1, "general-combined-goto-and-takeshot", {"P1"s, 5.0}).task(2, "general-land");

  const auto plan = planned(lab);

  double energy = 0, cost = 0;
  for (const ElementaryTask& task : plan.tasks) {
    energy += task.energy;
    cost += task.cost;
  }
  EXPECT_GT(energy, 0);
  EXPECT_DOUBLE_EQ(plan.energy, energy);
  EXPECT_DOUBLE_EQ(plan.cost, cost);
  EXPECT_NEAR(plan.tasks.at(1).cost, 5, 1e-9);
  EXPECT_NEAR(plan.tasks.at(1).energy, 5 * 1000 / 1.0e7, 1e-12);
}

}  // namespace
}  // namespace skein::supervisor
