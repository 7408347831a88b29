// SPDX-License-Identifier: Apache-2.0
#include "flight.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::import_tool {
namespace {

using mission_files::ChangeSpeed;
using mission_files::Delay;
using mission_files::FlyTo;
using mission_files::Height;
using mission_files::HeightOver;
using mission_files::Item;
using mission_files::Land;
using mission_files::LatLon;
using mission_files::ReturnHome;
using mission_files::Step;
using mission_files::StopPictures;
using mission_files::TakeOff;
using mission_files::TakePictures;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr LatLon kHome{47.5, 8.25};

class Flights : public ::testing::Test {
 protected:
  Flights() {
    world::TerrainSpec spec;
    spec.west = spec.south = -2000;
    spec.east = spec.north = 2000;
    spec.hills = {{{500, 0}, 50, 100}};
    site_.emplace(world::GeodeticOrigin{47.5, 8.25, 400}, spec, kHome, 430.0, std::nullopt);
    model_.name = "m";
    model_.cruise_speed = 5;
    model_.max_speed = 10;
    model_.climb_rate = model_.descent_rate = 2;
    model_.ceiling = 120;
  }

  Flight fly(const std::vector<Step>& steps) {
    std::vector<Item> items;
    for (const Step& step : steps)
      items.push_back({step, {static_cast<int>(items.size()) + 1, ""}});
    return flight_of(items, options_, *site_, model_, closed_, log_);
  }
  std::string errors() const { return to_text(log_.errors()); }

  static Height home(double metres) { return {metres, HeightOver::kHome}; }
  /// About so many metres east and north of home.
  static LatLon there(double east, double north) {
    return {kHome.latitude + north / 111'178, kHome.longitude + east / 75'330};
  }
  static FlyTo to(double east, double north, Height height, double hold = 0) {
    return {{there(east, north), height}, hold, false};
  }
  static std::vector<std::string> types(const Flight& flight) {
    std::vector<std::string> all;
    for (const FlightTask& task : flight.tasks) all.push_back(task.type);
    return all;
  }

  std::optional<Site> site_;
  world::VehicleModel model_;
  FlightOptions options_{"camera", 40};
  std::vector<world::Volume> closed_;
  Log log_{"f"};
};

TEST_F(Flights, WayPointsBetweenWhichNothingHappensAreOneWay) {
  const Flight flight = fly({TakeOff{home(20)}, to(100, 0, home(30)), to(200, 0, home(30)),
                             to(200, 100, home(30), 5), to(0, 100, home(20)), Land{}});

  EXPECT_EQ(errors(), "");
  EXPECT_THAT(types(flight), ElementsAre("takeoff", "goto", "wait", "goto", "land"));
  EXPECT_EQ(flight.tasks[0].params, "{altitude: 20}");
  EXPECT_THAT(flight.tasks[1].params, HasSubstr("{to: [[1"));
  EXPECT_EQ(flight.tasks[2].params, "{duration: 5}");
  EXPECT_TRUE(flight.lands);
}

TEST_F(Flights, EachTaskBeginsWhenTheOneBeforeHasEnded) {
  const Flight flight = fly({TakeOff{home(20)}, to(100, 0, home(30)), Delay{3}, ReturnHome{}});

  EXPECT_THAT(types(flight), ElementsAre("takeoff", "goto", "wait", "goto", "land"));
  for (const FlightTask& task : flight.tasks) EXPECT_EQ(task.after, task.id - 1);
  EXPECT_EQ(flight.last, 5);
}

TEST_F(Flights, HeightsCountFromHomeTheGroundOrTheSea) {
  const Flight flight =
      fly({TakeOff{home(20)}, to(500, 0, home(80)), Delay{1}, to(500, 0, {30, HeightOver::kGround}),
           Delay{1}, to(500, 0, {510, HeightOver::kSeaLevel})});

  EXPECT_EQ(errors(), "");
  const auto z = [&](std::size_t task) {
    const std::string& text = flight.tasks.at(task).params;
    return std::stod(text.substr(text.rfind(' ')));
  };
  EXPECT_NEAR(z(1), 80, 0.05);  // straight axes: 2 cm lower, 500 m away
  EXPECT_NEAR(z(3), 80, 0.2);   // the hill is 50 m high
  EXPECT_NEAR(z(5), 80, 0.05);  // home is 430 m over the sea
}

TEST_F(Flights, ASpeedHoldsForTheWaysAfterIt) {
  const Flight flight =
      fly({TakeOff{home(20)}, to(100, 0, home(20)), ChangeSpeed{7.5}, to(200, 0, home(20))});

  EXPECT_THAT(flight.tasks[1].params, ::testing::Not(HasSubstr("speed")));
  EXPECT_THAT(flight.tasks[2].params, HasSubstr(", speed: 7.5}"));
}

TEST_F(Flights, WhoFliesWithoutATakeoffTakesOffFirst) {
  const Flight flight = fly({to(100, 0, home(30))});

  EXPECT_THAT(types(flight), ElementsAre("takeoff", "goto"));
  EXPECT_EQ(flight.tasks[0].params, "{altitude: 30}");
  ASSERT_EQ(log_.said().size(), 1U);
  EXPECT_THAT(log_.said()[0], HasSubstr("takes off first, to 30 m"));
  EXPECT_FALSE(flight.lands);
}

TEST_F(Flights, PicturesAreTakenAlongTheWayBetweenTheirBeginAndTheirEnd) {
  const Flight flight =
      fly({TakeOff{home(20)}, to(100, 0, home(20)), TakePictures{0}, to(200, 0, home(20)),
           TakePictures{0}, to(200, 50, home(20)), StopPictures{}, to(0, 0, home(20))});

  EXPECT_EQ(errors(), "");
  EXPECT_THAT(types(flight), ElementsAre("takeoff", "goto", "goto", "takeshot", "goto"));
  const FlightTask& shots = flight.tasks[3];
  EXPECT_EQ(shots.params, "{device: camera}");
  EXPECT_EQ(shots.after, 2);
  EXPECT_EQ(shots.until_end_of, flight.tasks[2].id) << "and it stands behind it";
  EXPECT_EQ(flight.tasks[2].after, 2) << "flying on does not wait for the pictures";
}

TEST_F(Flights, SomeNumberOfPicturesIsOneTask) {
  const Flight flight = fly({TakeOff{home(20)}, TakePictures{3}, to(100, 0, home(20))});

  EXPECT_EQ(flight.tasks[1].params, "{device: camera, shots: 3}");
  EXPECT_EQ(flight.tasks[1].until_end_of, 0);
}

TEST_F(Flights, PicturesThatNobodyTakesAreTold) {
  options_.camera.clear();

  const Flight flight = fly({TakeOff{home(20)}, TakePictures{3}});

  EXPECT_THAT(types(flight), ElementsAre("takeoff"));
  EXPECT_THAT(to_text(log_.left_out()), HasSubstr("f:2: pictures, since no --camera"));
}

TEST_F(Flights, AWayHomeKeepsFromTheGroundAndEndsOnIt) {
  const Flight flight = fly({TakeOff{home(20)}, to(100, 0, home(3)), ReturnHome{}});

  EXPECT_THAT(types(flight), ElementsAre("takeoff", "goto", "land"));
  EXPECT_THAT(flight.tasks[1].params, HasSubstr("[0, 0, 5]"));
}

TEST_F(Flights, WhatTheVehicleCannotFlyIsToldAllAtOnce) {
  world::Volume tower;
  tower.name = "tower";
  tower.polygon = {{190, -10}, {210, -10}, {210, 10}, {190, 10}};
  closed_.push_back(tower);

  fly({TakeOff{home(1)}, to(100, 0, home(130)), to(500, 0, home(40)), to(200, 0, home(20)),
       ChangeSpeed{12}});

  EXPECT_THAT(errors(), HasSubstr("f:1: a takeoff to 1 m"));
  EXPECT_THAT(errors(), HasSubstr("f:2: 130 m over the ground there; expected 2 to 120 m"));
  EXPECT_THAT(errors(), HasSubstr("f:3: -"));
  EXPECT_THAT(errors(), HasSubstr("f:4: in closed air: 'tower'"));
  EXPECT_THAT(errors(), HasSubstr("f:5: 12 m/s; expected at most 10 m/s"));
}

TEST_F(Flights, AHeightOverTheSeaNeedsAHomeThatIsKnownOrAGeoid) {
  world::TerrainSpec spec;
  spec.west = spec.south = -2000;
  spec.east = spec.north = 2000;
  site_.emplace(world::GeodeticOrigin{47.5, 8.25, 400}, spec, kHome, std::nullopt, std::nullopt);
  fly({TakeOff{home(20)}, to(100, 0, {480, HeightOver::kSeaLevel})});
  EXPECT_THAT(errors(), HasSubstr("expected --geoid METRES"));

  log_ = Log("f");
  site_.emplace(world::GeodeticOrigin{47.5, 8.25, 400}, spec, kHome, std::nullopt, 48.0);
  const Flight flight = fly({TakeOff{home(20)}, to(0, 0, {380, HeightOver::kSeaLevel})});
  EXPECT_EQ(errors(), "");
  EXPECT_THAT(flight.tasks.at(1).params, HasSubstr(", 28]"));  // 380 + 48 - 400
}

TEST_F(Flights, WhatComesAfterAPlaceAtWhichItStaysIsToldAndNotFlown) {
  FlyTo stays = to(100, 0, home(20));
  stays.stays = true;

  const Flight flight = fly({TakeOff{home(20)}, stays, to(200, 0, home(20)), Land{}});

  EXPECT_THAT(types(flight), ElementsAre("takeoff", "goto"));
  EXPECT_EQ(log_.left_out().size(), 2U);
}

TEST_F(Flights, WhatAsksForNothingIsTold) {
  fly({Land{}, ReturnHome{}, TakeOff{home(20)}, TakeOff{home(30)}});

  EXPECT_EQ(log_.left_out().size(), 3U);
}

}  // namespace
}  // namespace skein::import_tool
