// SPDX-License-Identifier: Apache-2.0
// UAVs that plan on board, over real DDS: planning jobs in their own thread, missions, plans,
// hand-over and closed air on the wire.
#include <gmock/gmock.h>

#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The wall clock's delays count as often as the rate says; see missions_test.cpp.
constexpr const char* kRate = "30";

class DdsDeliberation : public ::testing::TestWithParam<std::string> {};

TEST_P(DdsDeliberation, MeetsEveryExpectation) {
  DdsRun run;
  run.take_scenario_of(GetParam());

  run.start({"--rate", kRate});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_THAT(run.output(), HasSubstr(" expectations met"));
  EXPECT_EQ(run.count("dropped", "kind", "dropped"), 0U);
  EXPECT_GT(run.count("goal", "state", "achieved"), 0U);
  EXPECT_TRUE(run.nothing_runs());
  EXPECT_THAT(run.left_in_shared_memory(), IsEmpty());
}

std::string name_of(const ::testing::TestParamInfo<std::string>& one) {
  std::string name = one.param;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenarios, DdsDeliberation,
                         ::testing::Values("karma/detection", "heliv-marvin/monitoring",
                                           "handover/radio", "handover/cut",
                                           "contingencies/no-fly-appears", "jacksboro/fire",
                                           "meetings/late-partner"),
                         name_of);

}  // namespace
}  // namespace skein::testing
