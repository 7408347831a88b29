// SPDX-License-Identifier: Apache-2.0
// Where partners meet in the air, and how they come there: each plans for itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

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

Names team_of(std::size_t size) {
  Names team;
  for (std::size_t i = 0; i < size; ++i) team.push_back("uav" + std::to_string(i));
  return team;
}

/// Its way to its place, from where it flies and with a home of its own.
Way way_to_meet(const Names& team, const std::string& me, const Vector3& from, const Vector3& at,
                const char* model) {
  PlanningLab lab = flying();
  lab.vehicle(testing::vehicle_of(model)).uav(me, team).flying_at(from);
  lab.knowledge.home = Vector3(from.y() / 4, from.x() / 4, 0);
  lab.task(1, "general-combined-goto-and-synchro-and-takeshot", {500.0, team, team, at, 30.0});
  const auto plan = planned(lab);
  return plan.tasks.empty() ? Way{from} : plan.tasks.front().way;
}

Vector3 somewhere() {
  return {1.0 * *rc::gen::inRange(-350, 350), 1.0 * *rc::gen::inRange(-350, 350),
          1.0 * *rc::gen::inRange(30, 110)};
}

/// Looked at every two metres: where another may circle or waver, at its height.
bool passes(const Way& way, const Vector3& place) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3 leg = way[i] - way[i - 1];
    const int steps = static_cast<int>(leg.norm() / 2) + 1;
    for (int k = 0; k <= steps; ++k) {
      const Vector3 off = way[i - 1] + (1.0 * k / steps) * leg - place;
      if (off.head<2>().norm() < 41 && std::abs(off.z()) < 10) return true;
    }
  }
  return false;
}

RC_GTEST_PROP(MeetingsLaw, NoPartnerFliesThroughWhereAnotherMayWait, ()) {
  const Names team = team_of(*rc::gen::inRange<std::size_t>(2, 6));
  const Vector3 at(*rc::gen::inRange(0, 300), *rc::gen::inRange(0, 300), *rc::gen::inRange(50, 90));
  std::vector<Way> ways;
  for (const std::string& one : team)
    ways.push_back(
        way_to_meet(team, one, somewhere(), at, *rc::gen::arbitrary<bool>() ? kMarvin : kKarma));
  for (const Way& way : ways) {
    for (const Way& other : ways) {
      if (&way == &other) continue;
      RC_ASSERT((way.back() - other.back()).norm() > 70);
      const bool begins_there = (way.front() - other.back()).head<2>().norm() < 55;
      if (!begins_there) RC_ASSERT(!passes(way, other.back()));
    }
  }
}

TEST(Meetings, ThePlacesAreTheSameWhereverHomesAre) {
  const Names team = team_of(3);
  const Vector3 at(200, 100, 60), from(0, 0, 60), elsewhere(400, -300, 60);

  EXPECT_EQ(way_to_meet(team, "uav1", from, at, kMarvin).back(),
            way_to_meet(team, "uav1", elsewhere, at, kMarvin).back());
}

TEST(Meetings, APlaceBehindAnotherIsReachedAroundIt) {
  const Names team = team_of(3);
  const Vector3 at(200, 0, 60);
  const Vector3 first = way_to_meet(team, "uav0", {0, 0, 60}, at, kMarvin).back();
  const Vector3 second = way_to_meet(team, "uav1", {0, 0, 60}, at, kMarvin).back();
  const Vector3 behind = second + 4 * (first - second);

  const auto way = way_to_meet(team, "uav1", {behind.x(), behind.y(), 60}, at, kMarvin);

  EXPECT_GT(way.size(), 2U);
  EXPECT_FALSE(passes(way, first));
}

}  // namespace
}  // namespace skein::supervisor
