// SPDX-License-Identifier: Apache-2.0
// Nobody waits for a silent partner beyond its lease; who is given up was silent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/mission.hpp"
#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kMeeting = "synchro 500 (marvin heliv) (marvin heliv)";

/// Marvin waits for Heliv from 100 s on, who dies at 50 s; the lease is 600 s.
Story waits(double until, const std::string& reason = "", const std::string& end = "aborted") {
  Story story;
  story.goal("marvin", 7, kMeeting, "under-way", 100);
  story.does("marvin", {1, "synchronise", 7, 100, until, end, "", {}, reason});
  return story.stands("marvin", 0, 2000).stands("heliv", 0, 50);
}

Story waits_for_dead(double until) {
  Story story = waits(until);
  return story.fault(50, "kill", "heliv");
}

TEST(AwaitedLaw, WhoWaitsForADeadPartnerBeyondItsLeaseBreaksIt) {
  EXPECT_THAT(waits_for_dead(900).broken("awaited"),
              ElementsAre(HasSubstr("for 'heliv', which is silent since 50.0 s, and was to wait "
                                    "until 700.0 s")));
  EXPECT_THAT(waits_for_dead(720).broken("awaited"), IsEmpty());
}

TEST(AwaitedLaw, OneThatIsCutOffIsSilentToo) {
  const auto told = [](double healed) {
    Story story = waits(900);
    story.goal("heliv", 8, kMeeting, "under-way", 20);
    for (const char* to : {"heliv", "marvin"}) {
      const std::string from = std::string(to) == "heliv" ? "marvin" : "heliv";
      story.link(150, from, to, false).link(healed, from, to, true);
    }
    return story;
  };

  EXPECT_EQ(told(950).broken("awaited").size(), 1U);
  EXPECT_THAT(told(800).broken("awaited"), IsEmpty());
}

// Found by random missions (--anything --busy 30): its operator had it in hand, at degree 1.
TEST(AwaitedLaw, WhoseWordsTheGroundStationSaysIsSilentOnceThatIsToo) {
  const auto told = [](int degree) { return waits_for_dead(900).degree("heliv", 20, degree); };
  EXPECT_THAT(told(2).broken("awaited"), IsEmpty());
  EXPECT_EQ(told(3).broken("awaited").size(), 1U);
  Story cut = told(2);
  cut.link(150, "ground", "marvin", false).link(150, "marvin", "ground", false);
  EXPECT_EQ(cut.broken("awaited").size(), 1U);
}

// Found by random missions (--meetings 28).
TEST(AwaitedLaw, WhoOnlyReceivesIsNotAwaited) {
  Story story;
  story.goal("marvin", 7, "synchro 500 (karma) (marvin heliv)", "under-way", 100);
  story.goal("karma", 9, "synchro 500 (karma) (marvin heliv)", "under-way", 20);
  story.does("marvin", {1, "synchronise", 7, 100, 1900, "aborted"}).stands("marvin", 0, 2000);
  EXPECT_THAT(story.fault(50, "kill", "heliv").broken("awaited"), IsEmpty());
}

TEST(AwaitedLaw, OneThatIsHeardOrCameMayBeWaitedForForLong) {
  const auto comes = [] { return waits(1900).goal("heliv", 8, kMeeting, "under-way", 20); };
  EXPECT_THAT(comes().broken("awaited"), IsEmpty());
  Story came = waits(1900, "", "ended");
  EXPECT_THAT(came.fault(50, "kill", "heliv").broken("awaited"), IsEmpty());
}

TEST(AwaitedLaw, OneThatIsHeardAndDoesNotPlanToComeIsWaitedForForALease) {
  const auto told = [](double until, double failed) {
    return waits(until).goal("heliv", 8, kMeeting, "failed", failed, "energy");
  };

  EXPECT_THAT(told(900, 150).broken("awaited"),
              ElementsAre(HasSubstr("'heliv', which does not plan to come since 150.0 s, and was "
                                    "to wait until 750.0 s")));
  EXPECT_THAT(told(900, 300).broken("awaited"), IsEmpty());
  EXPECT_EQ(waits(900).broken("awaited").size(), 1U);
}

TEST(AwaitedLaw, AnAttemptThatFollowsAnotherGoesOnWaiting) {
  const auto told = [](double again) {
    Story story = waits(720);
    story.does("marvin", {2, "synchronise", 7, again, again + 100, "aborted"});
    return story.fault(50, "kill", "heliv");
  };
  EXPECT_EQ(told(721).broken("awaited").size(), 1U);
  EXPECT_THAT(told(900).broken("awaited"), IsEmpty());
}

// Found by random missions (--partners 800052).
TEST(AwaitedLaw, AJointTaskThatRanDidNotWait) {
  const auto tries = [](const std::string& became) {
    const std::string type = "joint:monitoring-with-relay";
    Story story;
    story.goal("marvin", 7, kMeeting, "under-way", 100);
    story.does("marvin", {1, type, 7, 100, 720, "aborted"});
    story.does("marvin", {2, type, 7, 721, 821, "aborted"});
    story.line(journal::record_of(
        MissionTime::seconds(101), "marvin",
        journal::lines::Task{.uav = "marvin", .task = 1, .type = type, .state = became}));
    return story.stands("marvin", 0, 2000).fault(50, "kill", "heliv").broken("awaited");
  };
  EXPECT_EQ(tries("started").size(), 1U);
  EXPECT_THAT(tries("running"), IsEmpty());
}

TEST(AwaitedLaw, OneThatIsDeclaredLostIsWaitedForNoLonger) {
  const auto told = [](double until) {
    Story story = waits_for_dead(until);
    journal::lines::LostUav lost;
    lost.uav = "heliv";
    return story.line(journal::record_of(MissionTime::seconds(200), "ground", lost));
  };

  EXPECT_EQ(told(300).broken("awaited").size(), 1U);
  EXPECT_THAT(told(205).broken("awaited"), IsEmpty());
}

/// Marvin's goal fails at 800 s since nobody hears Heliv since then.
Story given_up(const std::string& since) {
  Story story;
  const std::string why = "no contact with 'heliv'" + since;
  return story.goal("marvin", 7, kMeeting, "under-way", 100)
      .goal("marvin", 7, kMeeting, "failed", 800, why)
      .stands("marvin", 0, 2000);
}

TEST(ReasonsLaw, WhoIsGivenUpWasSilentSinceThen) {
  EXPECT_THAT(given_up(" since 52 s").broken("reasons"), ElementsAre(HasSubstr("could be heard")));
  EXPECT_THAT(given_up(" since 52 s").fault(50, "kill", "heliv").broken("reasons"), IsEmpty());
  EXPECT_THAT(given_up(" since 52 s").fault(90, "kill", "heliv").broken("reasons"),
              ElementsAre(HasSubstr("until 90.0 s")));
}

// Found by missions over mountains (--partners --deaths 505): it died behind a ridge, where nobody
// had heard it yet; the link to where it lay came later.
TEST(ReasonsLaw, WhoDiedOutOfReachWasHeardBeforeThat) {
  const auto up_at = [](double up) {
    return given_up(" since 52 s")
        .link(50, "heliv", "marvin", false)
        .link(up, "heliv", "marvin", true)
        .fault(90, "kill", "heliv")
        .broken("reasons");
  };
  EXPECT_THAT(up_at(120), IsEmpty());
  EXPECT_THAT(up_at(60), ElementsAre(HasSubstr("until 90.0 s")));
}

// Found by random missions (--sharing --deaths 131): the link to it was lost while it was dead.
TEST(ReasonsLaw, WhoLivesAgainOutOfReachWasHeardBeforeItDied) {
  const Story dead =
      given_up(" since 52 s").fault(50, "kill", "heliv").fault(600, "resume", "heliv");
  EXPECT_THAT(Story(dead).link(400, "heliv", "marvin", false).broken("reasons"), IsEmpty());
  EXPECT_THAT(Story(dead).link(700, "heliv", "marvin", false).broken("reasons"),
              ElementsAre(HasSubstr("until 700.0 s")));
}

// Found by random missions (--partners --merged 982020): it came back while the plan without it was
// made.
TEST(ReasonsLaw, WhoIsGivenUpMayHaveJustComeBack) {
  const auto back_at = [](double back) {
    return given_up(" since 52 s")
        .link(50, "heliv", "marvin", false)
        .link(back, "heliv", "marvin", true)
        .broken("reasons");
  };
  EXPECT_THAT(back_at(799), IsEmpty());
  EXPECT_THAT(back_at(790), ElementsAre(HasSubstr("could be heard")));
}

// Found by random missions (--anything --minds 983012): the way past a relay was whole for 8 s, on
// a narrow radio.
TEST(ReasonsLaw, WhoIsGivenUpMayHaveBeenInReachForAMomentOnly) {
  const auto whole_for = [](double seconds, bool past_a_relay) {
    Story story = given_up(" since 52 s");
    story.relay("karma").link(0, "heliv", "karma", false).link(50, "heliv", "marvin", false);
    const std::string ear = past_a_relay ? "karma" : "marvin";
    return story.link(300, "heliv", ear, true)
        .link(300 + seconds, "heliv", ear, false)
        .broken("reasons");
  };
  EXPECT_THAT(whole_for(15, true), IsEmpty());
  EXPECT_THAT(whole_for(25, true), ElementsAre(HasSubstr("could be heard until 325.0 s")));
  EXPECT_THAT(whole_for(3, false), IsEmpty());
  EXPECT_THAT(whole_for(15, false), ElementsAre(HasSubstr("could be heard until 315.0 s")));
}

TEST(ReasonsLaw, WhoIsGivenUpWasSilentForAMinuteAtLeast) {
  EXPECT_THAT(given_up(" since 770 s").fault(768, "kill", "heliv").broken("reasons"),
              ElementsAre(HasSubstr("was silent for 30.0 s only")));
}

// Found by random missions (--meetings --gatherings 800015).
TEST(ReasonsLaw, WhatAPartnerSaidOfSilenceIsThePartnersWord) {
  const std::string word = "no contact with 'marvin' since 274 s";
  const auto passed_on = [&](const std::string& said) {
    Story story;
    story.goal("marvin", 7, kMeeting, "under-way", 100)
        .goal("marvin", 7, kMeeting, "failed", 800, "'heliv' takes no part: " + word)
        .stands("marvin", 0, 2000);
    return story.says("heliv", 334, said).stands("heliv", 0, 2000).broken("reasons");
  };
  EXPECT_THAT(passed_on("task 1002 aborted: " + word), IsEmpty());
  EXPECT_THAT(passed_on("task 1002 aborted"), ElementsAre(HasSubstr("'heliv' never said so")));
}

// Found by random missions (12): heliv's mission had a time, marvin's had none.
TEST(ReasonsLaw, WhyAPartnersGoalFailedIsJudgedThere) {
  const std::string word = "gotoxyz of goal 8 must start before 852 s";
  const auto passed_on = [&](const std::string& said) {
    Story story;
    story.goal("marvin", 7, kMeeting, "under-way", 100)
        .goal("marvin", 7, kMeeting, "failed", 800, "'heliv' takes no part: " + said)
        .stands("marvin", 0, 2000);
    story.goal("heliv", 8, std::string(kMeeting) + " [start-before 852]", "received", 90)
        .goal("heliv", 8, std::string(kMeeting) + " [start-before 852]", "failed", 100, word);
    return story.stands("heliv", 0, 2000).broken("reasons");
  };
  EXPECT_THAT(passed_on(word), IsEmpty());
  EXPECT_THAT(passed_on("it must start before 700 s"),
              ElementsAre(HasSubstr("nothing asked of it has a time")));
}

// Found by storms (agreed-places/pursuit 601): it was still on its way out of its role.
TEST(ReasonsLaw, WhyAPartnerLeavesAJointTaskIsItsWord) {
  const std::string word = "no contact with 'marvin' since 274 s";
  Story story;
  story.goal("marvin", 7, kMeeting, "under-way", 100)
      .goal("marvin", 7, kMeeting, "failed", 800, "'heliv' left: " + word)
      .stands("marvin", 0, 2000);
  story.leaves("heliv", 334, word).stands("heliv", 0, 2000);
  EXPECT_THAT(story.broken("reasons"), IsEmpty());
}

TEST(ReasonsLaw, SinceWhenIsSaid) {
  EXPECT_THAT(given_up("").fault(50, "kill", "heliv").broken("reasons"),
              ElementsAre(HasSubstr("it does not say since when")));
}

}  // namespace
}  // namespace skein::laws::testing
