// SPDX-License-Identifier: Apache-2.0
// Teams over real DDS: what is shared out at degree 5 (spec 6.3, 8.9), ways that cross (6.4).
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

TEST(DdsTeam, AGlobalMissionIsSharedOut) { expect_all_met("team/two", "10"); }

TEST(DdsTeam, UavsAtDifferentDegreesDoNotDisturbEachOther) { expect_all_met("team/mixed", "10"); }

TEST(DdsTeam, CometsIsOneGlobalMission) { expect_all_met("team/comets", "20"); }

TEST(DdsTeam, UavsWhoseWaysCrossMergeThem) { expect_all_met("team/crossing", "10"); }

}  // namespace
}  // namespace skein::testing
