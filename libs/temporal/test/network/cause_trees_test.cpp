// SPDX-License-Identifier: Apache-2.0
// Bounds that follow from each other, without a propagation.
#include "network/cause_trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr Bound kLower = Bound::kLower;

/// v0 before v1, v1 before v2 and v3: arc n ends at node n + 1.
class TreesOfFour : public ::testing::Test {
 protected:
  TreesOfFour() {
    for (int node = 0; node < 4; ++node) {
      arcs.add_node();
      trees.add_node();
    }
    arcs.add(0, 1);
    arcs.add(1, 2);
    arcs.add(1, 3);
    for (const NodeIndex node : {1U, 2U, 3U}) write(node, 10 * node);
    trees.take_changes(changes);
    log.mark();
  }
  /// The earliest date follows from the node before.
  void write(NodeIndex node, Ticks value) {
    trees.write(arcs, node, kLower, {value, 2 * (node - 1), kNone}, log);
  }
  std::vector<NodeIndex> tree(NodeIndex root) { return trees.tree(root, kLower); }
  std::vector<BoundChange> changed() {
    trees.take_changes(changes);
    return changes;
  }
  void undo() {
    log.undo_to_mark([&](const Undo& one) {
      if (one.write == Undo::Write::kState) return trees.undo(arcs, one, log);
      trees.at(one.id, one.bound).stale = false;
    });
  }

  ArcTable arcs;
  CauseTrees trees;
  UndoLog log;
  std::vector<BoundChange> changes;
};

TEST_F(TreesOfFour, AValueIsFollowedByItsEffects) {
  EXPECT_THAT(tree(1), UnorderedElementsAre(1, 2, 3));
  EXPECT_EQ(tree(0).front(), 0U);
  EXPECT_THAT(tree(0), UnorderedElementsAre(0, 1, 2, 3));
  EXPECT_THAT(tree(2), ElementsAre(2));
  EXPECT_THAT(trees.tree(1, Bound::kUpper), ElementsAre(1));
}

TEST_F(TreesOfFour, WhatFollowsFromNothingLeavesItsTreeWithItsEffects) {
  trees.write(arcs, 1, kLower, {}, log);

  EXPECT_THAT(tree(0), ElementsAre(0));
  EXPECT_THAT(tree(1), UnorderedElementsAre(1, 2, 3));
  EXPECT_EQ(trees.at(1, kLower).value, kFloating);
}

TEST_F(TreesOfFour, LeavesFromAnyPlaceAmongItsSiblings) {
  const ArcId third = arcs.add(1, 0);
  trees.write(arcs, 1, kLower, {10, kNone, kNone}, log);
  std::vector<NodeIndex> order{0, 2, 3};
  do {
    trees.write(arcs, 0, kLower, {5, 2 * third, kNone}, log);
    for (const NodeIndex node : {2U, 3U}) write(node, 10 * node);
    ASSERT_EQ(tree(1).size(), 4U);

    for (std::size_t left = 3; left > 0; --left) {
      trees.write(arcs, order[left - 1], kLower, {}, log);
      ASSERT_EQ(tree(1).size(), left) << order[left - 1];
    }
  } while (std::ranges::next_permutation(order).found);
}

TEST_F(TreesOfFour, ACauseIsACauseOfAllThatFollows) {
  EXPECT_TRUE(trees.is_cause_of(0, 3, kLower));
  EXPECT_TRUE(trees.is_cause_of(1, 2, kLower));
  EXPECT_FALSE(trees.is_cause_of(2, 3, kLower));
  EXPECT_FALSE(trees.is_cause_of(3, 1, kLower));
  EXPECT_FALSE(trees.is_cause_of(0, 3, Bound::kUpper));
}

TEST_F(TreesOfFour, WhatIsStaleIsNotGatheredAgainUntilItIsWritten) {
  EXPECT_FALSE(trees.is_cause_of(1, kNone, kLower));
  trees.mark_gathered_stale(kLower, log);
  EXPECT_TRUE(trees.at(2, kLower).stale);
  EXPECT_FALSE(trees.at(1, kLower).stale);
  EXPECT_FALSE(trees.is_cause_of(0, 3, kLower));

  write(3, 35);

  EXPECT_TRUE(trees.is_cause_of(0, 3, kLower));
  EXPECT_THAT(tree(1), UnorderedElementsAre(1, 2, 3)) << "also what is stale";
}

TEST_F(TreesOfFour, OnlyNetChangesAreToldInTheOrderOfTheFirst) {
  write(3, 31);
  write(2, 21);
  write(3, 33);
  write(2, 20);

  EXPECT_THAT(changed(), ElementsAre(BoundChange{3, kLower, 33}));
  EXPECT_THAT(changed(), IsEmpty());
}

TEST_F(TreesOfFour, OfANodeThatIsGoneNoChangeIsTold) {
  trees.add_node();
  arcs.add_node();
  trees.write(arcs, 4, kLower, {7, kNone, kNone}, log);
  trees.drop_node();

  EXPECT_THAT(changed(), IsEmpty());
}

TEST_F(TreesOfFour, UndoneTheyAreAsTheyWere) {
  trees.is_cause_of(1, kNone, kLower);
  trees.mark_gathered_stale(kLower, log);
  write(2, 25);
  trees.write(arcs, 1, kLower, {}, log);

  undo();

  EXPECT_THAT(tree(0), UnorderedElementsAre(0, 1, 2, 3));
  for (const NodeIndex node : {1U, 2U, 3U}) {
    EXPECT_EQ(trees.at(node, kLower).value, 10 * node) << node;
    EXPECT_FALSE(trees.at(node, kLower).stale) << node;
  }
  EXPECT_THAT(changed(), IsEmpty());
}

TEST_F(TreesOfFour, AStateThatWasStaleIsStaleAgainWhenItsWriteIsUndone) {
  trees.is_cause_of(1, kNone, kLower);
  trees.mark_gathered_stale(kLower, log);
  log.mark();
  write(2, 25);

  undo();

  EXPECT_TRUE(trees.at(2, kLower).stale);
}

}  // namespace
}  // namespace skein::temporal
