// SPDX-License-Identifier: Apache-2.0
// What was not agreed is asked again each second, for as long as the patience lasts: here 30 s.
#include "interaction/asking_again.hpp"

#include <gtest/gtest.h>

namespace skein::decision_node {
namespace {

class Asking : public ::testing::Test {
 protected:
  static MissionTime after(double seconds) { return MissionTime::seconds(100 + seconds); }
  Asking() { asking.ask("divide", after(0)); }

  AskingAgain asking{Duration::seconds(30)};
};

TEST_F(Asking, WhileItIsUnderNegotiationNothingIsDue) {
  EXPECT_EQ(asking.next(), std::nullopt);
  EXPECT_EQ(asking.due(after(20)), std::nullopt);
  EXPECT_TRUE(asking.asks("divide"));
  EXPECT_FALSE(asking.asks("keep"));
}

TEST_F(Asking, WhatIsNotAgreedIsDueAfterASecond) {
  asking.not_agreed("nobody answers", after(3));
  EXPECT_EQ(asking.next(), after(4));
  EXPECT_EQ(asking.due(after(3.9)), std::nullopt);
  EXPECT_EQ(asking.due(after(4)), "divide");
  EXPECT_EQ(asking.why(), "nobody answers");
}

TEST_F(Asking, HoweverOftenItIsAskedThePatienceIsTheSame) {
  for (double now = 1; now < 29; now += 2) {
    asking.not_agreed("nobody answers", after(now));
    asking.ask("divide", after(now + 1));
    EXPECT_EQ(asking.next(), std::nullopt);
    EXPECT_EQ(asking.why(), "nobody answers");
  }
  EXPECT_TRUE(asking.lasts(after(29.9)));
  EXPECT_FALSE(asking.lasts(after(30)));
}

TEST_F(Asking, UnderOtherCircumstancesThePatienceIsWhatItWasAtFirst) {
  asking.renew(after(20));
  EXPECT_TRUE(asking.lasts(after(49.9)));
  EXPECT_FALSE(asking.lasts(after(50)));

  AskingAgain nothing(Duration::seconds(30));
  nothing.renew(after(20));
  EXPECT_EQ(nothing.next(), std::nullopt);
  EXPECT_FALSE(nothing.asks("divide"));
}

TEST_F(Asking, AnActionInPlaceOfAnotherGoesOnWithItsPatience) {
  asking.ask("keep", after(20));
  EXPECT_TRUE(asking.asks("keep"));
  EXPECT_FALSE(asking.lasts(after(30)));
}

TEST_F(Asking, WhatWasStoppedIsNotDueAndBeginsAnew) {
  asking.not_agreed("nobody answers", after(3));
  asking.stop("keep");
  EXPECT_TRUE(asking.asks("divide")) << "another was stopped";
  asking.stop("divide");
  EXPECT_EQ(asking.next(), std::nullopt);
  EXPECT_EQ(asking.why(), "");
  asking.not_agreed("it came late", after(5));
  EXPECT_EQ(asking.due(after(9)), std::nullopt) << "nothing is asked";
  asking.ask("divide", after(10));
  EXPECT_TRUE(asking.lasts(after(39.9)));
}

}  // namespace
}  // namespace skein::decision_node
