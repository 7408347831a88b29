// SPDX-License-Identifier: Apache-2.0
// A member whose craft is not ready answers no call yet, and forgets none.
#include <gtest/gtest.h>

#include <set>

#include "skein/auction/team_member.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

struct AnyWay : Craft {
  Abilities abilities() const override { return 0; }
  std::optional<Leg> leg(Stopover, Stopover) const override { return Leg{1, 1, 0}; }
};

// As if its ways were planned for 0.8 s.
TEST(KeptCalls, OneOfItsOwnWaitsUntilThereIsACraft) {
  TeamSetup setup;
  setup.self = MemberNumber(0);
  setup.roster = {MemberNumber(0)};
  std::set<MissionTime> without;
  bool ready = false;
  setup.craft = [&](const auto&, MissionTime since) -> std::unique_ptr<const Craft> {
    without.insert(since);
    return ready ? std::make_unique<const AnyWay>() : nullptr;
  };
  TeamMember one(std::move(setup));
  one.handle(Bids{true}, at(0));
  Task task;
  task.number = TaskNumber(5);
  one.handle(MissionGiven{{MissionNumber(1), {{task}, {}}}}, at(0.1));
  double now = 0.2;
  for (; without.empty() && now < 20; now += 0.1) one.handle(Tick{}, at(now));
  for (int i = 0; i < 8; ++i, now += 0.1) one.handle(Tick{}, at(now));
  EXPECT_EQ(one.ledger().entries.at(TaskNumber(5)).stage, Stage::kForSale);

  ready = true;
  std::size_t offered = 0;
  for (int i = 0; i < 20; ++i, now += 0.1)
    for (const TeamEffect& effect : one.handle(Tick{}, at(now)))
      offered += std::holds_alternative<Offered>(effect) ? 1 : 0;

  EXPECT_EQ(without.size(), 1U) << "since when it has had none stays";
  EXPECT_EQ(offered, 1U) << "though its auctioneer asked again";
  EXPECT_EQ(one.ledger().entries.at(TaskNumber(5)).stage, Stage::kGranted);
}

ToMember call_for(std::uint32_t task) {
  Task one;
  one.number = TaskNumber(task);
  return Call{SaleNumber(7), 1, std::make_shared<const Catalogue>(Lot{{one}, {}}), {}, 0,
              {one.number},  0};
}

// As two send them that hold a token in one term, or anybody on the wire.
TEST(Calls, OfOneNumberForDifferentTasksAreAnsweredEachByACraftOfItsOwn) {
  TeamSetup setup;
  setup.self = MemberNumber(0);
  setup.roster = {MemberNumber(0), MemberNumber(1), MemberNumber(2)};
  std::vector<TaskNumber> made_for;
  setup.craft = [&](const auto& lot, MissionTime) {
    made_for.push_back(lot->lot().tasks.at(0).number);
    return std::make_unique<const AnyWay>();
  };
  TeamMember one(std::move(setup));
  const auto hear = [&](std::uint32_t from, std::uint32_t task, double second) {
    one.handle(Heard{MemberNumber(from), call_for(task)}, at(second));
  };

  hear(1, 5, 1);
  hear(1, 5, 1.3);
  hear(2, 6, 1.5);

  EXPECT_EQ(made_for, (std::vector{TaskNumber(5), TaskNumber(6)}));
}

}  // namespace
}  // namespace skein::auction
