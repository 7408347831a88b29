// SPDX-License-Identifier: Apache-2.0
// A short mission over real packets between network namespaces: what the long ones of this folder
// play with COMETS, in a quarter of a minute each.
#include <gtest/gtest.h>

#include <iostream>

#include "skein/laws/healing.hpp"
#include "skein/laws/protocol.hpp"
#include "testing/clocks_apart.hpp"
#include "testing/lab_run.hpp"

namespace skein {
namespace {

using skein::testing::breaches_beyond_clocks;
using skein::testing::Carried;
using skein::testing::LabRun;

constexpr double kRate = 10;

class ShortMission : public ::testing::Test {
 protected:
  /// What the air carried; skipped where this machine cannot have it.
  void play(const std::string& faults, const std::string& dds = "fastdds") {
    run_.start("../tests/network/scenarios/meeting", faults,
               {"--", "--rate", "10", "--quiet", "--dds", dds});
    const auto code = run_.wait(90);
    ASSERT_TRUE(code.has_value()) << "no end";
    if (*code == 77) {
      std::cout << run_.output();
      GTEST_SKIP() << run_.output();
    }
    EXPECT_EQ(*code, 0) << run_.output();
    const std::vector<journal::Record> records = run_.records();
    ASSERT_FALSE(records.empty());
    EXPECT_EQ(breaches_beyond_clocks(records, kRate), "");
    laws::HealingLimits limits;
    limits.healing = Duration::seconds(3 * kRate);
    EXPECT_EQ(laws::to_text(laws::broken_healing(records, limits)), "");
  }
  LabRun run_;
};

// What the air does not understand is no machine that cannot do it.
TEST_F(ShortMission, IsNotBegunWithAShareOfThirtyAndSaysSo) {
  run_.start("../tests/network/scenarios/meeting", "loss", {"--loss", "30"});
  const auto code = run_.wait(60);
  ASSERT_TRUE(code.has_value()) << "no end";
  if (*code == 77 && run_.output().find("Value 30") == std::string::npos) GTEST_SKIP();
  EXPECT_EQ(*code, 2) << run_.output();
  EXPECT_NE(run_.output().find("not in range"), std::string::npos) << run_.output();
}

TEST_F(ShortMission, EndsWellWhereThreeOfTenPacketsAreLost) {
  play("loss");
  if (IsSkipped()) return;
  const Carried air = run_.carried();
  EXPECT_GT(air.lost / (air.lost + air.carried), 0.15) << "nothing is before the mission starts";
  EXPECT_EQ(air.pieces, 0) << "who loses one of several pieces has lost them all";
}

TEST_F(ShortMission, EndsWellOverSerialRadiosWhichAreNotAskedForMoreThanTheyCarry) {
  play("narrow");
  if (IsSkipped()) return;
  const Carried air = run_.carried();
  EXPECT_LT(air.overflowed, 0.02 * air.carried);
}

TEST_F(ShortMission, EndsWellOnLinksThatAreUpOneSecondAndDownOne) {
  play("second-by-second");
  if (IsSkipped()) return;
  EXPECT_GT(run_.carried().cut, 50) << "the cuts were cuts";
}

TEST_F(ShortMission, EndsWellOverCycloneDdsWhereThreeOfTenPacketsAreLost) {
  play("loss", "cyclonedds");
}

TEST_F(ShortMission, EndsWellWithTheGroundStationAloneOnCycloneDdsAndFlappingLinks) {
  play("second-by-second", "ground=cyclonedds");
}

}  // namespace
}  // namespace skein
