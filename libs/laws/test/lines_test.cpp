// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::Story;

TEST(Lines, ThatLackWhatOneOfTheirKindMustHaveAreTold) {
  const MissionTime at = MissionTime::seconds(3);
  Story story;
  story.line(journal::Record(at, "marvin", "goal").with("uav", "marvin").with("goal", 7));
  story.line(journal::Record(at, "ground", "owner").with("task", 1));
  story.line(journal::Record(at, "ground", "of-another-kind").with("task", 1));

  EXPECT_THAT(story.broken("lines"),
              ElementsAre(HasSubstr("this line lacks something: {\"at\":3"), HasSubstr("owner")));
}

}  // namespace
}  // namespace skein::laws
