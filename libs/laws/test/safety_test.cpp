// SPDX-License-Identifier: Apache-2.0
// Closed air and energy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using world::Vector3;

const Vector3 kOver{0, 0, 40}, kFar{400, 300, 40};

constexpr const char* kTower =
    "  volumes: {tower: {polygon: [[100, 0], [200, 0], [200, 100], [100, 100]]}}\n";
constexpr const char* kClosing =
    "    - {step: close, when: {time: 50}, do: [{close_air: {name: smoke, polygon: [[100, 0], "
    "[200, 0], [200, 100], [100, 100]]}}]}\n";

TEST(ClosedAir, NobodyFliesIntoIt) {
  Story story(kTower);
  story.flies("marvin", 0, 100, kOver, {300, 60, 40});

  EXPECT_THAT(story.broken("closed-air"), ElementsAre(HasSubstr("into 'tower'")));
}

TEST(ClosedAir, WhoIsCaughtInsideLeavesWithoutDelay) {
  const auto leaves_after = [](double seconds) {
    Story story("", kClosing);
    story.flies("marvin", 0, 50 + seconds, {150, 50, 40}, {150, 50, 40});
    story.flies("marvin", 51 + seconds, 65 + seconds, {150, 50, 40}, {150, 150, 40});
    story.step(50, "close", "marvin");
    return story.broken("closed-air");
  };

  EXPECT_THAT(leaves_after(5), IsEmpty());
  EXPECT_THAT(leaves_after(100), ElementsAre(HasSubstr("stays")));
}

// Found by a storm (contingencies/air-closes-where-it-was-stopped 404).
TEST(ClosedAir, WhoPlansSlowlyComesIntoItWhileItPlansToTurnAway) {
  const auto planned_in = [](double seconds) {
    Story story("", kClosing);
    story.plans_in(seconds).flies("marvin", 0, 64, {-500, 50, 40}, {99, 50, 40});
    story.flies("marvin", 65, 67, {102, 50, 40}, {106, 50, 40});
    story.flies("marvin", 68, 80, {95, 50, 40}, {90, 50, 40}).step(50, "close", "marvin");
    return story.broken("closed-air");
  };

  EXPECT_THAT(planned_in(7), IsEmpty());
  EXPECT_THAT(planned_in(1), ElementsAre(HasSubstr("into 'smoke'")));
}

// Found by a storm (contingencies/air-closes-on-perception 308).
TEST(ClosedAir, WhileAFaultAbortsAllFlightsNobodyLeaves) {
  const auto told = [](const std::string& uav, const std::string& type) {
    Story story("", kClosing);
    story.refuses(40, uav, type, 80).flies("marvin", 0, 140, {150, 50, 40}, {150, 50, 40});
    story.flies("marvin", 141, 155, {150, 50, 40}, {150, 150, 40}).step(50, "close", "marvin");
    return story.broken("closed-air");
  };

  EXPECT_THAT(told("marvin", "goto"), IsEmpty());
  EXPECT_THAT(told("marvin", "perceive"), ElementsAre(HasSubstr("stays")));
  EXPECT_THAT(told("heliv", "goto"), ElementsAre(HasSubstr("stays")));
}

// Found by random missions (--merged 988010): a helicopter that hung at the edge of smoke wavered
// 5 m into it 30 s after it had come.
TEST(ClosedAir, WhatCanBeginNoFlightSinceThenMayWaverIntoIt) {
  const auto wavers_while_refused = [](double seconds) {
    Story story("", kClosing);
    story.refuses(40, "marvin", "goto", seconds);
    story.flies("marvin", 0, 149, {150, 102, 40}, {150, 102, 40});
    story.flies("marvin", 150, 159, {150, 95, 40}, {150, 95, 40});
    story.flies("marvin", 160, 170, {150, 102, 40}, {150, 150, 40}).step(50, "close", "marvin");
    return story.broken("closed-air");
  };

  EXPECT_THAT(wavers_while_refused(120), IsEmpty());
  EXPECT_THAT(wavers_while_refused(60), ElementsAre(HasSubstr("into 'smoke'")));
}

// A blimp that rises out of smoke in circles (--anything --capacity 9600 984025).
TEST(ClosedAir, OnItsWayOutOneMayComeThroughItAgain) {
  const auto comes_again = [](double at) {
    Story story("", kClosing);
    story.flies("marvin", 0, 60, {150, 95, 40}, {150, 95, 40});
    story.flies("marvin", 61, at - 1, {150, 104, 40}, {150, 104, 40});
    story.flies("marvin", at, at + 4, {150, 95, 40}, {150, 95, 40});
    story.flies("marvin", at + 5, at + 15, {150, 104, 40}, {150, 150, 40});
    return story.step(50, "close", "marvin").broken("closed-air");
  };

  EXPECT_THAT(comes_again(68), IsEmpty());
  EXPECT_THAT(comes_again(120), ElementsAre(HasSubstr("into 'smoke'")));
}

// Found by random missions (--anything --capacity 9600 984025): a blimp that climbed beside smoke
// circled into it while its question for air was on its way.
TEST(ClosedAir, OverANarrowRadioItTakesThreeWordsMoreToTurnAway) {
  const auto comes_into_it = [](double after, double capacity, bool asks) {
    Story story("", kClosing + std::string(asks ? "separation: {}\n" : ""));
    story.capacity(capacity).flies("marvin", 0, 49 + after, {-500, 50, 40}, {99, 50, 40});
    story.flies("marvin", 50 + after, 52 + after, {102, 50, 40}, {106, 50, 40});
    story.flies("marvin", 53 + after, 80, {95, 50, 40}, {90, 50, 40}).step(50, "close", "marvin");
    return story.broken("closed-air");
  };

  EXPECT_THAT(comes_into_it(13, 9'600, true), IsEmpty());  // 2.25 s
  EXPECT_THAT(comes_into_it(15, 9'600, true), ElementsAre(HasSubstr("into 'smoke'")));
  EXPECT_THAT(comes_into_it(13, 57'600, true), ElementsAre(HasSubstr("into 'smoke'")));
  EXPECT_THAT(comes_into_it(13, 9'600, false), ElementsAre(HasSubstr("into 'smoke'")));
}

// Found by random missions (--anything 1010018): a blimp at less than half its speed.
TEST(ClosedAir, WhatAFaultSlowsIsBlownFurtherWhileItTurns) {
  const auto turns_into_it = [](const std::string& uav, double at, double depth) {
    Story story(std::string(kTower) + "  wind: {toward: 0, speed: 3}\n",
                std::string(kClosing) +
                    "faults:\n  - {at: 10, slow: {uav: karma, factor: 2, for: 40}}\n"
                    "  - {at: 10, slow: {uav: heliv, factor: 2, for: 40}}\n");
    story.flies(uav, 0, at - 1, {50, 50, 40}, {99, 50, 40});
    story.flies(uav, at, at + 3, {100 + depth, 50, 40}, {100 + depth, 50, 40});
    story.flies(uav, at + 4, 200, {99, 50, 40}, {50, 50, 40});
    return story.broken("closed-air");
  };

  // Half a turn of 25 m at 8 m/s takes 9.8 s, and 9.8 s longer: 29 m of wind.
  EXPECT_THAT(turns_into_it("karma", 60, 25), IsEmpty());
  EXPECT_THAT(turns_into_it("karma", 60, 45), ElementsAre(HasSubstr("into 'tower'")));
  EXPECT_THAT(turns_into_it("karma", 100, 25), ElementsAre(HasSubstr("into 'tower'")));
  EXPECT_THAT(turns_into_it("heliv", 60, 25), ElementsAre(HasSubstr("into 'tower'")));
}

// Found by random missions (--anything 15): a robot whose home is closed drove out of it.
TEST(ClosedAir, WhoStoodInItAtFirstMayLeaveButNotStay) {
  const auto leaves_after = [](double seconds) {
    Story story(kTower);
    story.stands("marvin", 0, 30, {150, 50, 0});
    story.flies("marvin", 31, 30 + seconds, {150, 50, 40}, {150, 50, 40});
    story.flies("marvin", 31 + seconds, 45 + seconds, {150, 50, 40}, {150, 150, 40});
    return story.broken("closed-air");
  };

  EXPECT_THAT(leaves_after(5), IsEmpty());
  EXPECT_THAT(leaves_after(100), ElementsAre(HasSubstr("stays")));
}

// Found by random missions (--anything 984039): its operator had flown it there.
TEST(ClosedAir, WhoIsGivenDegreeFourInItMayLeaveButNotStay) {
  const auto leaves_after = [](double seconds) {
    Story story(kTower);
    story.degree("marvin", 0, 3).degree("marvin", 30, 4);
    story.flies("marvin", 0, 30 + seconds, {150, 50, 40}, {150, 50, 40});
    story.flies("marvin", 31 + seconds, 45 + seconds, {150, 50, 40}, {150, 150, 40});
    return story.broken("closed-air");
  };

  EXPECT_THAT(leaves_after(5), IsEmpty());
  EXPECT_THAT(leaves_after(100), ElementsAre(HasSubstr("stays")));
}

TEST(ClosedAir, AirThatIsOpenedAndClosedAgainWasOpenInBetween) {
  const std::string opens =
      "    - {step: open, when: {time: 60}, do: [{open_air: {name: smoke}}]}\n";
  const std::string again =
      "    - {step: again, when: {time: 200}, do: [{close_air: {name: smoke, polygon: [[100, 0], "
      "[200, 0], [200, 100], [100, 100]]}}]}\n"
      "    - {step: reopen, when: {time: 250}, do: [{open_air: {name: smoke}}]}\n";
  Story story("", kClosing + opens + again);
  story.flies("marvin", 0, 70, {150, 150, 40}, {150, 150, 40});
  story.flies("marvin", 71, 120, {150, 150, 40}, {150, 50, 40});
  story.step(50, "close", "marvin").step(60, "open", "marvin");
  story.step(200, "again", "marvin").step(250, "reopen", "marvin");

  EXPECT_THAT(story.broken("closed-air"), IsEmpty());
}

// Found by an outsider's missions: what people did was not looked at.
TEST(ClosedAir, WhatAnOperatorClosesIsClosedAndWhatOneOpensIsOpen) {
  const auto flown = [](bool closed_by_operator, bool opened) {
    const std::string by_script = kClosing;
    const std::string operators =
        std::string("  operator:\n") +
        "    - {does: shut, when: {time: 50}, do: [{close_air: {name: smoke, polygon: [[100, 0], "
        "[200, 0], [200, 100], [100, 100]]}}]}\n"
        "    - {does: open, when: {time: 60}, do: [{open_air: {name: smoke}}]}\n";
    Story story("", by_script + operators);
    story.flies("marvin", 0, 70, {150, 150, 40}, {150, 150, 40});
    story.flies("marvin", 71, 120, {150, 150, 40}, {150, 50, 40});
    if (closed_by_operator) story.step(50, "shut", "marvin", true);
    if (!closed_by_operator) story.step(50, "close", "marvin");
    if (opened) story.step(60, "open", "marvin", true);
    return story.broken("closed-air");
  };

  EXPECT_THAT(flown(true, false), ElementsAre(HasSubstr("into 'smoke'")));
  EXPECT_THAT(flown(true, true), IsEmpty());
  EXPECT_THAT(flown(false, true), IsEmpty());
}

// An operator has it in hand, who has to know.
TEST(ClosedAir, BelowDegreeFourItIsEnoughThatTheUavSaysSo) {
  const auto told = [](std::optional<double> when) {
    Story story("", kClosing);
    story.degree("marvin", 0, 3).flies("marvin", 0, 150, {150, 50, 40}, {150, 50, 40});
    story.step(50, "close", "marvin");
    story.says("marvin", 50, "0 user request: volume 'smoke' closed: smoke: accepted");
    if (when)
      story.says("marvin", *when, "it is in air that is closed or about to be (volume 'smoke')");
    EXPECT_THAT(story.broken("closed-air"), IsEmpty());
    return story.broken("closed-air-told");
  };

  EXPECT_THAT(told(55), IsEmpty());
  EXPECT_THAT(told(75), ElementsAre(HasSubstr("in 'smoke', closed since 50")));
  EXPECT_THAT(told(std::nullopt), ElementsAre(HasSubstr("says nothing")));
}

TEST(Energy, NeverBelowTheReserveInTheAir) {
  Story kept, drained;
  kept.flies("marvin", 0, 50, kOver, kOver, 0.2);
  for (int i = 0; i < 20; ++i) drained.flies("marvin", i, i, kOver, kOver, 0.165 - 0.005 * i);

  EXPECT_THAT(kept.broken("energy"), IsEmpty());
  EXPECT_THAT(drained.broken("energy"), ElementsAre(HasSubstr("reserve 8.0 %")));
}

TEST(Energy, WhatNobodyCouldHaveKeptIsNoBreach) {
  Story lost;
  lost.flies("marvin", 0, 50, kFar, kFar, 0.5).flies("marvin", 51, 60, kFar, kFar, 0.03);

  EXPECT_THAT(lost.broken("energy"), IsEmpty());
}

// Somebody else has it in hand, who has to know.
TEST(Energy, BelowDegreeFourItIsEnoughThatTheUavSaysSo) {
  const auto fallen = [](bool said) {
    Story story;
    story.degree("marvin", 0, 3).flies("marvin", 0, 50, kFar, kFar, 0.01);
    if (said) story.says("marvin", 20, "its energy lasts no longer than to come home");
    story.does("marvin", {1, "goto", 0, 5, 50, "aborted", "", {}, "energy used up"});
    return story.broken("energy");
  };

  EXPECT_THAT(fallen(true), IsEmpty());
  EXPECT_THAT(fallen(false), ElementsAre(HasSubstr("falls")));
}

TEST(Energy, WhoeverRefusesToLandAsLongAsThereIsEnergyIsNotBroughtDown) {
  const auto drained = [](double refused) {
    Story story;
    for (int i = 0; i < 20; ++i) story.flies("marvin", i, i, kOver, kOver, 0.165 - 0.005 * i);
    story.does(
        "marvin",
        {1, "land", 0, refused, refused, "aborted", "", {}, "aborted by the functional layer"});
    return story.broken("energy");
  };

  EXPECT_THAT(drained(10), IsEmpty());
  EXPECT_THAT(drained(18.5), ElementsAre(HasSubstr("reserve 8.0 %"))) << "told too late";
}

/// A flight that ends so after ten seconds.
Story meets_the_ground(const std::string& reason, int degree) {
  Story story;
  Doing flight{100, "goto", 700, 10, 20};
  flight.end = "aborted";
  flight.reason = reason;
  story.degree("marvin", 0, degree).flies("marvin", 0, 20, kOver, kFar).does("marvin", flight);
  return story;
}

TEST(AboveGround, WhoPlansFliesIntoNoGround) {
  EXPECT_THAT(meets_the_ground("the vehicle met the ground", 4).broken("above-ground"),
              ElementsAre(HasSubstr("goto 100 led it into the ground")));
  EXPECT_THAT(meets_the_ground("no way there", 4).broken("above-ground"), IsEmpty());
}

TEST(AboveGround, WhatAnOperatorFliesOrAnEngineFailsIsNotJudged) {
  Story failed = meets_the_ground("the vehicle met the ground", 4);
  failed.fault(15, "engine", "marvin");

  EXPECT_THAT(failed.broken("above-ground"), IsEmpty());
  EXPECT_THAT(meets_the_ground("the vehicle met the ground", 2).broken("above-ground"), IsEmpty());
}

}  // namespace
}  // namespace skein::laws::testing
