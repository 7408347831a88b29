// SPDX-License-Identifier: Apache-2.0
// What was said beforehand, of missions and of the wind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/deliberation.hpp"
#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kAskedThenGiven = R"(
    - step: ask
      when: {time: 10}
      do: [{mission: {uav: marvin, id: 1, evaluate: true, tasks: [{id: 701, task: [general-gotoxyz, A1]}]}}]
    - step: take
      when: {mission: {uav: marvin, id: 1, state: evaluated}}
      do: [{mission: {uav: marvin, id: 2, tasks: [{id: 702, task: [general-gotoxyz, A1]}]}}]
)";

/// Asked at 10 s, answered and given at 11 s; flown from 12 s to 40 s with this share of energy.
Story flown(double energy = 0.05) {
  Story story("", kAskedThenGiven);
  story.answer("marvin", 11, {1, true, true, 0.05, 35, 45}).answer("marvin", 12, {2, true});
  story.goal("marvin", 702, "general-gotoxyz A1", "received", 12);
  story.does("marvin", {100, "goto", 702, 12, 40});
  story.goal("marvin", 702, "general-gotoxyz A1", "achieved", 40);
  story.flies("marvin", 0, 12, {0, 0, 50}, {0, 0, 50}, 0.9);
  story.flies("marvin", 13, 60, {0, 0, 50}, {150, 60, 50}, 0.9 - energy);
  return story;
}

TEST(Evaluated, AMissionTakesTheTimeAndTheEnergyThatWereSaid) {
  EXPECT_THAT(flown().broken("evaluated"), IsEmpty());
}

TEST(Evaluated, OneThatEndsLaterIsTold) {
  Story story("", kAskedThenGiven);
  story.answer("marvin", 11, {1, true, true, 0.05, 15, 25}).answer("marvin", 12, {2, true});
  story.goal("marvin", 702, "general-gotoxyz A1", "received", 12);
  story.does("marvin", {100, "goto", 702, 12, 40});
  story.goal("marvin", 702, "general-gotoxyz A1", "achieved", 40);

  EXPECT_THAT(story.broken("evaluated"),
              ElementsAre(HasSubstr("was to end between 15.0 and 25.0 s, and ended at 40.0")));
}

TEST(Evaluated, OneThatWaitsForPartnersMayEndLater) {
  Story story("", kAskedThenGiven);
  story.answer("marvin", 11, {1, true, true, 0.05, 15, 25}).answer("marvin", 12, {2, true});
  story.does("marvin", {99, "synchronise", 701, 5, 30});
  story.goal("marvin", 702, "general-gotoxyz A1", "received", 12);
  story.does("marvin", {100, "goto", 702, 30, 40});
  story.goal("marvin", 702, "general-gotoxyz A1", "achieved", 40);

  EXPECT_THAT(story.broken("evaluated"), IsEmpty());
}

// Found by random missions (--merged 983023): it flew 24 m higher over one that held in its way.
TEST(Evaluated, OneThatIsFlownOverOthersMayTakeMore) {
  const auto higher_at = [](double at) {
    return flown(0.1)
        .line(journal::record_of(
            MissionTime::seconds(at), "marvin",
            journal::lines::Air{
                .uav = "marvin", .task = 100, .type = "goto", .state = "had", .raised = 24.0}))
        .broken("evaluated");
  };
  EXPECT_THAT(higher_at(13), IsEmpty());
  EXPECT_THAT(higher_at(5), SizeIs(1));
}

TEST(Evaluated, OneThatTakesTwiceTheEnergyIsTold) {
  EXPECT_THAT(flown(0.1).broken("evaluated"),
              ElementsAre(HasSubstr("was to take 5.0 % of its energy, and took 10.0 %")));
}

TEST(Evaluated, OneThatIsRefusedAfterAllIsTold) {
  Story story("", kAskedThenGiven);
  story.answer("marvin", 11, {1, true, true, 0.05, 15, 25}).answer("marvin", 12, {2, false});
  story.goal("marvin", 702, "general-gotoxyz A1", "received", 12);

  EXPECT_THAT(story.broken("evaluated"), ElementsAre(HasSubstr("could be taken")));
}

TEST(Evaluated, WhatIsRepairedMeanwhileIsAnotherThing) {
  Story story = flown(0.1);
  story.decides("marvin", 20, "6 repair: replan", "cause", "plan 3");

  EXPECT_THAT(story.broken("evaluated"), IsEmpty());
}

TEST(Wind, ThatIsFeltIsTheTrueOne) {
  const auto felt = [](const std::string& words) {
    Story story("  wind: {toward: 0, speed: 3}\n");
    story.says("marvin", 100, "the wind is felt to be " + words + " degrees north of east");
    return story.broken("wind");
  };

  EXPECT_THAT(felt("2.4 m/s towards 20"), IsEmpty());
  EXPECT_THAT(felt("3 m/s towards -90"),
              ElementsAre(HasSubstr("4.2 m/s from the true one of 3.0")));
}

}  // namespace
}  // namespace skein::laws::testing
