// SPDX-License-Identifier: Apache-2.0
// The world and the vehicle as they are believed.
#include "watch/beliefs.hpp"

#include <gmock/gmock.h>

#include "testing/rooms.hpp"
#include "watch/stand.hpp"

namespace skein::supervisor {
namespace {

using namespace testing;  // NOLINT: builders read as words
using ::testing::ElementsAre;
using ::testing::IsEmpty;

mission::ChangeWorld place_at(double x) {
  mission::ChangeWorld change;
  change.place = mission::KnownPlace{"alarm:1", {x, 0, 0}, 0, std::nullopt};
  return change;
}
mission::ChangeWorld closed(const std::string& name, bool remove = false) {
  mission::ChangeWorld change;
  change.volume.name = name;
  change.remove = remove;
  return change;
}
world::VehicleState flying_at(const world::Vector3& position) {
  world::VehicleState state;
  state.position = position;
  state.airborne = true;
  return state;
}

TEST(Beliefs, APlaceThatWasNotKnownHasNotMoved) {
  Rooms rooms;
  EXPECT_EQ(rooms.beliefs.learn(place_at(3)), 0);
  EXPECT_EQ(rooms.beliefs.learn(place_at(43)), 40);
  EXPECT_EQ(rooms.beliefs.world().places.at("alarm:1").x(), 43);
}

TEST(Beliefs, AWorldThatWasGivenAwayNeverChanges) {
  Rooms rooms;
  const auto given = rooms.beliefs.shared_world();
  const std::uint64_t revision = rooms.beliefs.revision();

  rooms.beliefs.learn(place_at(3));
  rooms.beliefs.close(closed("tower"));

  EXPECT_TRUE(given->places.empty());
  EXPECT_TRUE(given->volumes.empty());
  EXPECT_EQ(rooms.beliefs.revision(), revision + 2);
}

TEST(Beliefs, AVolumeIsClosedOnceAndOpenedAgain) {
  Rooms rooms;
  rooms.beliefs.close(closed("tower"));
  rooms.beliefs.close(closed("tower"));
  EXPECT_EQ(rooms.beliefs.world().volumes.size(), 1U);

  rooms.beliefs.close(closed("tower", true));
  EXPECT_THAT(rooms.beliefs.world().volumes, IsEmpty());
}

TEST(Beliefs, SayWhichDevicesFailedNow) {
  Rooms rooms;
  const world::VehicleState state;
  EXPECT_THAT(rooms.beliefs.see(state, {"camera"}, at(1)), ElementsAre("camera"));
  EXPECT_THAT(rooms.beliefs.see(state, {"camera", "radio"}, at(2)), ElementsAre("radio"));
  EXPECT_THAT(rooms.beliefs.see(state, {}, at(3)), IsEmpty());
  EXPECT_THAT(rooms.beliefs.see(state, {"camera"}, at(4)), ElementsAre("camera"));
}

TEST(Beliefs, AStateThatIsOlderThanTheLandingIsNotBelievedThatItFlies) {
  Rooms rooms;
  rooms.beliefs.see(flying_at({0, 0, 1}), {}, at(9));
  rooms.beliefs.see_end({TaskId{1}, "land", TaskState::kEnded, ""}, at(10));
  EXPECT_FALSE(rooms.beliefs.vehicle().airborne);

  rooms.beliefs.see(flying_at({0, 0, 1}), {}, at(11));
  EXPECT_FALSE(rooms.beliefs.vehicle().airborne);
  rooms.beliefs.see(flying_at({0, 0, 1}), {}, at(13));
  EXPECT_TRUE(rooms.beliefs.vehicle().airborne);
}

TEST(Beliefs, AVehicleThatTookOffFliesBeforeAStateSaysSo) {
  Rooms rooms;
  rooms.beliefs.see_end({TaskId{1}, "takeoff", TaskState::kEnded, ""}, at(10));
  EXPECT_TRUE(rooms.beliefs.vehicle().airborne);
}

// ---- where it keeps itself ----

/// One that cannot hover, at the end of a flight to (100, 0).
struct Circling : Rooms {
  static Config fixed_wing() {
    Config config = config_for_tests();
    auto knowledge = std::make_shared<Knowledge>(*config.knowledge);
    knowledge->vehicle.hovers = false;
    knowledge->vehicle.orbit_radius = 30;
    config.knowledge = knowledge;
    return config;
  }
  Circling() : Rooms(fixed_wing()) {
    goals({701});
    plan({TaskOf(100, "goto", 701).way({{0, 0, 40}, {100, 0, 40}}),
          TaskOf(101, "wait", 701).after(100)});
    gave({100, 101}).started(100).flies({130, 0, 40});
  }
};

TEST(Stand, OneThatCannotHoverIsWhereItCircles) {
  Circling rooms;
  EXPECT_FALSE(circled(rooms.book, rooms.beliefs));

  rooms.ended(100);
  EXPECT_EQ(circled(rooms.book, rooms.beliefs), world::Vector3(100, 0, 40));
  EXPECT_EQ(place_of_vehicle(rooms.book, rooms.beliefs), world::Vector3(100, 0, 40));
}

// Ways from there were planned 36 m below it, and as slopes asked for all air down to others.
TEST(Stand, OneThatGotOutOfTheWayUpwardsCirclesUpThere) {
  Circling rooms;
  rooms.ended(100).flies({130, 0, 43});
  EXPECT_EQ(circled(rooms.book, rooms.beliefs), world::Vector3(100, 0, 40)) << "it wavers";
  rooms.flies({130, 0, 76});
  EXPECT_EQ(circled(rooms.book, rooms.beliefs), world::Vector3(100, 0, 76));
}

TEST(Stand, OneThatIsFarFromWhereItFlewToIsWhereItIs) {
  Circling rooms;
  rooms.ended(100).flies({400, 0, 40});
  EXPECT_EQ(place_of_vehicle(rooms.book, rooms.beliefs), world::Vector3(400, 0, 40));
}

TEST(Stand, ATaskKeepsItWhereTheWayBeforeItEnds) {
  Circling rooms;
  EXPECT_EQ(stand_of(rooms.entry(101), rooms.book, rooms.beliefs), world::Vector3(100, 0, 40));
  EXPECT_FALSE(stand_of(rooms.entry(100), rooms.book, rooms.beliefs));
}

}  // namespace
}  // namespace skein::supervisor
