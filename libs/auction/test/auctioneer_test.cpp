// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/auctioneer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "skein/auction/bidder.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class LineCraft : public Craft {
 public:
  explicit LineCraft(double begin) : begin_(begin) {}
  Abilities abilities() const override { return 1; }
  std::optional<Leg> leg(Stopover from, Stopover to) const override {
    if (to.is_end()) return Leg{};
    const double a = from.is_begin() ? begin_ : 10.0 * from.task().value();
    const double way = std::abs(a - 10.0 * to.task().value());
    return Leg{way, way, way};
  }

 private:
  double begin_;
};

Lot four_tasks() {
  Lot lot;
  for (std::uint32_t n = 1; n <= 4; ++n) {
    Task task;
    task.number = TaskNumber(n);
    task.at = {10.0 * n, 0};
    lot.tasks.push_back(task);
  }
  return lot;
}

struct AuctioneerTest : ::testing::Test {
  AuctioneerTest() {
    SaleSetup setup{SaleNumber(7),
                    std::make_shared<const Catalogue>(four_tasks()),
                    {{MemberNumber(0), {}, 0}, {MemberNumber(1), {}, 0}},
                    {},
                    {},
                    1};
    auctioneer = std::make_unique<Auctioneer>(std::move(setup));
  }

  static std::vector<Send> sent(const SaleEffects& effects) {
    std::vector<Send> sends;
    for (const SaleEffect& effect : effects) {
      if (const auto* send = std::get_if<Send>(&effect)) sends.push_back(*send);
    }
    return sends;
  }
  ToAuctioneer answer(const Send& send) const {
    const LineCraft& craft = send.to == MemberNumber(0) ? left : right;
    return Bidder(send.to, craft).handle(send.message);
  }

  LineCraft left{0}, right{45};
  std::unique_ptr<Auctioneer> auctioneer;
};

TEST_F(AuctioneerTest, EverybodyIsCalledFirst) {
  const auto calls = sent(auctioneer->start(at(0)));

  ASSERT_THAT(calls, SizeIs(2));
  EXPECT_THAT(std::get<Call>(calls[0].message).items, SizeIs(4));
  EXPECT_EQ(auctioneer->rounds(), 1U);
}

// As a ledger may have them that was put together after a cut.
TEST(Auctioneer, SellsRoutesThatWaitForEachOtherAnew) {
  const auto number = [](std::uint32_t n) { return TaskNumber(n); };
  Lot lot = four_tasks();
  lot.precedences = {{number(1), number(2), {}}, {number(3), number(4), {}}};
  const MemberNumber one(0), other(1);
  SaleLimits without_trades;
  without_trades.patience = 1;
  Auctioneer auctioneer({SaleNumber(7),
                         std::make_shared<const Catalogue>(lot),
                         {{one, {number(2), number(3)}, 0}, {other, {number(4), number(1)}, 0}},
                         {},
                         without_trades,
                         1});
  const LineCraft craft(0);
  SaleEffects all = auctioneer.start(at(0));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto* send = std::get_if<Send>(&all[i]);
    if (send == nullptr) continue;
    const ToAuctioneer said = Bidder(send->to, craft).handle(send->message);
    for (SaleEffect& effect : auctioneer.handle(said, at(0.1))) all.push_back(std::move(effect));
  }

  ASSERT_TRUE(std::holds_alternative<Ended>(all.back()));
  std::set<TaskNumber> held;
  for (const auto& route : auctioneer.routes()) {
    held.insert(route.tasks.begin(), route.tasks.end());
    const auto place = [&](std::uint32_t n) { return std::ranges::find(route.tasks, number(n)); };
    const auto end = route.tasks.end();
    EXPECT_TRUE(place(1) == end || place(2) == end || place(1) < place(2));
    EXPECT_TRUE(place(3) == end || place(4) == end || place(3) < place(4));
  }
  const auto routes = auctioneer.routes();
  const bool as_before = routes[0].tasks == std::vector{number(2), number(3)} &&
                         routes[1].tasks == std::vector{number(4), number(1)};
  EXPECT_FALSE(as_before);
  EXPECT_THAT(held, SizeIs(4));
}

TEST_F(AuctioneerTest, NothingIsAwardedBeforeAllHaveAnswered) {
  const auto calls = sent(auctioneer->start(at(0)));

  EXPECT_THAT(auctioneer->handle(answer(calls[0]), at(0.1)), IsEmpty());
  const auto awards = sent(auctioneer->handle(answer(calls[1]), at(0.2)));

  ASSERT_FALSE(awards.empty());
  for (const Send& award : awards) EXPECT_TRUE(std::holds_alternative<Award>(award.message));
}

TEST_F(AuctioneerTest, AnAnswerSaidTwiceCountsOnce) {
  const auto calls = sent(auctioneer->start(at(0)));

  EXPECT_THAT(auctioneer->handle(answer(calls[0]), at(0.1)), IsEmpty());
  EXPECT_THAT(auctioneer->handle(answer(calls[0]), at(0.2)), IsEmpty());
}

TEST_F(AuctioneerTest, AnAnswerToAnotherSaleOrRoundHasNoEffect) {
  const auto calls = sent(auctioneer->start(at(0)));
  auctioneer->handle(answer(calls[0]), at(0.1));
  Offer offer = std::get<Offer>(answer(calls[1]));

  offer.sale = SaleNumber(6);
  EXPECT_THAT(auctioneer->handle(offer, at(0.2)), IsEmpty());
  offer.sale = SaleNumber(7);
  offer.round = 2;
  EXPECT_THAT(auctioneer->handle(offer, at(0.2)), IsEmpty());
  offer.round = 1;
  EXPECT_FALSE(auctioneer->handle(offer, at(0.2)).empty());
}

// As one with a defect, or with bad intentions, might answer.
TEST_F(AuctioneerTest, AnOfferThatIsNotAboutWhatWasAskedIsAsIfItHadNotCome) {
  const auto calls = sent(auctioneer->start(at(0)));
  auctioneer->handle(answer(calls[0]), at(0.1));
  const Offer sound = std::get<Offer>(answer(calls[1]));
  std::vector<Offer> odd(6, sound);
  odd[0].items.pop_back();
  odd[1].items[0].item = TaskNumber(99);
  odd[2].items[0].gaps[0].gap = 7;
  odd[3].legs.clear();
  odd[4].between.pop_back();
  odd[5].items[0].gaps.push_back(odd[5].items[0].gaps[0]);

  for (const Offer& offer : odd) {
    EXPECT_THAT(auctioneer->handle(offer, at(0.2)), IsEmpty());
  }
  const auto awards = sent(auctioneer->handle(sound, at(0.3)));
  ASSERT_FALSE(awards.empty());
  Answer taken = std::get<Answer>(answer(awards[0]));
  taken.legs.clear();
  EXPECT_THAT(auctioneer->handle(taken, at(0.4)), IsEmpty());
}

TEST_F(AuctioneerTest, WhoHasNotAnsweredIsAskedAgainBeforeItIsDropped) {
  const auto calls = sent(auctioneer->start(at(0)));
  auctioneer->handle(answer(calls[0]), at(0.1));

  EXPECT_EQ(auctioneer->next_wakeup(), at(0.5));
  const auto again = sent(auctioneer->tick(at(0.5)));
  ASSERT_THAT(again, SizeIs(1));
  EXPECT_EQ(again[0].to, MemberNumber(1));

  const SaleEffects late = auctioneer->tick(at(2));
  EXPECT_TRUE(std::holds_alternative<Dropped>(late.front()));
}

TEST_F(AuctioneerTest, BooksChangeOnlyWhenAllWinnersTookTheirRoutes) {
  auto open = sent(auctioneer->start(at(0)));
  std::vector<Send> awards;
  for (const Send& call : open) {
    for (Send& award : sent(auctioneer->handle(answer(call), at(0.1)))) awards.push_back(award);
  }
  ASSERT_THAT(awards, SizeIs(2));

  auctioneer->handle(answer(awards[0]), at(0.2));
  for (const auto& route : auctioneer->routes()) EXPECT_THAT(route.tasks, IsEmpty());
  auctioneer->handle(answer(awards[1]), at(0.3));
  EXPECT_THAT(auctioneer->routes()[0].tasks, ElementsAre(TaskNumber(1), TaskNumber(2)));
}

TEST_F(AuctioneerTest, ARefusalLeavesTheBooksAndIsNotOfferedAgain) {
  auto open = sent(auctioneer->start(at(0)));
  std::vector<Send> awards;
  for (const Send& call : open) {
    for (Send& award : sent(auctioneer->handle(answer(call), at(0.1)))) awards.push_back(award);
  }
  Answer refusal = std::get<Answer>(answer(awards[0]));
  refusal.refusal = "its battery is low";

  open = sent(auctioneer->handle(refusal, at(0.2)));

  for (const auto& route : auctioneer->routes()) EXPECT_THAT(route.tasks, IsEmpty());
  for (int step = 0; step < 2000 && !auctioneer->ended(); ++step) {
    std::vector<Send> next;
    for (const Send& one : open) {
      for (Send& send : sent(auctioneer->handle(answer(one), at(1)))) next.push_back(send);
    }
    open = std::move(next);
  }
  ASSERT_TRUE(auctioneer->ended());
  EXPECT_THAT(auctioneer->routes()[0].tasks, IsEmpty());
  EXPECT_THAT(auctioneer->routes()[1].tasks, SizeIs(4));
}

}  // namespace
}  // namespace skein::auction
