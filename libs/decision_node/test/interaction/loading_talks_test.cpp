// SPDX-License-Identifier: Apache-2.0
// What is negotiated before a joint task begins, and what a UAV offers.
#include "interaction/loading_talks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interaction/loading_time.hpp"
#include "testing/scouting.hpp"

namespace skein::decision_node {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Of "marvin", who scouts with heliv.
class BeforeItBegins : public ::testing::Test {
 protected:
  static std::vector<mission::Interval> between(double least, double most) {
    return {{Duration::seconds(least), Duration::seconds(most)}};
  }
  Result<interaction::Rows, Failure> offer(const std::vector<std::string>& roles) const {
    interaction::Terms terms;
    for (const std::string& role : roles) terms.parameters.push_back({role, "", {}});
    const world::VehicleState from = course_.sightings.own()->state;
    const Outlook outlook = course_.outlook();
    return offer_of_roles(terms, {course_.host, course_.sightings, course_.my, from, outlook});
  }
  double cost(const std::string& role) const { return offer({role}).value().front().numbers[0]; }

  testing::ScoutingCourse course_;
};

TEST_F(BeforeItBegins, RolesAreNegotiatedWithTheNumbersOfTheirHolders) {
  const auto session = roles_session(course_.my.joint);
  EXPECT_EQ(session.subject, course_.my.joint.subject + "/roles");
  EXPECT_EQ(session.modality, "role-allocation");
  ASSERT_THAT(session.parameters, SizeIs(3));
  EXPECT_EQ(session.parameters[0].name, "scout");
  EXPECT_THAT(session.parameters[0].numbers, ElementsAre(1, -1)) << "no limit";
  EXPECT_THAT(session.parameters[1].numbers, ElementsAre(0, -1));
}

TEST_F(BeforeItBegins, AndThenTheStart) {
  const auto session = start_session(course_.my.joint);
  EXPECT_EQ(session.subject, course_.my.joint.subject + "/start");
  EXPECT_EQ(session.modality, "time-interval");
}

TEST_F(BeforeItBegins, BothAreAboutTheJointTask) {
  const Joint& joint = course_.my.joint;
  EXPECT_TRUE(joint.has(roles_session(joint).subject));
  EXPECT_TRUE(joint.has(start_session(joint).subject));
  EXPECT_FALSE(joint.has(joint.subject));
  EXPECT_FALSE(joint.has(joint.subject + "2/start"));
  EXPECT_THAT(joint.others("marvin"), ElementsAre("heliv"));
}

TEST_F(BeforeItBegins, TheStartIsOfferedWhenThePlanHasIt) {
  const interaction::Rows rows = offer_of_start(between(10, 20), {});
  ASSERT_THAT(rows, SizeIs(1));
  EXPECT_THAT(rows.front().numbers, ElementsAre(10, 21)) << "with room to begin in";
}

TEST_F(BeforeItBegins, AStartThatCameTooEarlyIsOfferedLaterButNotTooLate) {
  const auto from = [](double ahead) {
    return offer_of_start(between(10, 20), Duration::seconds(ahead)).front().numbers;
  };
  EXPECT_THAT(from(5), ElementsAre(DoubleNear(15, 1e-6), 21));
  EXPECT_THAT(from(60), ElementsAre(20, 21));
}

TEST_F(BeforeItBegins, AStartWithoutEndIsOfferedWithOne) {
  const auto numbers = offer_of_start(between(10, 2e8), {}).front().numbers;
  EXPECT_THAT(numbers, ElementsAre(10, LoadingTime::kForever + 1));
}

TEST_F(BeforeItBegins, ARoleIsOfferedForWhatItCosts) {
  const auto rows = offer({"scout"});
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->front().name, "scout");
  EXPECT_GE(rows->front().numbers[0], 0);
}

TEST_F(BeforeItBegins, WhileItRunsAnotherRoleCostsFourSecondsMore) {
  const double runs = cost("spare");
  course_.my.phase = interaction::JointPhase::kLoading;
  const double loads = cost("spare");
  EXPECT_DOUBLE_EQ(runs, loads + 4);
  const double own = cost("scout");
  course_.my.phase = interaction::JointPhase::kRunning;
  EXPECT_DOUBLE_EQ(cost("scout"), own) << "it has that role";
}

TEST_F(BeforeItBegins, WhoCannotPlayOneOfTheRolesSaysWhyBesideItsOffers) {
  const auto rows = offer({"scout", "post"});
  ASSERT_TRUE(rows);
  ASSERT_THAT(*rows, SizeIs(2));
  EXPECT_THAT(rows->front().numbers, SizeIs(1));
  EXPECT_EQ(rows->back().name, "post");
  EXPECT_THAT(rows->back().numbers, IsEmpty());
  EXPECT_THAT(rows->back().text, HasSubstr("thermal"));
}

TEST_F(BeforeItBegins, ARoleThatNobodyKnowsIsRefused) {
  const auto rows = offer({"scout", "spy"});
  ASSERT_FALSE(rows);
  EXPECT_EQ(rows.error().why, "no role 'spy'");
}

TEST_F(BeforeItBegins, WhoCanPlayNoRoleSaysWhy) {
  const auto rows = offer({});
  ASSERT_FALSE(rows);
  EXPECT_THAT(rows.error().why, HasSubstr("it can play no role"));
}

}  // namespace
}  // namespace skein::decision_node
