// SPDX-License-Identifier: Apache-2.0
// Area sharing, judged by sweeps that the partition did not plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "skein/foundation/random.hpp"
#include "skein/negotiation/area_offer.hpp"
#include "skein/negotiation/modality.hpp"
#include "skein/refiners/coverage.hpp"
#include "skein/world/world_builder.hpp"
#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::names;

constexpr double kNone = std::numeric_limits<double>::infinity();

Terms terms_of(std::size_t members, Rows areas) {
  return {"s", 1, "", names(members), {}, std::move(areas), "a", {}, MissionTime::seconds(1)};
}

const NegotiationModality& area_sharing() {
  static const Modalities all = standard_modalities();
  return *all.at("area-sharing");
}

Row area(std::vector<double> corners) { return {"area", "", std::move(corners)}; }

Sweeper helicopter(double speed, double swath, world::Vector2 start) {
  Sweeper one;
  one.vehicle.cruise_speed = speed;
  one.vehicle.max_speed = 1.5 * speed;
  one.vehicle.climb_rate = one.vehicle.descent_rate = 3;
  one.vehicle.acceleration = 2;
  one.vehicle.yaw_rate = 0.8;
  one.vehicle.ceiling = 300;
  one.vehicle.energy = {1e9, 100, 1700, 1500, 400, 0.1};
  one.start = start;
  one.altitude = 50;
  one.swath = swath;
  return one;
}

/// When it is done with its part, by the sweep alone.
double end_of(const Sweeper& one, const world::Polygon& part) {
  world::TerrainSpec ground;
  ground.west = ground.south = -3000;
  ground.east = ground.north = 3000;
  world::WorldFile file;
  file.origin = world::GeodeticOrigin{};
  file.terrain = ground;
  file.radio.range = 1000;
  const world::World world = world::build_world(std::move(file)).value();
  refiners::CoverageQuery query;
  query.vehicle = one.vehicle;
  query.area = part;
  query.swath = one.swath;
  query.altitude = one.altitude;
  query.start = world::Vector3(one.start.x(), one.start.y(), one.altitude);
  return one.busy + refine(query, refiners::Setting{world, {}}).value().cost;
}

TEST(AreaSharing, AllAreDoneWithTheirPartsAtAboutTheSameTime) {
  Random random(3);
  std::vector<double> spreads;
  for (int round = 0; round < 9; ++round) {
    const std::size_t n = 2 + random.below(2);
    const double width = random.uniform(500, 900), height = random.uniform(500, 900);
    const Terms terms = terms_of(n, {area({0, 0, width, 0, width, height, 0, height})});
    std::map<std::string, Sweeper> sweepers;
    Offers offers;
    for (const std::string& uav : terms.members) {
      const world::Vector2 start{random.uniform(-200, width), random.uniform(-200, -1)};
      sweepers[uav] = helicopter(random.uniform(6, 14), random.uniform(30, 70), start);
      sweepers[uav].busy = random.uniform(0, 60);
      offers[uav] = offer_of(sweepers[uav]);
    }

    const auto result = area_sharing().settle(terms, offers);

    ASSERT_TRUE(result) << result.error().why;
    double whole = 0, earliest = kNone, latest = 0;
    for (const Row& part : *result) {
      whole += world::area(polygon_of(part));
      const double end = end_of(sweepers[part.name], polygon_of(part));
      earliest = std::min(earliest, end);
      latest = std::max(latest, end);
    }
    EXPECT_NEAR(whole, width * height, 1e-3 * width * height) << round;
    spreads.push_back((latest - earliest) / latest);
  }
  std::sort(spreads.begin(), spreads.end());
  EXPECT_LT(spreads[spreads.size() / 2], 0.05);
  EXPECT_LT(spreads.back(), 0.2);
}

TEST(AreaSharing, WhoIsTooFarOrTooBusyIsNotWaitedFor) {
  const Terms terms = terms_of(3, {area({0, 0, 200, 0, 200, 200, 0, 200})});
  Sweeper near = helicopter(10, 40, {0, 0}), far = helicopter(10, 40, {90000, 0}), busy = near;
  busy.busy = 9000;

  const auto result = area_sharing().settle(
      terms, {{"a", offer_of(near)}, {"b", offer_of(far)}, {"c", offer_of(busy)}});

  ASSERT_TRUE(result) << result.error().why;
  EXPECT_NEAR(world::area(polygon_of((*result)[0])), 40000, 1e-3);
  EXPECT_TRUE((*result)[1].numbers.empty());
  EXPECT_TRUE((*result)[2].numbers.empty());
}

TEST(AreaSharing, OfSeveralAreasTheNextGoesToWhoHasLessOfThoseBefore) {
  const Terms terms = terms_of(
      2, {area({0, 0, 600, 0, 600, 500, 0, 500}), area({700, 0, 760, 0, 760, 60, 700, 60})});
  Sweeper early = helicopter(10, 40, {0, 0}), late = helicopter(10, 40, {600, 0});
  early.busy = 400;

  const auto result = area_sharing().settle(terms, {{"a", offer_of(early)}, {"b", offer_of(late)}});

  ASSERT_TRUE(result) << result.error().why;
  ASSERT_EQ(result->size(), 4U);
  EXPECT_GT(world::area(polygon_of((*result)[1])), world::area(polygon_of((*result)[0])));
  EXPECT_NEAR(world::area(polygon_of((*result)[2])) + world::area(polygon_of((*result)[3])), 3600,
              1e-3);
}

TEST(AreaSharing, MoreAreaThanAllHaveTheEnergyForIsNotShared) {
  const Terms terms = terms_of(2, {area({0, 0, 900, 0, 900, 900, 0, 900})});
  Sweeper weak = helicopter(10, 40, {0, 0});
  weak.vehicle.energy.capacity = 1e5;

  const auto result = area_sharing().settle(terms, {{"a", offer_of(weak)}, {"b", offer_of(weak)}});

  ASSERT_FALSE(result);
  EXPECT_NE(result.error().why.find("all members together sweep less than the area"),
            std::string::npos)
      << result.error().why;
}

TEST(AreaSharing, DivisionsBeforeAndWhoseRemaindersAreSharedAnewMayBeSaid) {
  const Row field = area({0, 0, 100, 0, 100, 100, 0, 100});
  const auto problem = [&](Row one) {
    return area_sharing().problem_of(terms_of(2, {field, std::move(one)}));
  };
  EXPECT_EQ(problem({kDivisions, "", {3}}), std::nullopt);
  EXPECT_EQ(problem({kDivisions, "", {0}}), std::nullopt);
  EXPECT_EQ(problem({kAnew, "b", {1}}), std::nullopt);

  for (const double count : {-1.0, 1.5, 1e7}) {
    EXPECT_EQ(problem({kDivisions, "", {count}}), "'divisions' is no number of divisions");
    EXPECT_EQ(problem({kAnew, "b", {count}}), "'anew' is no number of divisions of a member");
  }
  EXPECT_NE(problem({kAnew, "b", {0}}), std::nullopt) << "it was never shared";
  EXPECT_NE(problem({kAnew, "somebody", {1}}), std::nullopt);
  EXPECT_NE(problem({kAnew, "b", {}}), std::nullopt);
  EXPECT_NE(
      area_sharing().problem_of(terms_of(2, {field, {kDivisions, "", {1}}, {kDivisions, "", {2}}})),
      std::nullopt);
  EXPECT_EQ(area_sharing().problem_of(terms_of(2, {{kAnew, "b", {1}}})), "no areas");
}

TEST(AreaSharing, OnlyAreasAreDivided) {
  const Row field = area({0, 0, 100, 0, 100, 100, 0, 100});
  const std::map<std::string, Rows> offers{{"a", offer_of(helicopter(8, 40, {0, 0}))},
                                           {"b", offer_of(helicopter(8, 40, {100, 100}))}};
  const auto plain = area_sharing().settle(terms_of(2, {field}), offers);
  const auto anew =
      area_sharing().settle(terms_of(2, {{kAnew, "b", {1}}, field, {kDivisions, "", {1}}}), offers);

  ASSERT_TRUE(plain && anew);
  EXPECT_EQ(*plain, *anew);
}

TEST(AreaSharing, AnOfferIsReadAsItWasMade) {
  Sweeper one = helicopter(9, 33, {12.5, -3});
  one.vehicle.hovers = false;
  one.vehicle.min_speed = 4;
  one.vehicle.min_turn_radius = 25;
  one.vehicle.orbit_radius = 40;
  one.busy = 17;

  const auto read = sweeper_of(offer_of(one));

  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->vehicle, one.vehicle);
  EXPECT_EQ(read->start, one.start);
  EXPECT_EQ(read->altitude, one.altitude);
  EXPECT_EQ(read->swath, one.swath);
  EXPECT_EQ(read->busy, one.busy);
}

}  // namespace
}  // namespace skein::interaction
