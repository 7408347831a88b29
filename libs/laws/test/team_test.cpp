// SPDX-License-Identifier: Apache-2.0
// What a team may do with its tasks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/team.hpp"
#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Marvin is sold task 11 at 20 s, under sale 1.
Story sold() {
  Story story;
  story.owner(20, 11, "owned", 1, "marvin", "sold to marvin for 12 s");
  return story;
}

TEST(TeamOnce, ATaskThatIsBegunAndDoneOnceIsFine) {
  Story story = sold();
  story.team("marvin", 25, 11, 1, "begun").team("marvin", 60, 11, 1, "done");
  EXPECT_THAT(story.broken("team-once"), IsEmpty());
}

TEST(TeamOnce, AnotherMayBeginWhatWasPutBack) {
  Story story = sold();
  story.team("marvin", 25, 11, 1, "begun").team("marvin", 60, 11, 1, "put-back", "no way");
  story.team("heliv", 70, 11, 2, "begun");
  EXPECT_THAT(story.broken("team-once"), IsEmpty());
}

TEST(TeamOnce, NobodyBeginsWhatAnotherIsAt) {
  Story story = sold();
  story.team("marvin", 25, 11, 1, "begun").team("heliv", 30, 11, 2, "begun");
  EXPECT_THAT(story.broken("team-once"),
              ElementsAre(HasSubstr("task 11 is begun, but marvin has begun it at 25.0 s")));
}

TEST(TeamOnce, NobodyBeginsWhatIsDone) {
  Story story = sold();
  story.team("marvin", 25, 11, 1, "begun").team("marvin", 60, 11, 1, "done");
  story.team("heliv", 70, 11, 2, "begun");
  EXPECT_THAT(story.broken("team-once"), ElementsAre(HasSubstr("although it was done")));
}

TEST(TeamOnce, NobodyBeginsTwiceUnderOneSale) {
  Story story = sold();
  story.team("marvin", 25, 11, 1, "begun").team("marvin", 60, 11, 1, "put-back", "no way");
  story.team("marvin", 70, 11, 1, "begun");
  EXPECT_THAT(story.broken("team-once"), SizeIs(1));
}

TEST(TeamOnce, OwnersOfAJointTaskBeginItTogether) {
  Story story;
  story.team("marvin", 25, 11, 1, "begun").team("heliv", 26, 11, 1, "begun");
  EXPECT_THAT(story.broken("team-once"), IsEmpty());
}

/// What marvin is at is for sale again, and another begins it.
std::vector<std::string> begun_twice(const std::string& repeatable, const std::string& why,
                                     const std::string& then) {
  Story story("team: {members: [marvin, heliv]}\n", R"(    - step: share
      when: {time: 1}
      do: [{global_mission: {id: 1, tasks: [{id: 11, task: [general-gotoxyz, P1])" +
                                                        repeatable + "}]}}]\n");
  story.owner(20, 11, "owned", 1, "marvin", "sold to marvin for 12 s");
  story.team("marvin", 25, 11, 1, "begun").owner(90, 11, "for-sale", 1, "", why);
  story.owner(95, 11, "granted", 2, then, "sold to " + then + " for 12 s");
  story.team(then, 96, 11, 2, "begun");
  return story.broken("team-once");
}

// Found by random missions (--anything --deaths 1013): it is told its grant late.
TEST(TeamOnce, TwoMayBeAtWhatIsRepeatableAndWasSoldAgainForSilence) {
  const std::string silent = "marvin was silent beyond its lease";
  EXPECT_THAT(begun_twice(", repeatable: true", silent, "heliv"), IsEmpty());
  EXPECT_THAT(begun_twice("", silent, "heliv"), SizeIs(1));
  EXPECT_THAT(begun_twice(", repeatable: true", "put back by marvin", "heliv"), SizeIs(1));
  EXPECT_THAT(begun_twice(", repeatable: true", silent, "marvin"), SizeIs(1)) << "by the same one";
}

// Found by storms of scenarios/team/five.yaml: the one that the operator had declared lost was
// back.
TEST(TeamOnce, TwoMayBeAtWhatWasSoldAgainAtTheOperatorsWord) {
  EXPECT_THAT(begun_twice("", "marvin was declared lost", "heliv"), IsEmpty());
  EXPECT_THAT(begun_twice("", "heliv was declared lost", "heliv"), SizeIs(1)) << "it was another";
  EXPECT_THAT(begun_twice("", "marvin was declared lost", "marvin"), SizeIs(1))
      << "by the same one";
}

TEST(TeamAsked, WhatIsSoldIsOwnedUnderTheSaleInWhichItWasBidFor) {
  const auto sold_under = [](int sale) {
    Story story;
    story.owner(20, 11, "for-sale", 0, "", "");
    story.line(journal::record_of(MissionTime::seconds(21), "marvin",
                                  journal::lines::Bid{.uav = "marvin", .task = 11, .sale = 4}));
    story.owner(22, 11, "owned", sale, "marvin", "sold to marvin for 12 s");
    story.owner(23, 11, "granted", sale, "marvin", "sold to marvin for 12 s");
    return story.broken("team-asked");
  };
  EXPECT_THAT(sold_under(4), IsEmpty());
  EXPECT_THAT(sold_under(3), ElementsAre(HasSubstr("sale 3, in which nobody was asked")));
}

/// Heliv alone bids for task 11 at 100 s; Marvin takes part too. `lost`, `found`: when an operator
/// says so of Marvin, if at all.
std::vector<std::string> called(std::optional<double> lost, std::optional<double> found,
                                double cut_until = 0, bool bids = false) {
  Story story;
  story.degree("marvin", 0, 5).degree("heliv", 0, 5).stands("marvin", 0, 200);
  const auto at = [&](double when, const std::string& node, const auto& line) {
    story.line(journal::record_of(MissionTime::seconds(when), node, line));
  };
  using namespace journal::lines;
  if (cut_until > 0) story.link(1, "marvin", "heliv", false);
  if (cut_until > 0) story.link(cut_until, "marvin", "heliv", true);
  if (lost) at(*lost, "ground", LostUav{.uav = "marvin"});
  if (found) at(*found, "ground", FoundUav{.uav = "marvin"});
  at(100, "heliv", Bid{.uav = "heliv", .task = 11, .sale = 4});
  if (bids) at(101, "marvin", Bid{.uav = "marvin", .task = 12, .sale = 4, .why = "too far"});
  return story.broken("team-called");
}

TEST(TeamCalled, WhoTakesPartIsAskedInEachSale) {
  EXPECT_THAT(called({}, {}), ElementsAre(HasSubstr("is not asked in sale 4")));
  EXPECT_THAT(called({}, {}, 0, true), IsEmpty());
}

TEST(TeamCalled, WhoIsNotReachedByAllMayBeLeftOut) {
  EXPECT_THAT(called({}, {}, 50), IsEmpty());
  EXPECT_THAT(called({}, {}, 30), SizeIs(1));
}

TEST(TeamCalled, WhoIsDeclaredLostIsAskedAgainOnceItIsFound) {
  EXPECT_THAT(called(10, {}), IsEmpty());
  EXPECT_THAT(called(10, 60), IsEmpty()) << "just now";
  EXPECT_THAT(called(10, 30), SizeIs(1));
}

TEST(TeamBegun, WhoIsGrantedATaskAndHasNothingElseToDoBeginsIt) {
  const auto granted = [](double at, bool begins, const std::string& goal) {
    Story story;
    story.degree("marvin", 0, 5).stands("marvin", 0, 200);
    story.owner(at, 11, "granted", 4, "marvin", "sold to marvin for 12 s");
    if (begins) story.team("marvin", at + 1, 11, 4, "begun");
    if (!goal.empty()) story.goal("marvin", 7, "(perceive P1 5)", goal, at + 1);
    return story.broken("team-begun");
  };

  EXPECT_THAT(granted(100, false, ""), ElementsAre(HasSubstr("does not begin task 11")));
  EXPECT_THAT(granted(100, true, ""), IsEmpty());
  EXPECT_THAT(granted(180, false, ""), IsEmpty()) << "just now";
  EXPECT_THAT(granted(100, false, "under-way"), IsEmpty()) << "it is at something else";
  EXPECT_THAT(granted(100, false, "achieved"), SizeIs(1));
}

TEST(TeamOwned, ATaskForSaleForLongWhileEverybodyIsThereIsForgotten) {
  Story story;
  story.degree("marvin", 0, 5).owner(20, 11, "for-sale", 0, "", "put back by heliv");
  story.stands("marvin", 0, 60);
  EXPECT_THAT(story.broken("team-owned"), IsEmpty());
  story.stands("marvin", 61, 100);
  EXPECT_THAT(story.broken("team-owned"),
              ElementsAre(HasSubstr("task 11 has no owner for 80.0 s")));
}

TEST(TeamOwned, WithNobodyAtDegreeFiveThereIsNobodyToSellTo) {
  Story story;
  story.owner(20, 11, "for-sale", 0, "", "put back by heliv").stands("marvin", 0, 200);
  EXPECT_THAT(story.broken("team-owned"), IsEmpty());
}

TEST(TeamOwned, WhoIsOutOfReachOfMostCannotBeSoldTo) {
  const auto last_heard = [](double at) {
    Story story;
    story.degree("marvin", 0, 5).owner(20, 11, "for-sale", 0, "", "put back by marvin");
    for (const char* other : {"ground", "heliv"}) story.link(at, "marvin", other, false);
    story.stands("heliv", 0, 1).stands("marvin", 0, 200);
    return story.broken("team-owned");
  };
  EXPECT_THAT(last_heard(70), IsEmpty());
  EXPECT_THAT(last_heard(90), SizeIs(1));
}

// Found by random missions (--anything 989014): with a robot that is not of the team, and has no
// vote, three of five were there.
TEST(TeamOwned, WhoIsNotOfTheTeamMakesNoMajorityOfIt) {
  const auto without = [](const std::string& other) {
    Story story("team: {members: [marvin, heliv], ground: false}\n");
    story.degree("marvin", 0, 5).owner(20, 11, "for-sale", 0, "", "put back by marvin");
    return story.link(25, "marvin", other, false).stands("marvin", 0, 200).broken("team-owned");
  };
  EXPECT_THAT(without("karma"), SizeIs(1));
  EXPECT_THAT(without("heliv"), IsEmpty());
}

// Found by random missions (--anything --deaths 1001): it sold them, out of the station's reach.
TEST(TeamOwned, WhatIsSoldBeyondTheGroundStationsReachItCannotKnow) {
  const auto last_heard = [](double at) {
    Story story;
    story.degree("marvin", 0, 5).owner(20, 11, "for-sale", 0, "", "put back by marvin");
    story.link(at, "marvin", "ground", false).stands("heliv", 0, 1).stands("marvin", 0, 200);
    return story.broken("team-owned");
  };
  EXPECT_THAT(last_heard(30), IsEmpty());
  EXPECT_THAT(last_heard(90), SizeIs(1));
}

// Found by random missions (--anything 14): all homes were beyond the radio's range.
TEST(TeamOwned, AMissionThatNobodyWhoBidsCouldBeGivenIsNotSold) {
  const auto given = [](double heard) {
    Story story;
    story.degree("marvin", 0, 5).link(0, "marvin", "ground", false);
    story.line(journal::record_of(MissionTime::seconds(10), "ground",
                                  journal::lines::GlobalMission{.mission = 1, .state = "given"}));
    story.link(200 - heard, "marvin", "ground", true).stands("marvin", 0, 200);
    return story.broken("team-owned");
  };
  EXPECT_THAT(given(50), IsEmpty());
  EXPECT_THAT(given(70), ElementsAre(HasSubstr("nobody sold it")));
}

TEST(TeamOwned, WhoHoldsForWantOfContactTakesPartAgainOnceItsDegreeIsSet) {
  Story story;
  story.degree("marvin", 0, 5).owner(20, 11, "for-sale", 0, "", "put back by marvin");
  story.contact("marvin", 30, "hold").stands("marvin", 0, 200);
  EXPECT_THAT(story.broken("team-owned"), IsEmpty());
  story.degree("marvin", 120, 5);
  EXPECT_THAT(story.broken("team-owned"), SizeIs(1));
}

// Marvin, of a team of four with the ground station, is in the air for 300 s; the others stand by.
Story aloft_without_goal() {
  Story story;
  story.degree("marvin", 0, 5).stands("heliv", 0, 300).stands("karma", 0, 300);
  story.flies("marvin", 0, 300, {900, 0, 50}, {900, 0, 50});
  return story;
}

TEST(TeamHome, WhoReachesMostWaitsForWork) {
  Story story = aloft_without_goal();
  story.link(20, "ground", "marvin", false);
  EXPECT_THAT(story.broken("team-home"), IsEmpty());
}

TEST(TeamHome, WhoIsOutOfReachOfMostForItsPolicyIsNotLeftThere) {
  const auto cut_at = [](double at) {
    Story story = aloft_without_goal();
    for (const char* other : {"ground", "heliv", "karma"}) story.link(at, other, "marvin", false);
    return story;
  };
  EXPECT_THAT(cut_at(150).broken("team-home"),
              ElementsAre(HasSubstr("out of reach of most of its team since 150.0 s")));
  EXPECT_THAT(cut_at(195).broken("team-home"), IsEmpty());
  EXPECT_THAT(cut_at(20).goal("marvin", 1, "perceive P1 20", "planned", 30).broken("team-home"),
              IsEmpty());
  EXPECT_THAT(cut_at(20).contact("marvin", 80, "hold").broken("team-home"), IsEmpty());
}

TEST(TeamHome, WhoIsOnlyHeardPastOthersIsInReach) {
  Story story = aloft_without_goal();
  for (const char* other : {"ground", "karma"}) story.link(20, other, "marvin", false);
  EXPECT_THAT(story.broken("team-home"), IsEmpty());
}

TEST(TeamExplained, ASaleSaysToWhomAndForWhat) {
  EXPECT_THAT(sold().broken("team-explained"), IsEmpty());
  Story story;
  story.owner(20, 11, "owned", 1, "marvin", "because");
  EXPECT_THAT(story.broken("team-explained"), ElementsAre(HasSubstr("task 11 is sold: 'because'")));
}

TEST(TeamExplained, WhatIsForNobodyAndWhatIsPutBackSaysWhy) {
  Story story = sold();
  story.owner(30, 12, "unsold", 0, "", "");
  story.team("marvin", 31, 11, 1, "begun").team("marvin", 40, 11, 1, "put-back");
  EXPECT_THAT(story.broken("team-explained"), SizeIs(2));
}

TEST(TeamExplained, NobodyBeginsWhatItDoesNotOwn) {
  Story story = sold();
  story.team("heliv", 31, 11, 1, "begun");
  EXPECT_THAT(story.broken("team-explained"), ElementsAre(HasSubstr("never said to own it")));
}

TEST(TeamOwned, WhoLeftATaskByItsContactLossPolicyDoesNotKeepItOnceHeardAgain) {
  const auto kept = [](double degree_again) {
    Story story = sold();
    story.degree("marvin", 0, 5).degree("heliv", 0, 5).stands("heliv", 0, 300);
    story.link(0, "marvin", "ground", true).link(30, "marvin", "ground", false);
    story.contact("marvin", 60, "return").link(100, "marvin", "ground", true);
    if (degree_again > 0) story.degree("marvin", degree_again, 5);
    return story;
  };

  EXPECT_THAT(kept(0).broken("team-owned"),
              ElementsAre(HasSubstr("task 11 is kept by one that left it at 60.0 s")));
  EXPECT_THAT(kept(110).broken("team-owned"), IsEmpty());
  Story put_back = kept(0);
  put_back.owner(120, 11, "owned", 2, "heliv", "sold to heliv for 12 s");
  EXPECT_THAT(put_back.broken("team-owned"), IsEmpty());
}

// Marvin owns 11 and 12, and begins 11 at 25 s, which is to end by 60 s.
Story at_work() {
  Story story = sold();
  story.degree("marvin", 0, 5).owner(20, 12, "owned", 1, "marvin", "sold to marvin for 12 s");
  story.team("marvin", 25, 11, 1, "begun").plans("marvin", 25, 11, 60).stands("marvin", 0, 200);
  return story;
}

TEST(TeamLate, WhoIsBehindKeepsNothingThatItHasNotBegun) {
  EXPECT_THAT(at_work().broken("team-late"),
              ElementsAre(HasSubstr("task 12 is kept by one whose task 11 was to end by 60.0 s")));
  Story in_time = at_work();
  in_time.team("marvin", 75, 11, 1, "done");
  EXPECT_THAT(in_time.broken("team-late"), IsEmpty());
}

TEST(TeamLate, WhatIsPutBackMayBeSoldToItAgain) {
  Story story = at_work();
  story.owner(81, 12, "for-sale", 1, "", "put back by marvin: it is 20 s behind with task 11");
  story.owner(83, 12, "owned", 2, "marvin", "sold to marvin for 40 s");
  EXPECT_THAT(story.broken("team-late"), IsEmpty());
}

TEST(TeamLate, ItIsTheFirstPlanThatPromises) {
  Story story = at_work();
  story.plans("marvin", 50, 11, 300);
  EXPECT_THAT(story.broken("team-late"), SizeIs(1));
}

// Found by an outsider's missions: a node that came back without its memory.
TEST(TeamLate, WhatAnotherLifePromisedForAGoalOfThatNumberIsNoPromise) {
  Story story = at_work();
  story.team("marvin", 75, 11, 1, "put-back").team("marvin", 300, 11, 2, "begun");
  EXPECT_THAT(story.broken("team-late"), IsEmpty());
}

// Found by random missions (--anything --minds 132): it had flown out of the station's reach.
TEST(TeamLate, WhatIsPutBackBeyondTheGroundStationsReachItCannotKnow) {
  const auto in_reach_from = [](double at) {
    Story story = at_work();
    story.link(40, "marvin", "ground", false).link(at, "marvin", "ground", true);
    return story.broken("team-late");
  };
  EXPECT_THAT(in_reach_from(90), IsEmpty());
  EXPECT_THAT(in_reach_from(70), SizeIs(1));
}

TEST(TeamLate, WhoseDegreeIsLoweredIsJudgedByOtherLaws) {
  Story story = at_work();
  story.degree("marvin", 65, 4);
  EXPECT_THAT(story.broken("team-late"), IsEmpty());
}

}  // namespace
}  // namespace skein::laws::testing
