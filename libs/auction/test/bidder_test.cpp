// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/bidder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace skein::auction {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr Abilities kCamera = 1, kInfrared = 2;

// On a line: tasks lie at ten times their number, the plan begins at 0 and ends anywhere.
class LineCraft : public Craft {
 public:
  Abilities abilities() const override { return kCamera; }
  double energy() const override { return joules; }
  double energy_of(const Task&) const override { return 5; }
  std::optional<Leg> leg(Stopover from, Stopover to) const override {
    if (to.is_end()) return Leg{};
    const double way = std::abs(place(from) - place(to));
    if (way > reach) return std::nullopt;
    return Leg{way, way, way};
  }
  std::optional<std::string> objection(const Task& task) const override {
    if (task.duration > 100) return "longer than its battery lasts";
    return std::nullopt;
  }
  double joules = 1000, reach = 1000;

 private:
  static double place(Stopover of) { return of.is_begin() ? 0 : 10.0 * of.task().value(); }
};

struct BidderTest : ::testing::Test {
  Call call(std::vector<Task> tasks, std::vector<TaskNumber> route, std::vector<TaskNumber> items) {
    return {SaleNumber(1),
            1,
            std::make_shared<const Catalogue>(Lot{std::move(tasks), {}}),
            std::move(route),
            0,
            std::move(items),
            0,
            false};
  }
  static Task task(std::uint32_t n) {
    Task made;
    made.number = TaskNumber(n);
    return made;
  }
  LineCraft craft;
  Bidder bidder{MemberNumber(4), craft};
};

TEST_F(BidderTest, ABidIsThePriceOfEachGapOfTheRoute) {
  const Offer offer = bidder.price(
      call({task(1), task(2), task(3)}, {TaskNumber(1), TaskNumber(3)}, {TaskNumber(2)}));

  ASSERT_THAT(offer.items, SizeIs(1));
  const auto& gaps = offer.items[0].gaps;
  ASSERT_THAT(gaps, SizeIs(3));
  EXPECT_EQ(gaps[0].in.seconds + gaps[0].out.seconds, 30);  // 0, 20, 10
  EXPECT_EQ(gaps[1].in.seconds + gaps[1].out.seconds, 20);  // between 10 and 30: no detour
  EXPECT_EQ(gaps[2].in.seconds + gaps[2].out.seconds, 10);  // back from 30
}

TEST_F(BidderTest, ACallLeavesNothingBehind) {
  const Call first = call({task(1), task(2)}, {TaskNumber(1)}, {TaskNumber(2)});

  const Offer once = bidder.price(first);
  bidder.take({SaleNumber(1), 1, first.lot, {TaskNumber(2), TaskNumber(1)}});
  const Offer again = bidder.price(first);

  ASSERT_EQ(once.items[0].gaps.size(), again.items[0].gaps.size());
  EXPECT_EQ(once.legs[0].seconds, again.legs[0].seconds);
  EXPECT_EQ(once.energy, again.energy);
}

TEST_F(BidderTest, WhatIsFixedHasNoGaps) {
  Call asked = call({task(1), task(2), task(3)}, {TaskNumber(1), TaskNumber(3)}, {TaskNumber(2)});
  asked.fixed = 2;

  const Offer offer = bidder.price(asked);

  ASSERT_THAT(offer.items[0].gaps, SizeIs(1));
  EXPECT_EQ(offer.items[0].gaps[0].gap, 2U);
}

TEST_F(BidderTest, TheCheapestGapsAloneAreGivenIfSoAsked) {
  Call asked = call({task(1), task(2), task(3)}, {TaskNumber(1), TaskNumber(3)}, {TaskNumber(2)});
  asked.gaps = 1;

  const Offer offer = bidder.price(asked);

  ASSERT_THAT(offer.items[0].gaps, SizeIs(1));
  EXPECT_EQ(offer.items[0].gaps[0].gap, 1U);
}

TEST_F(BidderTest, EveryRefusalSaysWhy) {
  craft.reach = 45;
  Task forbidden = task(1), skilled = task(2), each = task(3), far = task(9), endless = task(4);
  forbidden.forbidden = {MemberNumber(4)};
  skilled.needs = kInfrared;
  each.needs_each = kCamera | kInfrared;
  endless.duration = 101;

  const Offer offer = bidder.price(
      call({forbidden, skilled, each, far, endless}, {},
           {TaskNumber(1), TaskNumber(2), TaskNumber(3), TaskNumber(9), TaskNumber(4)}));

  for (const ItemPrice& price : offer.items) EXPECT_THAT(price.gaps, IsEmpty());
  EXPECT_THAT(offer.items[0].objection, HasSubstr("operator"));
  EXPECT_THAT(offer.items[1].objection, HasSubstr("none of the abilities"));
  EXPECT_THAT(offer.items[2].objection, HasSubstr("every member"));
  EXPECT_THAT(offer.items[3].objection, HasSubstr("no way"));
  EXPECT_THAT(offer.items[4].objection, HasSubstr("battery"));
}

TEST_F(BidderTest, WhatTheRouteTakesIsNotOfferedTwice) {
  const Offer offer = bidder.price(call({task(1), task(3)}, {TaskNumber(3)}, {TaskNumber(1)}));

  EXPECT_EQ(offer.energy, 1000 - 30 - 5);
}

TEST_F(BidderTest, ARouteThatCannotBeFlownAnyMoreIsRefused) {
  const auto lot = std::make_shared<const Catalogue>(Lot{{task(1), task(3)}, {}});
  const Award award{SaleNumber(1), 1, lot, {TaskNumber(1), TaskNumber(3)}};
  EXPECT_FALSE(bidder.take(award).refusal);

  craft.joules = 39;  // 30 of way, 5 for each task
  EXPECT_THAT(*bidder.take(award).refusal, HasSubstr("energy"));

  craft.joules = 1000;
  craft.reach = 15;
  EXPECT_THAT(*bidder.take(award).refusal, HasSubstr("no way"));
}

}  // namespace
}  // namespace skein::auction
