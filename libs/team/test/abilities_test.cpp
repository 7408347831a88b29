// SPDX-License-Identifier: Apache-2.0
// Which UAVs have what tasks need.
#include "skein/team/abilities.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::team {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Three UAVs carry 1, 2 and 3 kg.
struct Abilities : ::testing::Test {
  Abilities() {
    for (const auto& [uav, payload] :
         std::map<std::string, double>{{"heliv", 1}, {"karma", 2}, {"marvin", 3}})
      vehicles[uav].abilities = {{"payload", payload}};
    task.task.id = mission::GoalId(12);
  }
  std::vector<std::string> lacks(double least) {
    using interaction::Requirement;
    task.needs = {{"payload", Requirement::Bound{interaction::Relation::kAtLeast, least}}};
    std::vector<std::string> sentences;
    for (const Conflict& one :
         lacks_of({mission::MissionId(1), {task}, "script"}, roster, vehicles)) {
      EXPECT_EQ(one.task, mission::GoalId(12));
      sentences.push_back(one.sentence);
    }
    return sentences;
  }
  Roster roster{{"marvin", "heliv", "karma"}};
  Vehicles vehicles;
  GlobalTask task;
};

TEST_F(Abilities, OneThatHasWhatIsNeededIsEnoughForATaskOfOne) { EXPECT_THAT(lacks(3), IsEmpty()); }

TEST_F(Abilities, IfNobodyHasItEachSaysWhatItLacks) {
  EXPECT_THAT(lacks(4), ElementsAre("task 12: nobody has what it needs: "
                                    "heliv: it lacks payload ≥ 4 (it has 1); "
                                    "karma: it lacks payload ≥ 4 (it has 2); "
                                    "marvin: it lacks payload ≥ 4 (it has 3)"));
}

TEST_F(Abilities, OfATaskOfSeveralEachNeedsIt) {
  task.members = 2;
  EXPECT_THAT(lacks(2), IsEmpty());
  EXPECT_THAT(lacks(3), ElementsAre("task 12: 1 UAVs have what it needs, not 2: "
                                    "heliv: it lacks payload ≥ 3 (it has 1); "
                                    "karma: it lacks payload ≥ 3 (it has 2)"));
}

TEST_F(Abilities, WhoIsForbiddenDoesNotCountAndWhoItIsPinnedToNeedsIt) {
  task.not_by = {"marvin"};
  EXPECT_EQ(lacks(3).size(), 1U);
  task.not_by = {};
  task.by = "karma";
  EXPECT_THAT(lacks(2), IsEmpty());
  EXPECT_EQ(lacks(3).size(), 1U);
  task.members = 2;
  EXPECT_THAT(lacks(2), IsEmpty());
  task.by = "heliv";
  EXPECT_EQ(lacks(2).size(), 1U) << "the two others do not help";
}

}  // namespace
}  // namespace skein::team
