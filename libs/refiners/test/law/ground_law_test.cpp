// SPDX-License-Identifier: Apache-2.0
// One law for all services: what they answer is flown over the ground as it is, and `evaluate`
// finds nothing wrong with it.
#include <gtest/gtest.h>

#include "skein/refiners/evaluate.hpp"
#include "skein/refiners/partition.hpp"
#include "skein/refiners/patrol.hpp"
#include "skein/refiners/relay.hpp"
#include "skein/refiners/tour.hpp"
#include "skein/refiners/viewpoint.hpp"
#include "test_cases.hpp"
#include "testing/coverage_cases.hpp"
#include "testing/raw_ground.hpp"

namespace skein::refiners {
namespace {

using testing::RawGround;
using testing::Relief;
using testing::RoughWorld;
using world::Vector2;
using world::Vector3;

constexpr double kReliefs[] = {40, 150, 300};

struct Case {
  std::string name;
  RoughWorld rough;
  world::VehicleModel vehicle;
  Random random;

  Setting setting() const { return {.world = rough.world, .budget = {}}; }
  Vector3 over(const Vector2& at, double height) const {
    return {at.x(), at.y(), rough.raw.at(at.x(), at.y()) + height};
  }
  double height_of(const Vector3& at) const { return at.z() - rough.raw.at(at.x(), at.y()); }
  Vector2 place(double within = 500) {
    return {random.uniform(-within, within), random.uniform(-within, within)};
  }
};

/// Every kind of ground and of vehicle.
std::vector<Case> cases(std::uint64_t seeds = 2) {
  std::vector<Case> all;
  for (std::uint64_t seed = 1; seed <= skein::testing::cases(seeds, 6 * seeds); ++seed)
    for (const auto& [kind, name] : {std::pair{Relief::kHills, "hills"},
                                     {Relief::kRaster, "raster"},
                                     {Relief::kBoth, "raster with hills"}})
      for (const double relief : kReliefs)
        for (auto vehicle : {testing::helicopter(), testing::fixed_wing()}) {
          vehicle.energy.capacity *= 100;
          all.push_back({std::string(name) + " of " + std::to_string(relief) + " m, " +
                             vehicle.name + ", seed " + std::to_string(seed),
                         testing::rough_world(kind, seed, relief), vehicle,
                         Random(seed, "places")});
        }
  return all;
}

/// `least`: height that it must have everywhere, by the raw posts [m].
void judge(const Case& one, const Way& way, double least, const std::string& service) {
  EXPECT_GE(one.rough.raw.least_height(way), least - 1e-6) << service << " over " << one.name;
  EvaluateQuery query;
  query.vehicle = one.vehicle;
  query.way = way;
  const auto evaluated = refine(query, one.setting());
  ASSERT_TRUE(evaluated) << evaluated.error().why;
  EXPECT_TRUE(evaluated->task.obstructions.empty()) << service << " over " << one.name;
  for (const std::string& limit : evaluated->task.limits)
    ADD_FAILURE() << service << " over " << one.name << ": " << limit;
}

/// How many of the answers must be ways, so that the law judges something.
class Answers {
 public:
  ~Answers() { EXPECT_GE(2 * ways_, asked_) << "too few answers to judge: " << refusals_; }
  template <class Task>
  bool has(const Outcome<Task>& outcome) {
    ++asked_;
    if (outcome)
      ++ways_;
    else
      refusals_ += outcome.error().why + "; ";
    return outcome.has_value();
  }

 private:
  int asked_ = 0, ways_ = 0;
  std::string refusals_;
};

TEST(GroundLaw, SweepsKeepThreeQuartersOfTheirAltitudeOverAnyGround) {
  Answers answers;
  for (Case& one : cases()) {
    CoverageQuery query;
    query.vehicle = one.vehicle;
    query.area = testing::random_convex(one.random, 350);
    query.swath = 60;
    query.altitude = 80;
    if (one.random.chance(0.5)) query.start = one.over(one.place(), one.random.uniform(0, 150));
    if (one.random.chance(0.5)) query.end = one.over(one.place(), one.random.uniform(40, 150));
    const auto refined = refine(query, one.setting());
    if (!answers.has(refined)) continue;
    double least = 60;
    const auto& terrain = one.rough.world.terrain;
    for (const auto& end : {query.start, query.end})
      if (end) least = std::min(least, (end->z() - terrain.elevation(end->x(), end->y())) / 4);
    judge(one, refined->task.way, query.start || query.end ? std::clamp(least, 0.0, 20.0) : 60,
          "coverage");
  }
}

TEST(GroundLaw, PartsOfAnAreaAreSweptOverIt) {
  Answers answers;
  for (Case& one : cases()) {
    if (!one.vehicle.hovers) continue;
    PartitionQuery query;
    query.area = testing::random_convex(one.random, 350);
    for (int i = 0; i < 3; ++i) {
      Member member;
      member.uav = "uav" + std::to_string(i);
      member.vehicle = one.vehicle;
      member.start = one.place();
      member.swath = 60;
      member.altitude = 80;
      query.members.push_back(member);
    }
    const auto refined = refine(query, one.setting());
    if (!answers.has(refined)) continue;
    for (const Part& part : refined->task.parts) judge(one, part.coverage.way, 0, "partition");
  }
}

/// A vehicle that cannot hover climbs from its start on the way, no nearer to the ground than half
/// of it; legs leave the wanted heights by a tenth.
TEST(GroundLaw, PatrolsKeepNineTenthsOfTheirAltitudeOverAnyGround) {
  Answers answers;
  for (Case& one : cases()) {
    PatrolQuery query;
    query.vehicle = one.vehicle;
    query.zone = testing::rectangle(-400, -300, 300, 400);
    query.start = one.over(one.place(300), 80);
    query.altitude = 80;
    query.footprint = 70;
    query.duration = Duration::seconds(600);
    if (one.vehicle.hovers && one.random.chance(0.5)) query.mode = PatrolMode::kGradient;
    const auto refined = refine(query, one.setting());
    if (!answers.has(refined)) continue;
    const double begins =
        query.start.z() - one.rough.world.terrain.elevation(query.start.x(), query.start.y());
    const double least = one.vehicle.hovers ? 72 : std::min(query.altitude, begins) / 2;
    judge(one, refined->task.way, least, "patrol");
    EXPECT_LE(refined->duration.expected.to_seconds(), 601) << one.name;
  }
}

TEST(GroundLaw, WaysAndToursKeepTheirClearance) {
  Answers answers;
  for (Case& one : cases(1)) {
    PathQuery path;
    path.vehicle = one.vehicle;
    path.clearance = 20;
    path.from = one.over(one.place(700), 60);
    path.to = one.over(one.place(700), 60);
    const auto way = refine(path, one.setting());
    if (answers.has(way)) judge(one, way->task.way, 20, "path");

    TourQuery tour;
    tour.vehicle = one.vehicle;
    tour.start = path.from;
    tour.end = path.to;
    tour.clearance = 20;
    for (int i = 0; i < 4; ++i) {
      const Vector3 at = one.over(one.place(700), 60);
      tour.stops.push_back({"stop", {{at, at, {}}}});
    }
    const auto toured = refine(tour, one.setting());
    if (!answers.has(toured)) continue;
    for (const Visit& visit : toured->task.visits)
      if (visit.way.size() > 1) judge(one, visit.way, 20, "tour");
    if (toured->task.last.size() > 1) judge(one, toured->task.last, 20, "tour");
  }
}

TEST(GroundLaw, ViewpointsStandHighEnoughAndSeeTheirTarget) {
  Answers answers;
  for (Case& one : cases()) {
    ViewpointQuery query;
    query.vehicle = one.vehicle;
    world::SensorModel camera;
    camera.device = "camera";
    camera.aperture = 0.5;
    camera.gimballed = true;
    camera.range = 400;
    query.vehicle.sensors = {camera};
    query.device = camera.device;
    query.target = one.over(one.place(), one.random.uniform(0, 5));
    query.clearance = 25;
    query.count = 4;
    const auto refined = refine(query, one.setting());
    if (!answers.has(refined)) continue;
    for (const ViewPoint& point : refined->task.points) {
      EXPECT_GE(one.height_of(point.position), 25 - 1e-6) << one.name;
      EXPECT_LE(one.height_of(point.position), one.vehicle.ceiling + 1e-6) << one.name;
      EXPECT_GE(one.rough.raw.least_height({point.position, query.target}), -0.02) << one.name;
    }
  }
}

TEST(GroundLaw, RelaysStandHighEnoughAndSeeEachOther) {
  Answers answers;
  for (Case& one : cases()) {
    RelayQuery query;
    query.vehicle = one.vehicle;
    query.a = one.over(one.place(700), 5);
    query.b = one.over(one.place(700), 5);
    query.most = 3;
    query.clearance = 25;
    one.rough.world.radio.range = 900;
    const auto refined = refine(query, one.setting());
    if (!answers.has(refined)) continue;
    Way chain = {query.a};
    for (const Vector3& position : refined->task.positions) {
      EXPECT_GE(one.height_of(position), 25 - 1e-6) << one.name;
      EXPECT_LE(one.height_of(position), one.vehicle.ceiling + 1e-6) << one.name;
      chain.push_back(position);
    }
    chain.push_back(query.b);
    EXPECT_GE(one.rough.raw.least_height(chain), -1e-6) << one.name;
    for (std::size_t i = 1; i < chain.size(); ++i)
      EXPECT_LE((chain[i] - chain[i - 1]).norm(), 900 + 1e-6) << one.name;
  }
}

TEST(GroundLaw, WaysToInsertedTasksKeepTheirClearance) {
  Answers answers;
  for (Case& one : cases(1)) {
    InsertionQuery query;
    query.vehicle = one.vehicle;
    query.clearance = 20;
    query.start = one.over(one.place(700), 60);
    for (int i = 0; i < 3; ++i) {
      const Vector3 at = one.over(one.place(700), 60);
      query.plan.push_back({at, at, {}});
    }
    const Vector3 at = one.over(one.place(700), 60);
    query.task = {at, at, {}};
    const auto refined = refine(query, one.setting());
    if (!answers.has(refined)) continue;
    judge(one, refined->task.to, 20, "insertion");
    if (refined->task.from.size() > 1) judge(one, refined->task.from, 20, "insertion");
  }
}

}  // namespace
}  // namespace skein::refiners
