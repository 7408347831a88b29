// SPDX-License-Identifier: Apache-2.0
// Where partners meet in the air, and how they come there: each plans for itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "flight/autopilot.hpp"
#include "skein/foundation/random.hpp"
#include "testing/planned.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using testing::flying;
using testing::planned;
using testing::PlanningLab;
using world::Vector3;
using Way = std::vector<Vector3>;
using Names = std::vector<std::string>;

const char* const kMarvin = "scenarios/comets/models/marvin.yaml";
const char* const kKarma = "scenarios/comets/models/karma.yaml";

/// UAVs of a team, each as it is, and where it flies.
struct Team {
  Names names;
  std::vector<Partner> members;
  std::vector<Vector3> at;
};

Team& add(Team& team, const char* model, const Vector3& at) {
  team.names.push_back("uav" + std::to_string(team.names.size()));
  const Vector3 home(at.y() / 4, at.x() / 4, 0);
  const double altitude = 40 + 15 * static_cast<double>(team.at.size());
  team.members.push_back({team.names.back(), testing::vehicle_of(model), home, altitude});
  team.at.push_back(at);
  return team;
}

PlanningLab lab_of(const Team& team, std::size_t who) {
  PlanningLab lab = flying();
  lab.vehicle(team.members[who].vehicle).uav(team.names[who], team.names).flying_at(team.at[who]);
  lab.knowledge.home = team.members[who].home;
  lab.knowledge.altitude = team.members[who].altitude;
  lab.knowledge.partners = team.members;
  return lab;
}

/// Its way to its place at that meeting.
Way way_to_meet(const Team& team, std::size_t who, const mission::Argument& place) {
  PlanningLab lab = lab_of(team, who);
  lab.task(1, "general-combined-goto-and-synchro-and-takeshot",
           {500.0, team.names, team.names, place, 30.0});
  const auto plan = planned(lab);
  return plan.tasks.empty() ? Way{team.at[who]} : plan.tasks.front().way;
}

std::vector<Way> ways_to_meet(const Team& team, const mission::Argument& place) {
  std::vector<Way> ways;
  for (std::size_t i = 0; i < team.names.size(); ++i) ways.push_back(way_to_meet(team, i, place));
  return ways;
}

Vector3 somewhere() {
  return {1.0 * *rc::gen::inRange(-350, 350), 1.0 * *rc::gen::inRange(-350, 350),
          1.0 * *rc::gen::inRange(30, 110)};
}

Team some_team(std::size_t most) {
  Team team;
  for (std::size_t left = *rc::gen::inRange<std::size_t>(2, most + 1); left > 0; --left)
    add(team, *rc::gen::arbitrary<bool>() ? kMarvin : kKarma, somewhere());
  return team;
}

bool circles(const Team& team, std::size_t who) { return !team.members[who].vehicle.hovers; }

/// Looked at every two metres, from that way-point on: where another may circle or waver, at its
/// height.
bool passes(const Way& way, const Vector3& place, std::size_t first = 1) {
  for (std::size_t i = first; i < way.size(); ++i) {
    const Vector3 leg = way[i] - way[i - 1];
    const int steps = static_cast<int>(leg.norm() / 2) + 1;
    for (int k = 0; k <= steps; ++k) {
      const Vector3 off = way[i - 1] + (1.0 * k / steps) * leg - place;
      if (off.head<2>().norm() < 41 && std::abs(off.z()) < 10) return true;
    }
  }
  return false;
}

/// How far from its place it gets while it waits.
double reach(const Team& team, std::size_t who) { return circles(team, who) ? 52 : 5; }

RC_GTEST_PROP(MeetingsLaw, NoPartnerFliesThroughWhereAnotherMayWait, ()) {
  const Team team = some_team(5);
  const Vector3 at(*rc::gen::inRange(0, 300), *rc::gen::inRange(0, 300), *rc::gen::inRange(50, 90));
  const std::vector<Way> ways = ways_to_meet(team, at);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Vector3 mine = ways[i].back();
    RC_ASSERT((mine - at).norm() > 60);
    for (std::size_t k = 0; k < ways.size(); ++k) {
      if (i == k) continue;
      const Vector3 theirs = ways[k].back();
      const bool over = std::abs(mine.z() - theirs.z()) >= 24;
      RC_ASSERT(over || (mine - theirs).head<2>().norm() > reach(team, i) + reach(team, k) + 8);
      // Over each other two of them leave less room.
      if ((mine - theirs).head<2>().norm() < 74) continue;
      // Who begins where another may wait leaves, and does not come there again.
      const bool begins_there = (ways[i].front() - theirs).norm() < 80;
      RC_ASSERT(!passes(ways[i], theirs, begins_there ? 2 : 1));
    }
  }
}

// A few cases: each of them looks for the best side that leaves room for the others.
TEST(Meetings, WhereTheyLookFromIsReckonedAlikeByAll) {
  Random random(1, "teams");
  for (int round = 0; round < 8; ++round) {
    Team team;
    for (std::size_t left = 2 + random.below(2); left > 0; --left)
      add(team, random.chance(0.6) ? kMarvin : kKarma,
          {random.uniform(-350, 350), random.uniform(-350, 350), random.uniform(30, 110)});
    const Vector3 at(random.uniform(-100, 300), random.uniform(-100, 300), 0);
    const std::vector<Way> ways = ways_to_meet(team, at);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      for (std::size_t k = 0; k < ways.size(); ++k) {
        if (i == k) continue;
        const Vector3 off = ways[i].back() - ways[k].back();
        const double level = off.head<2>().norm();
        EXPECT_TRUE(std::abs(off.z()) >= 24 || level > reach(team, i) + reach(team, k) + 8);
        const bool begins_there = (ways[i].front() - ways[k].back()).norm() < 80;
        EXPECT_TRUE(begins_there || level <= 75 || !passes(ways[i], ways[k].back()));
      }
    }
  }
}

Team three_of(const char* model, const Vector3& from) {
  Team team;
  for (int i = 0; i < 3; ++i) add(team, model, from);
  return team;
}

TEST(Meetings, ThePlacesAreTheSameWhereverTheyComeFrom) {
  const Vector3 at(200, 100, 60);
  Team here = three_of(kMarvin, {0, 0, 60}), there = here;
  there.at.assign(3, Vector3(400, -300, 60));

  EXPECT_EQ(way_to_meet(here, 1, at).back(), way_to_meet(there, 1, at).back());
}

TEST(Meetings, APlaceInTheAirIsLeftToWhoComesWithAnotherTask) {
  const Team team = three_of(kMarvin, {0, 0, 60});
  const Vector3 at(200, 100, 60);

  for (const Way& way : ways_to_meet(team, at)) EXPECT_GE((way.back() - at).norm(), 74);
  PlanningLab lab = lab_of(team, 0);
  lab.task(1, "perceive", {at, 30.0});
  EXPECT_EQ(planned(lab).tasks.front().way.back(), at);
}

TEST(Meetings, APlaceBehindAnotherIsReachedAroundIt) {
  Team team = three_of(kMarvin, {0, 0, 60});
  const Vector3 at(200, 0, 60);
  const Vector3 first = way_to_meet(team, 0, at).back();
  const Vector3 second = way_to_meet(team, 1, at).back();
  const Vector3 behind = second + 2 * (first - second);
  team.at[1] = {behind.x(), behind.y(), 60};

  const auto way = way_to_meet(team, 1, at);

  EXPECT_GT(way.size(), 2U);
  EXPECT_FALSE(passes(way, first));
}

TEST(Meetings, WhoIsWhereAnotherWillWaitLeavesThatFirst) {
  Team team = three_of(kMarvin, {0, 0, 60});
  const Vector3 at(200, 0, 60);
  const Vector3 first = way_to_meet(team, 0, at).back();
  team.at[1] = first + Vector3(10, -5, 2);

  const auto way = way_to_meet(team, 1, at);

  ASSERT_GT(way.size(), 2U);
  const Vector3 out = way[1] - first;
  EXPECT_TRUE(out.head<2>().norm() > 40 || std::abs(out.z()) > 14) << out.transpose();
  EXPECT_FALSE(passes(way, first, 2));
}

TEST(Meetings, ABlimpTurnsInWhereNobodyWaits) {
  Team team;
  add(team, kKarma, {-200, 300, 90});
  add(team, kMarvin, {0, 0, 90});
  const Vector3 at(50, 290, 90);
  const auto way = way_to_meet(team, 0, at);
  const Vector3 waits = way_to_meet(team, 1, at).back();
  const world::VehicleModel& karma = team.members[0].vehicle;

  for (const Pose& pose : poses_at(way.front(), karma)) {
    const FlownWay flown = fly_way(pose, Way(way.begin() + 1, way.end()), karma, {});
    for (const Vector3& there : flown.track) EXPECT_GT((there - waits).norm(), 20);
    for (const Vector3& there : circle_over(flown.end, way.back(), karma, {}, 120))
      EXPECT_GT((there - waits).norm(), 20);
  }
}

}  // namespace
}  // namespace skein::supervisor
