// SPDX-License-Identifier: Apache-2.0
// Places to get out of the way to.
#include "merging/airways.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "skein/elementary/parameter_reader.hpp"
#include "testing/merged_team.hpp"

namespace skein::decision_node {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using world::Vector3;

/// A helicopter over ground of that elevation.
MergingConfig over_ground_at(double elevation) {
  world::TerrainSpec ground;
  ground.west = ground.south = -1'000;
  ground.east = ground.north = 1'000;
  ground.base = elevation;
  MergingConfig config;
  config.model = testing::quick_helicopter();
  config.terrain = std::make_shared<const world::Terrain>(ground);
  return config;
}

/// Over ground of that elevation, all around it to its height and above taken.
std::vector<double> heights_aside(double elevation) {
  const MergingConfig config = over_ground_at(elevation);
  AirwaySituation situation;
  situation.state.position = {0, 0, 40};
  situation.state.airborne = true;
  situation.rest = situation.state.position;
  const merging::Volume taken{{-10'000, 0}, {10'000, 0}, 10'000, 38, 500};
  std::vector<double> heights;
  for (const Airway& one : ways_aside(functional::TaskId(1), {taken}, config, situation))
    heights.push_back(one.end->z());
  return heights;
}

/// Where it comes down, of the way that is asked for first by one that got out of the way upwards.
Vector3 comes_down_at(bool hovers) {
  MergingConfig config = over_ground_at(0);
  config.model.hovers = hovers;
  config.model.min_turn_radius = config.model.orbit_radius = hovers ? 0 : 40;
  AirwaySituation situation;
  situation.state.position = {0, 0, 64};
  situation.state.airborne = true;
  situation.rest = situation.state.position;
  situation.aside = true;
  functional::Request request;
  request.id = functional::TaskId(7);
  request.type = "goto";
  request.parameters.add(elementary::points_parameter("waypoints", {{200, 0, 40}, {400, 0, 40}}));
  const auto airways = airways_of(request, true, config, situation);
  EXPECT_TRUE(airways && !airways->empty());
  const auto& way = airways->front().way->points();
  return *std::find_if(way.begin(), way.end(), [](const Vector3& at) { return at.z() < 41; });
}

// Found by random missions (--anything --minds 984106): a plane came down in circles where its
// first lane began, and into that across it: 96.2 % of the zone were mapped.
TEST(WayFromAside, LeadsDownAtOnceWhoCannotHoverAndOthersWhereTheyBegin) {
  EXPECT_EQ(comes_down_at(false), Vector3(0, 0, 40));
  EXPECT_EQ(comes_down_at(true), Vector3(200, 0, 40));
}

// Found by random missions (--crossing 610510): others flew over it and around it.
TEST(WaysAside, LeadDownWhereThereIsNoOtherAir) { EXPECT_THAT(heights_aside(0), Contains(16)); }

TEST(WaysAside, DoNotLeadDownToTheGround) {
  EXPECT_THAT(heights_aside(12), ElementsAre(28)) << "but to 16 m over it";
  EXPECT_THAT(heights_aside(30), IsEmpty());
}

// Found by random missions (--sweepers --clean 990009): the first lane of a mapping was flown from
// where the vehicle had got out of the way, and 5 % of the zone were not seen.
TEST(BegunAt, WhoGotOutOfTheWayComesToWhereItsWayBegins) {
  const MergingConfig config = over_ground_at(0);
  AirwaySituation situation;
  situation.state.position = {30, 40, 40};
  situation.state.airborne = true;
  situation.rest = situation.state.position;
  functional::Request request;
  request.id = functional::TaskId(7);
  request.type = "goto";
  request.parameters.add(elementary::points_parameter("waypoints", {{40, 0, 40}}));
  const auto flown = [&](const Vector3& place) {
    return flight_of(begun_at(place, request, config, situation), config, situation)->waypoints;
  };

  EXPECT_THAT(flown({0, 0, 40}), ElementsAre(Vector3(0, 0, 40), Vector3(40, 0, 40)));
  EXPECT_THAT(flown(*situation.rest), ElementsAre(Vector3(40, 0, 40)));
}

}  // namespace
}  // namespace skein::decision_node
