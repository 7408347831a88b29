// SPDX-License-Identifier: Apache-2.0
#include "schedule/implied_bounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::supervisor {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr bool kKept = true, kNotKept = false;
constexpr temporal::NodeIndex kOne = 1, kNext = 2, kEnd = 3, kLate = 4;

auto bound(temporal::NodeIndex node, temporal::Ticks least) {
  return ::testing::AllOf(::testing::Field(&ImpliedBounds::Bound::node, node),
                          ::testing::Field(&ImpliedBounds::Bound::least, least));
}

/// `kNext` comes at most 5 after `kOne`, and at least 8 after `kLate`.
ImpliedBounds soon_before_another() {
  ImpliedBounds bounds(5);
  bounds.add(kOne, kNext, 5, kNotKept);
  bounds.add(kNext, kLate, -8, kKept);
  return bounds;
}

TEST(ImpliedBounds, WhatComesSoonBeforeAnotherWaitsForWhatThatWaitsFor) {
  EXPECT_THAT(soon_before_another().of(kOne), ElementsAre(bound(kLate, 3)));
}

TEST(ImpliedBounds, WhatTheExecutionSeesToIsLeftOut) {
  ImpliedBounds bounds = soon_before_another();
  bounds.add(kOne, kLate, -3, kKept);

  EXPECT_THAT(bounds.of(kOne), IsEmpty());
}

TEST(ImpliedBounds, WhatItSeesToInPartIsWaitedForAllTheSame) {
  ImpliedBounds bounds = soon_before_another();
  bounds.add(kOne, kLate, -2, kKept);

  EXPECT_THAT(bounds.of(kOne), ElementsAre(bound(kLate, 3)));
}

TEST(ImpliedBounds, WhatIsPastIsNotWaitedFor) {
  ImpliedBounds bounds = soon_before_another();
  bounds.set_past(kLate);

  EXPECT_THAT(bounds.of(kOne), IsEmpty());
}

TEST(ImpliedBounds, WhoBoundsNothingWaitsForNothing) {
  EXPECT_THAT(soon_before_another().of(kNext), IsEmpty());
}

TEST(ImpliedBounds, TwoThatComeTogetherDoNotWaitForEachOther) {
  ImpliedBounds bounds(5);
  bounds.add(kOne, kNext, 0, kNotKept);
  bounds.add(kNext, kOne, 0, kKept);
  bounds.add(kNext, kLate, 7, kNotKept);

  EXPECT_THAT(bounds.of(kOne), IsEmpty());
}

// It lasts 8 at least; `kNext` comes before its end, and 10 after `kLate`.
TEST(ImpliedBounds, WhatNatureMayEndEarlyBeginsNoEarlierThanItsLeastLeavesRoomFor) {
  ImpliedBounds bounds(5);
  bounds.add(kEnd, kNext, -1, kNotKept);
  bounds.add(kNext, kLate, -10, kKept);
  bounds.may_last(kOne, kEnd, 8);

  EXPECT_THAT(bounds.of(kOne), ElementsAre(bound(kLate, 3)));
}

TEST(ImpliedBounds, AnEndThatNothingComesBeforeBoundsNoStart) {
  ImpliedBounds bounds(5);
  bounds.add(kEnd, kNext, 1, kNotKept);
  bounds.add(kNext, kOne, -1, kKept);
  bounds.may_last(kOne, kEnd, 8);

  EXPECT_THAT(bounds.of(kOne), IsEmpty());
}

}  // namespace
}  // namespace skein::supervisor
