// SPDX-License-Identifier: Apache-2.0
// A node that was dead hears all that came meanwhile only once it is back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/mission.hpp"

namespace skein::executive {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::Mission;
using testing::TaskOf;

class AfterSilence : public ::testing::Test {
 protected:
  static Config impatient() {
    Config config = testing::named("marvin");
    config.functional_timeout = Duration::seconds(3);
    return config;
  }
  Mission mission_{impatient()};
};

TEST_F(AfterSilence, AnswersAreWaitedForAnew) {
  mission_.start(TaskOf(1, "goto"));

  EXPECT_THAT(mission_.at(100).hears_again(), IsEmpty());

  EXPECT_THAT(mission_.at(102.9).tick(), IsEmpty());
  EXPECT_THAT(mission_.runs(1), ElementsAre("1 running"));
  EXPECT_THAT(mission_.at(110).tick(), IsEmpty());
}

TEST_F(AfterSilence, AnswersAreWaitedForNoLongerThanAny) {
  mission_.start(TaskOf(1, "goto"));
  mission_.at(100).hears_again();

  EXPECT_THAT(mission_.at(103).tick(), ElementsAre("1 aborted"));
}

TEST_F(AfterSilence, AnInterruptionIsWaitedForAnewToo) {
  mission_.start(TaskOf(1, "goto"));
  mission_.runs(1);
  mission_.abort(1);

  EXPECT_THAT(mission_.at(100).hears_again(), IsEmpty());

  EXPECT_THAT(mission_.aborted(1), ElementsAre("1 aborted"));
}

}  // namespace
}  // namespace skein::executive
