// SPDX-License-Identifier: Apache-2.0
#include "network/pending_constraints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace skein::temporal {
namespace {

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

using Named = std::pair<Constraint, Bound>;

class PendingOfFour : public ::testing::Test {
 protected:
  PendingOfFour() {
    pending.resize(4);
    log.mark();
  }
  std::vector<Named> all() const {
    std::vector<Named> all;
    for (const auto& one : pending.all()) all.emplace_back(one.constraint, one.bound);
    return all;
  }

  PendingConstraints pending;
  UndoLog log;
};

TEST_F(PendingOfFour, AConstraintIsPendingOnceForEachKindOfBounds) {
  pending.add(2, Bound::kLower, log);
  pending.add(2, Bound::kLower, log);
  pending.add(2, Bound::kUpper, log);

  EXPECT_THAT(all(), UnorderedElementsAre(Named{2, Bound::kLower}, Named{2, Bound::kUpper}));
}

TEST_F(PendingOfFour, RemovingOneLeavesTheOthersWhereTheyAreFound) {
  for (const Constraint k : {0U, 1U, 2U, 3U}) pending.add(k, Bound::kLower, log);
  pending.remove(0, Bound::kLower, log);
  pending.remove(3, Bound::kLower, log);
  pending.remove(3, Bound::kLower, log);
  pending.remove(1, Bound::kUpper, log);

  EXPECT_THAT(all(), UnorderedElementsAre(Named{1, Bound::kLower}, Named{2, Bound::kLower}));
  pending.add(3, Bound::kLower, log);
  EXPECT_EQ(all().size(), 3U);
}

TEST_F(PendingOfFour, OnlyWhatChangesSomethingIsLogged) {
  pending.remove(1, Bound::kLower, log);
  pending.add(1, Bound::kUpper, log);
  pending.add(1, Bound::kUpper, log);
  pending.add(2, Bound::kLower, log);
  pending.remove(1, Bound::kUpper, log);
  std::vector<Undo::Write> writes;

  log.undo_to_mark([&](const Undo& undo) {
    writes.push_back(undo.write);
    undo.write == Undo::Write::kPendingAdded ? pending.remove(undo.id, undo.bound, log)
                                             : pending.add(undo.id, undo.bound, log);
  });

  EXPECT_EQ(writes.size(), 3U);
  EXPECT_THAT(all(), IsEmpty());
}

TEST_F(PendingOfFour, MoreConstraintsDoNotMoveThosePending) {
  pending.add(3, Bound::kUpper, log);
  pending.resize(8);
  pending.add(7, Bound::kLower, log);
  pending.remove(3, Bound::kUpper, log);

  EXPECT_THAT(all(), UnorderedElementsAre(Named{7, Bound::kLower}));
}

}  // namespace
}  // namespace skein::temporal
