// SPDX-License-Identifier: Apache-2.0
#include "interaction/pursuit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/scouting.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// After a car that is seen 100 m east of marvin at first.
class CarPursuit : public ::testing::Test {
 protected:
  void car_at(double x, double y) {
    course_.sightings.see(
        mission::KnownPlace{"car", {x, y, 0}, 2, std::nullopt, MissionTime::seconds(1)});
  }
  void follow() {
    course_.at(1);
    car_at(100, 0);
    pursuit_.follow("pursue");
  }
  /// Where the last flight ends.
  world::Vector3 aim() const { return course_.way_of(course_.given.back()).back(); }

  testing::ScoutingCourse course_;
  Pursuit pursuit_{course_.surroundings(), course_};
};

TEST_F(CarPursuit, FliesToBesideTheTargetOnItsOwnSide) {
  follow();

  EXPECT_THAT(course_.told, ElementsAre("pursue runs"));
  ASSERT_THAT(course_.given, SizeIs(1));
  EXPECT_EQ(course_.given[0].componel, "pursue");
  EXPECT_NEAR((aim() - world::Vector3(70, 0, 60)).norm(), 0, 0.1);
  EXPECT_TRUE(pursuit_.follows("pursue"));
  EXPECT_FALSE(pursuit_.follows("sweep"));
}

TEST_F(CarPursuit, FliesToThePlaceBesideTheTargetThatItsRoleHas) {
  course_.at(1);
  car_at(100, 0);
  course_.play().know("side", interaction::Position{100, 45, 45});
  pursuit_.follow("flank");

  EXPECT_NEAR((aim() - world::Vector3(100, 45, 45)).norm(), 0, 0.1);
}

// Found by random missions (--escorts 2, 60): nothing was agreed on, and it stayed where it was.
TEST_F(CarPursuit, FliesToBesideTheTargetWhereItsRoleHasAPlaceFarFromThat) {
  course_.at(1);
  car_at(110, 0);
  course_.play().know("side", interaction::Position{0, 0, 60});
  pursuit_.follow("flank");

  EXPECT_NEAR((aim() - world::Vector3(80, 0, 60)).norm(), 0, 0.1);
}

TEST_F(CarPursuit, FailsWhereNobodyKnowsTheTarget) {
  pursuit_.follow("pursue");

  EXPECT_THAT(course_.failed, ElementsAre("pursue: nobody knows where 'car' is"));
  EXPECT_THAT(course_.given, IsEmpty());
  EXPECT_FALSE(pursuit_.follows("pursue"));
}

TEST_F(CarPursuit, FliesOnOnceItHasArrivedAndTheTargetHasMovedOnByMoreThanTenMetres) {
  follow();
  car_at(150, 0);
  pursuit_.look();
  EXPECT_THAT(course_.given, SizeIs(1)) << "one flight at a time";

  pursuit_.arrived("pursue");
  course_.stands_at({70, 0, 60});
  car_at(109, 0);
  pursuit_.look();
  EXPECT_THAT(course_.given, SizeIs(1));

  car_at(111, 0);
  pursuit_.look();
  ASSERT_THAT(course_.given, SizeIs(2));
  EXPECT_NEAR((aim() - world::Vector3(81, 0, 60)).norm(), 0, 0.1);
}

TEST_F(CarPursuit, OfWhatIsFollowedNoMoreNothingIsFlown) {
  follow();
  pursuit_.arrived("pursue");
  pursuit_.stop("pursue");
  car_at(300, 0);
  pursuit_.look();
  EXPECT_THAT(course_.given, SizeIs(1));

  follow();
  pursuit_.begin_anew();
  EXPECT_FALSE(pursuit_.follows("pursue"));
}

}  // namespace
}  // namespace skein::decision_node
