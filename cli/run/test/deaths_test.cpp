// SPDX-License-Identifier: Apache-2.0
#include "deaths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace skein::run_tool {
namespace {

using scenario::KillSpec;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Stage = Deaths::Stage;

KillSpec kill(double at, const char* node, std::optional<double> restart_after = {},
              bool forgets = false) {
  KillSpec spec{MissionTime::seconds(at), node, std::nullopt, forgets};
  if (restart_after) spec.restart_after = Duration::seconds(*restart_after);
  return spec;
}

// Daemons that are dead the moment after they are killed.
class SomeDeaths : public ::testing::Test {
 protected:
  // What is done at an instant, at rate 10: the steady clock shows a tenth.
  std::vector<std::string> at(double mission) {
    std::vector<std::string> done;
    const auto stage_of = [&](const std::string& node) { return stages[node]; };
    while (const auto deed = deaths.next(MissionTime::seconds(mission),
                                         Duration::seconds(mission / 10), stage_of)) {
      stages[deed->node] = deed->kills ? Stage::kDead : Stage::kLives;
      done.push_back((deed->kills ? "kill " : deed->forgets ? "restart " : "resume ") + deed->node);
    }
    return done;
  }

  Deaths deaths{{}, 10};
  std::map<std::string, Stage> stages;
};

TEST_F(SomeDeaths, AreFollowedByRestartsWhereTheScenarioSaysSo) {
  deaths = Deaths({kill(20, "sim"), kill(10, "marvin", 4), kill(10, "ground", 2, true)}, 10);

  EXPECT_THAT(at(9), IsEmpty());
  EXPECT_FALSE(deaths.awaits_restart());
  EXPECT_THAT(at(10), ElementsAre("kill marvin", "kill ground"));
  EXPECT_TRUE(deaths.awaits_restart());
  EXPECT_THAT(at(12), ElementsAre("restart ground"));
  EXPECT_THAT(at(30), ElementsAre("kill sim", "resume marvin"));
  EXPECT_FALSE(deaths.awaits_restart());
}

TEST_F(SomeDeaths, MayOverlapAndWhoLivesIsNotStartedAgain) {
  deaths = Deaths({kill(10, "marvin", 30), kill(15, "marvin", 5), kill(60, "marvin")}, 10);

  EXPECT_THAT(at(10), ElementsAre("kill marvin"));
  EXPECT_THAT(at(15), IsEmpty()) << "who is dead cannot die";
  EXPECT_THAT(at(20), ElementsAre("resume marvin"));
  EXPECT_THAT(at(40), IsEmpty()) << "it lives";
  EXPECT_FALSE(deaths.awaits_restart());
  EXPECT_THAT(at(60), ElementsAre("kill marvin"));
  EXPECT_THAT(at(90), IsEmpty()) << "for good";
}

TEST_F(SomeDeaths, AreOverBeforeTheRestart) {
  deaths = Deaths({kill(10, "marvin", 1)}, 10);
  EXPECT_THAT(at(10), ElementsAre("kill marvin"));

  stages["marvin"] = Stage::kDies;
  EXPECT_THAT(at(12), IsEmpty());

  stages["marvin"] = Stage::kDead;
  EXPECT_THAT(at(13), ElementsAre("resume marvin"));
}

}  // namespace
}  // namespace skein::run_tool
