// SPDX-License-Identifier: Apache-2.0
// A mission of the team as the market is given it, and what is wrong with one.
#include "skein/team/global_mission.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::team {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

mission::Vocabulary vocabulary() {
  mission::Vocabulary words;
  words.tasks["look"] = {
      "look", {mission::ParameterKind::kPlace, mission::ParameterKind::kDuration}, {"sight"}};
  return words;
}

Roster roster() { return Roster({"marvin", "heliv", "ground"}); }

GlobalTask look(std::uint64_t id) {
  GlobalTask asked;
  asked.task.id = mission::GoalId(id);
  asked.task.name = "look";
  asked.task.arguments = {std::string("P1"), 20.0};
  return asked;
}

GlobalMission mission_of(std::vector<GlobalTask> tasks) {
  return {mission::MissionId(1), std::move(tasks), "step one"};
}

std::vector<std::string> problems(const GlobalMission& mission) {
  return problems_of(mission, roster(), vocabulary(), {{"P1"}, {}, {"marvin", "heliv"}, nullptr},
                     MissionTime());
}

TEST(GlobalMission, IsALotOfTasksThatLastAsLongAsTheirDurationsAndKeepTheirWords) {
  GlobalTask first = look(11), then = look(12);
  first.task.time.start_after = MissionTime::seconds(30);
  first.task.time.end_before = MissionTime::seconds(90);
  then.after = {mission::GoalId(11)};
  then.by = "heliv";
  then.not_by = {"marvin"};
  then.members = 2;

  const auction::GivenMission lot = given(mission_of({first, then}), roster(), vocabulary());

  ASSERT_THAT(lot.lot.tasks, SizeIs(2));
  EXPECT_EQ(lot.lot.tasks[0].duration, 20);
  EXPECT_NEAR(lot.lot.tasks[0].earliest, 30, 1e-9);
  EXPECT_NEAR(lot.lot.tasks[0].deadline, 90, 1e-9);
  EXPECT_EQ(lot.lot.tasks[1].pinned, auction::MemberNumber(1));
  EXPECT_THAT(lot.lot.tasks[1].forbidden, ElementsAre(auction::MemberNumber(0)));
  EXPECT_EQ(lot.lot.tasks[1].least_members, 2U);
  EXPECT_THAT(lot.lot.precedences,
              ElementsAre(auction::Precedence{auction::TaskNumber(11), auction::TaskNumber(12)}));
  ASSERT_NE(order_of(lot.lot.tasks[0]), nullptr);
  EXPECT_EQ(order_of(lot.lot.tasks[0])->task, first.task);
  EXPECT_EQ(order_of(lot.lot.tasks[0])->asked_by, "step one");
  EXPECT_EQ(order_of(auction::Task()), nullptr);
}

GlobalTask look_after(std::uint64_t id, std::uint64_t first, double least, Duration most) {
  GlobalTask then = look(id);
  then.after = {mission::GoalId(first)};
  then.task.after = {{mission::GoalId(first), false, Duration::seconds(least), most}};
  return then;
}

TEST(GlobalMission, ATimeAfterAnotherTaskIsADelayOfTheLot) {
  const auto lot = given(mission_of({look(11), look_after(12, 11, 60, Duration::seconds(300)),
                                     look_after(13, 12, 5, Duration::max())}),
                         roster(), vocabulary());

  ASSERT_THAT(lot.lot.precedences, SizeIs(2));
  EXPECT_NEAR(lot.lot.precedences[0].delay.least, 60, 1e-9);
  EXPECT_NEAR(lot.lot.precedences[0].delay.most, 300, 1e-9);
  EXPECT_NEAR(lot.lot.precedences[1].delay.least, 5, 1e-9);
  EXPECT_FALSE(lot.lot.precedences[1].delay.bounds_above());
}

TEST(GlobalMission, OnceItIsGrantedADelayIsATime) {
  auction::Task granted;
  granted.duration = 20;
  granted.earliest = 160;
  granted.deadline = 420;
  GlobalTask asked = look_after(12, 11, 60, Duration::seconds(300));
  asked.task.time.start_after = MissionTime::seconds(10);

  const mission::HighLevelTask task = in_time(asked.task, granted);

  EXPECT_THAT(task.after, IsEmpty());
  EXPECT_EQ(task.time.start_after, MissionTime::seconds(160));
  EXPECT_EQ(task.time.start_before, MissionTime::seconds(400));
  EXPECT_EQ(in_time(look(11).task, granted), look(11).task);
  const GlobalTask open = look_after(12, 11, 60, Duration::max());
  EXPECT_EQ(in_time(open.task, granted).time.start_before, std::nullopt);
}

TEST(GlobalMission, ATimeIsAfterATaskThatItComesAfter) {
  GlobalTask stray = look_after(12, 11, 60, Duration::seconds(300)), end = stray;
  stray.after.clear();
  end.task.after.front().on_end = true;
  for (const GlobalTask& one : {stray, end})
    EXPECT_THAT(problems(mission_of({look(11), one})),
                ElementsAre(HasSubstr("of another task it may bound its beginning")));
}

TEST(GlobalMission, TimesBetweenTasksThatContradictEachOtherAreAProblem) {
  GlobalTask last = look_after(13, 11, 0, Duration::seconds(70));
  last.after.emplace_back(12);
  EXPECT_THAT(
      problems(mission_of({look(11), look_after(12, 11, 60, Duration::seconds(300)), last})),
      ElementsAre(HasSubstr("13 begins within 70 s of the end of 11, which lasts 20 s")));
}

TEST(GlobalMission, OneThatMakesSenseHasNoProblems) {
  EXPECT_THAT(problems(mission_of({look(11), look(12)})), IsEmpty());
}

TEST(GlobalMission, WordsThatTheDomainDoesNotKnowAreAProblem) {
  GlobalTask asked = look(11);
  asked.task.arguments[0] = std::string("P2");

  EXPECT_THAT(problems(mission_of({asked})), ElementsAre(HasSubstr("P2")));
}

TEST(GlobalMission, StrangersAreAProblemAndSoIsTheGroundStationThatCannotFly) {
  GlobalTask asked = look(11);
  asked.by = "ground";
  asked.not_by = {"karma"};

  EXPECT_THAT(problems(mission_of({asked})),
              ElementsAre("task 11: no UAV 'ground'", "task 11: no UAV 'karma'"));
}

TEST(GlobalMission, MoreMembersThanThereAreAndTasksThatAreNotInItAreProblems) {
  GlobalTask asked = look(11);
  asked.members = 3;
  asked.after = {mission::GoalId(99)};

  EXPECT_THAT(problems(mission_of({asked})),
              ElementsAre("task 11: it wants 3 of 2 UAVs", "task 11: task 99 is not in it"));
}

TEST(GlobalMission, TasksThatWaitForEachOtherContradictThemselves) {
  GlobalTask one = look(11), other = look(12);
  one.after = {mission::GoalId(12)};
  other.after = {mission::GoalId(11)};

  EXPECT_THAT(problems(mission_of({one, other})),
              ElementsAre(AnyOf("tasks 11, 12, 11: each is to end before the next begins",
                                "tasks 12, 11, 12: each is to end before the next begins")));
}

TEST(GlobalMission, AChainThatIsTooLongForADeadlineIsNamed) {
  GlobalTask one = look(11), other = look(12);
  other.after = {mission::GoalId(11)};
  other.task.time.end_before = MissionTime::seconds(20);

  EXPECT_THAT(problems(mission_of({one, other})),
              ElementsAre(AllOf(StartsWith("tasks 11, 12: the last cannot end before"),
                                HasSubstr("its deadline is 20"))));
}

TEST(GlobalMission, OneThatComesTooLateForItsChainIsRefusedForTheTimeThatIsLeft) {
  GlobalTask one = look(11), other = look(12);
  other.after = {mission::GoalId(11)};
  other.task.time.end_before = MissionTime::seconds(100);
  const auto at = [&](double now) {
    return problems_of(mission_of({one, other}), roster(), vocabulary(),
                       {{"P1"}, {}, {"marvin", "heliv"}, nullptr}, MissionTime::seconds(now));
  };

  EXPECT_THAT(at(60), IsEmpty());
  EXPECT_THAT(at(61),
              ElementsAre("tasks 11, 12: the last cannot end before 101 s, its deadline is 100 s: "
                          "11 begins at 61 s at the earliest and lasts 20 s, then 12 lasts 20 s"));
}

TEST(GlobalMission, WhatMayNotEndBeforeHoldsUpWhatComesAfterIt) {
  GlobalTask one = look(11), other = look(12);
  one.task.time.end_after = MissionTime::seconds(90);
  other.after = {mission::GoalId(11)};
  other.task.time.end_before = MissionTime::seconds(109);

  EXPECT_THAT(problems(mission_of({one, other})), ElementsAre(StartsWith("tasks 11, 12: ")));
  other.task.time.end_before = MissionTime::seconds(110);
  EXPECT_THAT(problems(mission_of({one, other})), IsEmpty());
  one.task.time.start_before = MissionTime::seconds(5);  // it lasts as long as it has to
  EXPECT_THAT(problems(mission_of({one, other})), IsEmpty());
}

TEST(GlobalMission, AJointTaskWhoseMembersCannotBeThereTogetherNamesWhoIsMissedAndWhy) {
  GlobalTask joint = look(21), alone = look(22);
  joint.members = 2;
  joint.task.time.end_before = MissionTime::seconds(30);
  alone.by = "heliv";
  alone.task.time.end_before = MissionTime::seconds(30);

  EXPECT_THAT(
      problems(mission_of({joint, alone})),
      ElementsAre(
          "tasks 21, 22: both need heliv, and after 21 (ends at 20 s at the earliest, lasts "
          "20 s) 22 cannot end before 40 s, and must by 30 s; after 22 (ends at 20 s at "
          "the earliest, lasts 20 s) 21 cannot end before 40 s, and must by 30 s"));
}

TEST(GlobalMission, AJointTaskThatTooFewMayDoIsAProblem) {
  GlobalTask joint = look(21);
  joint.members = 2;
  joint.not_by = {"heliv"};

  EXPECT_THAT(problems(mission_of({joint})),
              ElementsAre("task 21: it is for 2 members, and 1 may do it"));
}

TEST(GlobalMission, OneWhoIsPinnedAndForbiddenContradictsItself) {
  GlobalTask asked = look(11);
  asked.by = "heliv";
  asked.not_by = {"heliv"};

  EXPECT_THAT(problems(mission_of({asked})), SizeIs(1));
}

TEST(Roster, NumbersFollowTheOrderAndStrangersHaveNone) {
  EXPECT_EQ(roster().number_of("ground"), auction::MemberNumber(2));
  EXPECT_EQ(roster().number_of("karma"), std::nullopt);
  EXPECT_EQ(roster().name_of(auction::MemberNumber(1)), "heliv");
  EXPECT_EQ(roster().name_of(auction::MemberNumber(7)), "?");
}

TEST(Roster, AMemberIsSetUpWithTheNamesOfAll) {
  const auction::TeamSetup setup = setup_of({roster(), {}, 5}, "heliv");

  EXPECT_EQ(setup.self, auction::MemberNumber(1));
  EXPECT_THAT(setup.roster, SizeIs(3));
  EXPECT_EQ(setup.names.at(auction::MemberNumber(0)), "marvin");
  EXPECT_EQ(setup.seed, 5U);
}

// ---- for several, and about what is not known yet ----

GlobalTask together(std::uint32_t members) {
  GlobalTask asked;
  asked.task.id = mission::GoalId(11);
  asked.task.name = "meet";
  asked.task.arguments = {std::string(kMembers), std::string("P1")};
  asked.members = members;
  return asked;
}

std::vector<std::string> problems_of_meeting(const GlobalTask& task) {
  mission::Vocabulary words;
  words.tasks["meet"] = {
      "meet", {mission::ParameterKind::kUavs, mission::ParameterKind::kPlace}, {}};
  return problems_of(mission_of({task}), roster(), words,
                     {{"P1"}, {}, {"marvin", "heliv"}, nullptr}, MissionTime());
}

TEST(GlobalMission, TheWordMembersStandsForWhoItIsSoldTo) {
  const mission::HighLevelTask task = for_members(together(2).task, {"heliv", "karma"});

  EXPECT_EQ(std::get<std::vector<std::string>>(task.arguments[0]),
            (std::vector<std::string>{"heliv", "karma"}));
  EXPECT_EQ(std::get<std::string>(task.arguments[1]), "P1");
  EXPECT_THAT(problems_of_meeting(together(2)), IsEmpty());
}

TEST(GlobalMission, WhatIsForSeveralWantsTwoAtLeast) {
  EXPECT_THAT(problems_of_meeting(together(1)),
              ElementsAre(HasSubstr("task 11: it is for several, and says 'members: 1'")));
}

TEST(GlobalMission, AnAlarmNeedNotBeKnown) {
  GlobalTask task = look(11);
  task.task.arguments[0] = std::string("alarm:3");

  EXPECT_THAT(alarms_in(task.task), ElementsAre("alarm:3"));
  EXPECT_THAT(problems(mission_of({task})), IsEmpty());
}

TEST(GlobalMission, WhatOnlyLooksLikeAnAlarmIsAPlaceThatNobodyKnows) {
  for (const char* name : {"alarm:", "alarm:x", "alarm", "alarms:1"}) {
    GlobalTask task = look(11);
    task.task.arguments[0] = std::string(name);

    EXPECT_THAT(alarms_in(task.task), IsEmpty()) << name;
    EXPECT_THAT(problems(mission_of({task})), SizeIs(1)) << name;
  }
}

}  // namespace
}  // namespace skein::team
