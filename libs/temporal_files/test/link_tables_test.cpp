// SPDX-License-Identifier: Apache-2.0
#include "link_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LinkTables : public testing::Test {
 protected:
  LinkTables() {
    for (const char* name : {"a", "b", "c"}) nodes_.find_or_add(name);
  }

  std::vector<Arc> arcs_of(const std::vector<Edge>& edges) {
    return arcs_from(edges, nodes_, problems_);
  }
  std::string errors() { return to_text(problems_.take()); }

  Problems problems_{""};
  NameTable nodes_{"node", problems_};
  LinkTable links_{nodes_, problems_};
};

TEST_F(LinkTables, AFixedDurationBesideAnArcStandsTheOtherWayRound) {
  links_.add(Arc{0, 1, 0, 9}, {});
  links_.add(ContingentLink{0, 1, 4, 4}, {});

  EXPECT_THAT(links_.take_arcs(), ElementsAre(Arc{0, 1, 0, 9}, Arc{1, 0, -4, -4}));
  EXPECT_EQ(errors(), "");
}

TEST_F(LinkTables, AnEdgeAndItsOppositeAreOneArcInTheOrderOfTheFirst) {
  EXPECT_THAT(arcs_of({{0, 1, 9, {}}, {1, 2, 3, {}}, {1, 0, -4, {}}}),
              ElementsAre(Arc{0, 1, 4, 9}, Arc{1, 2, kMinusInfinite, 3}));
}

TEST_F(LinkTables, ALoneEdgeThatPointsBackInTimeIsTurned) {
  EXPECT_THAT(arcs_of({{1, 0, -4, {}}}), ElementsAre(Arc{0, 1, 4, kInfinite}));
  EXPECT_THAT(arcs_of({{1, 0, 4, {}}}), ElementsAre(Arc{1, 0, kMinusInfinite, 4}));
}

TEST_F(LinkTables, EdgesThatLeaveNoRoomStayTwoArcs) {
  EXPECT_THAT(arcs_of({{1, 0, -4, {}}, {0, 1, 3, {}}}),
              ElementsAre(Arc{1, 0, kMinusInfinite, -4}, Arc{0, 1, kMinusInfinite, 3}));
  EXPECT_EQ(errors(), "");
}

TEST_F(LinkTables, EdgesGivenTwiceAreProblems) {
  arcs_of({{0, 1, 1, {}}, {0, 1, 1, {}}});

  EXPECT_THAT(errors(), HasSubstr("the edge from 'a' to 'b' is there twice"));
}

TEST_F(LinkTables, ALoopStaysWhenNothingKeepsIt) {
  EXPECT_THAT(arcs_of({{2, 2, 1, {}}}), testing::IsEmpty());
  EXPECT_THAT(arcs_of({{2, 2, -1, {}}}), ElementsAre(Arc{2, 2, kMinusInfinite, -1}));
  EXPECT_EQ(errors(), "");
}

TEST(EdgesFrom, KeepsTheTightestOfEachPair) {
  const std::vector<Edge> edges =
      edges_from({{0, 1, 2, 9}, {1, 0, -7, kInfinite}, {1, 2, kMinusInfinite, kInfinite}});

  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].weight, 7);
  EXPECT_EQ(edges[1].weight, -2);
}

TEST(AppendFixed, TakesTheDirectionThatIsFree) {
  std::vector<Arc> arcs{{0, 1, 0, 9}};

  append_fixed(arcs, {{0, 1, 4, 4}, {1, 2, 5, 5}});

  EXPECT_THAT(arcs, ElementsAre(Arc{0, 1, 0, 9}, Arc{1, 0, -4, -4}, Arc{1, 2, 5, 5}));
}

TEST(ChooseOrigin, TakesTheNodeOfThatName) {
  Stnu network{{"a", "Z"}, 0, {}, {}};

  choose_origin(network, "Z");

  EXPECT_EQ(network.origin, 1U);
  EXPECT_TRUE(network.arcs.empty());
}

TEST(ChooseOrigin, AddsItBeforeNodesThatFollowNoOther) {
  Stnu network{{"a", "b", "c", "d"}, 0, {{0, 1, 0, 5}, {2, 1, -9, -1}}, {{0, 3, 1, 2}}};

  choose_origin(network, "Z");

  EXPECT_EQ(network.nodes[network.origin], "Z");
  EXPECT_THAT(network.arcs,
              ElementsAre(Arc{0, 1, 0, 5}, Arc{2, 1, -9, -1}, Arc{4, 0, 0, kInfinite}));
}

}  // namespace
}  // namespace skein::temporal
