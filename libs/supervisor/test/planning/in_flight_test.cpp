// SPDX-License-Identifier: Apache-2.0
// What begins while the vehicle flies on is judged from where it then is and heads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flight/autopilot.hpp"
#include "flight/closed_air.hpp"
#include "flight/flights_met.hpp"
#include "skein/foundation/random.hpp"
#include "testing/planned.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using testing::planned;
using testing::PlanningLab;
using world::Vector3;
using Way = refiners::Way;

const char* const kKarma = "scenarios/comets/models/karma.yaml";

/// Flies there, 100 m and more from home, beside a square of smoke, and is to come home.
PlanningLab coming_home(const Vector3& from, double heading, const world::Vector2& smoke) {
  PlanningLab lab;
  lab.vehicle(testing::vehicle_of(kKarma)).flying_at(from).first_id(1);
  lab.knowledge.home = {0, -300, 0};
  lab.knowledge.altitude = 90;
  lab.situation.heading = heading;
  lab.situation.flies_on = true;
  world::Volume volume{"smoke", {}, 0, 500, {}};
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    volume.polygon.emplace_back(smoke + 60 * world::Vector2(x, y));
  lab.world.volumes.push_back(volume);
  lab.task(1, "general-land");
  return lab;
}

/// How far into the volume it comes when it begins that way so many seconds later.
bool flies_into(const PlanningLab& lab, const Way& way, double later) {
  const world::VehicleModel& karma = lab.knowledge.vehicle;
  const double heading = lab.situation.heading;
  const Vector3 ahead(std::cos(heading), std::sin(heading), 0);
  const Pose pose{lab.situation.position + later * karma.cruise_speed * ahead, heading,
                  karma.cruise_speed};
  const FlownWay flown = fly_way(pose, Way(way.begin() + 1, way.end()), karma, lab.world.wind);
  return std::any_of(flown.track.begin(), flown.track.end(),
                     [&](const Vector3& at) { return is_near(lab.world.volumes.back(), at, 2); });
}

// It turns back over a corner of what has just been closed ahead.
TEST(InFlight, AWayHomeBesideSmokeIsOneThatItCanTurnInto) {
  const PlanningLab lab = coming_home({154, 205, 87}, -0.75, {208, 106});

  const auto plan = planned(lab);

  for (const double later : {0.0, 1.0, 2.0})
    EXPECT_FALSE(flies_into(lab, plan.tasks.front().way, later)) << later;
}

// By then it circles there, and leaves its circle anywhere.
TEST(InFlight, AWayThatIsFlownAfterAWaitIsJudgedFromTheCircle) {
  PlanningLab lab;
  lab.vehicle(testing::vehicle_of(kKarma)).flying_at({90, 188, 90}).first_id(1);
  lab.knowledge.home = {0, -300, 0};
  lab.knowledge.altitude = 90;
  lab.situation.heading = 0.98;
  lab.situation.flies_on = true;
  lab.world.places["there"] = {203, 58, 90};
  lab.world.volumes.push_back({"smoke", {{2, 56}, {134, 56}, {134, 132}, {2, 132}}, 0, 500, {}});
  lab.task(1, "general-wait", {60.0}).task(2, "general-gotoxyz", {"there"});

  const Way way = planned(lab).tasks.back().way;

  const world::VehicleModel& karma = lab.knowledge.vehicle;
  ASSERT_EQ(way.front(), lab.situation.position);
  EXPECT_FALSE(flights_meet(way, lab.world.volumes, karma, lab.world.wind, {2, 0},
                            poses_at(way.front(), karma)));
}

// Found by random missions (--anything 1015002): from one of 36 places of its circle the first turn
// led 15 m into closed air, from none of four.
TEST(InFlight, TheFirstTurnAfterATakeoffIsJudgedFromAllAroundTheCircle) {
  PlanningLab lab;
  lab.vehicle(testing::vehicle_of("tests/random_missions/models/plane.yaml")).first_id(1);
  lab.knowledge.altitude = 76;
  lab.world.wind.speed = 3.1;
  lab.world.wind.toward = 4.1;
  lab.situation.position = {-18, 106, 0};
  lab.situation.stands = true;
  lab.world.places["there"] = {180, -120, 90};
  lab.world.volumes.push_back({"V1", {{70, 149}, {210, 149}, {210, 247}, {70, 247}}, 35, 500, {}});
  lab.task(1, "general-gotoxyz", {"there"});

  const auto plan = planned(lab);

  ASSERT_EQ(plan.tasks.front().type, "takeoff");
  const Way& way = plan.tasks.back().way;
  EXPECT_FALSE(flights_meet(way, lab.world.volumes, lab.knowledge.vehicle, lab.world.wind, {0, 0},
                            poses_at(way.front(), lab.knowledge.vehicle, 36)));
}

TEST(InFlight, WhoeverHasTurningRoomComesHomeBesideSmoke) {
  Random random(1, "in flight");
  for (int left = 20; left > 0;) {
    const Vector3 from(random.uniform(-150, 150), random.uniform(80, 260), 90);
    const double heading = random.uniform(-3.1, 3.1);
    const world::Vector2 smoke(random.uniform(-100, 100), random.uniform(-60, 60));
    const PlanningLab lab = coming_home(from, heading, smoke);
    const Vector3 ahead(std::cos(heading), std::sin(heading), 0);
    const world::Volume& volume = lab.world.volumes.back();
    if (is_near(volume, from, 70) || is_near(volume, from + 30 * ahead, 60)) continue;
    --left;

    const auto plan = planned(lab);

    for (const double later : {0.0, 1.0, 2.0})
      EXPECT_FALSE(flies_into(lab, plan.tasks.front().way, later)) << from.transpose();
  }
}

}  // namespace
}  // namespace skein::supervisor
