// SPDX-License-Identifier: Apache-2.0
// What a UAV knows of where UAVs, objects and places are, and of when (spec 7.6).
#include "interaction/sightings.hpp"

#include <gtest/gtest.h>

#include "level_world.hpp"

namespace skein::decision_node {
namespace {

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

/// What is known at 100 s by one that knows a place of the world.
class Known {
 public:
  Known() {
    world_ = skein::testing::level_world(100);
    world_->places["fire-front"] = {90, 40, 0};
    world_->places["cellar"] = {90, 40, -20};
  }
  std::optional<interaction::Sighting> of(const std::string& name) const {
    return sightings.observer(arguments_, *world_, at(100))(name);
  }
  Sightings sightings{"uav1"};

 private:
  Arguments arguments_;
  std::optional<world::World> world_;
};

mission::KnownPlace seen(double x, double when) {
  return {"fire-front", {x, 40, 0}, 2, std::nullopt, at(when)};
}

TEST(Sightings, APlaceIsWhereItIsSaidToBeAtAnyTime) {
  const auto place = Known().of("fire-front");

  ASSERT_TRUE(place);
  EXPECT_EQ(place->at, at(100));
  EXPECT_FALSE(place->by_sensors);
}

TEST(Sightings, AnObjectIsAsOldAsItWasSeen) {
  Known known;
  known.sightings.see(seen(85, 60));

  const auto object = known.of("fire-front");

  ASSERT_TRUE(object);
  EXPECT_EQ(object->position[0], 85);
  EXPECT_EQ(object->at, at(60));
  EXPECT_TRUE(object->by_sensors);
}

// Over a relay a word may be overtaken by a later one.
TEST(Sightings, AnOlderWordOfAnObjectChangesNothing) {
  Known known;
  known.sightings.see(seen(85, 60));
  known.sightings.see(seen(88, 50));

  EXPECT_EQ(known.of("fire-front")->position[0], 85);
}

TEST(Sightings, OfWhatDoesNotMoveAnyMoreTheWorldCountsAgain) {
  Known known;
  known.sightings.see(seen(85, 60));
  known.sightings.see({"fire-front", {70, 40, 0}, 2, std::nullopt, std::nullopt});

  EXPECT_EQ(known.of("fire-front")->position[0], 90);
  EXPECT_EQ(known.of("fire-front")->at, at(100));
}

// Found by random missions (--escorts): over a hill its height above the sea was given as 0.
TEST(Sightings, APlaceUnderTheGroundIsOnIt) {
  Known known;
  EXPECT_EQ(known.of("cellar")->position[2], 0);
  mission::KnownPlace told = seen(85, 60);
  told.at.z() = -20;
  known.sightings.see(told);

  EXPECT_EQ(known.of("fire-front")->position[2], 0);
}

TEST(Sightings, OfWhatNobodyToldNothingIsKnown) { EXPECT_FALSE(Known().of("smoke")); }

}  // namespace
}  // namespace skein::decision_node
