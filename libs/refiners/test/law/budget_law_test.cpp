// SPDX-License-Identifier: Apache-2.0
// A budget holds, whatever is asked of whichever service: what is given so many seconds of
// processor time ends soon after them, with the best so far or with "no answer in time".
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "skein/refiners/area_gates.hpp"
#include "skein/refiners/evaluate.hpp"
#include "skein/refiners/partition.hpp"
#include "skein/refiners/patrol.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/refiners/viewpoint.hpp"
#include "test_cases.hpp"
#include "testing/coverage_cases.hpp"
#include "testing/in_time.hpp"
#include "testing/raw_ground.hpp"
#include "testing/relay_cases.hpp"

namespace skein::refiners {
namespace {

using skein::testing::kRoom;
using skein::testing::processor_seconds;
using testing::expect_in_time;
using testing::kBudgets;
using testing::Relief;
using testing::rough_world;
using world::Vector2;
using world::Vector3;

world::VehicleModel tireless(world::VehicleModel vehicle) {
  vehicle.energy.capacity *= 1e6;
  vehicle.ceiling = 3000;
  return vehicle;
}

std::vector<world::VehicleModel> both() {
  return {tireless(testing::helicopter()), tireless(testing::fixed_wing())};
}

Vector3 above(const world::World& world, double x, double y, double height) {
  return {x, y, world.terrain.elevation(x, y) + height};
}

/// 15 × 15 round holes.
std::vector<world::Polygon> many_holes() {
  std::vector<world::Polygon> holes;
  for (int i = -7; i <= 7; ++i)
    for (int j = -7; j <= 7; ++j) {
      holes.emplace_back();
      for (int k = 0; k < 8; ++k)
        holes.back().emplace_back(100 * i + 30 * std::cos(k * 0.785),
                                  100 * j + 30 * std::sin(k * 0.785));
    }
  return holes;
}

/// Prisms all over a world of that half width.
std::vector<world::Volume> many_volumes(int across, double half, double share = 0.4) {
  std::vector<world::Volume> volumes;
  const double pitch = 2 * half / across;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j) {
      const double x = -half + (i + 0.5) * pitch, y = -half + (j + 0.5) * pitch;
      const double side = share * pitch / 2;
      volumes.push_back({"v" + std::to_string(i * across + j),
                         testing::rectangle(x - side, y - side, x + side, y + side),
                         0,
                         2000,
                         {}});
    }
  return volumes;
}

TEST(BudgetLaw, SweepsOfAreasOfManyCornersEndInTimeWithAnAnswer) {
  const auto world = testing::level_world(1000);
  for (const std::size_t corners : {300UL, 2000UL}) {
    Random random(corners, "star");
    CoverageQuery query;
    query.vehicle = tireless(testing::helicopter());
    query.area = testing::random_star(random, corners, 300, 900);
    query.swath = 20;
    query.altitude = 60;
    expect_in_time(query, world, "a star of " + std::to_string(corners) + " corners");

    Setting setting{world, {}, 1, nullptr};
    setting.budget.time_is_up = [began = processor_seconds()] {
      return processor_seconds() - began > 0.1;
    };
    const auto refined = refine(query, setting);
    ASSERT_TRUE(refined) << refined.error().why;
    EXPECT_GT(testing::covered(query, refined->task, 2000), 0.999);
  }
}

TEST(BudgetLaw, SweepsOfOddAreasEndInTime) {
  const auto level = testing::level_world(1000);
  auto volumes = level;
  volumes.volumes = many_volumes(20, 1000);
  const auto steep = rough_world(Relief::kBoth, 1, 300, 900, 5).world;
  for (const auto& vehicle : both()) {
    CoverageQuery query;
    query.vehicle = vehicle;
    query.area = testing::rectangle(-800, -800, 800, 800);
    query.altitude = 60;
    query.swath = 40;
    expect_in_time(query, steep, vehicle.name + ", ground with many posts");
    expect_in_time(query, volumes, vehicle.name + ", 400 volumes in the area");
    query.holes = many_holes();
    expect_in_time(query, level, vehicle.name + ", 225 holes");
    query.holes.clear();
    query.swath = 0.5;
    expect_in_time(query, level, vehicle.name + ", a swath of half a metre");
  }
}

TEST(BudgetLaw, SweepsBetweenVolumesEndInTimeAndBlameThemOnlyAfterASearch) {
  auto world = testing::level_world(1000);
  world.volumes = many_volumes(5, 700, 0.3);
  for (const std::size_t corners : {40UL, 2000UL})
    for (const auto mode : {SweepMode::kLeastTime, SweepMode::kGiven}) {
      Random random(corners, "between volumes");
      CoverageQuery query;
      query.vehicle = tireless(testing::helicopter());
      query.area = testing::random_star(random, corners, 800, 950);
      query.swath = 20;
      query.altitude = 60;
      query.mode = mode;
      expect_in_time(query, world, std::to_string(corners) + " corners, 25 volumes");

      Setting setting{world, {}, 1, nullptr};
      setting.budget.time_is_up = [] { return true; };
      const auto refined = refine(query, setting);
      EXPECT_TRUE(refined || refined.error().kind == RefusalKind::kBudgetExhausted);
    }
}

TEST(BudgetLaw, PartsOfManyMembersEndInTime) {
  auto world = testing::level_world(1000);
  world.volumes = many_volumes(4, 500, 0.2);
  for (const bool closed : {true, false})
    for (const ShareMode mode : {ShareMode::kProportional, ShareMode::kBalanced}) {
      if (!closed) world.volumes.clear();
      PartitionQuery query;
      query.mode = mode;
      for (int k = 0; k < 200; ++k)
        query.area.emplace_back(900 * std::cos(k * 0.0314159), 900 * std::sin(k * 0.0314159));
      Random random(30, "starts");
      for (int i = 0; i < 30; ++i) {
        Member member;
        member.uav = "uav" + std::to_string(i);
        member.vehicle = both()[static_cast<std::size_t>(i % 2)];
        member.start = {random.uniform(-600, 600), random.uniform(-600, 600)};
        member.swath = 4 + i % 7;
        member.altitude = 60;
        query.members.push_back(member);
      }
      expect_in_time(query, world, "thirty members");
    }
}

TEST(BudgetLaw, PartsOfOddAreasEndInTime) {
  for (const bool rough : {false, true})
    for (const ShareMode mode : {ShareMode::kProportional, ShareMode::kBalanced}) {
      const auto world =
          rough ? rough_world(Relief::kBoth, 1, 300, 900, 10).world : testing::level_world(1000);
      PartitionQuery query;
      query.mode = mode;
      for (int k = 0; k < 200; ++k)
        query.area.emplace_back(800 * std::cos(k * 0.0314159), 700 * std::sin(k * 0.0314159));
      for (int i = 0; i < 10; ++i) {
        Member member;
        member.uav = "uav" + std::to_string(i);
        member.vehicle = both()[static_cast<std::size_t>(i % 2)];
        member.start = {60.0 * i - 300, 40.0 * (i % 3)};
        member.swath = 10 + i;
        member.altitude = 60;
        query.members.push_back(member);
      }
      expect_in_time(query, world, std::string("ten members, ") + (rough ? "rough" : "level"));
    }
}

PatrolQuery patrol_over(const world::World& world, double half) {
  PatrolQuery query;
  query.vehicle = tireless(testing::helicopter());
  query.zone = testing::rectangle(-half, -half, half, half);
  query.start = above(world, 0, 0, 100);
  query.altitude = 60;
  query.footprint = 40;
  query.duration = Duration::seconds(20'000);
  return query;
}

TEST(BudgetLaw, PatrolsOfOddZonesEndInTime) {
  for (const bool rough : {false, true}) {
    auto world =
        rough ? rough_world(Relief::kBoth, 2, 300, 900, 20).world : testing::level_world(1000);
    world.ground.grid = {-900, -900, 20, 90, 90};
    for (const auto& vehicle : both()) {
      const std::string who = vehicle.name + (rough ? " over rough ground" : "");
      auto query = patrol_over(world, 850);
      query.vehicle = vehicle;
      expect_in_time(query, world, who + ", a day");
      query.footprint = 400;
      expect_in_time(query, world, who + ", a wide footprint");
      query.footprint = 12;
      expect_in_time(query, world, who + ", a narrow footprint");
      query.footprint = 40;
      Random random(7);
      query.zone = testing::random_star(random, 2000, 300, 850);
      expect_in_time(query, world, who + ", a zone of 2,000 corners");
      auto closed = world;
      closed.volumes = many_volumes(12, 850);
      query.zone = testing::rectangle(-850, -850, 850, 850);
      query.start = above(world, 70, 70, 100);
      expect_in_time(query, closed, who + ", between 144 volumes");
      if (!vehicle.hovers) continue;
      query.mode = PatrolMode::kGradient;
      query.footprint = 150;
      query.start = above(world, 0, 0, 100);
      expect_in_time(query, world, who + ", by gradient");
    }
  }
}

TEST(BudgetLaw, PatrolsOverManyCellsEndInTime) {
  auto world = testing::level_world(1000);
  world.ground.grid = {-1000, -1000, 2, 1000, 1000};
  auto query = patrol_over(world, 990);
  query.footprint = 20;
  query.duration = Duration::seconds(100'000);
  expect_in_time(query, world, "a million cells");
}

void put_three_peaks(world::GroundState& ground) {
  ground.risk.clear();
  for (std::size_t i = 0; i < ground.grid.size(); ++i) {
    const Vector2 at = ground.grid.centre(i);
    double risk = 0.05;
    for (const Vector2& peak : {Vector2(-300, 200), Vector2(250, -350), Vector2(400, 420)})
      risk = std::max(risk, std::exp(-(at - peak).squaredNorm() / (2 * 120.0 * 120)));
    ground.risk.push_back(risk);
  }
}

/// Where few places are at risk a patrol is searched for longest: without a budget for seconds.
TEST(BudgetLaw, PatrolsWhereRiskHasPeaksAreAnsweredInTimeAndNeverWorseForMoreTime) {
  auto world = testing::level_world(1000);
  world.ground.grid = {-640, -640, 20, 64, 64};
  put_three_peaks(world.ground);
  auto query = patrol_over(world, 639);
  for (const double footprint : {20.0, 40.0, 60.0}) {
    query.footprint = footprint;
    expect_in_time(query, world, "risk with peaks, footprint " + std::to_string(footprint));
  }

  std::optional<PatrolFigures> before;
  for (const double budget : {0.5, 1.5}) {
    Setting setting{world, {}, 1, nullptr};
    setting.budget.time_is_up = [&, began = processor_seconds()] {
      return processor_seconds() - began > budget;
    };
    const auto refined = refine(query, setting);
    ASSERT_TRUE(refined) << refined.error().why;
    const PatrolFigures& now = refined->task.predicted;
    EXPECT_EQ(now.unseen, 0U);
    EXPECT_FALSE(before && now.mean_idleness > 1.01 * before->mean_idleness &&
                 now.worst_risk_idleness > 1.01 * before->worst_risk_idleness);
    before = now;
  }
}

TEST(BudgetLaw, APatrolThatIsShortOfTimeIsAnsweredWithThePartThatIsPlanned) {
  auto world = testing::level_world(1000);
  world.ground.grid = {-900, -900, 20, 90, 90};
  put_three_peaks(world.ground);
  const auto query = patrol_over(world, 850);
  Setting setting{world, {}, 1, nullptr};
  setting.budget.time_is_up = [began = processor_seconds()] {
    return processor_seconds() - began > 0.1;
  };

  const auto refined = refine(query, setting);

  ASSERT_TRUE(refined) << refined.error().why;
  EXPECT_TRUE(refined->effort.cut_short);
  EXPECT_GT(refined->task.way.size(), 10U);
}

TEST(BudgetLaw, ToursOfManyStopsEndInTime) {
  const auto level = testing::level_world(1000);
  const auto rough = rough_world(Relief::kBoth, 3, 200, 900, 20).world;
  for (const auto& vehicle : both())
    for (const auto* world : {&level, &rough})
      for (const std::size_t stops : {10UL, 100UL, 1000UL}) {
        Random random(stops);
        TourQuery query;
        query.vehicle = vehicle;
        query.clearance = 20;
        query.start = above(*world, 0, 0, 60);
        for (std::size_t i = 0; i < stops; ++i) {
          Stop stop{"stop" + std::to_string(i), {}};
          for (std::size_t gate = 0; gate < (stops == 100 ? 20U : 1U); ++gate) {
            const Vector3 at =
                above(*world, random.uniform(-800, 800), random.uniform(-800, 800), 60);
            stop.gates.push_back({at, at, {}});
          }
          query.stops.push_back(stop);
        }
        expect_in_time(query, *world,
                       vehicle.name + ", " + std::to_string(stops) + " stops" +
                           (world == &rough ? " over hills" : ""));
      }
}

TEST(BudgetLaw, WaysThroughManyVoxelsEndInTime) {
  auto rough = rough_world(Relief::kBoth, 4, 300, 900, 10).world;
  rough.airspace.voxel = 5;
  rough.airspace.size = {360, 360, 120};
  auto closed = rough;
  closed.volumes = many_volumes(20, 900, 0.8);
  for (const auto& vehicle : both())
    for (const auto* world : {&rough, &closed}) {
      const std::string where = world == &rough ? "" : ", between 400 volumes";
      PathQuery query;
      query.vehicle = vehicle;
      query.clearance = 10;
      query.from = above(*world, -895, -895, 40);
      query.to = above(*world, 895, 895, 40);
      expect_in_time(query, *world, vehicle.name + where);
      query.contact = Contact{query.from, {}};
      for (int i = 0; i < 10; ++i)
        query.contact->relays.push_back(above(*world, -900 + 180.0 * i, -800 + 160.0 * i, 90));
      auto radio = *world;
      radio.radio.range = 700;
      expect_in_time(query, radio, vehicle.name + where + ", in contact through ten relays");
    }
}

/// As many voxels as memory has room for, as a cube, as a carpet, and as a tower.
TEST(BudgetLaw, AirOfSoManyVoxelsIsNotMadeForLongerThanTheTime) {
  auto rough = rough_world(Relief::kBoth, 4, 300, 900, 10).world;
  rough.volumes = many_volumes(3, 900, 0.9);
  struct Shape {
    double voxel;
    std::array<std::int32_t, 3> size;
  };
  for (const Shape& shape : {Shape{2, {900, 900, 370}}, Shape{0.1, {17'000, 17'000, 1}},
                             Shape{1800, {1, 1, 1 << 20}}, Shape{0.01, {20, 20, 700'000}}}) {
    rough.airspace = {Vector3(-900, -900, -100), shape.voxel, shape.size};
    const std::string what = " in " + std::to_string(rough.airspace.count()) + " voxels, " +
                             std::to_string(shape.size[2]) + " of them high";
    const auto from = above(rough, -895, -895, 40), to = above(rough, 895, 895, 40);
    for (const auto& vehicle : both()) {
      PathQuery query;
      query.vehicle = vehicle;
      query.clearance = 10;
      query.from = from;
      query.to = to;
      expect_in_time(query, rough, vehicle.name + what);
    }
    PathQuery heard;
    heard.vehicle = both().front();
    heard.from = from;
    heard.to = to;
    heard.contact = Contact{from, {above(rough, 0, 0, 90)}};
    auto radio = rough;
    radio.radio.range = 1500;
    expect_in_time(heard, radio, "in contact" + what);
    RelayQuery relay;
    relay.vehicle = both().front();
    relay.a = from;
    relay.b = to;
    relay.most = 6;
    relay.clearance = 10;
    radio.radio.range = 700;
    expect_in_time(relay, radio, "relays" + what);
    TourQuery tour;
    tour.vehicle = both().front();
    tour.start = from;
    tour.stops.push_back({"there", {{to, to, {}}}});
    expect_in_time(tour, rough, "a tour" + what);
  }
}

TEST(BudgetLaw, ViewpointsAndRelaysEndInTime) {
  const auto rough = rough_world(Relief::kBoth, 5, 300, 900, 5).world;
  ViewpointQuery query;
  query.vehicle = tireless(testing::helicopter());
  world::SensorModel camera;
  camera.device = "camera";
  camera.aperture = 0.5;
  camera.gimballed = true;
  camera.range = 900;
  query.vehicle.sensors = {camera};
  query.device = "camera";
  query.target = above(rough, 0, 0, 0);
  query.count = 60;
  query.least_angle = 0.2;
  expect_in_time(query, rough, "sixty viewpoints");
  query.constraints.push_back({"never", [](const Vector3&) { return false; }});
  expect_in_time(query, rough, "viewpoints that nothing allows");

  Random random(6);
  for (int i = 0; i < 4; ++i) {
    auto one = testing::random_relay_case(random, 96, 20, 0.15);
    one.query.most = 12;
    expect_in_time(one.query, one.world, "a chain of relays");
  }
}

TEST(BudgetLaw, LongWaysAndPlansAreEvaluatedInTime) {
  auto rough = rough_world(Relief::kBoth, 8, 300, 900, 10).world;
  rough.volumes = many_volumes(20, 900);
  for (const auto& vehicle : both()) {
    Random random(9);
    EvaluateQuery way;
    way.vehicle = vehicle;
    for (int i = 0; i < 20'000; ++i)
      way.way.push_back(above(rough, random.uniform(-800, 800), random.uniform(-800, 800), 50));
    expect_in_time(way, rough, vehicle.name + ", a way of 20,000 legs");

    InsertionQuery plan;
    plan.vehicle = vehicle;
    plan.clearance = 10;
    const auto place = [&] {
      return above(rough, random.uniform(-800, 800), random.uniform(-800, 800), 320);
    };
    plan.start = place();
    for (int i = 0; i < 200; ++i) plan.plan.push_back({place(), place(), {}});
    plan.task = {place(), place(), {}};
    expect_in_time(plan, rough, vehicle.name + ", a plan of 200 tasks");
  }
}

TEST(BudgetLaw, GatesOfAreasAreFoundInTime) {
  const auto steep = rough_world(Relief::kBoth, 1, 300, 900, 5).world;
  CoverageQuery query;
  query.vehicle = tireless(testing::fixed_wing());
  Random random(3);
  query.area = testing::random_star(random, 200, 300, 850);
  query.altitude = 60;
  query.swath = 20;
  for (const double budget : kBudgets) {
    const double began = processor_seconds();
    Setting setting{steep, {}, 1, nullptr};
    setting.budget.time_is_up = [&] { return processor_seconds() - began > budget; };
    const auto gates = gates_of(query, setting);
    EXPECT_LT(processor_seconds() - began - budget, 2 * kRoom);
    EXPECT_TRUE(gates || !gates.error().why.empty());
  }
}

}  // namespace
}  // namespace skein::refiners
