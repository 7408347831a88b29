// SPDX-License-Identifier: Apache-2.0
// External arcs between the rows of UAVs, with their slack.
#include "meetings/external_arcs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "timeline_page.hpp"

namespace skein::report {
namespace {

using testing::count;
using ::testing::IsEmpty;
using testing::page_of_timeline;
using ::testing::SizeIs;

/// Two UAVs in the air for 90 s.
constexpr const char* kTwo =
    R"({"at":0,"node":"sim","kind":"telemetry","uav":"heliv","position":[0,0,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":0,"node":"sim","kind":"telemetry","uav":"marvin","position":[0,9,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":90,"node":"sim","kind":"telemetry","uav":"heliv","position":[0,0,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":90,"node":"sim","kind":"telemetry","uav":"marvin","position":[0,9,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
)";
// Heliv is at meeting 500 at 20 s and is needed there by 50 s; marvin comes at 35 s.
constexpr const char* kMeets =
    R"({"at":12,"node":"heliv","kind":"meeting","uav":"heliv","id":500,"known":true,"last":"marvin","there":false,"soonest":30,"slowest":40,"needed":50,"needed_by":"marvin"}
{"at":20,"node":"heliv","kind":"sync","id":500,"from":"heliv","to":"marvin","direction":"sent"}
{"at":20.5,"node":"marvin","kind":"sync","id":500,"from":"heliv","to":"marvin","direction":"received"}
{"at":35,"node":"marvin","kind":"sync","id":500,"from":"marvin","to":"heliv","direction":"sent"}
{"at":35.2,"node":"heliv","kind":"sync","id":500,"from":"marvin","to":"heliv","direction":"received"}
)";
// Marvin waits for its air until heliv has left it at 60 s.
constexpr const char* kLeaves =
    R"({"at":50,"node":"marvin","kind":"meeting","uav":"marvin","id":4503599627370497,"known":true,"order":true,"last":"heliv","there":false,"soonest":58,"slowest":70}
{"at":60,"node":"marvin","kind":"meeting","uav":"marvin","id":4503599627370497,"known":true,"order":true,"last":"heliv","there":true,"soonest":60,"slowest":60}
{"at":60.3,"node":"marvin","kind":"meeting","uav":"marvin","id":4503599627370497,"known":false}
)";

std::vector<ExternalArc> arcs_of(const std::string& log) {
  const SalvagedJournal read = testing::salvage(std::string(kTwo) + log);
  return external_arcs_of(read.journal, tell({}, read.journal));
}

TEST(ExternalArcs, WhoWasThereFirstHasSlackAndWhoCameLastHasNone) {
  const auto arcs = arcs_of(kMeets);
  ASSERT_THAT(arcs, SizeIs(2));
  EXPECT_EQ(arcs[0].from, 0U);  // heliv, for whom marvin never waited
  EXPECT_DOUBLE_EQ(arcs[0].comes, 20);
  EXPECT_DOUBLE_EQ(arcs[0].goes_on, 35);
  EXPECT_DOUBLE_EQ(arcs[0].slack(), 15);
  EXPECT_DOUBLE_EQ(arcs[0].needed.value_or(0), 50);
  EXPECT_EQ(arcs[0].needed_by, "marvin");
  EXPECT_EQ(arcs[1].from, 1U);
  EXPECT_NEAR(arcs[1].slack(), 0.2, 1e-9);
  EXPECT_FALSE(arcs[1].needed);
}

TEST(ExternalArcs, OfAnOrderBetweenWaysGoFromWhoLeavesToWhoHasItsAir) {
  const auto arcs = arcs_of(kLeaves);
  ASSERT_THAT(arcs, SizeIs(1));
  EXPECT_EQ(arcs[0].what, "air");
  EXPECT_EQ(arcs[0].from, 0U);
  EXPECT_EQ(arcs[0].to, 1U);
  EXPECT_NEAR(arcs[0].slack(), 0.3, 1e-9);
}

TEST(ExternalArcs, AreNoneWhereNobodyIsHeard) {
  EXPECT_THAT(arcs_of(""), IsEmpty());
  EXPECT_THAT(
      arcs_of(
          R"({"at":20,"node":"heliv","kind":"sync","id":500,"from":"heliv","to":"marvin","direction":"sent"})"
          "\n"),
      IsEmpty());
}

TEST(ExternalArcs, AreDrawnWithTheirSlack) {
  const std::string page = page_of_timeline(std::string(kTwo) + kMeets + kLeaves);

  EXPECT_EQ(count(page,
                  "sync 500: heliv is there at 0:20, marvin goes on at 0:35: 15 s of slack\n"
                  "marvin needed it there by 0:50: 30 s"),
            1U);
  EXPECT_EQ(count(page, "air: heliv has left at 1:00, marvin goes on at 1:00: 0.3 s of slack"), 1U);
  EXPECT_EQ(count(page, "class=\"external u"), 1U);
  EXPECT_EQ(count(page, "class=\"external tight u"), 2U);
  EXPECT_EQ(count(page, ">15 s</text>"), 1U);
}

}  // namespace
}  // namespace skein::report
