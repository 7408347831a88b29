// SPDX-License-Identifier: Apache-2.0
// The report shows who owned each task of the team when.
#include <gtest/gtest.h>

#include "skein/report/report.hpp"
#include "timeline_page.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::page_of_timeline;
using testing::salvage;

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

constexpr const char* kAuctions =
    R"({"at":6,"node":"uav1","kind":"bid","uav":"uav1","task":11,"sale":7,"added":52.4}
{"at":6,"node":"uav2","kind":"bid","uav":"uav2","task":11,"sale":7,"added":12.5}
{"at":6,"node":"uav3","kind":"bid","uav":"uav3","task":11,"sale":7,"why":"no camera"}
{"at":10,"node":"uav1","kind":"sale","state":"sold","task":11,"to":"uav2","value":13,"next_best":"uav1","next_value":53}
{"at":40,"node":"uav1","kind":"bid","uav":"uav1","task":11,"sale":8,"why":"no energy"}
{"at":41,"node":"uav1","kind":"sale","state":"unsold","task":11,"why":"uav1: no energy"}
{"at":42,"node":"uav1","kind":"bid","uav":"uav1","sale":8}
)";

TEST(TeamView, ATableSaysWhoOfferedWhatWhoDidNotAndWhatCameOfEachSale) {
  const std::string page =
      html_report({}, salvage(std::string(kTelemetry) + kOwners + kAuctions).journal);

  EXPECT_EQ(count(page,
                  "<td>11 perceive P1 20</td><td>uav2 12.5, uav1 52.4</td>"
                  "<td>uav3: no camera</td>"
                  "<td>0:10 sold to uav2 for 13.0, next best uav1 53.0</td>"),
            1U);
  EXPECT_EQ(count(page, "<td>uav1: no energy</td><td>0:41 unsold</td>"), 1U);
}

TEST(TeamView, WhereNothingWasAuctionedThereIsNoTableOfIt) {
  const std::string page = html_report({}, salvage(std::string(kTelemetry) + kOwners).journal);

  EXPECT_EQ(count(page, "Auctions:"), 0U);
}

TEST(TeamView, WithoutATeamThereIsNothing) {
  EXPECT_EQ(count(page_of_timeline(kTelemetry), "Tasks of the team"), 0U);
}

}  // namespace
}  // namespace skein::report
