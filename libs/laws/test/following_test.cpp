// SPDX-License-Identifier: Apache-2.0
// What is to be followed is followed for as long as asked: P1, at (100, 0), for 60 s.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks.hpp"
#include "testing/joint_told.hpp"

namespace skein::laws {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Told;

const world::Vector3 kBeside{90, 10, 40}, kAway{-100, 0, 40};

/// Marvin watches, and says that it follows from 20 s on for `seconds`.
Told followed(double seconds) {
  Told told;
  told.follows().phase(10, "marvin", "running", "watch").phase(12, "heliv", "running", "relay");
  told.componel(20, "marvin", "f1", "running").componel(20 + seconds, "marvin", "f1", "aborted");
  told.phase(900, "marvin", "ended", "watch").phase(901, "heliv", "ended", "relay");
  return told.goal(902, "marvin", "achieved").is_at("marvin", kBeside);
}

TEST(Following, LastsForAsLongAsAsked) {
  EXPECT_THAT(followed(60).broken(joint_tasks_not_done), IsEmpty());
  EXPECT_THAT(followed(30).broken(joint_tasks_not_done),
              ElementsAre(HasSubstr("nobody followed P1 for more than 30.0 of 60.0 s")));
  EXPECT_THAT(followed(240).broken(joint_tasks_not_done),
              ElementsAre(HasSubstr("marvin followed P1 for 240.0 s, asked for 60.0")));
}

TEST(Following, IsBesideTheTargetInTruth) {
  EXPECT_THAT(followed(60).is_at("marvin", kAway).broken(joint_tasks_not_done),
              ElementsAre(HasSubstr("more than 0.0 of 60.0 s")));

  Told leaves =
      followed(60).is_along("marvin", {{0, kBeside}, {40, kBeside}, {41, kAway}, {1000, kAway}});
  EXPECT_THAT(leaves.broken(joint_tasks_not_done), ElementsAre(HasSubstr("nobody followed P1")));
}

TEST(Following, BeginsOnTheWayToTheTarget) {
  const Told comes =
      followed(60).is_along("marvin", {{0, kAway}, {40, kAway}, {50, kBeside}, {1000, kBeside}});

  EXPECT_THAT(comes.broken(joint_tasks_not_done), IsEmpty());
}

TEST(Following, AddsUpWhereItIsInterrupted) {
  Told told = followed(30);
  told.componel(60, "marvin", "f1", "running").componel(90, "marvin", "f1", "aborted");

  EXPECT_THAT(told.broken(joint_tasks_not_done), IsEmpty());
}

TEST(Following, IsOverWhereTheRoleIsLeftWithoutAWordOnIt) {
  Told told;
  told.follows().phase(10, "marvin", "running", "watch").phase(12, "heliv", "running", "relay");
  told.componel(20, "marvin", "f1", "running").phase(80, "marvin", "ended", "watch");
  told.phase(81, "heliv", "ended", "relay").goal(902, "marvin", "achieved");

  EXPECT_THAT(told.is_at("marvin", kBeside).broken(joint_tasks_not_done), IsEmpty());
}

TEST(Following, MayLackWhatTheTargetsMovesTake) {
  EXPECT_THAT(followed(45).told_of(30, "P1", {110, 0, 0}).broken(joint_tasks_not_done), IsEmpty());
}

TEST(Following, OfOneIsEnoughWhereAnotherIsLost) {
  Told told = followed(60);
  told.phase(10, "heliv", "running", "watch").componel(20, "heliv", "f1", "running");
  told.componel(40, "heliv", "f1", "aborted").phase(41, "heliv", "aborted", "watch");
  const auto broken = told.is_at("heliv", kBeside).broken(joint_tasks_not_done);

  EXPECT_THAT(broken, Not(::testing::Contains(HasSubstr("followed"))));
}

// Found by random missions (--escorts 40).
TEST(Watching, MayBeLeftByWhoHearsNobodyWithoutAWordToThoseWhoGoOn) {
  const auto left = [](bool radio, const std::string& why) {
    Told told;
    told.link(0, true, "heliv", "marvin").link(30, radio, "heliv", "marvin");
    told.phase(10, "marvin", "running", "watch").phase(12, "heliv", "running", "relay");
    told.perceives("marvin", 9, 20, 40).is_at("marvin", {0, 0, 40});
    told.phase(90, "marvin", "aborted", "watch", why).phase(95, "heliv", "ended", "relay");
    return told.goal(96, "heliv", "achieved").broken(joint_tasks_not_done);
  };

  EXPECT_THAT(left(false, "no contact with 'heliv' since 30 s"), IsEmpty());
  EXPECT_THAT(left(true, "no contact with 'heliv' since 30 s"),
              ElementsAre(HasSubstr("for 20.0 of 60.0 s")));
  EXPECT_THAT(left(false, "no way"), ElementsAre(HasSubstr("for 20.0 of 60.0 s")));
}

}  // namespace
}  // namespace skein::laws
