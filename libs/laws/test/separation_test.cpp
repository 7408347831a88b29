// SPDX-License-Identifier: Apache-2.0
// UAVs in the air keep the separation of their models, where the scenario asks for it. Marvin and
// Heliv: 1.6 and 6.8 m level, 2.3 and 4.9 m in height.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/execution.hpp"
#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using world::Vector3;

Story asked() {
  return Story("", "    - {step: end, when: {time: 1999}, do: [{finish: true}]}\nseparation: {}\n");
}

TEST(SeparationLaw, WaysThatCrossAtOneInstantBreakItBetweenSamplesToo) {
  Story story = asked();
  story.flies("marvin", 0, 9, {0, 50, 40}, {126, 50, 40});
  story.flies("heliv", 0, 9, {63, -13, 40}, {63, 113, 40});

  EXPECT_THAT(story.broken("separation"),
              ElementsAre(HasSubstr("0.0 m level and 0.0 m in height")));
}

TEST(SeparationLaw, OneAfterTheOtherIsFine) {
  Story story = asked();
  story.flies("marvin", 0, 9, {0, 50, 40}, {126, 50, 40});
  story.flies("heliv", 6, 15, {63, -13, 40}, {63, 113, 40});

  EXPECT_THAT(story.broken("separation"), IsEmpty());
}

TEST(SeparationLaw, OneOverTheOtherIsFine) {
  Story story = asked();
  story.stands("marvin", 0, 20, {50, 50, 40}).stands("heliv", 0, 20, {50, 50, 47.5});

  EXPECT_THAT(story.broken("separation"), IsEmpty());
}

TEST(SeparationLaw, OnTheGroundNobodyIsTooNear) {
  Story story = asked();
  story.stands("marvin", 0, 20, {50, 50, 0}).stands("heliv", 0, 20, {50, 52, 3});

  EXPECT_THAT(story.broken("separation"), IsEmpty());
}

TEST(SeparationLaw, WhoFallsIsExcused) {
  Story story = asked();
  story.stands("marvin", 0, 20, {50, 50, 40}).stands("heliv", 0, 20, {50, 52, 42});
  story.fault(0, "engine", "heliv");

  EXPECT_THAT(story.broken("separation"), IsEmpty());
}

TEST(BeginsLaw, AMotionThatWaitsForItsAirForEverBreaksIt) {
  Story story = asked();
  story.does("marvin", {7, "goto", 0, 10, 1200, "ended", "", {}, "", 1000});

  EXPECT_THAT(story.broken("begins"), ElementsAre(HasSubstr("does not begin for 990.0 s")));
}

TEST(BeginsLaw, OneThatWaitsForAWhileDoesNot) {
  Story story = asked();
  story.does("marvin", {7, "goto", 0, 10, 1200, "ended", "", {}, "", 300});

  EXPECT_THAT(story.broken("begins"), IsEmpty());
}

/// The vehicle flies a way of its own from 20 s to `until`; the goto runs from `runs` on.
Story flies_beside(double until, double runs) {
  using journal::record_of;
  namespace lines = journal::lines;
  constexpr std::uint64_t kOwn = 4'500'000'000'000'001;
  Story story = asked();
  const auto at = [](double s) { return MissionTime::seconds(s); };
  const auto task = [&](double s, const char* state) {
    story.line(record_of(at(s), "marvin",
                         lines::Task{.uav = "marvin", .task = 7, .type = "goto", .state = state}));
  };
  const auto truth = [&](double s, std::uint64_t number, const char* state) {
    story.line(record_of(
        at(s), "sim",
        lines::Functional{.uav = "marvin", .task = number, .type = "goto", .state = state}));
  };
  task(10, "started");
  truth(20, kOwn, "running");
  truth(until, kOwn, "ended");
  task(runs, "running");
  truth(1100, 7, "running");
  truth(1200, 7, "ended");
  task(1200, "ended");
  return story;
}

TEST(BeginsLaw, ASweepBeginsWithItsFirstPortion) {
  EXPECT_THAT(flies_beside(60, 20.3).broken("begins"), IsEmpty());
}

TEST(BeginsLaw, AFlightAsideIsNoBegin) {
  EXPECT_THAT(flies_beside(60, 1100.3).broken("begins"),
              ElementsAre(HasSubstr("does not begin for 1090.0 s")));
}

// Who reaches neither its partner nor the ground takes no air.
TEST(BeginsLaw, OneThatIsOutOfReachOfTheGroundDoesNotUntilItIsBack) {
  const auto broken = [](double back) {
    Story story = asked();
    story.does("marvin", {7, "goto", 0, 10, 2000, "ended", "", {}, "", 1900});
    story.link(50, "marvin", "ground", false).link(back, "marvin", "ground", true);
    return story.broken("begins");
  };
  EXPECT_THAT(broken(1500), IsEmpty());
  EXPECT_THAT(broken(500), ElementsAre(HasSubstr("does not begin for 1890.0 s")));
}

// Below degree 4 a UAV stays where its operator has put it.
TEST(BeginsLaw, OneThatWaitsForSomebodyWhoIsInAnOperatorsHandDoesNot) {
  const auto broken = [](double given_back) {
    Story story = asked();
    story.does("marvin", {7, "goto", 0, 10, 2000, "ended", "", {}, "", 1900});
    story.air("marvin", 11, "waits", "heliv to leave");
    story.degree("heliv", 0, 3).degree("heliv", given_back, 4);
    return story.broken("begins");
  };
  EXPECT_THAT(broken(1500), IsEmpty());
  EXPECT_THAT(broken(500), ElementsAre(HasSubstr("does not begin for 1890.0 s")));
}

// Where it was when it was heard of last it may still be. A third one may hear it (--mixed
// --capacity 19200 984015), and passes nothing on.
TEST(BeginsLaw, OneThatWaitsForSomebodyWhomNeitherItNorTheGroundHearsDoesNot) {
  const auto broken = [](double back, const std::vector<std::string>& deaf) {
    Story story = asked();
    story.does("marvin", {7, "goto", 0, 10, 2000, "ended", "", {}, "", 1900});
    story.air("marvin", 11, "waits", "heliv to leave");
    for (const std::string& by : deaf)
      story.link(50, "heliv", by, false).link(back, "heliv", by, true);
    return story.broken("begins");
  };
  const auto never_begun = ElementsAre(HasSubstr("does not begin for 1890.0 s"));
  EXPECT_THAT(broken(1500, {"ground", "marvin"}), IsEmpty());
  EXPECT_THAT(broken(500, {"ground", "marvin"}), never_begun);
  EXPECT_THAT(broken(1500, {"ground", "karma"}), never_begun);
  EXPECT_THAT(broken(1500, {"marvin", "karma"}), never_begun);
}

// Found by random missions (--sweepers 911226): its home was in the air of a blimp's sweep of 17
// min.
TEST(BeginsLaw, OneThatWaitsForASweepOfAnotherDoesNotUntilThatIsOver) {
  const auto broken = [](double swept) {
    Story story = asked();
    story.does("marvin", {7, "goto", 0, 10, 2000, "ended", "", {}, "", 1900});
    story.air("marvin", 11, "waits", "heliv to leave");
    story.does("heliv", {9, "goto", 0, 5, swept, "ended", "", {}, "", 6});
    return story.broken("begins");
  };
  EXPECT_THAT(broken(1050), IsEmpty());
  EXPECT_THAT(broken(850), ElementsAre(HasSubstr("does not begin for 1890.0 s")));
}

// Six minutes each, and none is flown.
Story gives_up(int times) {
  Story story = asked();
  for (int i = 0; i < times; ++i) {
    const double from = 10 + 365 * i, until = from + 360;
    story.does("marvin", {7 + i, "goto", 701, from, until, "aborted", "", {}, "no air", until});
  }
  return story;
}

TEST(BeginsLaw, AGoalWhoseMotionsAreGivenUpAgainAndAgainBreaksIt) {
  EXPECT_THAT(gives_up(5).broken("begins"), ElementsAre(HasSubstr("none begins, for 1800.0 s")));
}

TEST(BeginsLaw, OneThatIsGivenUpThriceDoesNot) {
  EXPECT_THAT(gives_up(3).broken("begins"), IsEmpty());
}

TEST(SeparationLaw, WhereNobodyAsksNothingIsJudged) {
  Story story;
  story.stands("marvin", 0, 20, {50, 50, 40}).stands("heliv", 0, 20, {50, 50, 40});

  EXPECT_THAT(story.broken("separation"), IsEmpty());
  EXPECT_THAT(story.too_near(), ElementsAre(HasSubstr("0.0 m level and 0.0 m in height")))
      << "it is seen all the same";
}

TEST(SeparationLaw, WhoComesFromFarWithinASecondIsSeen) {
  Story story = asked();
  story.stands("marvin", 0, 9, {50, 50, 40});
  story.flies("heliv", 0, 9, {50 - 4.5 * 20, 50, 40}, {50 + 4.5 * 20, 50, 40});

  EXPECT_THAT(story.broken("separation"), ElementsAre(HasSubstr("0.0 m level")));
}

}  // namespace
}  // namespace skein::laws::testing
