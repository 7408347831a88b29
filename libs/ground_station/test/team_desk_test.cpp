// SPDX-License-Identifier: Apache-2.0
// The ground station in a team: missions given once, and who has what.
#include "skein/ground_station/team_desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::ground_station {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

MissionKnowledge knowledge() {
  MissionKnowledge known;
  known.vocabulary.emplace();
  known.vocabulary->tasks["look"] = {"look", {mission::ParameterKind::kPlace}, {}};
  known.places = {"P1"};
  return known;
}

TeamDesk desk() {
  return TeamDesk({team::Roster({"marvin", "heliv", "ground"}), {}, 1}, "ground", knowledge(),
                  {"marvin", "heliv"});
}

GiveGlobalMission mission_of(std::uint64_t id, std::uint64_t task,
                             const std::string& place = "P1") {
  GiveGlobalMission give;
  give.mission.id = mission::MissionId(id);
  team::GlobalTask& one = give.mission.tasks.emplace_back();
  one.task.id = mission::GoalId(task);
  one.task.name = "look";
  one.task.arguments = {place};
  return give;
}

template <class Kind>
std::vector<Kind> all(const std::vector<TeamDesk::Effect>& effects) {
  std::vector<Kind> found;
  for (const auto& effect : effects) {
    if (const auto* one = std::get_if<Kind>(&effect)) found.push_back(*one);
  }
  return found;
}

// The book in which task 11 stands like this.
TeamHeard beat(auction::Stage stage, std::uint64_t revision) {
  auto ledger = std::make_shared<auction::Ledger>();
  ledger->term = 1;
  ledger->revision = revision;
  ledger->missions = {auction::MissionNumber(1)};
  auction::LedgerEntry& entry = ledger->entries[auction::TaskNumber(11)];
  entry.task.number = auction::TaskNumber(11);
  entry.stage = stage;
  entry.owners = {auction::MemberNumber(0)};
  entry.why = "sold to marvin for 12 s";
  return {"marvin", auction::Beat{1, revision, ledger}};
}

auction::Status answer_of(const std::vector<TeamDesk::Effect>& effects) {
  for (const TeamTell& tell : all<TeamTell>(effects)) {
    if (const auto* status = std::get_if<auction::Status>(&tell.message)) return *status;
  }
  return {};
}

TEST(TeamDesk, AMissionIsSaidToTheHolderUntilItsBookHasIt) {
  TeamDesk ground = desk();
  EXPECT_EQ(all<GlobalMissionChanged>(ground.handle(mission_of(1, 11), at(1))).at(0).stage,
            GlobalStage::kGiven);
  auto empty = std::make_shared<auction::Ledger>();
  empty->term = 1;
  empty->revision = 1;

  const auto first = ground.handle(TeamHeard{"marvin", auction::Beat{1, 1, empty}}, at(2));
  const auto again = ground.handle(TeamHeard{"marvin", auction::Beat{1, 1, nullptr}}, at(3));
  const auto then = ground.handle(beat(auction::Stage::kForSale, 2), at(4));

  EXPECT_THAT(answer_of(first).missions, SizeIs(1));
  EXPECT_THAT(answer_of(again).missions, SizeIs(1));
  EXPECT_THAT(answer_of(then).missions, IsEmpty());
  EXPECT_FALSE(answer_of(first).bids);
}

TEST(TeamDesk, AMissionGivenTwiceIsOneAndThatIsSaid) {
  TeamDesk ground = desk();
  ground.handle(mission_of(1, 11), at(1));

  const auto effects = ground.handle(mission_of(1, 11), at(2));

  ASSERT_THAT(all<GlobalMissionChanged>(effects), SizeIs(1));
  EXPECT_THAT(all<GlobalMissionChanged>(effects)[0].why, HasSubstr("second time"));
  auto empty = std::make_shared<auction::Ledger>();
  empty->term = 1;
  const auto told = ground.handle(TeamHeard{"marvin", auction::Beat{1, 0, empty}}, at(3));
  EXPECT_THAT(answer_of(told).missions, SizeIs(1));
}

TEST(TeamDesk, AMissionThatMakesNoSenseIsRefusedWithEveryReason) {
  TeamDesk ground = desk();

  const auto refused =
      all<GlobalMissionChanged>(ground.handle(mission_of(1, 11, "nowhere"), at(1)));

  ASSERT_THAT(refused, SizeIs(1));
  EXPECT_EQ(refused[0].stage, GlobalStage::kRefused);
  EXPECT_THAT(refused[0].why, HasSubstr("nowhere"));
}

TEST(TeamDesk, AMissionThatNeedsWhatEverybodyLacksIsRefusedAtOnceWithWhatEachLacks) {
  using interaction::Requirement;
  MissionKnowledge known = knowledge();
  known.vehicles["marvin"].abilities = {{"payload", 1}};
  known.vehicles["heliv"] = {};
  known.vehicles["karma"].abilities = {{"payload", 9}};  // is not in the team
  TeamDesk ground({team::Roster({"marvin", "heliv", "ground"}), {}, 1}, "ground", known,
                  {"marvin", "heliv", "karma"});
  const auto given = [&](std::uint64_t id, double least) {
    GiveGlobalMission give = mission_of(id, id + 10);
    give.mission.tasks[0].needs = {
        {"payload", Requirement::Bound{interaction::Relation::kAtLeast, least}}};
    return all<GlobalMissionChanged>(ground.handle(give, at(1))).at(0);
  };

  EXPECT_EQ(given(1, 1).stage, GlobalStage::kGiven);
  const GlobalMissionChanged refused = given(2, 2);
  EXPECT_EQ(refused.stage, GlobalStage::kRefused);
  EXPECT_EQ(refused.why,
            "task 12: nobody has what it needs: heliv: it lacks payload ≥ 2; "
            "marvin: it lacks payload ≥ 2 (it has 1)");
}

TEST(TeamDesk, ATaskOfAnotherMissionIsNotTakenAgain) {
  TeamDesk ground = desk();
  ground.handle(mission_of(1, 11), at(1));

  const auto refused = all<GlobalMissionChanged>(ground.handle(mission_of(2, 11), at(2)));

  ASSERT_THAT(refused, SizeIs(1));
  EXPECT_EQ(refused[0].why, "task 11 is one of another mission");
}

TEST(TeamDesk, EveryChangeOfOwnerIsToldOnceWithItsReasonAndTheEndOfAMissionToo) {
  TeamDesk ground = desk();
  ground.handle(mission_of(1, 11), at(1));

  const auto owned = ground.handle(beat(auction::Stage::kOwned, 1), at(2));
  const auto again = ground.handle(beat(auction::Stage::kOwned, 1), at(3));
  const auto done = ground.handle(beat(auction::Stage::kDone, 2), at(4));

  ASSERT_THAT(all<TeamTaskChanged>(owned), SizeIs(1));
  EXPECT_THAT(all<TeamTaskChanged>(owned)[0].standing.owners, ElementsAre("marvin"));
  EXPECT_EQ(all<TeamTaskChanged>(owned)[0].standing.why, "sold to marvin for 12 s");
  EXPECT_THAT(all<TeamTaskChanged>(again), IsEmpty());
  ASSERT_THAT(all<GlobalMissionChanged>(done), SizeIs(1));
  EXPECT_EQ(all<GlobalMissionChanged>(done)[0].stage, GlobalStage::kDone);
  EXPECT_EQ(ground.standings().at(mission::GoalId(11)).stage, auction::Stage::kDone);
}

// 11 nobody can do, 12 is done in the end, 13 comes after 11.
TEST(TeamDesk, WhatNobodyCanDoWhenItIsCalledAgainEndsTheMissionWithEachReason) {
  TeamDesk ground = desk();
  GiveGlobalMission give = mission_of(1, 11);
  for (const std::uint64_t task : {12, 13}) {
    give.mission.tasks.push_back(give.mission.tasks[0]);
    give.mission.tasks.back().task.id = mission::GoalId(task);
  }
  give.mission.tasks[2].after = {mission::GoalId(11)};
  ground.handle(give, at(1));
  std::uint64_t revision = 0;
  const auto stands = [&](auction::Stage first, auction::Stage second) {
    auto ledger = std::make_shared<auction::Ledger>();
    ledger->term = 1;
    ledger->revision = ++revision;
    for (const auto& [task, stage] :
         {std::pair(11, first), std::pair(12, second), std::pair(13, auction::Stage::kOwned)}) {
      auction::LedgerEntry& entry = ledger->entries[auction::TaskNumber(task)];
      entry.task.number = auction::TaskNumber(task);
      entry.stage = stage;
      entry.why = stage == auction::Stage::kUnsold ? "marvin: no camera; heliv: too far" : "";
    }
    return all<GlobalMissionChanged>(
        ground.handle(TeamHeard{"marvin", auction::Beat{1, revision, ledger}},
                      at(2.0 + static_cast<double>(revision))));
  };
  using auction::Stage;

  EXPECT_THAT(stands(Stage::kUnsold, Stage::kGranted), IsEmpty());
  EXPECT_THAT(stands(Stage::kForSale, Stage::kGranted), IsEmpty());
  EXPECT_THAT(stands(Stage::kUnsold, Stage::kGranted), IsEmpty()) << "12 goes on";
  const auto over = stands(Stage::kUnsold, Stage::kDone);
  ASSERT_THAT(over, SizeIs(1));
  EXPECT_EQ(over[0].stage, GlobalStage::kRefused);
  EXPECT_THAT(over[0].why, HasSubstr("nobody can do what is left: task 11"));
  EXPECT_THAT(over[0].why, HasSubstr("marvin: no camera; heliv: too far"));
  EXPECT_THAT(stands(Stage::kForSale, Stage::kDone), IsEmpty());
  EXPECT_THAT(stands(Stage::kUnsold, Stage::kDone), IsEmpty()) << "said once";

  EXPECT_THAT(stands(Stage::kOwned, Stage::kDone), IsEmpty());
  EXPECT_THAT(stands(Stage::kUnsold, Stage::kDone), IsEmpty()) << "it is called again first";
  EXPECT_THAT(stands(Stage::kForSale, Stage::kDone), IsEmpty());
  EXPECT_THAT(stands(Stage::kUnsold, Stage::kDone), SizeIs(1));
}

// The holder of the token calls it no more: the second call never comes. It was said at 9 s that
// nobody could, by whoever is heard no more, or that it is over.
TEST(TeamDesk, WhatIsTooLateEndsTheMissionWithoutAnotherCallAndSaysSo) {
  const auto told = [](bool pinned, MissionTime then) {
    TeamDesk ground = desk();
    if (pinned) ground.handle(DegreeChanged{"heliv", 3}, at(0));
    GiveGlobalMission give = mission_of(1, 11);
    if (pinned) give.mission.tasks[0].by = "heliv";
    ground.handle(give, at(1));
    auto ledger = std::make_shared<auction::Ledger>();
    ledger->term = 1;
    ledger->revision = 1;
    auction::LedgerEntry& entry = ledger->entries[auction::TaskNumber(11)];
    entry.task.number = auction::TaskNumber(11);
    entry.task.duration = 20;
    entry.task.deadline = 120;
    entry.stage = auction::Stage::kUnsold;
    entry.why = "marvin: no camera";
    EXPECT_THAT(all<GlobalMissionChanged>(
                    ground.handle(TeamHeard{"marvin", auction::Beat{1, 1, ledger}}, at(9))),
                IsEmpty());
    EXPECT_THAT(all<GlobalMissionChanged>(ground.handle(Tick{}, at(100))), IsEmpty());
    const auto over = all<GlobalMissionChanged>(ground.handle(Tick{}, then));
    EXPECT_THAT(all<GlobalMissionChanged>(ground.handle(Tick{}, then)), IsEmpty()) << "said once";
    return over;
  };

  for (const bool pinned : {false, true}) {
    const auto over = told(pinned, at(101));
    ASSERT_THAT(over, SizeIs(1));
    EXPECT_EQ(over[0].stage, GlobalStage::kRefused);
    EXPECT_EQ(over[0].why,
              "nobody can do what is left: task 11 (): nobody can do it in time any more: its "
              "deadline is 120 s, and it had to begin by 100 s");
  }
}

// Found by reading: the mission was over while its operator had the UAV in hand.
TEST(TeamDesk, WhatIsPinnedToOneWhoseDegreeIsLowWaitsForItAndSaysSo) {
  TeamDesk ground = desk();
  ground.handle(DegreeChanged{"heliv", 3}, at(0));
  GiveGlobalMission give = mission_of(1, 11);
  give.mission.tasks[0].by = "heliv";
  ground.handle(give, at(1));
  std::uint64_t revision = 0;
  const auto stands = [&](auction::Stage stage) {
    ++revision;
    return ground.handle(beat(stage, revision), at(2.0 + static_cast<double>(revision)));
  };
  using auction::Stage;

  for (int call = 0; call < 3; ++call) {
    const auto unsold = stands(Stage::kUnsold);
    EXPECT_THAT(all<GlobalMissionChanged>(unsold), IsEmpty());
    ASSERT_THAT(all<TeamTaskChanged>(unsold), SizeIs(1));
    EXPECT_THAT(all<TeamTaskChanged>(unsold)[0].standing.why,
                HasSubstr("heliv, which it is pinned to, does not bid at degree 3"));
    stands(Stage::kForSale);
  }
  ground.handle(DegreeChanged{"heliv", 5}, at(20));
  EXPECT_THAT(all<GlobalMissionChanged>(stands(Stage::kUnsold)), IsEmpty());
  stands(Stage::kForSale);
  EXPECT_THAT(all<GlobalMissionChanged>(stands(Stage::kUnsold)), SizeIs(1));
}

// Found by an outsider's missions: the one whose task it is was the only one of whom nothing was
// said.
TEST(TeamDesk, WhatIsPinnedToOneWhoIsLostOrDoesNotAnswerSaysSo) {
  const auto told = [](bool lost, bool found, const std::string& others) {
    TeamDesk ground = desk();
    GiveGlobalMission give = mission_of(1, 11);
    give.mission.tasks[0].by = "heliv";
    ground.handle(give, at(1));
    if (lost) ground.handle(DeclareLost{"heliv"}, at(2));
    if (found) ground.handle(DeclareFound{"heliv"}, at(3));
    std::vector<std::string> whys;
    for (std::uint64_t call = 1; call < 4; ++call) {
      for (const auction::Stage stage : {auction::Stage::kUnsold, auction::Stage::kForSale}) {
        TeamHeard book = beat(stage, 2 * call + (stage == auction::Stage::kForSale ? 1 : 0));
        auto& ledger = std::get<auction::Beat>(book.message).ledger;
        auto changed = std::make_shared<auction::Ledger>(*ledger);
        changed->entries[auction::TaskNumber(11)].why = others;
        ledger = changed;
        const auto effects = ground.handle(book, at(10.0 * static_cast<double>(call)));
        for (const auto& task : all<TeamTaskChanged>(effects))
          if (task.standing.stage == auction::Stage::kUnsold) whys.push_back(task.standing.why);
        for (const auto& mission : all<GlobalMissionChanged>(effects)) whys.push_back(mission.why);
      }
    }
    return whys;
  };
  const std::string given_away = "marvin: the operator gives it to another";

  EXPECT_THAT(told(true, false, given_away), Contains(HasSubstr("nobody can do what is left")));
  EXPECT_THAT(told(true, false, given_away),
              Each(HasSubstr(given_away + "; heliv, which it is pinned to, is declared lost")));
  EXPECT_THAT(told(true, true, given_away),
              Each(HasSubstr(given_away + "; heliv, which it is pinned to, does not answer")));
  EXPECT_THAT(told(false, false, given_away + "; heliv: it lacks camera"),
              Each(HasSubstr("it lacks camera")));
  EXPECT_THAT(told(false, false, given_away + "; heliv: it lacks camera"),
              Each(Not(HasSubstr("pinned"))));
}

// What this member still has to say to the holder, by numbers of tasks.
std::vector<std::vector<std::uint64_t>> lots_of(const auction::Status& status) {
  std::vector<std::vector<std::uint64_t>> lots;
  for (const auction::GivenMission& mission : status.missions) {
    std::vector<std::uint64_t>& tasks = lots.emplace_back();
    for (const auction::Task& task : mission.lot.tasks) tasks.push_back(task.number.value());
  }
  return lots;
}

// 11 now, 12 about the first alarm, 13 after 12, 14 about the second.
TEST(TeamDesk, WhatNamesAnAlarmWaitsForItWithAllThatComesAfter) {
  TeamDesk ground = desk();
  GiveGlobalMission give = mission_of(1, 11);
  for (const std::uint64_t task : {12, 13, 14}) {
    give.mission.tasks.push_back(give.mission.tasks[0]);
    give.mission.tasks.back().task.id = mission::GoalId(task);
  }
  give.mission.tasks[1].task.arguments = {std::string("alarm:1")};
  give.mission.tasks[2].after = {mission::GoalId(12)};
  give.mission.tasks[3].task.arguments = {std::string("alarm:2")};
  auto empty = std::make_shared<auction::Ledger>();
  empty->term = 1;
  const auto told = [&](std::uint64_t revision) {
    empty->revision = revision;
    return lots_of(
        answer_of(ground.handle(TeamHeard{"marvin", auction::Beat{1, revision, empty}}, at(2))));
  };

  const auto given = ground.handle(give, at(1));
  const auto first = told(1);
  ground.handle(PlaceKnown{"alarm:1"}, at(3));
  const auto then = told(2);
  ground.handle(PlaceKnown{"alarm:1"}, at(4));
  ground.handle(PlaceKnown{"alarm:2"}, at(5));
  const auto last = told(3);

  const auto waiting = all<TeamTaskChanged>(given);
  ASSERT_THAT(waiting, SizeIs(3));
  EXPECT_THAT(waiting[0].standing.why, HasSubstr("waits at the ground station"));
  EXPECT_THAT(first, ElementsAre(ElementsAre(11)));
  EXPECT_THAT(then, ElementsAre(ElementsAre(11), ElementsAre(12, 13)));
  EXPECT_THAT(last, ElementsAre(ElementsAre(11), ElementsAre(12, 13), ElementsAre(14)));
}

TEST(TeamDesk, WhoIsLostIsSaidToTheTeamAndAStrangerIsNot) {
  TeamDesk ground = desk();
  ground.handle(DeclareLost{"heliv"}, at(1));

  const auto told = ground.handle(beat(auction::Stage::kOwned, 1), at(2));

  EXPECT_TRUE(answer_of(told).losses.is_lost(auction::MemberNumber(1)));
  EXPECT_THAT(all<Anomaly>(ground.handle(DeclareLost{"karma"}, at(3))), SizeIs(1));
}

TEST(TeamDesk, WhoIsFoundAgainIsSaidToTheTeam) {
  TeamDesk ground = desk();
  ground.handle(DeclareLost{"heliv"}, at(1));
  ground.handle(DeclareFound{"heliv"}, at(1.5));

  const auto told = ground.handle(beat(auction::Stage::kOwned, 1), at(2));

  EXPECT_FALSE(answer_of(told).losses.is_lost(auction::MemberNumber(1)));
  EXPECT_THAT(answer_of(told).losses.turns(), SizeIs(1)) << "who knows of the loss alone hears it";
  EXPECT_THAT(all<Anomaly>(ground.handle(DeclareFound{"karma"}, at(3))), SizeIs(1));
}

TEST(TeamDesk, WithoutAHolderItStandsForTheToken) {
  TeamDesk ground = desk();
  ground.handle(Tick{}, at(0));
  ASSERT_TRUE(ground.next_wakeup().has_value());

  EXPECT_THAT(all<TeamTell>(ground.handle(Tick{}, *ground.next_wakeup())), SizeIs(2));
}

TEST(TeamDesk, StagesOfMissionsHaveNames) {
  EXPECT_EQ(to_text(GlobalStage::kRefused), "refused");
  EXPECT_EQ(to_text(GlobalStage::kGiven), "given");
  EXPECT_EQ(to_text(GlobalStage::kDone), "done");
}

}  // namespace
}  // namespace skein::ground_station
