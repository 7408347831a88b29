// SPDX-License-Identifier: Apache-2.0
#include "trade_picker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Ten tasks, a hundred metres apart; member i has tasks 2i and 2i + 1.
struct TradePickerTest : ::testing::Test {
  TradePickerTest() {
    Lot all;
    for (std::uint32_t n = 0; n < 10; ++n) all.tasks.push_back(a_task(n).at(100.0 * n));
    lot = std::make_unique<Catalogue>(std::move(all));
    for (std::uint32_t m = 0; m < 5; ++m) {
      BookedRoute route;
      route.member = MemberNumber(m);
      route.tasks = {TaskNumber(2 * m), TaskNumber(2 * m + 1)};
      books.push_back(route);
    }
  }
  TradePicker picker(std::uint64_t seed = 1) const { return {*lot, aim, limits, seed}; }
  template <class Check>
  void for_many_seeds(Check check) const {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      TradePicker one = picker(seed);
      check(one);
    }
  }

  std::unique_ptr<Catalogue> lot;
  std::vector<BookedRoute> books;
  Aim aim;
  SaleLimits limits;
};

TEST_F(TradePickerTest, FromTwoToTheLimitOfDifferentTasksArePutBack) {
  limits.trade = 4;
  std::set<std::size_t> sizes;

  for_many_seeds([&](TradePicker& one) {
    const auto items = one.items(books, 0, {});
    EXPECT_EQ(std::set<TaskNumber>(items.begin(), items.end()).size(), items.size());
    sizes.insert(items.size());
  });

  EXPECT_THAT(sizes, ElementsAre(2, 3, 4));
}

TEST_F(TradePickerTest, WhatIsFixedIsNeverPutBack) {
  for (BookedRoute& route : books) route.fixed = 1;

  for_many_seeds([&](TradePicker& one) {
    for (const TaskNumber item : one.items(books, 0, {})) EXPECT_EQ(item.value() % 2, 1U);
  });
}

// A joint task that one of its members has begun.
TEST_F(TradePickerTest, WhatIsFixedForOneMemberIsFixedForItsPartner) {
  books[0].tasks = {TaskNumber(0)};
  books[0].fixed = 1;
  books[1].tasks = {TaskNumber(3), TaskNumber(0)};
  books.resize(2);

  for_many_seeds(
      [&](TradePicker& one) { EXPECT_THAT(one.items(books, 0, {}), Each(TaskNumber(3))); });
}

TEST_F(TradePickerTest, WhereNothingMayMoveNothingIsPutBack) {
  for (BookedRoute& route : books) route.fixed = 2;

  EXPECT_THAT(picker().items(books, 0, {}), IsEmpty());
  EXPECT_THAT(picker().items({}, 0, {}), IsEmpty());
}

TEST_F(TradePickerTest, WhatIsLeftOverComesFirstAndWithWhatLiesNear) {
  books[4].tasks.clear();
  std::map<TaskNumber, int> beside;

  for_many_seeds([&](TradePicker& one) {
    const auto items = one.items(books, 0, {TaskNumber(8)});
    EXPECT_EQ(items.front(), TaskNumber(8));
    for (std::size_t i = 1; i < items.size(); ++i) ++beside[items[i]];
  });

  EXPECT_GT(beside[TaskNumber(7)], 2 * beside[TaskNumber(0)]);
}

TEST_F(TradePickerTest, NoMoreLeftOversThanTheLimitAreOfferedTogether) {
  limits.trade = 3;
  std::vector<TaskNumber> left;
  for (std::uint32_t n = 0; n < 8; ++n) left.emplace_back(n);

  EXPECT_THAT(picker().items({}, 0, left),
              ElementsAre(TaskNumber(0), TaskNumber(1), TaskNumber(2)));
}

TEST_F(TradePickerTest, WithEquityWhoEndsLastIsRelievedMoreOften) {
  const auto first_of_last = [&](double equity) {
    aim.equity = equity;
    int count = 0;
    for_many_seeds([&](TradePicker& one) {
      const TaskNumber first = one.items(books, 4, {}).front();
      count += first == TaskNumber(8) || first == TaskNumber(9) ? 1 : 0;
    });
    return count;
  };

  EXPECT_GT(first_of_last(1), first_of_last(0) + 40);
}

TEST_F(TradePickerTest, AllAreCalledWhileTheyAreNoMoreThanTheLimit) {
  limits.called = 5;
  EXPECT_THAT(picker().called(books, {TaskNumber(0)}), ElementsAre(0, 1, 2, 3, 4));

  limits.called = 4;
  for_many_seeds([&](TradePicker& one) {
    EXPECT_THAT(one.called(books, {TaskNumber(0)}), SizeIs(::testing::Le(4)));
  });
}

TEST_F(TradePickerTest, OwnersAreAlwaysCalledThenWhoIsNear) {
  limits.called = 3;

  for_many_seeds([&](TradePicker& one) {
    const auto called = one.called(books, {TaskNumber(0)});
    EXPECT_TRUE(called.contains(0));
    EXPECT_TRUE(called.contains(1)) << "the nearest to it";
  });
}

TEST_F(TradePickerTest, EveryOwnerIsCalledThoughTheyAreMoreThanTheLimit) {
  limits.called = 2;
  const std::vector<TaskNumber> items{TaskNumber(0), TaskNumber(4), TaskNumber(9)};

  for_many_seeds([&](TradePicker& one) {
    const auto called = one.called(books, items);
    for (const std::size_t owner : {0, 2, 4}) EXPECT_TRUE(called.contains(owner));
  });
}

TEST_F(TradePickerTest, WhoHasNothingIsCalledByChance) {
  limits.called = 2;
  books[4].tasks.clear();
  int called = 0;

  for_many_seeds(
      [&](TradePicker& one) { called += one.called(books, {TaskNumber(0)}).contains(4) ? 1 : 0; });

  EXPECT_GT(called, 15);
  EXPECT_LT(called, 80);
}

}  // namespace
}  // namespace skein::auction
