// SPDX-License-Identifier: Apache-2.0
// The formats of others: GraphML and plain text of the CSTNU Tool, JSON of HEATlab.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnostics_text.hpp"
#include "skein/temporal/incremental_controllability.hpp"
#include "skein/temporal/stn_solution.hpp"
#include "skein/temporal/stnu_controllability.hpp"
#include "skein/temporal_files/drawing.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr Ticks kSecond = kTicksPerSecond;

std::string errors(const std::string& text) { return errors_of(read_network(text)); }

// --- GraphML -------------------------------------------------------------------------------------

std::string edge(const std::string& source, const std::string& target, const std::string& type,
                 const std::string& key, const std::string& value) {
  return "<edge source='" + source + "' target='" + target + "'><data key='Type'>" + type +
         "</data><data key='" + key + "'>" + value + "</data></edge>\n";
}

std::string graphml(const std::string& edges,
                    const std::string& nodes = "<node id='Z'/><node id='A'/><node id='C'/>") {
  return "<?xml version='1.0' encoding='UTF-8'?>\n<graphml>\n"
         "<key id='Type' for='edge'/><key id='Value' for='edge'/>\n<graph "
         "edgedefault='directed'>\n" +
         nodes + "\n" + edges + "</graph></graphml>\n";
}

Stnu read(const std::string& text) {
  const Result<ReadNetwork, Diagnostics> result = read_network(text);
  EXPECT_EQ(errors_of(result), "");
  return result ? result->network : Stnu{};
}

TEST(Graphml, JoinsAnEdgeAndItsOppositeIntoAnArc) {
  const Stnu network = read(graphml(edge("Z", "A", "normal", "Value", "10") +
                                    edge("A", "Z", "constraint", "Value", "-3") +
                                    edge("C", "A", "derived", "Value", "-2.5")));

  EXPECT_EQ(network.origin, 0U);
  EXPECT_THAT(network.arcs, ElementsAre(Arc{0, 1, 3 * kSecond, 10 * kSecond},
                                        Arc{1, 2, 5 * kSecond / 2, kInfinite}));
}

TEST(Graphml, ReadsAContingentLinkAsAPairOfValues) {
  const Stnu network = read(graphml(edge("C", "A", "contingent", "Value", "-1") +
                                    edge("A", "C", "contingent", "Value", "3")));

  EXPECT_THAT(network.contingent, ElementsAre(ContingentLink{1, 2, kSecond, 3 * kSecond}));
}

TEST(Graphml, ReadsAContingentLinkAsAPairOfLabelledValues) {
  for (const char* key : {"LabeledValue", "LabeledValues"}) {
    const Stnu network = read(graphml(edge("A", "C", "contingent", key, "LC(C):1") +
                                      edge("C", "A", "contingent", key, "UC(C): -3")));

    EXPECT_THAT(network.contingent, ElementsAre(ContingentLink{1, 2, kSecond, 3 * kSecond}));
  }
}

TEST(Graphml, ReadsAContingentLinkGivenInBothWays) {
  const std::string both =
      "<edge source='A' target='C'><data key='Type'>contingent</data><data key='Value'>3</data>"
      "<data key='LabeledValue'>LC(C):1</data></edge><edge source='C' target='A'><data "
      "key='Type'>contingent</data><data key='Value'>-1</data><data key='LabeledValue'>UC(C):";

  EXPECT_EQ(errors(graphml(both + "-3</data></edge>")), "");
  EXPECT_THAT(errors(graphml(both + "-4</data></edge>")),
              HasSubstr("whose value and labelled value differ"));
}

TEST(Graphml, TellsKeysByTheirAttributeName) {
  const Stnu network = read(
      "<graphml><key id='d0' attr.name='Value' for='edge'/><key id='d1' attr.name='Type'/><graph>"
      "<node id='Z'/><node id='A'/><edge source='Z' target='A'><data key='d1'>requirement</data>"
      "<data key='d0'>7</data></edge></graph></graphml>");

  EXPECT_THAT(network.arcs, ElementsAre(Arc{0, 1, kMinusInfinite, 7 * kSecond}));
}

TEST(Graphml, LeavesOutWaitsThatAreDerivedAndInfiniteValues) {
  const Stnu network = read(graphml(edge("Z", "A", "derived", "LabeledValue", "UC(C):-2") +
                                    edge("A", "C", "normal", "Value", "∞")));

  EXPECT_TRUE(network.arcs.empty());
}

TEST(Graphml, KeepsAnEmptyIntervalSinceTheNetworkIsThenInconsistent) {
  const Stnu network = read(
      graphml(edge("Z", "A", "normal", "Value", "2") + edge("A", "Z", "normal", "Value", "-3")));

  EXPECT_THAT(network.arcs, ElementsAre(Arc{0, 1, kMinusInfinite, 2 * kSecond},
                                        Arc{1, 0, kMinusInfinite, -3 * kSecond}));
}

TEST(Graphml, KeepsAFixedDurationBesideAnEdge) {
  const Stnu network = read(graphml(edge("A", "C", "normal", "Value", "9") +
                                    edge("A", "C", "contingent", "Value", "4") +
                                    edge("C", "A", "contingent", "Value", "-4")));

  EXPECT_THAT(network.arcs, ElementsAre(Arc{1, 2, kMinusInfinite, 9 * kSecond},
                                        Arc{2, 1, -4 * kSecond, -4 * kSecond}));
}

TEST(Graphml, AddsTheOriginBeforeNodesThatFollowNone) {
  const Stnu network = read(graphml(
      edge("A", "C", "contingent", "Value", "3") + edge("C", "A", "contingent", "Value", "-1"),
      "<node id='A'/><node id='C'/>"));

  EXPECT_THAT(network.nodes, ElementsAre("A", "C", "Z"));
  EXPECT_EQ(network.origin, 2U);
  EXPECT_THAT(network.arcs, ElementsAre(Arc{2, 0, 0, kInfinite}));
}

TEST(Graphml, NamesEachErrorOfAContingentLink) {
  const auto pair = [](const char* out, const char* back) {
    return errors(graphml(edge("A", "C", "contingent", "Value", out) +
                          edge("C", "A", "contingent", "Value", back)));
  };

  EXPECT_EQ(pair("3", "-1"), "");
  EXPECT_THAT(pair("1", "-3"), HasSubstr("min 3 is greater than max 1"));
  EXPECT_THAT(pair("3", "1"), HasSubstr("without a positive shortest and longest"));
  EXPECT_THAT(pair("-3", "-1"), HasSubstr("without a positive shortest and longest"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "contingent", "Value", "3"))),
              HasSubstr("without its opposite; expected a contingent edge from 'C' to 'A'"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "contingent", "LabeledValue", "LC(Z):3"))),
              HasSubstr("does not name the end of its link"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "contingent", "LabeledValue", "3"))),
              HasSubstr("'3' is not a labelled value"));
  EXPECT_THAT(errors(graphml(edge("A", "Z", "contingent", "Value", "3") +
                             edge("Z", "A", "contingent", "Value", "-1"))),
              HasSubstr("ends in the origin 'Z'"));
}

TEST(Graphml, NamesEachErrorOfAnEdge) {
  EXPECT_THAT(errors(graphml(edge("A", "B", "normal", "Value", "3"))),
              StartsWith("line 6:1: unknown node 'B'"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "norml", "Value", "3"))),
              HasSubstr("unknown type of edge 'norml'; did you mean 'normal'?"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "normal", "Value", "three"))),
              HasSubstr("'three' is not a number"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "normal", "Value", "1e10"))), HasSubstr("overflows"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "normal", "Vlue", "3"))),
              HasSubstr("an edge without a value"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "normal", "Value", "3") +
                             edge("A", "C", "normal", "Value", "4"))),
              HasSubstr("7:1: the edge from 'A' to 'C' is there twice"));
  EXPECT_THAT(errors(graphml(edge("A", "C", "normal", "LabeledValue", "UC(C):-4"))),
              HasSubstr("a labelled value outside a contingent link"));
}

TEST(Graphml, NamesEachErrorOfTheDocument) {
  EXPECT_THAT(errors("<graphml><graph></graphml>"),
              StartsWith("line 1:19: not XML: mismatched tag"));
  EXPECT_THAT(errors("<svg/>"), HasSubstr("the root element is 'svg'; expected <graphml>"));
  EXPECT_THAT(errors("<graphml/>"), HasSubstr("no graph"));
  EXPECT_THAT(errors("<graphml><graph/><graph/></graphml>"), HasSubstr("a second graph"));
  EXPECT_THAT(errors("<graphml><graph edgedefault='undirected'/></graphml>"),
              HasSubstr("expected 'directed'"));
  EXPECT_THAT(errors(graphml("<egde/>")), HasSubstr("'egde'; did you mean 'edge'?"));
  EXPECT_THAT(errors(graphml("", "<node id='A'/><node id='A'/>")), HasSubstr("'A' is there twice"));
  EXPECT_THAT(errors(graphml("", "<node/>")), HasSubstr("<node> without the attribute 'id'"));
  EXPECT_THAT(errors(graphml("", "<node id='A'><data key='Obs'>p</data></node>")),
              HasSubstr("the network is conditional"));
  EXPECT_THAT(errors("<graphml><graph><data key='NetworkType'>CSTNU</data></graph></graphml>"),
              HasSubstr("of type 'CSTNU'; expected STN or STNU"));
}

TEST(Graphml, ExpandsNoEntities) {
  const std::string laughs =
      "<!DOCTYPE g [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>]><graphml>&b;</graphml>";

  EXPECT_THAT(errors(laughs), HasSubstr("a document type declaration; expected none"));
  EXPECT_THAT(errors("<graphml>&b;</graphml>"), HasSubstr("undefined entity"));
}

TEST(Graphml, BoundsItsNesting) {
  std::string deep;
  for (int i = 0; i < 20; ++i) deep += "<graphml>";

  EXPECT_THAT(errors(deep), HasSubstr("nested more than 16 deep"));
}

TEST(Graphml, AKeyMayBeDeclaredOnceForEachKindOfElement) {
  const auto with = [](const char* second) {
    return "<graphml><key id='d0' for='node' attr.name='colour'/><key id='d0' for='" +
           std::string(second) +
           "' attr.name='Value'/><graph><node id='Z'><data key='d0'>red</data></node><node id='A'/>"
           "<edge source='Z' target='A'><data key='d0'>7</data></edge></graph></graphml>";
  };

  EXPECT_THAT(read(with("edge")).arcs, ElementsAre(Arc{0, 1, kMinusInfinite, 7 * kSecond}));
  EXPECT_THAT(read(with("all")).arcs, ElementsAre(Arc{0, 1, kMinusInfinite, 7 * kSecond}));
  EXPECT_THAT(errors(with("node")), HasSubstr("key 'd0' is there twice for the same elements"));
}

// What the reader of the CSTNU Tool asks of a file: it takes the functions of the declared keys
// without looking whether they are there, and each node's x and y as numbers.
TEST(Graphml, WritesTheKeysThatTheCstnuToolReads) {
  const Stnu network{{"Z", "a", "b"}, 0, {{0, 1, 0, 9}}, {{1, 2, 5, 7}}};

  const std::string text = write_network(network, Format::kGraphml).value();

  for (const char* key : {"x", "y", "Obs", "Label"}) {
    EXPECT_THAT(text, HasSubstr("<key id=\"" + std::string(key) + "\" for=\"node\"><default>"));
  }
  for (const char* key : {"Type", "Value"}) {
    EXPECT_THAT(text, HasSubstr("<key id=\"" + std::string(key) + "\" for=\"edge\"><default>"));
  }
  EXPECT_THAT(text, HasSubstr(R"(<node id="b"><data key="x">270</data><data key="y">90</data>)"));
}

// --- what files of others may say and ours may not
// ------------------------------------------------

std::string plain(const std::string& rest) { return "# Time-Point Names\nZ A C\n" + rest; }

std::string warnings(const std::string& text) {
  const Result<ReadNetwork, Diagnostics> result = read_network(text, "f");
  EXPECT_EQ(errors_of(result), "");
  return result ? to_text(result->warnings) : "";
}

std::vector<std::string> with_loop(const std::string& weight, const std::string& stc) {
  return {graphml(edge("A", "A", "normal", "Value", weight)),
          plain("# Ordinary Edges\nA " + weight + " A\n"),
          R"({"constraints":[{"first_node":1,"second_node":1,"type":"stc",)" + stc + "}]}"};
}

TEST(FilesOfOthers, ALinkFromANodeToItselfThatHoldsIsLeftOutWithAWarning) {
  for (const std::string& text : with_loop("3", R"("min_duration":-1,"max_duration":3)")) {
    const std::vector<Arc> arcs = read(text).arcs;
    EXPECT_TRUE(
        std::none_of(arcs.begin(), arcs.end(), [](const Arc& arc) { return arc.from == arc.to; }));
    EXPECT_THAT(warnings(text), HasSubstr("warning: a")) << text;
    EXPECT_THAT(warnings(text), HasSubstr("to itself")) << text;
  }
}

TEST(FilesOfOthers, ALinkFromANodeToItselfThatDoesNotHoldMakesTheNetworkInconsistent) {
  for (const std::string& text : with_loop("-3", R"("min_duration":"-inf","max_duration":-3)")) {
    const Stnu network = read(text);

    EXPECT_FALSE(solve_stn(without_uncertainty(network))->consistent);
    const auto verdict = check_dynamic_controllability(network);
    EXPECT_FALSE(verdict->consistent);
    EXPECT_EQ(verdict->conflict.size(), 1U);
    EXPECT_EQ(make_dispatchable(network).error().fault, StnuFault::kNotControllable);
    EXPECT_FALSE(IncrementalDc::create(network)->result().controllable);
    EXPECT_THAT(draw_svg(network, {}).value(), HasSubstr("to itself, ≤ -3"));
    for (const Format format : {Format::kGraphml, Format::kPlain, Format::kHeatlab}) {
      EXPECT_FALSE(
          solve_stn(without_uncertainty(read(*write_network(network, format))))->consistent);
    }
    EXPECT_THAT(write_network(network, Format::kJson).error().why, HasSubstr("to itself"));
  }
}

TEST(FilesOfOthers, AContingentMinThatIsNotPositiveIsTheLeastDurationThereIs) {
  for (const std::string& text :
       {graphml(edge("A", "C", "contingent", "Value", "3") +
                edge("C", "A", "contingent", "Value", "0")),
        graphml(edge("A", "C", "contingent", "LabeledValue", "LC(C):-2") +
                edge("C", "A", "contingent", "LabeledValue", "UC(C):-3")),
        plain("# Contingent Links\nA 0 3 C\n"),
        std::string(R"({"constraints":[{"first_node":1,"second_node":2,"type":"stcu",
                        "min_duration":0,"max_duration":3}]})")}) {
    const Stnu network = read(text);

    ASSERT_EQ(network.contingent.size(), 1U) << text;
    EXPECT_EQ(network.contingent[0].min, 1);
    EXPECT_EQ(network.contingent[0].max, 3 * kSecond);
    EXPECT_THAT(warnings(text), HasSubstr("is not positive; it is read as one nanosecond"));
  }
}

// The end may come at once: what must not come before it may not come before its activation
// either, and what must come before it has no time at all.
TEST(FilesOfOthers, AnEndThatMayComeAtOnceGivesTheVerdictsOfZero) {
  const auto controllable = [](const std::string& edges) {
    return check_dynamic_controllability(
               read(plain("# Ordinary Edges\n" + edges + "# Contingent Links\nA 0 3 C\n")))
        ->controllable;
  };

  EXPECT_TRUE(controllable("C 0 Z\nZ 3 C\n")) << "if A is at Z";
  EXPECT_TRUE(controllable("Z 0 A\nA 0 Z\nZ 3 C\n")) << "from 0 to 3 after Z";
  EXPECT_FALSE(controllable("Z 0 A\nA 0 Z\nC -1 Z\n")) << "1 after Z at the earliest";
}

TEST(FilesOfOthers, AFixedDurationThatIsNotPositiveIsARequirement) {
  const Stnu network = read(plain("# Contingent Links\nA 0 0 C\n"));

  EXPECT_TRUE(network.contingent.empty());
  EXPECT_THAT(network.arcs, testing::Contains(Arc{1, 2, 0, 0}));
}

TEST(PutOriginFirst, LetsNoNodeComeBeforeTheOrigin) {
  Stnu network{{"a", "Z", "b", "c", "d", "e"},
               1,
               {{1, 0, -5, 7}, {2, 1, -3, 4}, {1, 3, -9, -2}, {0, 4, 1, 2}},
               {{4, 5, 1, 3}}};

  put_origin_first(network);

  const auto solution = solve_stn(without_uncertainty(network));
  EXPECT_FALSE(solution->consistent) << "c is 2 before Z";
  network.arcs[2].min = network.arcs[2].max = 3;
  const StnSolution mended = solve_stn(without_uncertainty(network)).value();
  ASSERT_TRUE(mended.consistent);
  for (const DateWindow& window : mended.windows) EXPECT_GE(window.earliest, 0);
  EXPECT_EQ(network.arcs[0], (Arc{1, 0, 0, 7}));
  EXPECT_EQ(network.arcs[1], (Arc{2, 1, -3, 0}));
}

// --- plain text ----------------------------------------------------------------------------------

constexpr const char* kPlain = R"(# KIND OF NETWORK
STNU
# Num Time-Points
3
# Num Ordinary Edges
2
# Num Contingent Links
1
# Time-Point Names
'Z' 'A 1' C
# Ordinary Edges
'Z' 10 'A 1'
'A 1' -3 'Z'
# Contingent Links
'A 1' 1.5 3 C
)";

TEST(PlainText, ReadsEdgesAndContingentLinks) {
  const Stnu network = read(kPlain);

  EXPECT_THAT(network.nodes, ElementsAre("Z", "A 1", "C"));
  EXPECT_THAT(network.arcs, ElementsAre(Arc{0, 1, 3 * kSecond, 10 * kSecond}));
  EXPECT_THAT(network.contingent, ElementsAre(ContingentLink{1, 2, 1'500'000'000, 3 * kSecond}));
}

TEST(PlainText, NeedsNoCountsAndSkipsComments) {
  const Stnu network = read(
      "# Written by hand, for a test\n\n# Time-Point Names\r\n'Z'\n'A'\n# Ordinary Edges\nZ 1 A\n");

  EXPECT_THAT(network.arcs, ElementsAre(Arc{0, 1, kMinusInfinite, kSecond}));
}

TEST(PlainText, NamesEachErrorWithItsPlace) {
  const std::string nodes = "# Time-Point Names\n'Z' 'A' 'C'\n";

  EXPECT_THAT(errors(nodes + "# Ordinary Edges\n'Z' 1 'B'\n"),
              StartsWith("line 4:7: unknown node 'B'"));
  EXPECT_THAT(errors(nodes + "# Ordinary Edges\n'Z' x 'A'\n"),
              HasSubstr("4:5: 'x' is not a number"));
  EXPECT_THAT(errors(nodes + "# Ordinary Edges\n'Z' 1\n"),
              HasSubstr("2 words; expected 'source' weight 'target'"));
  EXPECT_THAT(errors(nodes + "# Ordinary Edges\n'Z' 1 'A\n"),
              HasSubstr("a quote that does not end"));
  EXPECT_THAT(errors(nodes + "# Ordinry Edges\n'Z' 1 'A'\n"),
              HasSubstr("unknown section 'ordinry edges'; did you mean 'ordinary edges'?"));
  EXPECT_THAT(errors(nodes + "# Contingent Links\n'A' -2 -1 'C'\n"), HasSubstr("not positive"));
  EXPECT_THAT(errors(nodes + "# Contingent Links\n'A' 1 2 'Z'\n"), HasSubstr("ends in the origin"));
  EXPECT_THAT(errors("# Num Time-Points\n2\n" + nodes),
              HasSubstr("2 time-points announced, 3 found"));
  EXPECT_THAT(errors("# KIND OF NETWORK\nCSTN\n" + nodes), HasSubstr("expected STN or STNU"));
  EXPECT_THAT(errors("# Time-Point Names\n'A' 'A'\n"),
              StartsWith("line 2:5: node 'A' is there twice"));
  EXPECT_THAT(errors("# Time-Point Names\n'A\xFF'\n"), HasSubstr("is not UTF-8"));
}

// --- HEATlab -------------------------------------------------------------------------------------

constexpr const char* kHeatlab = R"({
  "nodes": [{"node_id": 1, "local_id": 4}, {"node_id": 2}],
  "constraints": [
    {"first_node": 0, "second_node": 1, "type": "stc", "min_duration": 0, "max_duration": "inf"},
    {"first_node": 1, "second_node": 2, "type": "stcu", "min_duration": 1, "max_duration": 2.5}]})";

std::string heatlab(const std::string& constraint) {
  return R"({"constraints":[)" + constraint + "]}";
}

std::string constraint(const std::string& type, const std::string& min, const std::string& max) {
  return R"({"first_node":0,"second_node":1,"type":")" + type + R"(","min_duration":)" + min +
         R"(,"max_duration":)" + max + "}";
}

TEST(Heatlab, ReadsConstraintsWithNodesThatOnlyTheyName) {
  const Stnu network = read(kHeatlab);

  EXPECT_THAT(network.nodes, ElementsAre("1", "2", "0"));
  EXPECT_EQ(network.origin, 2U);
  EXPECT_THAT(network.arcs, ElementsAre(Arc{2, 0, 0, kInfinite}));
  EXPECT_THAT(network.contingent, ElementsAre(ContingentLink{0, 1, kSecond, 5 * kSecond / 2}));
}

TEST(Heatlab, RoundsToTheNanosecond) {
  const Stnu network = read(heatlab(constraint("stc", "0.30000000000000004", "1")));

  EXPECT_EQ(network.arcs.front().min, 300'000'000);
}

TEST(Heatlab, ReadsTheDomainOfANodeAsAConstraint) {
  const Stnu network = read(R"({"nodes":[{"node_id":1,"min_domain":2,"max_domain":"inf"}],
                                "constraints":[]})");

  EXPECT_THAT(network.arcs, ElementsAre(Arc{1, 0, 2 * kSecond, kInfinite}));
}

TEST(Heatlab, NamesEachError) {
  EXPECT_EQ(errors(heatlab(constraint("stc", R"("-inf")", R"("inf")"))), "");
  EXPECT_THAT(errors(heatlab(constraint("pstc", "0", "1"))),
              HasSubstr("unknown type 'pstc'; expected \"stc\" or \"stcu\""));
  EXPECT_THAT(errors(heatlab(constraint("stc", "2", "1"))), HasSubstr("greater than max"));
  EXPECT_THAT(errors(heatlab(constraint("stcu", "-2", "-1"))), HasSubstr("not positive"));
  EXPECT_THAT(errors(heatlab(constraint("stcu", "1", R"("inf")"))), HasSubstr("max is infinite"));
  EXPECT_THAT(errors(heatlab(constraint("stc", R"("inf")", R"("inf")"))),
              HasSubstr("no duration satisfies this bound"));
  EXPECT_THAT(errors(heatlab(constraint("stc", R"("nan")", "1"))),
              HasSubstr("'nan' is not a duration"));
  EXPECT_THAT(errors(heatlab(constraint("stc", "null", "1"))), HasSubstr("this is null"));
  EXPECT_THAT(errors(heatlab(constraint("stc", "0", "1") + "," + constraint("stc", "0", "1"))),
              HasSubstr("constraints[1]: the arc from '0' to '1' is there twice"));
  EXPECT_THAT(errors(R"({"constraints":[{"first_node":-1,"second_node":1.5}]})"),
              HasSubstr("constraints[0].second_node: '1.5' is not a node"));
}

}  // namespace
}  // namespace skein::temporal
