// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/team.hpp"

namespace skein::auction {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr Abilities kCamera = 1, kInfrared = 2;

TEST(Sale, EachTaskGoesToWhomItCostsLeast) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0}).add_task({90, 0}).add_task({20, 0});

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(outcome.routes[0].tasks, ElementsAre(task_number(0), task_number(2)));
  EXPECT_THAT(outcome.routes[1].tasks, ElementsAre(task_number(1)));
  EXPECT_DOUBLE_EQ(outcome.value.first, 30);
}

TEST(Sale, EquitySpreadsWhatTheSumWouldPile) {
  Team team{{{{0, 0}}, {{40, 40}}}, {}, {}, {}, {}};
  for (int i = 1; i <= 8; ++i) team.add_task({10.0 * i, 0});

  const SaleOutcome piled = team.sell();
  team.aim.equity = 1;
  const SaleOutcome spread = team.sell();

  EXPECT_THAT(piled.routes[1].tasks, IsEmpty());
  EXPECT_FALSE(spread.routes[1].tasks.empty());
  EXPECT_LT(spread.value.first, piled.routes[0].end);
}

TEST(Sale, OfARouteAndItsReverseThatAreWorthTheSameTheOneWhoseTasksEndFirstIsSold) {
  FlatVehicle comes_home{{0, 0}};
  comes_home.end = Place{0, 0};
  Team team{{comes_home}, {}, {}, {}, {}};
  team.add_task({100, 0}).add_task({10, 0}, 5).add_task({10, 40}, 5);

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(outcome.routes[0].tasks, ElementsAre(task_number(1), task_number(0), task_number(2)));
}

TEST(Sale, NoRouteHomeIsSoldWhoseTasksWouldEndSoonerTheOtherWayRound) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Team team = random_team(2, 6, seed);
    team.aim.equity = 0.5;
    for (FlatVehicle& vehicle : team.vehicles) vehicle.end = vehicle.begin;
    const SaleOutcome outcome = team.sell();

    for (const auto& route : outcome.routes) {
      double there = 0, back = 0;
      for (const double start : route.starts) {
        there += start;
        back += route.end - start;  // tasks that take no time
      }
      EXPECT_LE(there, back + 1e-3) << "seed " << seed;
    }
  }
}

TEST(Sale, EverySaleSaysWhoElseCouldAndWhatThatWouldHaveCost) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0});

  const auto sold = told<Sold>(team.sell());

  ASSERT_THAT(sold, SizeIs(1));
  EXPECT_THAT(sold[0].members, ElementsAre(member_number(0)));
  ASSERT_TRUE(sold[0].next_best);
  EXPECT_THAT(sold[0].next_best->members, ElementsAre(member_number(1)));
  EXPECT_DOUBLE_EQ(sold[0].value.first, 10);
  EXPECT_DOUBLE_EQ(sold[0].next_best->value.first, 90);
}

TEST(Sale, AJointTaskHasAllItsMembersAtOnce) {
  Team team{{{{0, 0}}, {{100, 0}}, {{0, 900}}}, {}, {1}, {}, {}};
  team.add_task({10, 0}, 50).last().least_members = 2;

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(members_of(outcome, task_number(0)), ElementsAre(member_number(0), member_number(1)));
  EXPECT_DOUBLE_EQ(start_of(outcome, task_number(0)), 90);
}

TEST(Sale, AJointTaskThatLacksAMemberHasNone) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0}).last().least_members = 3;
  team.add_task({20, 0});

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(members_of(outcome, task_number(0)), IsEmpty());
  EXPECT_THAT(members_of(outcome, task_number(1)), SizeIs(1));
  const auto unsold = told<Unsold>(outcome);
  ASSERT_THAT(unsold, SizeIs(1));
  EXPECT_THAT(unsold[0].together, HasSubstr("too few"));
}

TEST(Sale, AbilitiesAreCoveredTogetherByAsFewAsSuffice) {
  Team team{{{{0, 0}, {}, 1, kCamera},
             {{5, 0}, {}, 1, kInfrared},
             {{500, 0}, {}, 1, kCamera | kInfrared}},
            {},
            {1},
            {},
            {}};
  team.add_task({10, 0}).last().needs = kCamera | kInfrared;

  EXPECT_THAT(members_of(team.sell(), task_number(0)),
              ElementsAre(member_number(0), member_number(1)));

  team.vehicles[2].begin = {12, 0};
  EXPECT_THAT(members_of(team.sell(), task_number(0)), ElementsAre(member_number(2)));
}

TEST(Sale, AMissionNobodyCanDoIsSaidAtOnceWithTheReasonOfEach) {
  Team team{{{{0, 0}, {}, 1, kCamera}, {{5, 0}, {}, 1, kCamera}}, {}, {}, {}, {}};
  team.add_task({10, 0}).last().needs = kInfrared;
  team.last().forbidden = {member_number(1)};

  const SaleOutcome outcome = team.sell();

  const auto unsold = told<Unsold>(outcome);
  ASSERT_THAT(unsold, SizeIs(1));
  ASSERT_THAT(unsold[0].reasons, SizeIs(2));
  EXPECT_THAT(unsold[0].reasons[0].why, HasSubstr("abilities"));
  EXPECT_THAT(unsold[0].reasons[1].why, HasSubstr("operator"));
  EXPECT_EQ(outcome.rounds, 1U);
}

TEST(Sale, APrecedenceHoldsBetweenVehicles) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {1}, {}, {}};
  team.add_task({10, 0}, 30).add_task({95, 0}, 5);
  team.lot.precedences = {{task_number(0), task_number(1)}};

  const SaleOutcome outcome = team.sell();

  EXPECT_DOUBLE_EQ(start_of(outcome, task_number(0)), 10);
  EXPECT_DOUBLE_EQ(start_of(outcome, task_number(1)), 40);
}

TEST(Sale, WindowsAndDeadlinesHold) {
  Team team{{{{0, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0}, 5).last().earliest = 60;
  team.add_task({50, 0}, 5).last().deadline = 55;

  const SaleOutcome outcome = team.sell();

  EXPECT_DOUBLE_EQ(start_of(outcome, task_number(1)), 50);
  EXPECT_DOUBLE_EQ(start_of(outcome, task_number(0)), 95);
}

TEST(Sale, ADeadlineThatNobodyMeetsIsToldAndTheRestIsSold) {
  Team team{{{{0, 0}}}, {}, {}, {}, {}};
  team.add_task({50, 0}).last().deadline = 49;
  team.add_task({60, 0});

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(outcome.routes[0].tasks, ElementsAre(task_number(1)));
  const auto unsold = told<Unsold>(outcome);
  ASSERT_THAT(unsold, SizeIs(1));
  EXPECT_THAT(unsold[0].reasons[0].why, HasSubstr("no time"));
}

TEST(Sale, ALotThatContradictsItselfIsNotSold) {
  Team team{{{{0, 0}}}, {}, {}, {}, {}};
  team.add_task({1, 0}).add_task({2, 0});
  team.lot.precedences = {{task_number(0), task_number(1)}, {task_number(1), task_number(0)}};

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(told<Rejected>(outcome), SizeIs(1));
  EXPECT_EQ(outcome.messages, 0U);
}

TEST(Sale, TheOperatorPinsAndForbids) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0}).last().pinned = member_number(1);
  team.add_task({90, 0}).last().forbidden = {member_number(1)};

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(members_of(outcome, task_number(0)), ElementsAre(member_number(1)));
  EXPECT_THAT(members_of(outcome, task_number(1)), ElementsAre(member_number(0)));
}

TEST(Sale, EnergyLimitsWhatAMemberTakes) {
  Team team{{{{0, 0}}, {{0, 100}}}, {}, {}, {}, {}};
  team.add_task({10, 0}).add_task({20, 0}).add_task({0, 30}).add_task({0, 40});
  EXPECT_THAT(team.sell().routes[1].tasks, IsEmpty());
  team.vehicles[0].energy = 25;

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(outcome.routes[0].tasks, ElementsAre(task_number(0), task_number(1)));
  EXPECT_THAT(outcome.routes[1].tasks, SizeIs(2));
}

TEST(Sale, WhatIsCommittedDoesNotMove) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {}, {}, {}};
  team.add_task({90, 0}).add_task({95, 0}).add_task({5, 0});
  team.holdings = {{member_number(0), {task_number(0), task_number(1)}, 1},
                   {member_number(1), {}, 0}};

  const SaleOutcome outcome = team.sell();

  EXPECT_EQ(outcome.routes[0].tasks.front(), task_number(0));
  EXPECT_THAT(members_of(outcome, task_number(0)), ElementsAre(member_number(0)));
}

TEST(Sale, OneThatComesLateTakesOverWork) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {1}, {}, {}};
  for (int i = 1; i <= 9; ++i) team.add_task({10.0 * i, 0});
  std::vector<TaskNumber> all;
  for (std::size_t i = 0; i < 9; ++i) all.push_back(task_number(i));
  team.holdings = {{member_number(0), all, 1}, {member_number(1), {}, 0}};

  const SaleOutcome outcome = team.sell();

  EXPECT_GE(outcome.routes[1].tasks.size(), 4U);
  EXPECT_FALSE(told<Sold>(outcome).empty());
  for (const Sold& sold : told<Sold>(outcome)) EXPECT_TRUE(sold.trade);
}

TEST(Sale, AWinnerThatVanishesLosesWhatItWasToHave) {
  Team team{{{{0, 0}}, {{100, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0}).add_task({90, 0});
  std::map<MemberNumber, int> heard;
  team.present = [&heard](MemberNumber member, MissionTime) {
    return member != member_number(0) || ++heard[member] == 1;  // offers, then nothing
  };

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(outcome.routes[0].tasks, IsEmpty());
  EXPECT_THAT(outcome.routes[1].tasks, SizeIs(2));
  const auto dropped = told<Dropped>(outcome);
  ASSERT_THAT(dropped, SizeIs(1));
  EXPECT_THAT(dropped[0].why, HasSubstr("award"));
}

TEST(Sale, WhoDoesNotAnswerIsNamedAndTheOthersGoOn) {
  Team team{{{{0, 0}}, {{100, 0}}, {{50, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0}).add_task({90, 0});
  team.present = [](MemberNumber member, MissionTime) { return member != member_number(0); };

  const SaleOutcome outcome = team.sell();

  EXPECT_THAT(told<Unsold>(outcome), IsEmpty());
  ASSERT_THAT(told<Dropped>(outcome), SizeIs(1));
  EXPECT_EQ(told<Dropped>(outcome)[0].member, member_number(0));
}

TEST(Sale, NobodyThereLeavesEverythingUnsoldAndSaysSo) {
  Team team{{{{0, 0}}}, {}, {}, {}, {}};
  team.add_task({10, 0});
  team.present = [](MemberNumber, MissionTime) { return false; };

  const SaleOutcome outcome = team.sell();

  ASSERT_THAT(told<Unsold>(outcome), SizeIs(1));
  EXPECT_THAT(told<Unsold>(outcome)[0].reasons[0].why, HasSubstr("does not answer"));
}

TEST(Sale, TheOrderInWhichAnswersComeDoesNotMatter) {
  Team team = random_team(4, 12, 5);
  const SaleOutcome quick = team.sell();
  team.transport.seed = 77;
  team.transport.longest = Duration::milliseconds(200);

  const SaleOutcome slow = team.sell();

  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(quick.routes[i].tasks, slow.routes[i].tasks);
  EXPECT_EQ(quick.messages, slow.messages);
}

TEST(Sale, OneSeedIsOneSale) {
  const Team team = random_team(3, 15, 8);

  const SaleOutcome once = team.sell(), again = team.sell();

  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(once.routes[i].tasks, again.routes[i].tasks);
  EXPECT_EQ(once.ended, again.ended);
}

}  // namespace
}  // namespace skein::auction
