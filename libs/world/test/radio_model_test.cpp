// SPDX-License-Identifier: Apache-2.0
#include "skein/world/radio_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace skein::world {
namespace {

Terrain terrain() {
  TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.hills = {{{0, 0}, 50, 100}};
  return Terrain(spec);
}

const RadioModel kRadio = {300, true, Duration::milliseconds(20), 0.01, 0.1};

TEST(RadioModel, IsUpWithinRangeInSight) {
  const RadioLink link = kRadio.link({-100, 200, 10}, {100, 200, 10}, terrain(), false);

  EXPECT_EQ(link, (RadioLink{true, Duration::milliseconds(20), 0.01}));
}

TEST(RadioModel, TerrainCutsOnlyWhoNeedsSight) {
  RadioModel through_hills = kRadio;
  through_hills.needs_line_of_sight = false;

  EXPECT_FALSE(kRadio.link({-100, 0, 10}, {100, 0, 10}, terrain(), true).up);
  EXPECT_TRUE(through_hills.link({-100, 0, 10}, {100, 0, 10}, terrain(), true).up);
}

TEST(RadioModel, HoldsABitBeyondItsRangeOnceUp) {
  const Vector3 a(-200, 200, 60), b(115, 200, 60);  // 315 m

  EXPECT_FALSE(kRadio.link(a, b, terrain(), false).up);
  EXPECT_TRUE(kRadio.link(a, b, terrain(), true).up);
  EXPECT_FALSE(kRadio.link(a, b + Vector3(20, 0, 0), terrain(), true).up);
}

TEST(RadioModel, ADownLinkLosesEverything) {
  EXPECT_EQ(kRadio.link({-400, 0, 10}, {400, 0, 10}, terrain(), true),
            (RadioLink{false, Duration(), 1}));
}

RC_GTEST_PROP(RadioModel, IsSymmetrical, (bool was_up)) {
  const Terrain ground = terrain();
  const auto end = [] {
    return Vector3(*rc::gen::inRange(-400, 400), *rc::gen::inRange(-400, 400),
                   *rc::gen::inRange(0, 100));
  };
  const Vector3 a = end(), b = end();

  RC_ASSERT(kRadio.link(a, b, ground, was_up) == kRadio.link(b, a, ground, was_up));
}

LinkBudget budget() {
  LinkBudget budget;
  budget.emission_power = 20;
  budget.sensitivity = -90;
  budget.reference_loss = 40;
  budget.path_loss_exponent = 2.5;
  return budget;
}

RadioModel budgeted() {
  RadioModel radio = kRadio;
  radio.budget = budget();
  return radio;
}

TEST(RadioModel, TheRangeOfABudgetIsWhereReceptionFallsToTheSensitivity) {
  const double reach = budgeted().reach();

  EXPECT_NEAR(20 - 40 - 25 * std::log10(reach), -90, 1e-9);
  EXPECT_NEAR(reach, 630.957, 1e-3);
  EXPECT_EQ(kRadio.reach(), 300);
}

TEST(RadioModel, ABudgetDecidesTheLinkInPlaceOfTheRange) {
  const Vector3 a(-300, 200, 60), b(300, 200, 60);  // 600 m

  EXPECT_TRUE(budgeted().link(a, b, terrain(), false).up);
  EXPECT_FALSE(kRadio.link(a, b, terrain(), false).up);
}

TEST(RadioModel, TheMarginIsWhatIsReceivedAboveTheSensitivity) {
  const Vector3 a(-100, 200, 60), b(100, 200, 60);  // 200 m

  const double received = 20 - 40 - 25 * std::log10(200.0);

  EXPECT_NEAR(budgeted().margin(a, b, terrain()), received + 90, 1e-9);
  EXPECT_NEAR(kRadio.margin(a, b, terrain()), 20 * std::log10(1.5), 1e-9);
}

TEST(RadioModel, TheGroundTakesAllTheMargin) {
  RadioModel through_hills = kRadio;
  through_hills.needs_line_of_sight = false;
  const Vector3 a(-100, 0, 10), b(100, 0, 10);

  EXPECT_EQ(kRadio.margin(a, b, terrain()), -std::numeric_limits<double>::infinity());
  EXPECT_GT(through_hills.margin(a, b, terrain()), 0);
}

TEST(RadioModel, TheMarginStaysFiniteAtTheSamePlace) {
  RadioModel whisper = kRadio;
  whisper.range = 0.5;

  EXPECT_EQ(kRadio.margin(0.0), kRadio.margin(1.0));
  EXPECT_EQ(whisper.margin(0.0), 0);
  EXPECT_LT(whisper.margin(0.6), 0);
}

RC_GTEST_PROP(RadioModel, ALinkComesUpExactlyWhereTheMarginIsNotNegative, (bool with_budget)) {
  const RadioModel radio = with_budget ? budgeted() : kRadio;
  const Terrain ground = terrain();
  const double reach = radio.reach();
  const double distance = *rc::gen::element(reach, std::nextafter(reach, 0.0), reach * (1 + 1e-15),
                                            reach * 0.3, reach * 1.01, reach + 1e-12);
  const Vector3 a = Vector3(-400, 300, 60), b = a + Vector3(distance, 0, 0);

  RC_ASSERT((radio.margin(a, b, ground) >= 0) == radio.link(a, b, ground, false).up);
}

TEST(RadioModel, CoverageIsTheMarginToAReceiverOverEachCell) {
  const Terrain ground = terrain();
  const Grid grid = {-500, -500, 50, 20, 20};
  const Vector3 point(-150, 0, 5);

  const std::vector<double> margins = kRadio.coverage(point, grid, ground, 1.5);

  ASSERT_EQ(margins.size(), grid.size());
  std::size_t heard = 0, hidden = 0;
  for (std::size_t i = 0; i < margins.size(); ++i) {
    const Vector2 c = grid.centre(i);
    const Vector3 receiver(c.x(), c.y(), ground.elevation(c.x(), c.y()) + 1.5);
    EXPECT_EQ(margins[i] >= 0, kRadio.link(point, receiver, ground, false).up) << c.transpose();
    heard += margins[i] >= 0 ? 1U : 0U;
    hidden += std::isinf(margins[i]) ? 1U : 0U;
  }
  EXPECT_GT(heard, 20U);
  EXPECT_GT(hidden, 5U);
}

TEST(RadioModel, EveryFigureThatMakesNoSenseIsNamed) {
  RadioModel wrong = kRadio;
  wrong.range = -1;
  wrong.loss = 1;
  wrong.latency = Duration::milliseconds(-1);
  wrong.hysteresis = std::nan("");

  EXPECT_EQ(problems_of(wrong).size(), 4U);
  EXPECT_TRUE(problems_of(kRadio).empty());
  EXPECT_TRUE(problems_of(budgeted()).empty());
}

TEST(RadioModel, ABudgetMustLeaveSomethingToReceive) {
  const auto with = [](auto change) {
    RadioModel radio = budgeted();
    change(*radio.budget);
    return problems_of(radio).size();
  };

  EXPECT_EQ(with([](LinkBudget& b) { b.emission_power = -60; }), 1U);
  EXPECT_EQ(with([](LinkBudget& b) { b.path_loss_exponent = 0; }), 1U);
  EXPECT_EQ(with([](LinkBudget& b) { b.sensitivity = std::nan(""); }), 1U);
  EXPECT_EQ(with([](LinkBudget& b) { b.path_loss_exponent = 1e-3; }), 1U);
}

}  // namespace
}  // namespace skein::world
