// SPDX-License-Identifier: Apache-2.0
// Partners of a joint task that end their roles, fall silent or are declared lost.
#include "interaction/companions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Of "marvin", with a lease of 100 s.
class ThreeTogether : public ::testing::Test {
 protected:
  static MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

  ThreeTogether() {
    partners_.start(at(0));
    for (const std::string uav : {"heliv", "karma"}) heard(uav, 0);
    my_.joint.members = {"heliv", "karma", "marvin"};
    my_.holders = {{"heliv", "relay"}, {"karma", "watch"}, {"marvin", "watch"}};
  }
  void heard(const std::string& uav, double when) {
    partners_.contact({uav, false, true}, at(when));
  }
  void falls_silent(const std::string& uav, double when) {
    partners_.contact({uav, false, false}, at(when));
  }
  std::vector<std::string> lost(double now) const {
    std::vector<std::string> names;
    for (const Companions::Lost& one : companions_.lost(at(now))) names.push_back(one.uav);
    return names;
  }

  const std::string self_ = "marvin";
  Partners partners_{Duration::seconds(100)};
  Membership my_;
  Companions companions_{partners_, my_, self_};
};

TEST_F(ThreeTogether, WhoIsSilentForAMinuteIsLost) {
  falls_silent("heliv", 10);
  EXPECT_THAT(lost(69), IsEmpty());
  EXPECT_EQ(companions_.next_loss(), at(70));
  EXPECT_THAT(lost(70), ElementsAre("heliv"));
  EXPECT_THAT(companions_.lost(at(70)).front().why, HasSubstr("since 10 s"));
  heard("heliv", 75);
  EXPECT_THAT(lost(80), IsEmpty());
  EXPECT_EQ(companions_.next_loss(), std::nullopt);
}

TEST_F(ThreeTogether, WhoIsDeclaredLostIsLostAtOnce) {
  partners_.declare_lost("karma");
  EXPECT_THAT(lost(1), ElementsAre("karma"));
  EXPECT_EQ(companions_.lost(at(1)).front().why, "'karma' is declared lost");
}

TEST_F(ThreeTogether, OfWhoHasEndedNothingIsExpectedAnyMore) {
  falls_silent("heliv", 10);
  companions_.has_ended("heliv");
  EXPECT_THAT(lost(100), IsEmpty());
  EXPECT_EQ(companions_.next_loss(), std::nullopt);
  EXPECT_FALSE(companions_.all_have_ended());
  companions_.has_ended("karma");
  EXPECT_TRUE(companions_.all_have_ended()) << "it has not ended itself";
}

TEST_F(ThreeTogether, OnceRolesAreAgreedAnewNobodyHasEnded) {
  companions_.has_ended("heliv");
  companions_.has_ended("karma");
  companions_.begin_anew();
  EXPECT_FALSE(companions_.all_have_ended());
}

TEST_F(ThreeTogether, WhoHoldsNoRoleIsNotCountedOn) {
  my_.holders.erase("heliv");
  falls_silent("heliv", 10);
  EXPECT_THAT(lost(100), IsEmpty());
  companions_.has_ended("karma");
  EXPECT_TRUE(companions_.all_have_ended());
}

TEST_F(ThreeTogether, WhileItLoadsAMemberIsGivenUpAfterItsLease) {
  my_.holders.clear();
  EXPECT_EQ(companions_.next_given_up(at(0)), std::nullopt);
  falls_silent("karma", 30);
  falls_silent("heliv", 10);
  EXPECT_EQ(companions_.next_given_up(at(0)), at(110));
  EXPECT_EQ(companions_.next_given_up(at(20)), at(120)) << "it is waited for since then";
}

}  // namespace
}  // namespace skein::decision_node
