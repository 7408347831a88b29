// SPDX-License-Identifier: Apache-2.0
// Multi-agent networks as text (spec 5.5).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "diagnostics_text.hpp"
#include "skein/temporal_files/network_text.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kSmall = R"({
  "agents": ["A", "B"],
  "nodes": [{"name": "a1", "agent": "A"}, {"name": "b1", "agent": "B"}],
  "arcs": [{"from": "v0", "to": "a1", "min": 0.000000001, "max": null},
           {"from": "b1", "to": "a1", "min": null, "max": 4}],
  "steps": [{"at": 7, "arc": 1, "min": 2, "max": 3}, {"at": 5, "arc": 0, "min": null, "max": 9}]
})";

std::string document(const std::string& nodes, const std::string& arcs = "",
                     const std::string& steps = "") {
  return R"({"agents":["A","B"],"nodes":[)" + nodes + R"(],"arcs":[)" + arcs + R"(],"steps":[)" +
         steps + "]}";
}

std::string node(const std::string& name, const std::string& agent) {
  return R"({"name":")" + name + R"(","agent":")" + agent + R"("})";
}

std::string errors(const std::string& text) { return errors_of(read_mastn(text)); }

const std::string kArc = R"({"from":"v0","to":"a","min":0,"max":1})";

TEST(ReadMastn, ReadsNetworkAndScenario) {
  const Result<Mastn, Diagnostics> read = read_mastn(kSmall);

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_THAT(read->agents, ElementsAre("A", "B"));
  EXPECT_THAT(read->nodes, ElementsAre("v0", "a1", "b1"));
  EXPECT_THAT(read->owner, ElementsAre(0, 0, 1));
  EXPECT_THAT(read->arcs,
              ElementsAre(Arc{0, 1, 1, kInfinite}, Arc{2, 1, kMinusInfinite, 4'000'000'000}));
}

TEST(ReadMastn, PutsStepsInTheOrderOfTime) {
  const Result<Mastn, Diagnostics> read = read_mastn(kSmall);

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_THAT(read->steps, ElementsAre(Step{5'000'000'000, 0, kMinusInfinite, 9'000'000'000},
                                       Step{7'000'000'000, 1, 2'000'000'000, 3'000'000'000}));
}

TEST(ReadMastn, NeedsNoSteps) { EXPECT_EQ(errors(R"({"agents":[],"nodes":[],"arcs":[]})"), ""); }

TEST(ReadMastn, NamesEachErrorOfOwnership) {
  EXPECT_THAT(errors(document(node("a", "C"))), HasSubstr("nodes[0].agent: unknown agent 'C'"));
  EXPECT_THAT(errors(document(node("v0", "A"))), HasSubstr("'v0' is the origin"));
  EXPECT_THAT(errors(document(node("a", "A") + "," + node("a", "B"))),
              HasSubstr("node 'a' is there twice"));
  EXPECT_THAT(errors(R"({"agents":["A","A"],"nodes":[],"arcs":[]})"),
              HasSubstr("agent 'A' is there twice"));
  EXPECT_THAT(errors(document(node("a", "b") + "," + node("b", "a"))),
              HasSubstr("cyclic ownership: 'a' → 'b' → 'a'"));
  EXPECT_THAT(errors(document(node("a", "a"))), HasSubstr("cyclic ownership: 'a' → 'a'"));
  EXPECT_THAT(errors(document(node("a", "b") + "," + node("b", "B"))),
              HasSubstr("the owner 'b' of 'a' is a node; expected the name of an agent"));
}

TEST(ReadMastn, AgentsAndNodesMayHaveTheSameNames) {
  EXPECT_EQ(errors(document(node("A", "B") + "," + node("B", "A"))), "");
}

TEST(ReadMastn, NamesEachErrorOfAStep) {
  const auto step = [](const std::string& at, const std::string& arc, const std::string& min) {
    return document(node("a", "A"), kArc,
                    R"({"at":)" + at + R"(,"arc":)" + arc + R"(,"min":)" + min + R"(,"max":2})");
  };

  EXPECT_EQ(errors(step("1", "0", "2")), "");
  EXPECT_THAT(errors(step("1", "1", "2")),
              HasSubstr("steps[0].arc: not a position: '1'; expected a whole number from 0 to 0"));
  EXPECT_THAT(errors(step("1", "-1", "2")), HasSubstr("not a position"));
  EXPECT_THAT(errors(step("1", "0.5", "2")), HasSubstr("not a position"));
  EXPECT_THAT(errors(step("1", "0", "3")), HasSubstr("min 3 is greater than max 2"));
  EXPECT_THAT(errors(step("null", "0", "2")), HasSubstr("steps[0].at: this is null"));
  EXPECT_THAT(errors(step("1e300", "0", "2")), HasSubstr("overflows"));
  EXPECT_THAT(errors(document("", "", R"({"at":0,"arc":0,"min":0,"max":0})")),
              HasSubstr("a step, and there are no arcs"));
}

TEST(ReadMastn, NamesEachErrorOfAnArc) {
  const std::string a = node("a", "A");

  EXPECT_THAT(errors(document(a, kArc + "," + kArc)), HasSubstr("arcs[1]: the arc from 'v0' to"));
  EXPECT_THAT(errors(document(a, R"({"from":"v0","to":"z","min":0,"max":1})")),
              HasSubstr("unknown node 'z'"));
  EXPECT_THAT(errors(document(a, R"({"from":"v0","to":"a","min":3,"max":1})")),
              HasSubstr("greater than max"));
  EXPECT_THAT(errors(document(a, R"({"from":"v0","to":"a","min":0})")),
              HasSubstr("arcs[0]: missing key 'max'"));
}

TEST(ReadMastn, IsReadAsANetworkWithoutAgentsToo) {
  const auto read = read_network(kSmall);

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->format, Format::kMastn);
  EXPECT_EQ(read->network, without_agents(*read_mastn(kSmall)));
}

RC_GTEST_PROP(WriteMastn, WritesWhatIsReadBack, ()) {
  MastnShape shape;
  shape.agents = *rc::gen::inRange(1U, 5U);
  shape.nodes = *rc::gen::inRange(1U, 6U);
  shape.local = *rc::gen::inRange(0U, 4U);
  shape.external = *rc::gen::inRange(0U, 4U);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Mastn network = generate_mastn(shape, seed);
  network.steps = make_scenario(network, chain_arcs(shape), {}, seed);
  for (Step& step : network.steps) step.at += *rc::gen::inRange(0, 1000);
  if (!network.arcs.empty()) network.arcs.front().max = kInfinite;

  const Result<Mastn, Diagnostics> read = read_mastn(write_mastn(network));

  RC_ASSERT(errors_of(read) == "");
  RC_ASSERT(*read == network);
}

}  // namespace
}  // namespace skein::temporal
