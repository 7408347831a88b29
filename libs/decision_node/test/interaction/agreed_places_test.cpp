// SPDX-License-Identifier: Apache-2.0
#include "interaction/agreed_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "skein/config/parse.hpp"
#include "skein/world/world_builder.hpp"
#include "testing/level_ground.hpp"

namespace skein::decision_node {
namespace {

using interaction::Position;
using interaction::Rows;
using ::testing::HasSubstr;
using ::testing::SizeIs;

world::World flat_world() {
  world::WorldFile file = testing::level_ground();
  file.airspace.ceiling = 150;
  return world::build_world(std::move(file)).value();
}

class AgreedPlaces : public ::testing::Test {
 protected:
  AgreedPlaces() {
    knowledge_.uav = "marvin";
    knowledge_.vehicle.cruise_speed = 10;
    knowledge_.vehicle.ceiling = 150;
  }
  Outlook outlook() const {
    return {knowledge_, world_,
            [](const std::string& name) -> std::optional<interaction::Sighting> {
              if (name != "fire") return std::nullopt;
              return interaction::Sighting{{100, 0, 0}, MissionTime()};
            },
            MissionTime()};
  }
  static interaction::CoordinationAction action(const std::string& modality,
                                                const std::string& in) {
    interaction::CoordinationAction result;
    result.modality = modality;
    result.in = config::parse_yaml(in, "in").value();
    return result;
  }
  interaction::Terms terms(const std::string& modality, Rows parameters) const {
    interaction::Terms result;
    result.modality = modality;
    result.members = {"heliv", "marvin"};
    result.parameters = std::move(parameters);
    return result;
  }
  static world::VehicleState at(double x, double y) {
    world::VehicleState state;
    state.position = {x, y, 50};
    return state;
  }
  const Arguments scope_{{"front", Argument(std::string("fire"))}};
  supervisor::Knowledge knowledge_;
  world::World world_ = flat_world();
};

constexpr const char* kAround = "{around: front, distance: 40, altitude: 50, directions: 4}";

TEST_F(AgreedPlaces, DirectionsAreOnACircleAroundTheTarget) {
  const auto rows = place_terms(action("perception-positions", kAround), scope_, 2, outlook());
  ASSERT_TRUE(rows) << rows.error().why;
  const auto session = terms("perception-positions", *rows);

  const auto east = place_of_member("marvin", session, {{"marvin", "", {0}}}, world_);
  const auto north = place_of_member("marvin", session, {{"marvin", "", {1}}}, world_);

  ASSERT_TRUE(east && north);
  EXPECT_NEAR((*east)[0], 140, 1e-9);
  EXPECT_NEAR((*north)[1], 40, 1e-9);
  EXPECT_NEAR((*north)[2], 50, 1e-9);
}

TEST_F(AgreedPlaces, TheNearerPlaceCostsLess) {
  const auto rows = place_terms(action("perception-positions", kAround), scope_, 2, outlook());
  const auto offer =
      offer_of_places(terms("perception-positions", rows.value()), at(200, 0), outlook());

  ASSERT_TRUE(offer) << offer.error().why;
  ASSERT_THAT(*offer, SizeIs(4));
  EXPECT_LT((*offer)[0].numbers[1], (*offer)[2].numbers[1]);
}

TEST_F(AgreedPlaces, WhatIsNoFreeAirIsNotOffered) {
  world::Volume closed;
  closed.name = "tower";
  closed.polygon = {{130, -10}, {150, -10}, {150, 10}, {130, 10}};
  closed.ceiling = 200;
  world_.volumes.push_back(closed);
  const auto rows = place_terms(action("perception-positions", kAround), scope_, 2, outlook());

  const auto offer =
      offer_of_places(terms("perception-positions", rows.value()), at(200, 0), outlook());

  ASSERT_TRUE(offer);
  ASSERT_THAT(*offer, SizeIs(3));
  EXPECT_EQ((*offer)[0].numbers[0], 1);
}

TEST_F(AgreedPlaces, AChainHasALinkForEachMember) {
  const auto rows = place_terms(
      action("relay-chain", "{from: front, to: [-200, 0, 0], altitude: 60}"), scope_, 2, outlook());
  ASSERT_TRUE(rows) << rows.error().why;
  ASSERT_THAT(*rows, SizeIs(2));
  EXPECT_NEAR((*rows)[0].numbers[0], 0, 1e-9);
  EXPECT_NEAR((*rows)[1].numbers[0], -100, 1e-9);
  const auto session = terms("relay-chain", *rows);

  const auto first = place_of_member("marvin", session, {{"marvin", "", {0}}}, world_);

  ASSERT_TRUE(first);
  EXPECT_NEAR((*first)[2], 60, 1e-9);
  EXPECT_FALSE(place_of_member("marvin", session, {{"marvin", "", {-1}}}, world_));
}

TEST_F(AgreedPlaces, WhatTheActionDoesNotSayIsRefusedWithItsName) {
  const auto why = [&](const std::string& modality, const std::string& in) {
    const auto rows = place_terms(action(modality, in), scope_, 2, outlook());
    return rows ? "" : rows.error().why;
  };
  EXPECT_THAT(why("perception-positions", "{around: front, distance: 40, directions: 4}"),
              HasSubstr("'altitude'"));
  EXPECT_THAT(
      why("perception-positions", "{around: nowhere, distance: 4, altitude: 4, directions: 4}"),
      HasSubstr("'nowhere'"));
  EXPECT_THAT(why("relay-chain", "{from: front, altitude: 60}"), HasSubstr("'to'"));
}

TEST_F(AgreedPlaces, TermsThatSayNoPlacesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Rows& rows : {Rows{}, Rows{{"directions", "", {4}}},
                           Rows{{"directions", "", {4}}, {"circle", "", {1, 2}}},
                           Rows{{"directions", "", {4}}, {"circle", "", {nan, 0, 40, 50}}}}) {
    EXPECT_FALSE(offer_of_places(terms("perception-positions", rows), at(0, 0), outlook()));
  }
}

}  // namespace
}  // namespace skein::decision_node
