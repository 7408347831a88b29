// SPDX-License-Identifier: Apache-2.0
// Goals that fail: their reasons, and failures that nothing explains.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Reasons, AReasonIsThereAndTrue) {
  const auto fails = [](const std::string& why) {
    Story story;
    story.goal("marvin", 701, "perceive P1 60", "received", 1)
        .goal("marvin", 701, "perceive P1 60", "failed", 2, why);
    return story.broken("reasons");
  };

  EXPECT_THAT(fails(""), ElementsAre(HasSubstr("gives no reason")));
  EXPECT_THAT(fails("task 104 must start while 103 runs, but waits for 102"), SizeIs(1));
  EXPECT_THAT(fails("the way of goal 701 (perceive P1 60) (perceive P1 60) is too long"),
              ElementsAre(HasSubstr("names a goal twice over")));
  EXPECT_THAT(fails("it begins in closed air, and no free air is near"),
              ElementsAre(HasSubstr("no air is closed")));
  EXPECT_THAT(fails("needs 140 % of the energy, and 90 % is left above the reserve"), IsEmpty());
}

TEST(Reasons, AirThatTheScenarioClosesLaterIsPlannedFor) {
  Story story(
      "  volumes: {tower: {polygon: [[100, 0], [200, 0], [200, 100]], from: 300, until: 900}}\n");
  story.goal("marvin", 701, "perceive P1 60", "received", 1)
      .goal("marvin", 701, "perceive P1 60", "failed", 2, "closed air is too near for its turns");

  EXPECT_THAT(story.broken("reasons"), IsEmpty());
}

TEST(Reasons, ATimeIsOfSomethingAskedOfItOrOfWhoNeedsIt) {
  const auto fails = [](const std::string& heliv) {
    Story story;
    story.goal("heliv", 800, heliv, "received", 1);
    story.goal("marvin", 701, "perceive P1 60", "received", 1)
        .goal("marvin", 701, "perceive P1 60", "failed", 2,
              "it starts no earlier than 90 s, must start before 50 s, which 'heliv' needs");
    return story.broken("reasons");
  };

  EXPECT_THAT(fails("general-land [end-before 60]"), IsEmpty());
  EXPECT_THAT(fails("general-land"), ElementsAre(HasSubstr("nothing asked of heliv has a time")));
}

TEST(Reasons, ADeviceThatFailedIsOfWhoeverLacksIt) {
  for (const std::string why :
       {"'heliv' left: t42: device 'visible' has failed",
        "heliv: it can play no role: observe: device 'visible' has failed"}) {
    const auto fails = [&](const std::string& whose) {
      Story story;
      story.goal("heliv", 800, "general-land", "received", 1).fault(1, "sensor", whose);
      story.goal("marvin", 701, "perceive P1 60", "received", 1)
          .goal("marvin", 701, "perceive P1 60", "failed", 2, why);
      return story.broken("reasons");
    };

    EXPECT_THAT(fails("heliv"), IsEmpty()) << why;
    EXPECT_THAT(fails("marvin"), ElementsAre(HasSubstr("no device failed"))) << why;
  }
}

TEST(Feasible, WhereNothingGoesWrongNothingFails) {
  Story story;
  story.goal("marvin", 701, "perceive P1 60", "received", 1)
      .goal("marvin", 701, "perceive P1 60", "failed", 2, "no");

  EXPECT_THAT(story.broken("feasible"), SizeIs(1));
}

TEST(Feasible, WhatWouldMakeAnotherMissItsDeadlineIsRefused) {
  const auto fails = [](const std::string& helivs) {
    Story story;
    story.goal("heliv", 800, helivs, "received", 1);
    story.goal("marvin", 701, "perceive P1 60", "received", 1)
        .goal("marvin", 701, "perceive P1 60", "failed", 2,
              "it starts no earlier than 90 s, must start before 50 s, which 'heliv' needs");
    return story.broken("feasible");
  };

  EXPECT_THAT(fails("general-land [end-before 60]"), IsEmpty());
  EXPECT_THAT(fails("general-land"), SizeIs(1));
}

// Found by random missions (--anything --clean 991002): it was sent 160 m over the ground.
TEST(Feasible, WhoIsSentHigherThanItFliesMayRefuse) {
  const auto fails = [](const std::string& where) {
    Story story;
    const std::string statement = "general-gotoxyz " + where;
    story.goal("marvin", 701, statement, "received", 1)
        .goal("marvin", 701, statement, "failed", 2, "no");
    return story.broken("feasible");
  };

  EXPECT_THAT(fails("(150 60 5000)"), IsEmpty());
  EXPECT_THAT(fails("(150 60 50)"), SizeIs(1));
}

TEST(Feasible, OverGroundSteeperThanItClimbsAVehicleMayFindNoWay) {
  const auto fails = [](double height, const std::string& why) {
    Story story;
    story.hill({{600, 300}, height, 200});
    story.goal("karma", 701, "perform-monitoring P1 60", "received", 1)
        .goal("karma", 701, "perform-monitoring P1 60", "failed", 2, why);
    return story.broken("feasible");
  };

  EXPECT_THAT(fails(120, "the ground is too near for its turns"), IsEmpty());
  EXPECT_THAT(fails(120, "no contact with 'heliv' since 60 s"), IsEmpty());
  EXPECT_THAT(fails(120, "no free air beside it for partner 2"), IsEmpty());
  EXPECT_THAT(fails(120, "half the time is over without an offer of heliv"), IsEmpty());
  EXPECT_THAT(fails(120, "no"), SizeIs(1));
  EXPECT_THAT(fails(5, "the ground is too near for its turns"), SizeIs(1));
}

TEST(Feasible, OrdersThatNeverComeAreNotWaitedForUntilItFalls) {
  const auto fails = [](const std::string& statement, const std::string& why) {
    Story story;
    story.goal("marvin", 701, statement, "received", 1)
        .goal("marvin", 701, statement, "failed", 3000, why);
    return story.broken("feasible");
  };

  EXPECT_THAT(fails("wait-for-orders", "energy short; goal 701 waits no longer"), IsEmpty());
  EXPECT_THAT(fails("wait-for-orders", "no"), SizeIs(1));
  EXPECT_THAT(fails("general-wait 60", "energy short; goal 701 waits no longer"), SizeIs(1));
}

TEST(Feasible, APartnerWhoseOwnGoalFailedIsNotWaitedForUntilItFalls) {
  const auto broken = [](const std::string& partner) {
    const std::string statement = "synchro 500 (heliv marvin) (heliv marvin)";
    Story story;
    story.goal("marvin", 701, statement, "received", 1)
        .goal("marvin", 702, "perceive P1 60", "received", 1);
    story.goal("heliv", 701, statement + " [end-before 20]", "received", 1);
    story.goal("heliv", 701, statement + " [end-before 20]", partner, 2, "it must end before 20");
    story.goal("marvin", 701, statement, "failed", 3000, "energy short; goal 701 waits no longer");
    story.goal("marvin", 702, "perceive P1 60", "failed", 3000, "needs 9 % of the energy");
    return story.broken("feasible");
  };

  EXPECT_THAT(broken("failed"), IsEmpty());
  EXPECT_THAT(broken("achieved"), SizeIs(2));
}

// Marvin waits for Heliv, which waits for Karma, which does not come.
TEST(Feasible, APartnerWhoWaitsInVainItselfIsNotWaitedForUntilItFalls) {
  const auto broken = [](const std::string& of_karma) {
    Story story;
    story.goal("marvin", 701, "synchro 501 (heliv) (heliv marvin)", "received", 1)
        .goal("marvin", 702, "perceive P1 60", "received", 1)
        .goal("heliv", 801, "synchro 500 (heliv karma) (heliv karma)", "received", 1)
        .goal("heliv", 802, "synchro 501 (heliv) (heliv marvin)", "received", 1)
        .goal("karma", 901, "synchro 500 (heliv karma) (heliv karma) [end-before 20]", "received",
              1);
    story.goal("karma", 901, "synchro 500 (heliv karma) (heliv karma) [end-before 20]", of_karma, 2,
               "it must end before 20");
    story.goal("heliv", 801, "synchro 500 (heliv karma) (heliv karma)", "under-way", 10);
    story.goal("marvin", 701, "synchro 501 (heliv) (heliv marvin)", "under-way", 10);
    story.goal("marvin", 702, "perceive P1 60", "failed", 3000, "needs 9 % of the energy");
    return story.broken("feasible");
  };

  EXPECT_THAT(broken("failed"), IsEmpty());
  EXPECT_THAT(broken("achieved"), SizeIs(1));
}

// Random mission --sharing 328.
TEST(Feasible, AJointTaskOfWhichAMemberWasNotAskedFails) {
  const auto broken = [](const std::string& theirs) {
    const std::string statement = "cooperative-mapping field C1 H 542 (heliv marvin)";
    Story story;
    story.goal("marvin", 701, statement, "received", 1).goal("heliv", 801, theirs, "received", 1);
    story.goal("marvin", 701, statement, "failed", 900,
               "half the time is over without an offer of heliv");
    return story.broken("feasible");
  };

  EXPECT_THAT(broken("cooperative-mapping other C2 H 542 (heliv marvin)"), IsEmpty());
  EXPECT_THAT(broken("cooperative-mapping field C1 H 542 (heliv marvin)"), SizeIs(1));
}

TEST(Feasible, APartnerWhoWasNotAskedIsNotWaitedForUntilItFalls) {
  const auto broken = [](const std::string& theirs) {
    Story story;
    story.goal("marvin", 701, "wait-until-synchro 500 (heliv marvin) (heliv marvin)", "received", 1)
        .goal("heliv", 801, theirs, "received", 1);
    story.goal("marvin", 701, "wait-until-synchro 500 (heliv marvin) (heliv marvin)", "failed",
               3000, "energy short; goal 701 waits no longer");
    return story.broken("feasible");
  };

  EXPECT_THAT(broken("perceive P1 60"), IsEmpty());
  EXPECT_THAT(broken("wait-until-synchro 500 (heliv marvin) (heliv marvin)"), SizeIs(1));
}

}  // namespace
}  // namespace skein::laws::testing
