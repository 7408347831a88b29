// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/auction/task.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TaskNumber number(std::uint32_t n) { return TaskNumber(n); }

Task task(std::uint32_t n, double duration = 0) {
  Task made;
  made.number = number(n);
  made.duration = duration;
  return made;
}

TEST(Contradictions, AChainThatEndsInTimeIsNone) {
  Task last = task(3, 10);
  last.deadline = 60;

  const auto found = contradictions(
      {{task(1, 20), task(2, 30), last}, {{number(1), number(2)}, {number(2), number(3)}}});

  EXPECT_THAT(found, IsEmpty());
}

TEST(Contradictions, ADeadlineThatAChainCannotMeetNamesTheWholeChain) {
  Task last = task(3, 10);
  last.deadline = 59;

  const auto found = contradictions(
      {{task(1, 20), task(2, 30), last}, {{number(1), number(2)}, {number(2), number(3)}}});

  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].chain, ElementsAre(number(1), number(2), number(3)));
  EXPECT_THAT(found[0].why, HasSubstr("60 s"));
}

TEST(Contradictions, AWindowShorterThanTheTaskIsOne) {
  Task narrow = task(7, 30);
  narrow.earliest = 100;
  narrow.deadline = 120;

  const auto found = contradictions({{narrow}, {}});

  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].chain, ElementsAre(number(7)));
}

TEST(Contradictions, ACircleIsNamedFromTaskToTheSameTask) {
  const auto found = contradictions({{task(1), task(2), task(3), task(4)},
                                     {{number(1), number(2)},
                                      {number(2), number(3)},
                                      {number(3), number(2)},
                                      {number(3), number(4)}}});

  ASSERT_THAT(found, SizeIs(1));
  ASSERT_THAT(found[0].chain, SizeIs(3));
  EXPECT_EQ(found[0].chain.front(), found[0].chain.back());
  EXPECT_THAT(std::set<TaskNumber>(found[0].chain.begin(), found[0].chain.end()),
              ElementsAre(number(2), number(3)));
}

TEST(Contradictions, EverythingWrongIsSaidAtOnce) {
  Task torn = task(5);
  torn.pinned = MemberNumber(1);
  torn.forbidden = {MemberNumber(1)};
  Task late = task(6, 10);
  late.deadline = 5;

  const auto found = contradictions({{torn, late, task(6)}, {{number(5), number(9)}}});

  std::vector<std::string> said;
  for (const Contradiction& one : found) said.push_back(one.why);
  EXPECT_THAT(said, ElementsAre(HasSubstr("pinned"), HasSubstr("twice"), HasSubstr("task 9 is not"),
                                HasSubstr("cannot end before")));
}

}  // namespace
}  // namespace skein::auction
