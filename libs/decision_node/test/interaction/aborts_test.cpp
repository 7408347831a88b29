// SPDX-License-Identifier: Apache-2.0
#include "interaction/aborts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace skein::decision_node {
namespace {

const executive::TaskId kAborted(7), kAnother(8);

TEST(Aborts, OfATaskThatNobodyHereAbortsNothingIsKnown) {
  Aborts aborts;
  aborts.note(kAnother, AbortedFor::kRole);

  EXPECT_EQ(aborts.of(kAborted), std::nullopt);
  EXPECT_EQ(aborts.take(kAborted), std::nullopt);
  EXPECT_EQ(aborts.of(kAnother), AbortedFor::kRole) << "the other is still under way";
}

TEST(Aborts, AreForgottenWithTheEndOfTheTask) {
  Aborts aborts;
  aborts.note(kAborted, AbortedFor::kNothing);

  EXPECT_EQ(aborts.take(kAborted), AbortedFor::kNothing);
  EXPECT_EQ(aborts.take(kAborted), std::nullopt);
}

// A meeting that is begun again without the lost, and that the role stops meanwhile: it is over.
// The same holds for a flight over closing air. In whatever order they come.
TEST(Aborts, OfSeveralReasonsTheRoleDecidesAndThenThatItIsBegunAnew) {
  std::vector<AbortedFor> reasons{AbortedFor::kRole, AbortedFor::kAnew, AbortedFor::kNothing};
  do {
    Aborts aborts;
    AbortedFor first = reasons.front();
    for (const AbortedFor why : reasons) {
      aborts.note(kAborted, why);
      first = std::min(first, why);
      EXPECT_EQ(aborts.of(kAborted), first);
    }
    EXPECT_EQ(aborts.take(kAborted), AbortedFor::kRole);
  } while (std::next_permutation(reasons.begin(), reasons.end()));
}

}  // namespace
}  // namespace skein::decision_node
