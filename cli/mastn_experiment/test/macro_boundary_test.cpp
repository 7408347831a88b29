// SPDX-License-Identifier: Apache-2.0
#include "macro_boundary.hpp"

#include <gtest/gtest.h>

namespace skein::temporal {
namespace {

// A: v0 - 1 - 2 - 3 - 4 - 5 and 1 - 3; B: v0 - 6. External: 2 - 6 and 5 - 6. Interior: {1}, {3, 4}
// until the arc 1 - 3 joins them.
Mastn two_agents() {
  Mastn mastn;
  mastn.agents = {"A", "B"};
  mastn.nodes = {"v0", "a1", "a2", "a3", "a4", "a5", "b1"};
  mastn.owner = {0, 0, 0, 0, 0, 0, 1};
  mastn.arcs = {{0, 1, 0, 1}, {1, 2, 0, 1}, {2, 3, 0, 1}, {3, 4, 0, 1},
                {4, 5, 0, 1}, {0, 6, 0, 1}, {2, 6, 0, 1}, {5, 6, 0, 1}};
  return mastn;
}

TEST(MacroBoundary, CountsFrontierNodesAndTheOriginAroundAComponent) {
  const MacroBoundary boundary(two_agents());

  EXPECT_EQ(boundary.ordered_pairs(0), 2U) << "a1 is between v0 and a2";
  EXPECT_EQ(boundary.ordered_pairs(3), 2U) << "a3 and a4 are between a2 and a5";
  EXPECT_EQ(boundary.greatest(), 2U);
}

TEST(MacroBoundary, JoinsComponentsThatAnArcConnects) {
  Mastn mastn = two_agents();
  mastn.arcs.push_back({1, 3, 0, 1});
  const MacroBoundary boundary(mastn);

  EXPECT_EQ(boundary.ordered_pairs(0), 6U) << "v0, a2, a5";
  EXPECT_EQ(boundary.greatest(), 3U);
}

TEST(MacroBoundary, AnArcBetweenTwoBoundaryNodesIsAComponent) {
  const MacroBoundary boundary(two_agents());

  EXPECT_EQ(boundary.ordered_pairs(5), 2U) << "v0 to b1, which has external arcs";
}

TEST(MacroBoundary, WithoutExternalArcsOnlyTheOriginIsAround) {
  Mastn mastn = two_agents();
  mastn.arcs.resize(6);
  const MacroBoundary boundary(mastn);

  EXPECT_EQ(boundary.ordered_pairs(2), 0U);
  EXPECT_EQ(boundary.greatest(), 1U);
}

}  // namespace
}  // namespace skein::temporal
