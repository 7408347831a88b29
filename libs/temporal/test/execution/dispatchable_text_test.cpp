// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_files/dispatchable_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "controllability/random_stnu.hpp"

namespace skein::temporal {
namespace {

using ::testing::HasSubstr;

DispatchableNetwork small() {
  // x comes after a at the latest when c has: it has to wait for c, or until the longest duration
  // less what it may be late.
  const Stnu plan{{"Z", "a", "c", "x"},
                  0,
                  {{0, 1, 0, 9 * kTicksPerSecond}, {3, 2, -kTicksPerSecond, kTicksPerSecond}},
                  {{1, 2, 2 * kTicksPerSecond, 6 * kTicksPerSecond}}};
  return make_dispatchable(plan).value();
}

std::size_t times(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

TEST(WriteDispatchable, HasEveryEdgeLinkAndWaitInSeconds) {
  const DispatchableNetwork network = small();
  ASSERT_EQ(network.waits.size(), 1U);

  const auto json = nlohmann::json::parse(write_dispatchable(network, Format::kJson).value());

  EXPECT_EQ(json.at("origin"), "Z");
  EXPECT_EQ(json.at("edges").size(), network.edges.size());
  EXPECT_EQ(json.at("waits").at(0).dump(), R"({"delay":5,"from":"a","node":"x","to":"c"})");
  EXPECT_EQ(json.at("contingent").at(0).dump(), R"({"from":"a","max":6,"min":2,"to":"c"})");
}

TEST(WriteDispatchable, WritesWaitsInGraphmlAsTheCstnuToolDoes) {
  const std::string text = write_dispatchable(small(), Format::kGraphml).value();

  EXPECT_THAT(text, HasSubstr(R"(source="x" target="a"><data key="Type">derived</data>)"
                              R"(<data key="LabeledValue">UC(c):-5</data>)"));
}

TEST(WriteDispatchable, SaysWhichFormatsHaveWaits) {
  for (const Format format : {Format::kPlain, Format::kHeatlab, Format::kMastn}) {
    EXPECT_THAT(write_dispatchable(small(), format).error().why, HasSubstr("json and graphml"));
  }
}

// The law of a dispatchable form: it is the same plan. What is read back is controllable, and has
// every edge, link and wait.
TEST(WriteDispatchable, IsTheSamePlanWhenReadAsANetwork) {
  Random random(9);
  int forms = 0;
  for (int i = 0; i < 300; ++i) {
    testing::RandomStnuOptions options;
    options.anchored = true;
    const Stnu network = testing::random_stnu(options, random);
    const auto form = make_dispatchable(network);
    if (!form) continue;
    ++forms;

    const std::string text = write_dispatchable(*form, Format::kGraphml).value();
    const auto read = read_network(text);

    ASSERT_EQ((read ? std::string() : to_text(read.error())), "");
    EXPECT_TRUE(check_dynamic_controllability(read->network)->controllable) << i;
    EXPECT_EQ(times("UC(", text), form->waits.size()) << i;
    EXPECT_EQ(times("<edge ", text),
              form->edges.size() + form->waits.size() + 2 * form->plan.contingent.size());
    for (const DistanceEdge& edge : form->edges) {
      const auto holds = [&](const Arc& arc) {
        return (arc.from == edge.from && arc.to == edge.to && arc.max == edge.weight) ||
               (arc.to == edge.from && arc.from == edge.to && -arc.min == edge.weight);
      };
      EXPECT_TRUE(std::any_of(read->network.arcs.begin(), read->network.arcs.end(), holds)) << i;
    }
  }
  EXPECT_GT(forms, 50);
}

}  // namespace
}  // namespace skein::temporal
