// SPDX-License-Identifier: Apache-2.0
// Values that a sweep puts into a scenario.
#include "sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::batch_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kText =
    "radio: {loss: 0}\nfaults: [{at: 5, kill: sim}]\nuavs: {a: {degree: 3}}\n";

std::string changed(const Combination& combination) {
  const auto text = with_values(kText, combination);
  return text ? *text : "failed: " + text.error().why;
}

TEST(ReadSweeps, PartsValuesAtCommasThatAreInNoBrackets) {
  const auto sweeps = read_sweeps({"radio.loss=0,0.1", "uavs.a.start=[0, 5],[9, 1]"});

  ASSERT_TRUE(sweeps.has_value());
  EXPECT_THAT(sweeps->at(0).values, ElementsAre("0", "0.1"));
  EXPECT_EQ(sweeps->at(1).path, "uavs.a.start");
  EXPECT_THAT(sweeps->at(1).values, ElementsAre("[0, 5]", "[9, 1]"));
}

TEST(ReadSweeps, SaysEverythingThatIsWrongAtOnce) {
  const auto sweeps = read_sweeps({"radio.loss", "=3", "a..b=1", "a.=1", "x=1,", "x=2", "y=[1"});

  ASSERT_FALSE(sweeps.has_value());
  const std::string said = to_text(sweeps.error());
  EXPECT_EQ(sweeps.error().size(), 7U) << said;
  EXPECT_THAT(said, HasSubstr("PATH=VALUE"));
  EXPECT_THAT(said, HasSubstr("x is given twice"));
  EXPECT_THAT(said, HasSubstr("'[1' is no YAML"));
}

TEST(Combinations, AreAllOfThemTheLastTurningQuickest) {
  const auto all = combinations({{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}});

  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(to_text(all[0]), "a=1 b=x");
  EXPECT_EQ(to_text(all[1]), "a=1 b=y");
  EXPECT_EQ(to_text(all[5]), "a=2 b=z");
}

TEST(Combinations, OfNoSweepAreOneThatChangesNothing) {
  ASSERT_EQ(combinations({}).size(), 1U);
  EXPECT_EQ(*with_values(kText, combinations({})[0]), kText);
}

TEST(WithValues, ChangesAddsAndGoesIntoLists) {
  EXPECT_THAT(changed({{"radio.loss", "0.3"}}), HasSubstr("loss: 0.3"));
  EXPECT_THAT(changed({{"radio.latency", "2"}}), HasSubstr("latency: 2"));
  EXPECT_THAT(changed({{"faults.0.at", "77"}}), HasSubstr("at: 77"));
  EXPECT_THAT(changed({{"uavs.a", "{degree: 4}"}}), HasSubstr("degree: 4"));
  EXPECT_THAT(changed({{"world.wind.speed", "6"}}), HasSubstr("speed: 6"));
}

TEST(WithValues, LeavesTheRestAsItWas) {
  const std::string text = changed({{"radio.loss", "0.3"}});

  EXPECT_THAT(text, HasSubstr("kill: sim"));
  EXPECT_THAT(text, HasSubstr("degree: 3"));
}

TEST(WithValues, SaysWhyAPathLeadsNowhere) {
  EXPECT_THAT(changed({{"faults.1.at", "7"}}), HasSubstr("no item of a list of 1"));
  EXPECT_THAT(changed({{"faults.first.at", "7"}}), HasSubstr("no item of a list"));
  EXPECT_THAT(changed({{"radio.loss.more", "7"}}), HasSubstr("a single value"));
  EXPECT_FALSE(with_values("[1, 2]", {{"a", "1"}}).has_value());
  EXPECT_FALSE(with_values("a: [", {{"a", "1"}}).has_value());
}

RC_GTEST_PROP(ReadSweeps, AnyTextIsReadOrRefused, (const std::vector<std::string>& texts)) {
  const auto sweeps = read_sweeps(texts);
  if (!sweeps) RC_ASSERT(!sweeps.error().empty());
}

}  // namespace
}  // namespace skein::batch_tool
