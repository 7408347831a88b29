// SPDX-License-Identifier: Apache-2.0
// The report shows who owned each task of the team when.
#include <gtest/gtest.h>

#include "timeline_page.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::page_of_timeline;

constexpr const char* kTelemetry =
    R"({"at":0,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":false}
{"at":90,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":false}
)";
constexpr const char* kOwners =
    R"({"at":5,"node":"ground","kind":"owner","task":11,"statement":"perceive P1 20","stage":"for-sale","sale":0}
{"at":10,"node":"ground","kind":"owner","task":11,"statement":"perceive P1 20","stage":"owned","sale":4,"owners":"uav1","why":"sold to uav1 for 12 s"}
{"at":20,"node":"ground","kind":"owner","task":11,"statement":"perceive P1 20","stage":"granted","sale":4,"owners":"uav1","why":"sold to uav1 for 12 s"}
{"at":60,"node":"ground","kind":"owner","task":11,"statement":"perceive P1 20","stage":"done","sale":4,"owners":"uav1","why":"done"}
{"at":61,"node":"ground","kind":"owner","statement":"without a number"}
)";

TEST(TeamView, ATaskIsARowWithABandForEachOwnerUntilItIsDone) {
  const std::string page = page_of_timeline(std::string(kTelemetry) + kOwners);

  EXPECT_EQ(count(page, "Tasks of the team"), 1U);
  EXPECT_EQ(count(page, "11 perceive P1 20"), 4U) << "a label, and three bands";
  EXPECT_EQ(count(page, "class=\"violated\""), 1U);
  EXPECT_EQ(count(page, "class=\"joint-loading\""), 1U);
  EXPECT_EQ(count(page, "class=\"joint-running\""), 1U);
  EXPECT_EQ(count(page, "sold to uav1 for 12 s"), 2U);
}

TEST(TeamView, WithoutATeamThereIsNothing) {
  EXPECT_EQ(count(page_of_timeline(kTelemetry), "Tasks of the team"), 0U);
}

}  // namespace
}  // namespace skein::report
