// SPDX-License-Identifier: Apache-2.0
// Bids wait for the ways around what straight flights go through: not for long, and in small jobs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "level_world.hpp"
#include "skein/decision_node/decision_node.hpp"
#include "skein/team/global_mission.hpp"
#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using auction::TaskNumber;
using testing::all;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kWallAt = 50;  // [m] east, between the UAV at the origin and the places

// A team of two, with `places` to "go" to, 20 m apart behind a wall.
Config walled(std::uint32_t places) {
  Config config;
  config.uav = "marvin";
  config.others = {"heliv"};
  config.degree = 5;
  auto knowledge = std::make_shared<supervisor::Knowledge>();
  knowledge->uav = "marvin";
  knowledge->vehicle.cruise_speed = 5;
  knowledge->vehicle.max_speed = 10;
  knowledge->vehicle.climb_rate = knowledge->vehicle.descent_rate = 2;
  knowledge->vehicle.ceiling = 200;
  knowledge->vehicle.energy.capacity = 1e6;
  knowledge->team = {"marvin", "heliv"};
  knowledge->vocabulary.tasks["go"] = {"go", {mission::ParameterKind::kPlace}, {}};
  auto world = std::make_shared<world::World>(skein::testing::level_world(2000));
  for (std::uint32_t i = 1; i <= places; ++i)
    world->places["P" + std::to_string(i)] = {100 + 20.0 * i, 0, 0};
  world->volumes.push_back(
      {"wall",
       {{kWallAt, -300}, {kWallAt + 10, -300}, {kWallAt + 10, 300}, {kWallAt, 300}},
       0,
       500,
       {}});
  config.knowledge = knowledge;
  config.world = world;
  config.team = team::Config{team::Roster({"marvin", "heliv", "ground"}), {}, 1};
  return config;
}

class Behind {
 public:
  explicit Behind(std::uint32_t places, Config config) : node_(std::move(config)) {
    give(Started{});
    world::Telemetry telemetry;
    telemetry.uav = "marvin";
    give(telemetry);
    auto ledger = std::make_shared<auction::Ledger>();
    ledger->term = 2;
    ledger->revision = 1;
    auction::Lot lot;
    for (std::uint32_t i = 1; i <= places; ++i) {
      auction::LedgerEntry& entry = ledger->entries[TaskNumber(i)];
      entry.task.number = TaskNumber(i);
      mission::HighLevelTask task;
      task.id = mission::GoalId(i);
      task.name = "go";
      task.arguments = {"P" + std::to_string(i)};
      entry.task.work = std::make_shared<const team::Order>(task, "operator");
      lot.tasks.push_back(entry.task);
    }
    lot_ = std::make_shared<const auction::Catalogue>(std::move(lot));
    give(TeamTold{"heliv", auction::Beat{2, 1, ledger}});
  }
  explicit Behind(std::uint32_t places) : Behind(places, walled(places)) {}

  Effects give(const Input& input) { return node_.handle(input, now_); }
  Effects call(std::uint64_t sale = 1) {
    std::vector<TaskNumber> items;
    for (const auction::Task& task : lot_->lot().tasks) items.push_back(task.number);
    return give(TeamTold{
        "heliv", auction::Call{auction::SaleNumber(sale), 1, lot_, {}, 0, items, 0, false}});
  }
  // A job comes back with the first `count` of its legs, each longer by so much.
  Effects planned(const StartDetours& job, std::size_t count, supervisor::Detour detour) {
    return give(DetoursPlanned{job.job, {std::min(count, job.request.legs.size()), detour}});
  }
  void wait(double seconds) { now_ = now_ + Duration::seconds(seconds); }
  MissionTime now() const { return now_; }
  std::optional<MissionTime> next_wakeup() const { return node_.next_wakeup(); }

 private:
  MissionTime now_;
  DecisionNode node_;
  std::shared_ptr<const auction::Catalogue> lot_;
};

const supervisor::Detour kLonger{true, Duration::seconds(90), 9000};
constexpr supervisor::Detour kNoWayThere{false, {}, 0};

std::size_t offers(const Effects& effects) {
  std::size_t count = 0;
  for (const SendTeam& sent : all<SendTeam>(effects))
    count += std::holds_alternative<auction::ToAuctioneer>(sent.message) ? 1 : 0;
  return count;
}

TEST(TeamDetours, ACallIsAnsweredOnceTheWaysAreThereWithWhatTheyCostMore) {
  Behind marvin(1), straight(1);
  const Effects called = marvin.call();
  const auto jobs = all<StartDetours>(called);
  ASSERT_THAT(jobs, SizeIs(1));
  EXPECT_EQ(offers(called), 0U);
  EXPECT_THAT(jobs[0].request.legs, SizeIs(2)) << "there, and home from there";

  marvin.wait(0.3);
  const Effects told = marvin.planned(jobs[0], 2, kLonger);

  straight.call();
  straight.wait(1);
  const auto bids = all<BidNoted>(told), plain = all<BidNoted>(straight.give(Tick{}));
  EXPECT_EQ(offers(told), 1U);
  ASSERT_THAT(bids, SizeIs(1));
  ASSERT_THAT(plain, SizeIs(1));
  EXPECT_NEAR(bids[0].added.value_or(0), plain[0].added.value_or(0) + 180, 1e-6);
}

TEST(TeamDetours, ACallIsAnsweredAfterASecondWithoutThem) {
  Behind marvin(1);
  marvin.call();
  EXPECT_LE(marvin.next_wakeup().value_or(MissionTime::max()), MissionTime::seconds(1));
  marvin.wait(0.9);
  EXPECT_EQ(offers(marvin.give(Tick{})), 0U);

  marvin.wait(0.1);
  EXPECT_EQ(offers(marvin.give(Tick{})), 1U);
  EXPECT_GT(marvin.next_wakeup().value_or(MissionTime::max()), marvin.now());
}

TEST(TeamDetours, WhatAJobHadNoTimeForIsPlannedByTheNextAndOneJobRunsAtATime) {
  Behind marvin(3);
  const auto first = all<StartDetours>(marvin.call());
  ASSERT_THAT(first, SizeIs(1));
  ASSERT_THAT(first[0].request.legs, SizeIs(6)) << "between them the air is free";
  marvin.wait(0.1);
  EXPECT_THAT(all<StartDetours>(marvin.give(Tick{})), IsEmpty());

  const Effects some = marvin.planned(first[0], 4, kLonger);
  const auto second = all<StartDetours>(some);
  ASSERT_THAT(second, SizeIs(1));
  EXPECT_EQ(offers(some), 0U);
  ASSERT_THAT(second[0].request.legs, SizeIs(2));
  EXPECT_EQ(second[0].request.legs[0].from, first[0].request.legs[4].from);

  EXPECT_EQ(offers(marvin.planned(second[0], 2, kLonger)), 1U);
}

TEST(TeamDetours, AJobHasSoManyLegsAtTheMost) {
  Behind marvin(80);

  const auto jobs = all<StartDetours>(marvin.call());

  ASSERT_THAT(jobs, SizeIs(1));
  EXPECT_LE(jobs[0].request.legs.size(), 64U);
}

TEST(TeamDetours, WhatIsKnownIsNotPlannedAgain) {
  Behind marvin(1);
  marvin.planned(all<StartDetours>(marvin.call(1))[0], 2, kLonger);

  const Effects again = marvin.call(2);

  EXPECT_THAT(all<StartDetours>(again), IsEmpty());
  EXPECT_EQ(offers(again), 1U);
}

TEST(TeamDetours, WhereNothingIsInTheWayNobodyWaits) {
  Config config = walled(3);
  auto open = std::make_shared<world::World>(*config.world);
  open->volumes.clear();
  config.world = open;
  Behind marvin(3, std::move(config));

  const Effects called = marvin.call();

  EXPECT_THAT(all<StartDetours>(called), IsEmpty());
  EXPECT_EQ(offers(called), 1U);
}

TEST(TeamDetours, ItDoesNotBidForWhatNoWayLeadsToAndSaysWhy) {
  Behind marvin(1);
  const auto jobs = all<StartDetours>(marvin.call());

  const auto bids = all<BidNoted>(marvin.planned(jobs.at(0), 2, kNoWayThere));

  ASSERT_THAT(bids, SizeIs(1));
  EXPECT_EQ(bids[0].added, std::nullopt);
  EXPECT_EQ(bids[0].objection, "there is no way to it");
}

TEST(TeamDetours, WhatASensorMaySeeFromElsewhereIsBidForAllTheSame) {
  Config config = walled(1);
  auto knowledge = std::make_shared<supervisor::Knowledge>(*config.knowledge);
  world::SensorModel camera;
  camera.device = "camera";
  knowledge->vehicle.sensors = {camera};
  knowledge->vocabulary.tasks["go"].uses = {"sight"};
  knowledge->vocabulary.serves.emplace("camera", "sight");
  config.knowledge = knowledge;
  Behind marvin(1, std::move(config));
  const auto jobs = all<StartDetours>(marvin.call());

  const auto bids = all<BidNoted>(marvin.planned(jobs.at(0), 2, kNoWayThere));

  ASSERT_THAT(bids, SizeIs(1));
  EXPECT_NE(bids[0].added, std::nullopt);
}

TEST(TeamDetours, OfAnOlderWorldNothingIsTaken) {
  Behind marvin(1);
  const auto before = all<StartDetours>(marvin.call());
  marvin.give(Command{
      {1, 7},
      mission::ChangeWorld{world::Volume{"more", {{60, 0}, {70, 0}, {70, 9}}, 0, 500, {}}, false}});

  const Effects late = marvin.planned(before.at(0), 2, kLonger);

  EXPECT_EQ(offers(late), 0U);
}

}  // namespace
}  // namespace skein::decision_node
