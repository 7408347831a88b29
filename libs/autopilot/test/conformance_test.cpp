// SPDX-License-Identifier: Apache-2.0
// The bridge keeps the contract of a functional layer, whatever the autopilot and the link.
#include "skein/conformance/conformance.hpp"

#include <gtest/gtest.h>

#include "testing/rig.hpp"

namespace skein::autopilot {
namespace {

using testing::Rig;
using testing::Trouble;

/// Every point that was not kept.
std::string broken_points(Dialect dialect, const Trouble& trouble) {
  Rig rig(dialect, trouble);
  conformance::Config config;
  config.device = "visible";
  conformance::Conformance check(config);
  rig.until(
      "ready", [&] { return rig.bridge().is_ready(); }, 30);
  std::size_t heard = 0, looked = 0;
  const auto give = [&](const conformance::Input& input) {
    for (const functional::Request& asked : check.handle(input, MissionTime() + rig.now()))
      rig.give(asked);
  };
  for (int i = 0; i < 40'000 && !check.done(); ++i) {
    rig.step();
    for (const functional::Status& one : rig.take_statuses()) give(one);
    for (; heard < rig.telemetry().size(); ++heard) give(rig.telemetry()[heard]);
    for (; looked < rig.perceptions().size(); ++looked) give(rig.perceptions()[looked]);
    if (check.next_wakeup()) give(conformance::Tick{});
  }
  std::string broken = check.done() ? "" : "it came to no end\n";
  for (const conformance::Verdict& one : check.verdicts()) {
    if (!one.kept) broken += one.point + ": " + one.seen + "\n";
  }
  EXPECT_EQ(check.verdicts().size(), 18U);
  EXPECT_FALSE(rig.vehicle().heard_sticks());
  return broken;
}

class Contract : public ::testing::TestWithParam<Dialect> {};

TEST_P(Contract, IsKeptOverAGoodLink) { EXPECT_EQ(broken_points(GetParam(), {}), ""); }

TEST_P(Contract, IsKeptOverALinkThatLosesAFifthAndAddsGarbage) {
  EXPECT_EQ(broken_points(GetParam(), {0.2, 40}), "");
}

INSTANTIATE_TEST_SUITE_P(Dialects, Contract, ::testing::Values(Dialect::kPx4, Dialect::kArdupilot),
                         [](const auto& one) { return std::string(to_text(one.param)); });

}  // namespace
}  // namespace skein::autopilot
