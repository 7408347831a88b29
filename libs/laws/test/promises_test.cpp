// SPDX-License-Identifier: Apache-2.0
// Times that were asked for: each bound, on both sides of it, and what counts as telling.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Of one goal with this bound: its goto from `begin` to `end`, and what was said of it.
struct Flight {
  std::string bound;
  double begin, end;
  std::string said = "";
  int goal = 701;
  std::string became = "ended";
};

std::vector<std::string> judged(const Flight& it) {
  Story story;
  const std::string statement = "general-gotoxyz A1 [" + it.bound + "]";
  story.goal("marvin", it.goal, statement, "received", 1);
  story.does("marvin", {100, "goto", it.goal, it.begin, it.end, it.became});
  if (!it.said.empty()) story.says("marvin", it.end, it.said);
  story.goal("marvin", it.goal, statement, "achieved", it.end);
  return story.broken("times");
}

struct Bounded {
  Flight flight;
  const char* told;  ///< empty: it is kept
};

TEST(TimesLaw, EachBoundIsKeptOnItsSideAndWithinAMoment) {
  const std::vector<Bounded> all = {
      {{"start-after 50", 50, 80}, ""},
      {{"start-after 50", 49.5, 80}, ""},
      {{"start-after 50", 48, 80}, "goto 100 began at 48.0 s, not after 50.0"},
      {{"start-before 50", 50.5, 80}, ""},
      {{"start-before 50", 52, 80}, "goto 100 began at 52.0 s, not before 50.0"},
      {{"end-after 70", 20, 69.5}, ""},
      {{"end-after 70", 20, 60}, "goto 100 ended at 60.0 s, not after 70.0"},
      {{"end-before 70", 20, 70.5}, ""},
      {{"end-before 70", 20, 75}, "goto 100 ended at 75.0 s, not before 70.0"},
  };
  for (const Bounded& one : all) {
    const auto broken = judged(one.flight);
    if (*one.told == '\0') {
      EXPECT_THAT(broken, IsEmpty()) << one.flight.bound;
    } else {
      EXPECT_THAT(broken, ElementsAre(HasSubstr(one.told))) << one.flight.bound;
    }
  }
}

TEST(TimesLaw, TheEndOfWhatWasAbortedIsNotItsEnd) {
  EXPECT_THAT(judged({"end-before 70", 20, 90, "", 701, "aborted"}), IsEmpty());
  EXPECT_THAT(judged({"start-before 10", 20, 90, "", 701, "aborted"}), SizeIs(1));
}

TEST(TimesLaw, AWordOfTheGoalIsEnoughInEachOfItsForms) {
  for (const std::string said :
       {"goal 701 ended late", "goal 701 will begin early", "the deadline of goal 701 passes",
        "goal 701 cannot end before 70 s", "late: goals 700, 701, 702"})
    EXPECT_THAT(judged({"end-before 70", 20, 75, said}), IsEmpty()) << said;
}

TEST(TimesLaw, AWordOfSomethingElseIsNone) {
  for (const std::string said : {"goal 701 goes on", "goal 702 ended late", "it is late"})
    EXPECT_THAT(judged({"end-before 70", 20, 75, said}), SizeIs(1)) << said;
}

TEST(TimesLaw, AWordOfAGoalWhoseNumberHoldsThatOfThisOneIsNone) {
  EXPECT_THAT(judged({"end-before 70", 20, 75, "goal 701 ended late", 70}), SizeIs(1));
  EXPECT_THAT(judged({"end-before 70", 20, 75, "goal 170 ended late", 70}), SizeIs(1));
  EXPECT_THAT(judged({"end-before 70", 20, 75, "goal 70 ended late", 70}), IsEmpty());
  EXPECT_THAT(judged({"end-before 70", 20, 75, "goal 701 ended late, and so did 70", 70}),
              IsEmpty());
}

// ---- bounds that count from another goal, against plain arithmetic ----

std::vector<std::string> judged_after(const std::string& bound, double origin, double begin) {
  Story story;
  const std::string first = "general-gotoxyz A2";
  const std::string statement = "general-gotoxyz A1 [start-after-goal 700 " + bound + "]";
  story.goal("marvin", 700, first, "received", 1).goal("marvin", 700, first, "achieved", origin);
  story.goal("marvin", 701, statement, "received", 1);
  story.does("marvin", {100, "goto", 701, begin, begin + 20});
  story.goal("marvin", 701, statement, "achieved", begin + 20);
  return story.broken("times");
}

TEST(TimesLaw, ABoundAfterAGoalIsAnIntervalWithAMomentAtEachEnd) {
  for (const double origin : {10.0, 50.0}) {
    for (int after = 30; after <= 70; after += 2) {
      const bool kept = after >= 39 && after <= 61;
      EXPECT_THAT(judged_after("40 to 60", origin, origin + after), SizeIs(kept ? 0 : 1))
          << after << " s after " << origin;
    }
  }
}

TEST(TimesLaw, ABoundWithoutAnEndIsKeptForEver) {
  EXPECT_THAT(judged_after("40 or more", 50, 1500), IsEmpty());
  EXPECT_THAT(judged_after("40 or more", 50, 60),
              ElementsAre(HasSubstr("began 10.0 s after goal 700, not 40.0 s or more")));
}

// ---- reasons that cannot be true ----

struct Reason {
  std::string why;
  const char* untrue;  ///< empty: it may be true
};

TEST(ReasonsLaw, EachKindOfReasonIsHeldAgainstWhatHappened) {
  const std::vector<Reason> all = {
      {"no method for perceive", ""},
      {"", "it gives no reason"},
      {"task 1 must start while 2 runs", "tasks of its own plan contradict each other"},
      {"no grid of less than half a cell", "nobody can set that cell"},
      {"it must end before 50 s", "nothing asked of it has a time"},
      {"it must start before 50 s", "nothing asked of it has a time"},
      {"not 20 s after the end of goal 4", "nothing asked of it has a time"},
      {"it must end before 50 s, which 'nobody' needs", "nothing asked of it has a time"},
      {"it must end before task 7, which runs", ""},
      {"the way leads through closed air", "no air is closed"},
      {"device 'visible' has failed", "no device failed"},
      {"the engine has failed", ""},
  };
  for (const Reason& one : all) {
    Story story;
    story.goal("marvin", 701, "perceive P1 60", "received", 1)
        .goal("marvin", 701, "perceive P1 60", "failed", 2, one.why);
    const auto broken = story.broken("reasons");
    if (*one.untrue == '\0') {
      EXPECT_THAT(broken, IsEmpty()) << one.why;
    } else {
      EXPECT_THAT(broken, ElementsAre(HasSubstr(one.untrue))) << one.why;
    }
  }
}

TEST(ReasonsLaw, OneReasonOfAMissionIsToldOnce) {
  Story story;
  for (const int goal : {701, 702, 703})
    story.goal("marvin", goal, "perceive P1 60", "received", 1)
        .goal("marvin", goal, "perceive P1 60", "failed", 2, "device 'ir' has failed");
  story.goal("marvin", 704, "perceive P1 60", "received", 1)
      .goal("marvin", 704, "perceive P1 60", "failed", 3, "device 'ir' has failed");

  EXPECT_THAT(story.broken("reasons"), SizeIs(2)) << "one for each instant";
}

TEST(ReasonsLaw, ADeviceThatFailsLaterIsNoReason) {
  const auto fails_at = [](double fault) {
    Story story;
    story.fault(fault, "sensor", "marvin");
    story.goal("marvin", 701, "perceive P1 60", "received", 1)
        .goal("marvin", 701, "perceive P1 60", "failed", 20, "device 'visible' has failed");
    return story.broken("reasons");
  };
  EXPECT_THAT(fails_at(10), IsEmpty());
  EXPECT_THAT(fails_at(30), ElementsAre(HasSubstr("no device failed")));
}

TEST(ReasonsLaw, WhatTheOperatorsGoalIsAchievedOrCancelledForNeedsNoReason) {
  for (const std::string state : {"achieved", "cancelled", "under-way"}) {
    Story story;
    story.goal("marvin", 701, "perceive P1 60", "received", 1)
        .goal("marvin", 701, "perceive P1 60", state, 2);
    EXPECT_THAT(story.broken("reasons"), IsEmpty()) << state;
  }
}

// ---- one motion, and none under what holds the vehicle: who overlaps whom, by every order ----

TEST(OneMotionLaw, TwoMotionsOverlapIfAndOnlyIfTheirIntervalsDo) {
  for (double first = 0; first <= 60; first += 10) {
    for (double second = 0; second <= 60; second += 10) {
      if (first == second) continue;
      Story story;
      story.does("marvin", {101, "goto", 701, 10 + first, 35 + first});
      story.does("marvin", {102, "goto", 702, 10 + second, 35 + second});
      const bool overlap = std::abs(first - second) < 25;
      EXPECT_THAT(story.broken("one-motion"), SizeIs(overlap ? 1 : 0))
          << first << " and " << second;
    }
  }
}

TEST(OneMotionLaw, MotionsOfTwoUavsNeverOverlap) {
  Story story;
  story.does("marvin", {101, "goto", 701, 10, 50}).does("heliv", {102, "goto", 702, 10, 50});

  EXPECT_THAT(story.broken("one-motion"), IsEmpty());
}

TEST(OneMotionLaw, WhatTheVehicleRefusesForWhatItDoesIsToldWithItsReason) {
  for (const std::string why : {"task 7 is still active", "camera is in use by task 7"}) {
    Story story;
    story.does("marvin", {101, "goto", 701, 10, 10, "aborted", "", {}, why});
    EXPECT_THAT(story.broken("one-motion"),
                ElementsAre(HasSubstr("goto 101 of goal 701 was asked for and refused: " + why)));
  }
  Story other;
  other.does("marvin", {101, "goto", 701, 10, 10, "aborted", "", {}, "no way there"});
  EXPECT_THAT(other.broken("one-motion"), IsEmpty());
}

// ---- idle-told ----

/// At degree 3 in the air, from 10 s on with nothing under way.
Story hangs_in_the_air() {
  Story story;
  story.flies("marvin", 0, 200, {0, 0, 40}, {0, 0, 40}).degree("marvin", 0, 3);
  story.does("marvin", {3, "goto", 0, 0, 10});
  return story;
}

TEST(IdleTold, WhoHangsInTheAirInAnOperatorsHandSaysSo) {
  EXPECT_THAT(hangs_in_the_air().broken("idle-told"),
              ElementsAre(HasSubstr("in the air at degree 3 with nothing under way for 75.0 s")));
  Story told = hangs_in_the_air();
  told.says("marvin", 71, "in the air with nothing under way for 60.0 s, at degree 3: …");
  EXPECT_THAT(told.broken("idle-told"), IsEmpty());
}

TEST(IdleTold, ATaskThatIsUnderWayIsEnough) {
  Story story = hangs_in_the_air();
  story.does("marvin", {4, "wait", 0, 60, 150});

  EXPECT_THAT(story.broken("idle-told"), IsEmpty());
}

// Found by a test of restarts (comets/confirmed): it was 26 s in the air when its node died.
TEST(IdleTold, WhoseNodeIsDownMeanwhileSaysItLater) {
  const auto down_until = [](double until) {
    return hangs_in_the_air()
        .fault(50, "kill", "marvin")
        .fault(until, "resume", "marvin")
        .broken("idle-told");
  };

  EXPECT_THAT(down_until(110), ElementsAre(HasSubstr("in the air at degree 3")));
  EXPECT_THAT(down_until(140), IsEmpty());
}

// Found by random missions (--hands --deaths 1008001).
TEST(IdleTold, WhoHasSaidItBeforeItsNodeWasAwayNeedNotSayItAgain) {
  Story story = hangs_in_the_air();
  story.fault(100, "kill", "marvin").fault(108, "resume", "marvin");
  EXPECT_THAT(story.broken("idle-told"), SizeIs(2));

  story.says("marvin", 71, "in the air with nothing under way for 60.0 s, at degree 3: …");
  EXPECT_THAT(story.broken("idle-told"), IsEmpty());
}

// Found by random missions (--hands 1011011): a look took 0.1 s, which its UAV may not notice.
TEST(IdleTold, WhoHasSaidItBeforeAShortLookNeedNotSayItAgain) {
  const auto looks_for = [](double seconds) {
    Story story = hangs_in_the_air();
    story.says("marvin", 71, "in the air with nothing under way for 60.0 s, at degree 3: …");
    story.does("marvin", {4, "takeshot", 0, 99.5, 99.5 + seconds});
    return story.broken("idle-told");
  };

  EXPECT_THAT(looks_for(0.6), IsEmpty());
  EXPECT_THAT(looks_for(3), SizeIs(1)) << "it hangs there for 100 s after it";
}

// Found by random missions (--hands 990035): at degree 1 a UAV does not know of it.
TEST(IdleTold, ARendezvousThatTheGroundKeepsForItIsNoTaskOfItsOwn) {
  Story story = hangs_in_the_air();
  story.degree("marvin", 12, 1).does("marvin", {4, "rendezvous", 0, 60, 100});
  story.says("marvin", 70, "in the air with nothing under way for 60.0 s, at degree 1: …");

  EXPECT_THAT(story.broken("idle-told"), IsEmpty());
}

// Found by random missions (--hands --merged --rough --deaths 1008020): the ground station did not
// hear of the end, gave the flight up after minutes, and only that was taken for the end.
TEST(IdleTold, WhatTheGroundDoesNotKnowToBeOverIsOver) {
  Story story = hangs_in_the_air().degree("marvin", 0.5, 1);
  story.starts_unheard("marvin", 100, 3, "goto", "aborted");
  EXPECT_THAT(story.broken("idle-told"), SizeIs(1));

  story.says("marvin", 71, "in the air with nothing under way for 60.0 s, at degree 1: …");
  EXPECT_THAT(story.broken("idle-told"), IsEmpty());
}

TEST(IdleTold, AtDegreeFourOtherLawsAskForMore) {
  EXPECT_THAT(hangs_in_the_air().degree("marvin", 20, 4).broken("idle-told"), IsEmpty());
}

}  // namespace
}  // namespace skein::laws::testing
