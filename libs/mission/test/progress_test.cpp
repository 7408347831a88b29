// SPDX-License-Identifier: Apache-2.0
// What was done of a high-level task, in words.
#include "skein/mission/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::mission {
namespace {

TEST(Progress, OfNothingSaysNothing) {
  EXPECT_TRUE(Progress{}.none());
  EXPECT_EQ(to_text(Progress{}), "");
}

TEST(Progress, AddsUpWhatWasPerceived) {
  Progress progress;
  progress.looks = {{"ir", {0, 0, 40}, Duration::seconds(200.04)},
                    {"visible", {9, 0, 40}, Duration::seconds(90)}};

  EXPECT_EQ(progress.looked(), Duration::seconds(290.04));
  EXPECT_EQ(to_text(progress), "perceived 290 s");
}

TEST(Progress, SaysAllThatWasDone) {
  Progress progress;
  progress.waited = Duration::seconds(12.5);
  progress.reached = {{1, 2, 3}};
  progress.synchronised = {551};

  EXPECT_EQ(to_text(progress), "waited 12.5 s, 1 place reached, synchronised 551");
  EXPECT_FALSE(progress.none());
}

}  // namespace
}  // namespace skein::mission
