// SPDX-License-Identifier: Apache-2.0
#include "draft.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "skein/auction/bidder.hpp"
#include "skein/foundation/random.hpp"
#include "winners.hpp"

namespace skein::auction {
namespace {

using ::testing::IsEmpty;

TaskNumber number(std::size_t n) { return TaskNumber(static_cast<std::uint32_t>(n)); }

// In the plane, straight, at 1 m/s.
class PlaneCraft : public Craft {
 public:
  PlaneCraft(Place begin, Abilities abilities, const Catalogue& lot)
      : begin_(begin), abilities_(abilities), lot_(&lot) {}
  Abilities abilities() const override { return abilities_; }
  std::optional<Leg> leg(Stopover from, Stopover to) const override {
    if (to.is_end()) return Leg{};
    const Place a = from.is_begin() ? begin_ : lot_->task(from.task()).at;
    const Place b = lot_->task(to.task()).at;
    const double way = std::hypot(a.x - b.x, a.y - b.y);
    return Leg{way, way, way};
  }

 private:
  Place begin_;
  Abilities abilities_;
  const Catalogue* lot_;
};

// A random lot of which everything is on sale, with the offers of three members.
struct Market {
  explicit Market(std::uint64_t seed, bool coupled) : random(seed, "draft") {
    Lot all;
    for (std::size_t i = 0; i < 7; ++i) {
      Task task;
      task.number = number(i);
      task.at = place();
      task.duration = random.uniform(0, 20);
      if (random.chance(0.2)) task.earliest = random.uniform(0, 100);
      if (random.chance(0.2)) task.deadline = random.uniform(150, 400);
      if (coupled && random.chance(0.4)) task.least_members = 2;
      all.tasks.push_back(task);
    }
    if (coupled) all.precedences = {{number(0), number(3)}, {number(5), number(1)}};
    lot = std::make_shared<const Catalogue>(std::move(all));
    for (std::size_t i = 0; i < 7; ++i) items.push_back(number(i));
    for (std::uint32_t m = 0; m < 3; ++m) {
      const PlaneCraft craft(place(), 1, *lot);
      offers.push_back(
          Bidder(MemberNumber(m), craft).price({SaleNumber(1), 1, lot, {}, 0, items, 0, true}));
    }
  }

  Place place() { return {random.uniform(0, 100), random.uniform(0, 100)}; }

  Draft draft(Aim aim) const {
    Draft made(*lot, aim, items);
    for (const Offer& offer : offers) {
      BookedRoute route;
      route.member = offer.member;
      made.add(route, &offer);
    }
    return made;
  }

  Random random;
  std::shared_ptr<const Catalogue> lot;
  std::vector<TaskNumber> items;
  std::vector<Offer> offers;
};

struct DraftLaws : ::testing::TestWithParam<bool> {};

// Placing is what judging said it would be.
TEST_P(DraftLaws, APlacingIsJudgedExactlyWithoutBeingTried) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Market market(seed, GetParam());
    Draft draft = market.draft(Aim{seed % 2 == 0 ? 1.0 : 0.3});
    ASSERT_TRUE(draft.restore());
    for (std::uint32_t item = 0; item < draft.item_count(); ++item) {
      for (const Placing& placing : draft.placings(item, 5)) {
        Draft tried = draft;
        ASSERT_TRUE(tried.place(placing)) << "seed " << seed;
        EXPECT_EQ(tried.value().unsold, placing.value.unsold);
        EXPECT_NEAR(tried.value().first, placing.value.first, 1e-9) << "seed " << seed;
        EXPECT_NEAR(tried.value().second, placing.value.second, 1e-9) << "seed " << seed;
      }
      if (const auto all = draft.placings(item, 5); !all.empty()) {
        draft.place(all[market.random.below(all.size())]);
      }
    }
  }
}

// Dates of what winner determination leaves: everybody is there, everything before is over.
TEST_P(DraftLaws, WinnersHaveDatesThatHold) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Market market(seed, GetParam());
    Draft draft = market.draft(Aim{1});
    determine_winners(draft, market.random, 4);
    std::map<TaskNumber, std::uint32_t> members;
    for (std::size_t r = 0; r < draft.route_count(); ++r) {
      double free = 0;
      const auto tasks = draft.tasks(r);
      const auto legs = draft.legs(r);
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        const Task& task = market.lot->task(tasks[i]);
        const double start = draft.start(tasks[i]);
        ASSERT_GE(start, free + legs[i].seconds - 1e-9);
        ASSERT_GE(start, task.earliest);
        free = start + task.duration;
        ASSERT_LE(free, task.deadline);
        ++members[tasks[i]];
      }
    }
    for (const auto& [task, count] : members) {
      EXPECT_EQ(count, market.lot->task(task).least_members);
    }
    for (const Precedence& p : market.lot->lot().precedences) {
      if (!members.contains(p.first) || !members.contains(p.then)) continue;
      EXPECT_GE(draft.start(p.then),
                draft.start(p.first) + market.lot->task(p.first).duration - 1e-9);
    }
  }
}

TEST_P(DraftLaws, RestoringTakesTheItemsOutAgain) {
  Market market(9, GetParam());
  Draft draft = market.draft(Aim{0});
  determine_winners(draft, market.random, 2);
  ASSERT_TRUE(draft.restore());

  EXPECT_EQ(draft.value().unsold, draft.item_count());
  EXPECT_EQ(draft.value().first, 0);
  for (std::size_t r = 0; r < draft.route_count(); ++r) EXPECT_THAT(draft.tasks(r), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(AloneAndTogether, DraftLaws, ::testing::Bool());

}  // namespace
}  // namespace skein::auction
