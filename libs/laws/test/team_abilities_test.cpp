// SPDX-License-Identifier: Apache-2.0
// Who does a task of a team has what it needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/story.hpp"

namespace skein::laws::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// 11 needs one that carries 2 kg; Marvin carries 3, Heliv 1.
struct Carrying : Story {
  Carrying() {
    using interaction::Requirement;
    team::GlobalTask task;
    task.task.id = mission::GoalId(11);
    task.needs = {{"payload", Requirement::Bound{interaction::Relation::kAtLeast, 2}}};
    global_mission({task});
    figure("marvin", "payload", 3).figure("heliv", "payload", 1);
  }
  std::vector<std::string> begun_by(const std::string& uav, const std::string& end) {
    team(uav, 25, 11, 1, "begun").team(uav, 60, 11, 1, end);
    return broken("team-abilities");
  }
};

TEST(TeamAbilities, WhoHasWhatATaskNeedsMayDoIt) {
  EXPECT_THAT(Carrying().begun_by("marvin", "done"), IsEmpty());
}

TEST(TeamAbilities, WhoLacksItDoesNotEvenBegin) {
  const auto is_told =
      ElementsAre(HasSubstr("it began task 11 of the team, and it lacks payload ≥ 2 (it has 1)"));
  EXPECT_THAT(Carrying().begun_by("heliv", "done"), is_told);
  EXPECT_THAT(Carrying().begun_by("heliv", "put-back"), is_told);
}

}  // namespace
}  // namespace skein::laws::testing
