// SPDX-License-Identifier: Apache-2.0
// Areas shared out among unlike vehicles, with their sweeps.
#include "skein/refiners/partition.hpp"

#include <gtest/gtest.h>

#include "partition/division_law.hpp"

namespace skein::refiners {
namespace {

using division::area_of;
using division::lawful;
using testing::level_world;
using testing::three_unlike;
using world::Vector2;

/// Annex B of the thesis: three of different speed, swath and height, one convex area, starts on
/// its border. The figures are not in the text.
PartitionQuery annex_b() {
  PartitionQuery query;
  query.area = {{-350, -300}, {300, -380}, {520, 40}, {260, 420}, {-280, 360}, {-480, 20}};
  const double speeds[] = {6, 10, 12}, swaths[] = {30, 40, 60}, heights[] = {40, 60, 90};
  const Vector2 starts[] = {{-350, -300}, {520, 40}, {-280, 360}};
  for (std::size_t i = 0; i < 3; ++i) {
    Member member;
    member.uav = "uav" + std::to_string(i + 1);
    member.vehicle = testing::helicopter();
    member.speed = speeds[i];
    member.swath = swaths[i];
    member.altitude = heights[i];
    member.start = starts[i];
    query.members.push_back(member);
  }
  return query;
}

const world::World& ground() {
  static const world::World world = level_world(2000);
  return world;
}

Outcome<Partition> ask(const PartitionQuery& query, Budget budget = {}) {
  return refine(query, {ground(), std::move(budget)});
}

std::string refused(const PartitionQuery& query, RefusalKind kind) {
  const auto outcome = ask(query);
  if (outcome) return "not refused";
  EXPECT_EQ(outcome.error().kind, kind) << outcome.error().why;
  return outcome.error().field;
}

TEST(Partition, SharesOutInProportionOfSpeedTimesSwath) {
  const auto outcome = ask(annex_b());

  ASSERT_TRUE(outcome) << outcome.error().why;
  const auto& parts = outcome->task.parts;
  ASSERT_EQ(parts.size(), 3U);
  const double total = 6 * 30 + 10 * 40 + 12 * 60;
  EXPECT_NEAR(parts[0].share, 6 * 30 / total, 1e-12);
  EXPECT_NEAR(parts[1].share, 10 * 40 / total, 1e-12);
  EXPECT_NEAR(area_of(parts[2].polygon) / area_of(annex_b().area), 12 * 60 / total, 1e-9);
}

TEST(Partition, PartsObeyTheLawsOfDivide) {
  for (const ShareMode mode : {ShareMode::kProportional, ShareMode::kBalanced}) {
    PartitionQuery query = annex_b();
    query.mode = mode;

    const auto outcome = ask(query);

    ASSERT_TRUE(outcome);
    std::vector<world::Polygon> parts;
    std::vector<Vector2> starts;
    std::vector<double> shares;
    for (const Part& part : outcome->task.parts) {
      parts.push_back(part.polygon);
      shares.push_back(part.share);
      starts.push_back(part.anchor);
    }
    EXPECT_TRUE(lawful(query.area, starts, shares, parts));
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LT((starts[i] - query.members[i].start).norm(), 1e-6);
  }
}

TEST(Partition, TheThreeOfAnnexBFinishWithinFivePerCentWhenBalanced) {
  PartitionQuery query = annex_b();
  query.mode = ShareMode::kBalanced;

  const auto outcome = ask(query);

  ASSERT_TRUE(outcome) << outcome.error().why;
  EXPECT_LE(outcome->task.spread, 0.05);
}

TEST(Partition, TheSpreadAndTheCostAreThoseOfTheDurations) {
  const auto outcome = ask(annex_b());

  ASSERT_TRUE(outcome);
  double earliest = 1e18, latest = 0;
  for (const Part& part : outcome->task.parts) {
    earliest = std::min(earliest, part.duration.expected.to_seconds());
    latest = std::max(latest, part.duration.expected.to_seconds());
    EXPECT_LE(part.duration.least, part.duration.expected);
    EXPECT_LE(part.coverage.energy, 0.9);
    EXPECT_FALSE(part.coverage.way.empty());
  }
  EXPECT_NEAR(outcome->cost, latest, 1e-6);
  EXPECT_NEAR(outcome->task.spread, (latest - earliest) / latest, 1e-6);
  EXPECT_EQ(outcome->duration.expected, Duration::seconds(latest));
}

TEST(Partition, BalancingIsNeverLaterAndMeetsItsGoals) {
  Random random(5);
  std::vector<double> spreads, ratios;
  for (int i = 0; i < division::cases(40, 200); ++i) {
    PartitionQuery query = three_unlike(random);
    const auto proportional = ask(query);
    query.mode = ShareMode::kBalanced;
    const auto balanced = ask(query);
    ASSERT_TRUE(proportional && balanced);
    spreads.push_back(balanced->task.spread);
    ratios.push_back(balanced->cost / proportional->cost);
    EXPECT_LE(ratios.back(), 1 + 1e-12);
  }
  std::sort(spreads.begin(), spreads.end());
  std::sort(ratios.begin(), ratios.end());

  EXPECT_LE(spreads[spreads.size() / 2], 0.05);
  EXPECT_LE(ratios[ratios.size() / 2], 0.92);
}

/// What coverage reckons of none of them: seconds for each square metre, and for each metre that a
/// part is wide across.
double flown(const Member& member, const world::Polygon& part) {
  double low = part.front().x(), high = low;
  for (const Vector2& corner : part) {
    low = std::min(low, corner.x());
    high = std::max(high, corner.x());
  }
  return world::area(part) / (0.6 * member.speed * member.swath) + 0.4 * (high - low);
}

TEST(Partition, BalancedByWhatIsFlownAllEndTogetherByThat) {
  PartitionQuery query = annex_b();
  query.mode = ShareMode::kBalanced;
  const auto reckoned = ask(query);
  query.flown = [](const Member& member, double, const world::Polygon& part) {
    return std::optional(flown(member, part));
  };

  const auto outcome = ask(query);

  ASSERT_TRUE(reckoned && outcome);
  const auto spread_of = [&](const Partition& partition) {
    double first = 1e18, last = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double end = flown(query.members[i], partition.parts[i].polygon);
      first = std::min(first, end);
      last = std::max(last, end);
    }
    return (last - first) / last;
  };
  EXPECT_GT(spread_of(reckoned->task), 0.05) << "there is something to balance";
  EXPECT_LE(spread_of(outcome->task), 0.03);
  for (std::size_t i = 0; i < 3; ++i) {
    const Part& part = outcome->task.parts[i];
    EXPECT_NEAR(part.duration.expected.to_seconds(), flown(query.members[i], part.polygon), 1e-3);
  }
  EXPECT_NEAR(outcome->task.spread, spread_of(outcome->task), 1e-6);
}

TEST(Partition, WhereWhatIsFlownIsUnknownItIsBalancedByWhatIsReckoned) {
  PartitionQuery query = annex_b();
  query.mode = ShareMode::kBalanced;
  const auto reckoned = ask(query);
  query.flown = [](const Member&, double, const world::Polygon&) { return std::nullopt; };

  const auto outcome = ask(query);

  ASSERT_TRUE(reckoned && outcome);
  EXPECT_LE(outcome->cost, reckoned->cost);
  EXPECT_LE(outcome->task.spread, 0.05);
}

TEST(Partition, WhoIsBusyFirstGetsLessAndEndsWithTheOthers) {
  PartitionQuery query = annex_b();
  query.mode = ShareMode::kBalanced;
  const auto free = ask(query);
  query.members[2].busy = 300;
  const auto busy = ask(query);

  ASSERT_TRUE(free && busy);
  EXPECT_LT(busy->task.parts[2].share, free->task.parts[2].share);
  EXPECT_LT(busy->task.spread, 0.08);
  const Part& last = busy->task.parts[2];
  EXPECT_GT(last.duration.expected, Duration::seconds(300));
  EXPECT_GT(last.duration.least, Duration::seconds(300));
}

TEST(Partition, TheSameQueryGivesTheSameAnswer) {
  PartitionQuery query = annex_b();
  query.mode = ShareMode::kBalanced;

  const auto first = ask(query), second = ask(query);

  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->cost, second->cost);
  EXPECT_EQ(first->effort, second->effort);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(first->task.parts[i].polygon, second->task.parts[i].polygon);
}

TEST(Partition, GivenSharesAreKept) {
  PartitionQuery query = annex_b();
  for (std::size_t i = 0; i < 3; ++i) query.members[i].share = static_cast<double>(i + 1);

  const auto outcome = ask(query);

  ASSERT_TRUE(outcome);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(outcome->task.parts[i].share, static_cast<double>(i + 1) / 6, 1e-12);
}

TEST(Partition, OneMemberSweepsAll) {
  PartitionQuery query = annex_b();
  query.members.resize(1);
  query.members[0].vehicle.energy.capacity *= 10;
  query.mode = ShareMode::kBalanced;

  const auto outcome = ask(query);

  ASSERT_TRUE(outcome) << outcome.error().why;
  EXPECT_EQ(outcome->task.spread, 0);
  EXPECT_NEAR(outcome->task.parts[0].share, 1, 1e-12);
}

TEST(Partition, ALittleEnergyMeansASmallPart) {
  PartitionQuery query = annex_b();
  query.members[2].vehicle.energy.capacity /= 15;
  for (const ShareMode mode : {ShareMode::kProportional, ShareMode::kBalanced}) {
    query.mode = mode;

    const auto outcome = ask(query);

    ASSERT_TRUE(outcome) << outcome.error().why;
    EXPECT_LE(outcome->task.parts[2].coverage.energy, 0.9);
    EXPECT_LT(outcome->task.parts[2].share, 0.5);
  }
}

TEST(Partition, IsRefusedWhenAllTogetherLackTheEnergy) {
  PartitionQuery query = annex_b();
  for (Member& member : query.members) member.vehicle.energy.capacity /= 50;

  EXPECT_EQ(refused(query, RefusalKind::kBeyondVehicle), "members");
  query.mode = ShareMode::kBalanced;
  EXPECT_EQ(refused(query, RefusalKind::kBeyondVehicle), "members");
}

TEST(Partition, AShareThatTheEnergyDoesNotAllowIsRefused) {
  PartitionQuery query = annex_b();
  for (Member& member : query.members) member.share = 1;
  query.members[1].share = 1000;
  query.members[1].vehicle.energy.capacity /= 4;

  EXPECT_EQ(refused(query, RefusalKind::kBeyondVehicle), "members.1.share");
}

TEST(Partition, OfAnAreaOutsideTheWorldIsRefused) {
  PartitionQuery query = annex_b();
  for (world::Vector2& corner : query.area) corner.y() -= 1e6;

  EXPECT_EQ(refused(query, RefusalKind::kBadQuery), "area");
}

TEST(Partition, StartsVeryFarAwayAreFine) {
  PartitionQuery query = annex_b();
  query.mode = ShareMode::kBalanced;
  query.members[1].start = {3000, 0};

  const auto outcome = ask(query);

  ASSERT_TRUE(outcome) << outcome.error().why;
  EXPECT_GT(outcome->task.parts[1].share, 0);
}

TEST(Partition, StopsAtItsBudgetWithWhatItHas) {
  PartitionQuery query = annex_b();
  query.mode = ShareMode::kBalanced;
  Budget few;
  few.steps = 1;
  Budget none;
  none.time_is_up = [] { return true; };

  const auto by_steps = ask(query, few), by_time = ask(query, none);

  ASSERT_TRUE(by_steps && by_time);
  EXPECT_LE(by_steps->effort.steps, 3U);
  EXPECT_TRUE(by_time->effort.cut_short);
}

TEST(Partition, EachFaultOfAQueryIsNamed) {
  const auto with = [](auto change) {
    PartitionQuery query = annex_b();
    change(query);
    return refused(query, RefusalKind::kBadQuery);
  };
  const double nan = std::nan("");

  EXPECT_EQ(with([](auto& q) { q.area.push_back({0, 0}); }), "area");
  EXPECT_EQ(with([](auto& q) { q.area.resize(2); }), "area");
  EXPECT_EQ(with([](auto& q) { std::swap(q.area[1], q.area[3]); }), "area");
  EXPECT_EQ(with([&](auto& q) { q.area[1].x() = nan; }), "area.1");
  EXPECT_EQ(with([](auto& q) { q.members.clear(); }), "members");
  EXPECT_EQ(with([](auto& q) { q.members.resize(65, q.members[0]); }), "members");
  EXPECT_EQ(with([](auto& q) { q.members[1].swath = 0; }), "members.1.swath");
  EXPECT_EQ(with([&](auto& q) { q.members[1].altitude = nan; }), "members.1.altitude");
  EXPECT_EQ(with([](auto& q) { q.members[2].speed = -1; }), "members.2.speed");
  EXPECT_EQ(with([](auto& q) { q.members[2].busy = -1; }), "members.2.busy");
  EXPECT_EQ(with([&](auto& q) { q.members[0].start.y() = nan; }), "members.0.start");
  EXPECT_EQ(with([](auto& q) { q.members[0].share = 1; }), "members.1.share");
  EXPECT_EQ(with([](auto& q) {
              for (Member& member : q.members) member.share = -1;
            }),
            "members.0.share");
  EXPECT_EQ(with([](auto& q) { q.members[2].vehicle.cruise_speed = 0; }),
            "members.2.vehicle.speed.cruise");
}

}  // namespace
}  // namespace skein::refiners
