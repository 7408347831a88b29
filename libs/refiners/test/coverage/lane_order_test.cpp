// SPDX-License-Identifier: Apache-2.0
#include "coverage/lane_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "coverage/block_order.hpp"
#include "skein/foundation/random.hpp"
#include "testing/builders.hpp"

namespace skein::refiners {
namespace {

using testing::fixed_wing;
using testing::helicopter;
using world::Vector2;

Block slanted(std::size_t lanes, double spacing, double slant = 0, double length = 300) {
  Block block;
  for (std::size_t i = 0; i < lanes; ++i) {
    const auto at = static_cast<double>(i);
    block.push_back({at * spacing, at * slant, at * slant + length});
  }
  return block;
}

Block moved(Block block, double x, double y) {
  for (Strip& strip : block) strip = {strip.y + y, strip.from + x, strip.to + x};
  return block;
}

double added_up(const std::vector<Pass>& passes, const TurnModel& model, const SweepEnds& ends) {
  double sum = ends.start ? model.reach(*ends.start, passes.front()) : 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    sum += model.along((passes[i].to - passes[i].from).norm());
    if (i > 0) sum += model.between(passes[i - 1], passes[i]);
  }
  return sum + (ends.end ? model.leave(passes.back(), *ends.end) : 0);
}

TEST(Interleaved, HoldsEveryLaneOnce) {
  for (std::size_t lanes = 1; lanes < 40; ++lanes)
    for (std::size_t rounds = 1; rounds <= lanes; ++rounds) {
      LaneOrder order = interleaved(lanes, rounds);
      std::sort(order.begin(), order.end());
      LaneOrder all(lanes);
      std::iota(all.begin(), all.end(), 0U);
      ASSERT_EQ(order, all) << lanes << " in " << rounds;
    }
}

TEST(Interleaved, TurnsLeadOverHalfARound) {
  EXPECT_EQ(interleaved(6, 1), (LaneOrder{0, 3, 1, 4, 2, 5}));
  EXPECT_EQ(interleaved(12, 2), (LaneOrder{0, 3, 1, 4, 2, 5, 9, 6, 10, 7, 11, 8}));
}

TEST(OptionsOf, EveryOptionFliesEveryLaneOnceInAlternateSenses) {
  for (const auto& vehicle : {helicopter(), fixed_wing()}) {
    const TurnModel model(vehicle, 15);
    const Block block = slanted(11, 25, 7);
    const BlockOptions options = options_of(block, model);

    for (const BlockOption& option : options.options) {
      const auto passes = passes_of(block, options, option);
      ASSERT_EQ(passes.size(), block.size());
      std::vector<double> flown;
      for (std::size_t i = 0; i < passes.size(); ++i) {
        flown.push_back(passes[i].from.y());
        EXPECT_EQ(passes[i].to.x() > passes[i].from.x(), passes[i].heading == 0);
        if (i > 0) {
          EXPECT_NE(passes[i].heading, passes[i - 1].heading);
        }
      }
      std::sort(flown.begin(), flown.end());
      EXPECT_EQ(std::unique(flown.begin(), flown.end()), flown.end());
      EXPECT_NEAR(option.seconds, added_up(passes, model, {}), 1e-9);
      EXPECT_EQ(option.first.from, passes.front().from);
      EXPECT_EQ(option.last.to, passes.back().to);
    }
  }
}

TEST(OptionsOf, HoveringTakesNeighboursFromEveryCorner) {
  const TurnModel model(helicopter(), 10);

  EXPECT_EQ(options_of(slanted(5, 20), model).options.size(), 4U);
}

TEST(OptionsOf, WideTurnsSkipLanesAndSaveTime) {
  const TurnModel model(fixed_wing(), 15);
  const Block block = slanted(16, 20);
  double neighbours = 15 * model.beside(20), fastest = 1e300;
  for (const Strip& strip : block) neighbours += model.along(strip.to - strip.from);

  for (const BlockOption& option : options_of(block, model).options)
    fastest = std::min(fastest, option.seconds);

  EXPECT_LT(fastest, 0.85 * neighbours);
}

TEST(LevelSeconds, IsExactWhereLanesEndLevel) {
  for (const auto& vehicle : {helicopter(), fixed_wing()})
    for (const std::size_t lanes : {1U, 2U, 3U, 9U, 30U}) {
      const TurnModel model(vehicle, 12);
      const Block block = slanted(lanes, 22);
      double fastest = 1e300;
      for (const BlockOption& option : options_of(block, model).options)
        fastest = std::min(fastest, option.seconds);

      EXPECT_NEAR(level_seconds(block, model), fastest, 1e-6) << lanes;
    }
}

TEST(OrderBlocks, OneBlockBeginsNearTheStart) {
  const TurnModel model(helicopter(), 10);
  const std::vector<Block> blocks{slanted(4, 20)};

  for (const Vector2& start :
       {Vector2(-50, -50), Vector2(350, -50), Vector2(-50, 110), Vector2(350, 110)}) {
    const Route route = order_blocks(blocks, model, {start, std::nullopt});
    EXPECT_EQ(route.passes.front().from.x(), start.x() < 0 ? 0 : 300);
    EXPECT_EQ(route.passes.front().from.y(), start.y() < 0 ? 0 : 60);
  }
}

TEST(OrderBlocks, EndsNearTheEnd) {
  const TurnModel model(helicopter(), 10);

  const Route route = order_blocks({slanted(4, 20)}, model, {std::nullopt, Vector2(-50, 110)});

  EXPECT_EQ(route.passes.back().to, Vector2(0, 60));
}

TEST(OrderBlocks, IsNoSlowerThanAnyOrderOfThreeBlocks) {
  const TurnModel model(helicopter(), 10);
  Random random(9);

  for (int i = 0; i < 50; ++i) {
    std::vector<Block> blocks;
    for (std::size_t k = 0; k < 3; ++k)
      blocks.push_back(moved(slanted(2 + random.below(3), 20, 3, 80), random.uniform(-500, 500),
                             random.uniform(-500, 500)));
    const SweepEnds ends{Vector2(random.uniform(-500, 500), 0), std::nullopt};
    double least = 1e300;
    std::vector<std::size_t> order{0, 1, 2};
    do {
      std::vector<BlockOptions> options;
      for (const std::size_t k : order) options.push_back(options_of(blocks[k], model));
      for (const auto& a : options[0].options)
        for (const auto& b : options[1].options)
          for (const auto& c : options[2].options)
            least = std::min(least, model.reach(*ends.start, a.first) + a.seconds + b.seconds +
                                        c.seconds + model.between(a.last, b.first) +
                                        model.between(b.last, c.first));
    } while (std::next_permutation(order.begin(), order.end()));

    const Route route = order_blocks(blocks, model, ends);

    EXPECT_NEAR(route.seconds, least, 1e-9);
    EXPECT_NEAR(route.seconds, added_up(route.passes, model, ends), 1e-9);
    EXPECT_GE(quick_seconds(blocks, model, ends), least - 1e-9);
  }
}

TEST(OrderBlocks, ManyBlocksAreAllSweptOnce) {
  const TurnModel model(helicopter(), 10);
  Random random(10);
  std::vector<Block> blocks;
  for (int k = 0; k < 80; ++k)
    blocks.push_back(
        moved(slanted(2, 20, 0, 40), random.uniform(-900, 900), random.uniform(-900, 900)));

  for (const std::size_t count : {12U, 80U}) {
    const std::vector<Block> some(blocks.begin(), blocks.begin() + count);
    const Route route = order_blocks(some, model, {Vector2(0, 0), Vector2(0, 0)});

    EXPECT_EQ(route.passes.size(), 2 * count);
    EXPECT_NEAR(route.seconds, added_up(route.passes, model, {Vector2(0, 0), Vector2(0, 0)}), 1e-6);
  }
}

}  // namespace
}  // namespace skein::refiners
