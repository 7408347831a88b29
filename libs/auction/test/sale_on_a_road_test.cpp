// SPDX-License-Identifier: Apache-2.0
// Whole sales: calls out, offers in, until nobody gains.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "skein/foundation/random.hpp"
#include "testing/naive_plan.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<TaskNumber> tasks(std::vector<std::uint32_t> numbers) {
  return {numbers.begin(), numbers.end()};
}
std::vector<MemberNumber> team_of(std::vector<std::uint32_t> numbers) {
  return {numbers.begin(), numbers.end()};
}

TEST(SaleOnARoad, WhatLiesNearerIsBoughtByWhoIsNearer) {
  RoadSale team({{a_task(1).at(10), a_task(2).at(20), a_task(3).at(80), a_task(4).at(90)}, {}},
                {0, 100});

  team.hold();

  EXPECT_THAT(team.route(0), ::testing::UnorderedElementsAreArray(tasks({1, 2})));
  EXPECT_THAT(team.route(1), ::testing::UnorderedElementsAreArray(tasks({3, 4})));
  EXPECT_EQ(team.sale->value().first, 80);
  EXPECT_EQ(team.ends, 1U);
  EXPECT_THAT(team.unsold, IsEmpty());
}

TEST(SaleOnARoad, EquityGivesTheSecondOfTwoNearTasksToWhoIsFar) {
  RoadSale team({{a_task(1).at(10).lasting(100), a_task(2).at(10).lasting(100)}, {}}, {0, 30});
  team.aim.equity = 1;

  team.hold();

  EXPECT_THAT(team.route(0), SizeIs(1));
  EXPECT_THAT(team.route(1), SizeIs(1));
  EXPECT_EQ(team.sale->value().first, 140) << "20 there, 100 of work, 20 back";
}

TEST(SaleOnARoad, WhoeverBuysIsToldWithTheNextBestAndBothValues) {
  RoadSale team({{a_task(1).at(10)}, {}}, {0, 100});

  team.hold();

  ASSERT_THAT(team.sold, SizeIs(1));
  EXPECT_EQ(team.sold[0].members, team_of({0}));
  EXPECT_EQ(team.sold[0].value.first, 20);
  EXPECT_FALSE(team.sold[0].trade);
  EXPECT_EQ(team.sold[0].round, 1U);
  ASSERT_TRUE(team.sold[0].next_best);
  EXPECT_EQ(team.sold[0].next_best->members, team_of({1}));
  EXPECT_EQ(team.sold[0].next_best->value.first, 180);
}

TEST(SaleOnARoad, WhereNobodyElseCouldThereIsNoNextBest) {
  RoadSale team({{a_task(1).at(10).needing(0b10)}, {}}, {0, 100});
  team.crafts[1].able = 0b10;

  team.hold();

  ASSERT_THAT(team.sold, SizeIs(1));
  EXPECT_EQ(team.sold[0].members, team_of({1}));
  EXPECT_FALSE(team.sold[0].next_best);
}

TEST(SaleOnARoad, ThePinnedMemberHasItHoweverFarItIs) {
  RoadSale team({{a_task(1).at(10).pinned(1), a_task(2).at(10).not_for(0)}, {}}, {0, 100});

  team.hold();

  EXPECT_THAT(team.route(0), IsEmpty());
  EXPECT_THAT(team.route(1), SizeIs(2));
}

TEST(SaleOnARoad, WhatNobodyCanIsToldWithTheReasonOfEach) {
  RoadSale team({{a_task(1).at(10).needing(0b10)}, {}}, {0, 100});
  team.crafts[1].able = 0b10;
  team.crafts[1].objections[TaskNumber(1)] = "its camera is broken";

  team.hold();

  ASSERT_THAT(team.unsold, SizeIs(1));
  ASSERT_THAT(team.unsold[0].reasons, SizeIs(2));
  EXPECT_EQ(team.unsold[0].reasons[0].why, "it has none of the abilities");
  EXPECT_EQ(team.unsold[0].reasons[1].why, "its camera is broken");
  EXPECT_EQ(team.unsold[0].together, "");
}

// That the other finds no time for it would be untrue: it must not.
TEST(SaleOnARoad, WhoMustNotSinceItIsPinnedToAnotherSaysSo) {
  RoadSale team({{a_task(1).at(10).needing(1).pinned(0)}, {}}, {0, 100});
  team.crafts[0].objections[TaskNumber(1)] = "its camera is broken";

  team.hold();

  ASSERT_THAT(team.unsold, SizeIs(1));
  ASSERT_THAT(team.unsold[0].reasons, SizeIs(2));
  EXPECT_EQ(team.unsold[0].reasons[0].why, "its camera is broken");
  EXPECT_EQ(team.unsold[0].reasons[1].why, "the operator gives it to another");
}

TEST(SaleOnARoad, WhatCannotBeBesideTheOthersIsToldAtTheEndWithoutAnObjection) {
  RoadSale team({{a_task(1).at(10).lasting(50).by(60), a_task(2).at(10).lasting(50).by(60)}, {}},
                {0});

  team.hold();

  ASSERT_THAT(team.unsold, SizeIs(1));
  EXPECT_EQ(team.unsold[0].reasons.at(0).why,
            "it finds no time for it, or no energy, beside what is sold");
  EXPECT_THAT(team.route(0), SizeIs(1));
  EXPECT_EQ(team.sale->value().unsold, 1U);
}

TEST(SaleOnARoad, TooFewOfThoseThatCouldIsSaidOfTheGroup) {
  RoadSale team({{a_task(1).at(10).members(2)}, {}}, {0, 100});
  team.crafts[1].objections[TaskNumber(1)] = "its camera is broken";

  team.hold();

  ASSERT_THAT(team.unsold, SizeIs(1));
  EXPECT_EQ(team.unsold[0].together, "those that could are too few");
}

TEST(SaleOnARoad, AnAbilityThatTheWillingLackTogetherIsSaidOfTheGroup) {
  RoadSale team({{a_task(1).at(10).needing(0b111)}, {}}, {0, 100});
  team.crafts[0].able = 0b001;
  team.crafts[1].able = 0b010;

  team.hold();

  ASSERT_THAT(team.unsold, SizeIs(1));
  EXPECT_EQ(team.unsold[0].together, "those that could lack an ability between them");
}

TEST(SaleOnARoad, AJointTaskHasAllItsMembersAndBeginsWhenTheLastIsThere) {
  RoadSale team({{a_task(1).at(10).members(2).lasting(5)}, {}}, {0, 100, 500});

  team.hold();

  ASSERT_THAT(team.sold, SizeIs(1));
  EXPECT_EQ(team.sold[0].members, team_of({0, 1}));
  for (const std::size_t m : {0, 1}) {
    EXPECT_THAT(team.sale->routes()[m].starts, ElementsAre(90));
  }
  EXPECT_THAT(team.route(2), IsEmpty());
}

TEST(SaleOnARoad, AbilitiesAreBroughtTogetherByNoMoreMembersThanItTakes) {
  RoadSale team({{a_task(1).at(10).needing(0b11)}, {}}, {0, 20, 30});
  team.crafts[0].able = 0b01;
  team.crafts[1].able = 0b01;
  team.crafts[2].able = 0b10;

  team.hold();

  ASSERT_THAT(team.sold, SizeIs(1));
  EXPECT_THAT(team.sold[0].members, SizeIs(2));
  EXPECT_EQ(team.sold[0].members[1], MemberNumber(2));
}

TEST(SaleOnARoad, APrecedenceHoldsBetweenTwoMembers) {
  RoadSale team({{a_task(1).at(0).lasting(50).pinned(0), a_task(2).at(100).pinned(1)},
                 {{TaskNumber(1), TaskNumber(2)}}},
                {0, 100});

  team.hold();

  EXPECT_THAT(team.sale->routes()[1].starts, ElementsAre(50));
}

TEST(SaleOnARoad, ALotThatContradictsItselfIsRejectedWithoutACall) {
  RoadSale team({{a_task(1).lasting(10).by(5)}, {}}, {0});

  team.hold();

  ASSERT_THAT(team.rejected, SizeIs(1));
  EXPECT_THAT(team.rejected[0].contradictions, SizeIs(1));
  EXPECT_THAT(team.sent, IsEmpty());
  EXPECT_EQ(team.ends, 0U);
  EXPECT_TRUE(team.sale->ended());
  EXPECT_FALSE(team.sale->next_wakeup());
}

TEST(SaleOnARoad, NobodyToCallEndsItWithEveryTaskUnsold) {
  RoadSale team({{a_task(1)}, {}}, {});

  team.hold();

  EXPECT_THAT(team.unsold, SizeIs(1));
  EXPECT_EQ(team.ends, 1U);
}

TEST(SaleOnARoad, WhatIsCommittedDoesNotMoveAndTheRestIsTraded) {
  RoadSale team({{a_task(1).at(90), a_task(2).at(95)}, {}}, {0, 100});
  team.holdings[0] = {MemberNumber(0), tasks({1, 2}), 1};

  team.hold();

  EXPECT_EQ(team.route(0), tasks({1}));
  EXPECT_EQ(team.route(1), tasks({2}));
  ASSERT_THAT(team.sold, SizeIs(1));
  EXPECT_TRUE(team.sold[0].trade);
}

TEST(SaleOnARoad, NoMoreAreOfferedInARoundThanTheLimitSays) {
  RoadSale team({{a_task(1).at(1), a_task(2).at(2), a_task(3).at(3)}, {}}, {0});
  team.limits.together = 2;

  team.hold();

  EXPECT_THAT(std::get<Call>(team.sent.at(0).message).items,
              ElementsAre(TaskNumber(1), TaskNumber(2)));
  EXPECT_THAT(team.route(0), SizeIs(3));
  EXPECT_THAT(team.sold, SizeIs(::testing::Ge(3)));
}

TEST(SaleOnARoad, ItEndsAtTheMostRoundsThoughTradesMightGain) {
  RoadSale team({{a_task(1).at(1), a_task(2).at(2)}, {}}, {0, 5});
  team.limits.most_rounds = 3;

  team.hold();

  EXPECT_EQ(team.sale->rounds(), 3U);
}

TEST(SaleOnARoad, ItEndsAfterSoManyRoundsWithoutGain) {
  RoadSale team({{a_task(1).at(1), a_task(2).at(2)}, {}}, {0});
  team.limits.patience = 4;

  team.hold();

  EXPECT_EQ(team.sale->rounds(), 5U) << "one that sells, four that gain nothing";
}

// ---- silence ----

// More tasks than are offered together: those of rounds that nobody is left for are told as well.
TEST(SilenceInASale, WhatIsNotOfferedToAnybodyAnyMoreIsToldUnsoldToo) {
  RoadSale team({{a_task(1), a_task(2), a_task(3), a_task(4), a_task(5)}, {}}, {0});
  team.limits.together = 2;
  team.silent = [](const Send&) { return true; };

  team.hold();

  std::set<TaskNumber> told;
  for (const Unsold& one : team.unsold) told.insert(one.task);
  EXPECT_EQ(told.size(), 5U);
  EXPECT_EQ(team.unsold.size(), 5U);
}

TEST(SilenceInASale, WhoMissesACallIsDroppedAndTheOthersBuy) {
  RoadSale team({{a_task(1).at(10)}, {}}, {0, 100});
  team.silent = [](const Send& send) { return send.to == MemberNumber(0); };

  team.hold();

  ASSERT_THAT(team.dropped, SizeIs(1));
  EXPECT_EQ(team.dropped[0].member, MemberNumber(0));
  EXPECT_EQ(team.dropped[0].why, "did not answer a call");
  EXPECT_EQ(team.dropped[0].round, 1U);
  EXPECT_EQ(team.route(1), tasks({1}));
}

TEST(SilenceInASale, WhoIsDroppedIsNotCalledAgain) {
  RoadSale team({{a_task(1).at(10), a_task(2).at(20)}, {}}, {0, 100});
  team.silent = [](const Send& send) { return send.to == MemberNumber(0); };

  team.hold();

  const auto called = std::count_if(team.sent.begin(), team.sent.end(),
                                    [](const Send& send) { return send.to == MemberNumber(0); });
  EXPECT_EQ(called, 4) << "once, and three times again within the time to answer";
}

TEST(SilenceInASale, WhoMissesAnAwardIsDroppedAndItsTaskSoldToAnother) {
  RoadSale team({{a_task(1).at(10)}, {}}, {0, 100});
  team.silent = [](const Send& send) {
    return send.to == MemberNumber(0) && std::holds_alternative<Award>(send.message);
  };

  team.hold();

  ASSERT_THAT(team.dropped, SizeIs(1));
  EXPECT_EQ(team.dropped[0].why, "did not answer an award");
  EXPECT_THAT(team.route(0), IsEmpty());
  EXPECT_EQ(team.route(1), tasks({1}));
}

TEST(SilenceInASale, NobodyAnswersAndEachTaskIsUnsoldForThat) {
  RoadSale team({{a_task(1), a_task(2)}, {}}, {0, 100});
  team.silent = [](const Send&) { return true; };

  team.hold();

  ASSERT_THAT(team.unsold, SizeIs(2));
  for (const auto& reason : team.unsold[1].reasons) EXPECT_EQ(reason.why, "it does not answer");
  EXPECT_THAT(team.dropped, SizeIs(2));
  EXPECT_EQ(team.ends, 1U);
}

TEST(SilenceInASale, WhoIsSilentKeepsWhatItHad) {
  RoadSale team({{a_task(1).at(90), a_task(2).at(95)}, {}}, {0, 100});
  team.holdings[0] = {MemberNumber(0), tasks({1, 2}), 0};
  team.silent = [](const Send& send) { return send.to == MemberNumber(0); };

  team.hold();

  EXPECT_EQ(team.route(0), tasks({1, 2}));
  EXPECT_THAT(team.route(1), IsEmpty());
}

TEST(SilenceInASale, TheTimeToAnswerIsOverAtItsEndAndNotBefore) {
  RoadSale team({{a_task(1)}, {}}, {0});
  team.limits.answer_within = Duration::seconds(2);
  auto sale = team.auctioneer();
  sale->start(at(10));

  EXPECT_THAT(sale->tick(at(10.4999)), IsEmpty());
  EXPECT_THAT(sale->tick(at(11.9999)), SizeIs(1)) << "said again";
  EXPECT_EQ(sale->next_wakeup(), at(12)) << "not after the end";
  const auto late = sale->tick(at(12));
  EXPECT_TRUE(std::holds_alternative<Dropped>(late.at(0)));
}

TEST(SilenceInASale, ARefusedAwardIsSaidWithItsReasonAndTheTaskGoesToTheNext) {
  RoadSale team({{a_task(1).at(10)}, {}}, {0, 100});
  team.answered = [&team](const Send& send) {
    ToAuctioneer said = team.answer(send);
    auto* answer = std::get_if<Answer>(&said);
    if (answer != nullptr && send.to == MemberNumber(0)) answer->refusal = "its battery is low";
    return said;
  };

  team.hold();

  ASSERT_THAT(team.dropped, SizeIs(1));
  EXPECT_EQ(team.dropped[0].why, "its battery is low");
  EXPECT_EQ(team.route(1), tasks({1}));
}

// ---- against all allocations ----

RoadSale small_sale(Random& random, bool coupled) {
  Lot lot;
  for (std::uint32_t n = 0; n < 4; ++n) {
    RoadTask task = a_task(n).at(random.uniform(0, 100)).lasting(random.uniform(0, 20));
    if (random.chance(0.3)) task.from(random.uniform(0, 100));
    if (random.chance(0.3)) task.by(random.uniform(130, 400));
    if (random.chance(0.2)) task.not_for(static_cast<std::uint32_t>(random.below(2)));
    lot.tasks.push_back(task);
  }
  if (coupled) lot.precedences.push_back({TaskNumber(2), TaskNumber(0)});
  RoadSale team(std::move(lot), {random.uniform(0, 100), random.uniform(0, 100)});
  team.aim.equity = random.uniform();
  team.limits.patience = 40;
  if (random.chance(0.3)) team.crafts[0].joules = random.uniform(20, 200);
  return team;
}

bool may(const RoadSale& team, std::uint32_t member, std::uint32_t task) {
  return !team.catalogue->task(task).forbidden.contains(MemberNumber(member));
}

// All orders of the tasks, cut everywhere into what each of two does and what nobody does.
std::optional<Value> best_of_all(const RoadSale& team) {
  std::optional<Value> best;
  std::vector<std::uint32_t> order(team.catalogue->size());
  std::iota(order.begin(), order.end(), 0U);
  do {
    for (std::size_t one = 0; one <= order.size(); ++one) {
      for (std::size_t two = one; two <= order.size(); ++two) {
        NaivePlan::Routes routes(2);
        bool allowed = true;
        for (std::size_t i = 0; i < two; ++i) {
          const std::uint32_t who = i < one ? 0 : 1;
          allowed = allowed && may(team, who, order[i]);
          routes[who].emplace_back(order[i]);
        }
        const auto value = allowed ? NaivePlan(team, routes).value(team.aim) : std::nullopt;
        if (value && (!best || better(*value, *best))) best = value;
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

void expect_laws_of_a_sale(std::uint64_t seed, bool coupled) {
  Random random(seed, "small sales");
  RoadSale team = small_sale(random, coupled);
  team.hold();

  NaivePlan walked(team, {team.route(0), team.route(1)});
  const auto value = walked.value(team.aim);
  RC_ASSERT(value.has_value());
  RC_ASSERT(value->unsold == team.sale->value().unsold);
  RC_ASSERT(std::abs(value->first - team.sale->value().first) < 1e-5);
  RC_ASSERT(team.unsold.size() == value->unsold);
  for (const Auctioneer::Route& route : team.sale->routes()) {
    for (std::size_t i = 0; i < route.tasks.size(); ++i) {
      RC_ASSERT(may(team, route.member.value(), route.tasks[i].value()));
      RC_ASSERT(std::abs(route.starts.at(i) - walked.start(route.tasks[i])) < 1e-6);
    }
  }
  const auto best = best_of_all(team);
  RC_ASSERT(!better(*value, *best));
}

RC_GTEST_PROP(SmallSale, SaysWhatItsRoutesAreWorthAndNeverMoreThanTheBest, (std::uint64_t seed)) {
  expect_laws_of_a_sale(seed, false);
}

RC_GTEST_PROP(SmallSale, HoldsWithPrecedencesToo, (std::uint64_t seed)) {
  expect_laws_of_a_sale(seed, true);
}

TEST(SmallSale, IsNearlyAlwaysTheBestOfAllAllocations) {
  int best = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed, "small sales");
    RoadSale team = small_sale(random, false);
    team.hold();
    best += better(*best_of_all(team), team.sale->value()) ? 0 : 1;
  }
  EXPECT_GE(best, 95);
}

// ---- what is left over ----

TEST(SaleOnARoad, WhatNobodyCouldTakeIsSoldOnceATradeMakesRoomForIt) {
  // Member 0 is nearer to 1, and has the time for one of them only.
  RoadSale team({{a_task(1).at(10).lasting(30).by(60), a_task(2).at(40).by(45).not_for(1)}, {}},
                {0, 30});
  team.limits.together = 1;  // 1 is sold before 2 is called
  team.limits.trade = 2;

  team.hold();

  EXPECT_EQ(team.route(0), tasks({2}));
  EXPECT_EQ(team.route(1), tasks({1}));
  EXPECT_EQ(team.sale->value().unsold, 0U);
}

}  // namespace
}  // namespace skein::auction
