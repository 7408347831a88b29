// SPDX-License-Identifier: Apache-2.0
// Small networks with uncertainty whose verdict is worked out by hand, each with its reason; both
// checks, the dispatchable form and executions at the extreme durations must agree with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controllability/back_propagation.hpp"
#include "skein/temporal/stnu_controllability.hpp"
#include "skein/temporal/stnu_execution.hpp"
#include "stnu_builder.hpp"

namespace skein::temporal {
namespace {

using ::testing::IsEmpty;
using testing::StnuBuilder;

struct Case {
  const char* why;
  bool controllable;
  Stnu network;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.why; }

/// A task of 2 to 5 from a to c, and x with c - x in [min, max].
StnuBuilder beside(Ticks min, Ticks max) {
  return StnuBuilder("z a c x").contingent("a", "c", 2, 5).arc("x", "c", min, max);
}

/// Tasks a -> b of 2 to 4 and c -> d of 3 to 6, the second 0 to 5 after the first.
StnuBuilder in_turn() {
  return StnuBuilder("z a b c d")
      .contingent("a", "b", 2, 4)
      .arc("b", "c", 0, 5)
      .contingent("c", "d", 3, 6);
}

/// Tasks a -> b of 2 to 5 and a -> c of 3 to 6.
StnuBuilder together() {
  return StnuBuilder("z a b c").contingent("a", "b", 2, 5).contingent("a", "c", 3, 6);
}

/// As together(), and x after both by `deadline` after a.
Stnu joined(Ticks deadline) {
  return StnuBuilder("z a b c x")
      .contingent("a", "b", 2, 5)
      .contingent("a", "c", 3, 6)
      .arc("b", "x", 0, kInfinite)
      .arc("c", "x", 0, kInfinite)
      .arc("a", "x", 0, deadline)
      .build();
}

/// x has c - x in [-3, 1], the task a -> c lasts 2 to 6, and d comes exactly `ahead` before x.
StnuBuilder announced(Ticks ahead) {
  return StnuBuilder("z a c x d")
      .contingent("a", "c", 2, 6)
      .arc("x", "c", -3, 1)
      .arc("d", "x", ahead, ahead);
}

std::vector<Case> preceding_cases() {
  // x strictly before c cannot look at c, so x - a must lie in [5 - max, 2 - min]; with min = 0 it
  // may still react to an early end.
  return {
      {"x at the end, or at 3 when it has not come", true, beside(0, 2).build()},
      {"x at the end, or at 5 when it has not come", true, beside(0, 0).build()},
      {"x - a in [1, 1]", true, beside(1, 4).build()},
      {"x - a in [2, 1]", false, beside(1, 3).build()},
      {"x - a in [-2, 0], before the task", true, beside(2, 7).build()},
      {"x - a in [-2, 0] and x after a leaves 0", true, beside(2, 7).arc("a", "x", 0, 9).build()},
      {"x - a in [-2, 0] and x strictly after a", false, beside(2, 7).arc("a", "x", 1, 9).build()},
      {"x - a in [1, 2] and is 1", true, beside(0, 4).arc("a", "x", 1, 1).build()},
      {"x - a in [1, 2] and is 2", true, beside(0, 4).arc("a", "x", 2, 2).build()},
      {"x - a in [1, 2] and is 3", false, beside(0, 4).arc("a", "x", 3, 3).build()},
      {"x - a in [1, 2] and is 0", false, beside(0, 4).arc("a", "x", 0, 0).build()},
  };
}

std::vector<Case> following_cases() {
  return {
      {"x reacts at the very instant", true, beside(0, 0).arc("c", "x", 0, 0).build()},
      {"x exactly 4 after c reacts", true, beside(-4, -4).build()},
      {"x reacts, and the task may make it late: 5 + 1 > 5", false,
       beside(-3, -1).arc("a", "x", 0, 5).build()},
      {"x reacts, 5 + 1 is just in time", true, beside(-3, -1).arc("a", "x", 0, 6).build()},
      {"x reacts, 2 + 3 is just late enough", true, beside(-3, -1).arc("a", "x", 5, 99).build()},
      {"x reacts, 2 + 3 is too early for 6", false, beside(-3, -1).arc("a", "x", 6, 99).build()},
      {"x meets 5 from 2 + 3 to 5 + 0", true, beside(-3, 0).arc("a", "x", 5, 5).build()},
      {"x cannot be at 5 when c is, and 1 later", false,
       beside(-3, -1).arc("a", "x", 5, 5).build()},
  };
}

std::vector<Case> sequence_cases() {
  return {
      {"longest durations 4 + 6 fit in 10", true, in_turn().arc("a", "d", 0, 10).build()},
      {"longest durations 4 + 6 do not fit in 9", false, in_turn().arc("a", "d", 0, 9).build()},
      {"shortest, with the longest pause: 2 + 5 + 3", true,
       in_turn().arc("a", "d", 10, 99).build()},
      {"2 + 5 + 3 does not reach 11", false, in_turn().arc("a", "d", 11, 99).build()},
      {"c at 7: d from 10 to 13, b leaves a pause of 3 to 5", true,
       in_turn().arc("a", "d", 10, 13).build()},
      {"d's uncertainty of 3 does not fit in [10, 12]", false,
       in_turn().arc("a", "d", 10, 12).build()},
      {"both uncertainties may add when nothing corrects them", true,
       StnuBuilder("z a b c")
           .contingent("a", "b", 1, 2)
           .contingent("b", "c", 1, 2)
           .arc("a", "c", 2, 4)
           .build()},
      {"and do not fit in less", false,
       StnuBuilder("z a b c")
           .contingent("a", "b", 1, 2)
           .contingent("b", "c", 1, 2)
           .arc("a", "c", 3, 4)
           .build()},
  };
}

std::vector<Case> parallel_cases() {
  return {
      {"c - b from 3 - 5 to 6 - 2", true, together().arc("b", "c", -2, 4).build()},
      {"b may be 2 after c", false, together().arc("b", "c", -1, 4).build()},
      {"c may be 4 after b", false, together().arc("b", "c", -2, 3).build()},
      {"x after both, 6 after a at worst", true, joined(6)},
      {"x after both, 6 after a at worst, is not by 5", false, joined(5)},
  };
}

std::vector<Case> announced_cases() {
  // d before c always: d - a in [6 - (1 + ahead), 2 - (ahead - 3)] as one interval of c - d.
  return {
      {"d - a in [1, 1]", true, announced(4).build()},
      {"d - a in [0, 0]", true, announced(5).build()},
      {"d - a in [-1, -1], before the task", true, announced(6).build()},
      {"d - a in [-1, -1] and not before the task", false,
       announced(6).arc("a", "d", 0, kInfinite).build()},
      {"d waits for c or for 3 after a", true, announced(2).build()},
      {"d waits for c or for 3 after a, and may not wait beyond 2", false,
       announced(2).arc("a", "d", kMinusInfinite, 2).build()},
      {"d waits for c or for 3 after a, and may wait until 3", true,
       announced(2).arc("a", "d", kMinusInfinite, 3).build()},
  };
}

std::vector<Case> calendar_cases() {
  const auto task = [](Ticks start_min, Ticks start_max, Ticks end_min, Ticks end_max) {
    return StnuBuilder("z a c")
        .arc("z", "a", start_min, start_max)
        .contingent("a", "c", 5, 8)
        .arc("z", "c", end_min, end_max)
        .build();
  };
  return {
      {"started at 10 at the latest, 18 holds", true, task(0, 10, 5, 18)},
      {"started at 9, 17 holds", true, task(0, 10, 5, 17)},
      {"started at 10, 17 does not hold", false, task(10, 10, 5, 17)},
      {"8 does not fit in 7", false, task(0, 10, 0, 7)},
      {"started at 0, 8 holds", true, task(0, 10, 0, 8)},
      {"started at 10 the end is after 15", true, task(0, 10, 15, 99)},
      {"16 is not reached by 10 + 5", false, task(0, 10, 16, 99)},
      {"the end wants a window of 3", true, task(0, 99, 20, 23)},
      {"a window of 2 is too small", false, task(0, 99, 20, 22)},
  };
}

class Textbook : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Preceding, Textbook, ::testing::ValuesIn(preceding_cases()));
INSTANTIATE_TEST_SUITE_P(Following, Textbook, ::testing::ValuesIn(following_cases()));
INSTANTIATE_TEST_SUITE_P(Sequence, Textbook, ::testing::ValuesIn(sequence_cases()));
INSTANTIATE_TEST_SUITE_P(Parallel, Textbook, ::testing::ValuesIn(parallel_cases()));
INSTANTIATE_TEST_SUITE_P(Announced, Textbook, ::testing::ValuesIn(announced_cases()));
INSTANTIATE_TEST_SUITE_P(Calendar, Textbook, ::testing::ValuesIn(calendar_cases()));

TEST_P(Textbook, BothChecksSayWhatWasWorkedOutByHand) {
  const auto result = check_dynamic_controllability(GetParam().network);

  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->controllable, GetParam().controllable);
  EXPECT_EQ(BackPropagation(GetParam().network, false).run(), GetParam().controllable);
  EXPECT_EQ(result->conflict.empty(), GetParam().controllable);
  EXPECT_EQ(make_dispatchable(GetParam().network).has_value(), GetParam().controllable);
}

TEST_P(Textbook, EveryCombinationOfExtremeDurationsIsExecutedWithinBounds) {
  const auto form = make_dispatchable(GetParam().network);
  if (!form) return;
  const std::vector<ContingentLink>& links = GetParam().network.contingent;
  Random random(1);

  for (std::size_t choice = 0; choice < (std::size_t{1} << links.size()); ++choice) {
    std::vector<Ticks> durations;
    for (std::size_t i = 0; i < links.size(); ++i) {
      durations.push_back((choice >> i & 1U) != 0 ? links[i].max : links[i].min);
    }
    for (const StartPolicy policy :
         {StartPolicy::kEarliest, StartPolicy::kLatest, StartPolicy::kRandom}) {
      const Execution run = execute(*form, durations, policy, random);

      EXPECT_TRUE(run.complete);
      EXPECT_THAT(run.violated, IsEmpty());
      EXPECT_THAT(run.contingencies, IsEmpty());
    }
  }
}

}  // namespace
}  // namespace skein::temporal
