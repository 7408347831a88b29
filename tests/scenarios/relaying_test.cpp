// SPDX-License-Identifier: Apache-2.0
// Relaying (spec 1.3) and narrow radios in whole missions: what goes to or comes from a UAV out of
// reach goes past others, also a chain of them, and another takes over when one dies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/laws/healing.hpp"
#include "skein/laws/protocol.hpp"
#include "test_cases.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

using ::testing::IsEmpty;

class Radio : public ::testing::TestWithParam<std::string> {};

TEST_P(Radio, MeetsEveryExpectationAndKeepsTheLawsWhateverTheSeed) {
  const auto seeds = cases<std::uint64_t>(3, 500);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const scenario::Scenario scenario = scenario_at(GetParam(), with(seed));
    const Mission mission = play(scenario);

    EXPECT_EQ(mission.end, End::kFinished) << "seed " << seed;
    EXPECT_EQ(mission.failures(), "") << "seed " << seed;
    EXPECT_THAT(laws::broken_protocol(mission.records), IsEmpty()) << "seed " << seed;
    EXPECT_THAT(laws::broken_healing(mission.records, laws::healing_limits(scenario)), IsEmpty())
        << "seed " << seed;
    EXPECT_EQ(mission.untrue, "") << "seed " << seed;
  }
}

TEST_P(Radio, IsTheSameByteForByteForOneSeed) {
  const std::string once = play(scenario_at(GetParam(), with(1))).log();

  EXPECT_TRUE(once == play(scenario_at(GetParam(), with(1))).log());
}

INSTANTIATE_TEST_SUITE_P(Missions, Radio,
                         ::testing::Values("relaying/one-relay", "relaying/chain",
                                           "relaying/relay-dies", "comets/serial-radio"),
                         [](const auto& one) {
                           std::string name = one.param;
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name;
                         });

// The expectations can fail: without relays contact with who is out of reach is lost.
TEST(Relaying, IsWhatKeepsContact) {
  for (const char* name : {"relaying/one-relay", "relaying/chain", "relaying/relay-dies"}) {
    scenario::Scenario scenario = scenario_at(name, with(1));
    scenario.radio.relays.clear();

    EXPECT_THAT(play(scenario).failures(), ::testing::HasSubstr("never lost")) << name;
  }
}

}  // namespace
}  // namespace skein::testing
