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

// Each reckons the division in half of the session, while the clock goes on: slower than the
// others, and a field that is mapped soon.
TEST(DdsAreaSharing, ThreeShareAFieldByNegotiation) {
  DdsRun run;
  run.take_scenario_of("area-sharing/negotiated");
  run.change("field: [[150, 60], [1700, -60], [2250, 800], [1800, 1650], [450, 1600], [60, 800]]",
             "field: [[300, 100], [1300, 0], [1500, 500], [1200, 800], [300, 700]]");

  run.start({"--rate", "10"});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_GE(run.count("negotiation", "modality", "area-sharing"), 6U);  // offered, agreed: of three
  EXPECT_TRUE(run.nothing_runs());
}

}  // namespace
}  // namespace skein::testing
