// SPDX-License-Identifier: Apache-2.0
// The report shows who waited for the air of a way, and who had it.
#include <gtest/gtest.h>

#include "skein/report/report.hpp"
#include "timeline_page.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::kFlight;
using testing::page_of_timeline;

constexpr const char* kAir =
    R"({"at":5,"node":"uav1","kind":"air","uav":"uav1","task":7,"type":"goto","state":"waits","waited":0,"for":"heliv to leave"}
{"at":25,"node":"uav1","kind":"air","uav":"uav1","task":7,"type":"goto","state":"had","waited":20,"raised":24}
{"at":60,"node":"uav1","kind":"air","uav":"uav1","task":8,"type":"land","state":"unasked","waited":10}
{"at":61,"node":"uav1","kind":"air"}
)";

TEST(AirView, AUavIsARowWithABandForEachWaitAndEachWay) {
  const std::string page = page_of_timeline(std::string(kFlight) + kAir);

  EXPECT_EQ(count(page, "Air of ways"), 1U);
  EXPECT_EQ(count(page, "7 goto: waits, heliv to leave"), 1U);
  EXPECT_EQ(count(page, "7 goto: had, 24 m higher"), 1U);
  EXPECT_EQ(count(page, "class=\"joint-loading\""), 1U);
  EXPECT_EQ(count(page, "class=\"joint-running\""), 1U);
  EXPECT_EQ(count(page, "class=\"violated\""), 1U);
}

TEST(AirView, AWaitSaysForWhom) {
  EXPECT_EQ(count(page_of_timeline(std::string(kFlight) + kAir), "for heliv<"), 1U);
}

constexpr const char* kVolumes =
    R"({"at":5,"node":"uav1","kind":"air","uav":"uav1","task":7,"type":"goto","state":"had","waited":0,"air":[0,0,100,0,20,30,50,100,0,100,0,10,30,50]}
{"at":9,"node":"sim","kind":"task","uav":"uav1","task":7,"type":"goto","state":"scheduled"}
{"at":40,"node":"sim","kind":"task","uav":"uav1","task":7,"type":"goto","state":"ended"}
{"at":60,"node":"uav1","kind":"air","uav":"uav1","task":8,"type":"land","state":"had","waited":0,"air":[100,0,100,0,10,-1000,50]}
)";

TEST(AirView, TheMapHasEachReservationForItsTime) {
  const std::string page =
      html_report({}, testing::salvage(std::string(kFlight) + kVolumes).journal);

  EXPECT_EQ(count(page, R"(data-from="5" data-to="40")"), 1U) << "the way, while it is flown";
  EXPECT_EQ(count(page, R"(data-from="40" data-to="60")"), 1U) << "where it stays until the next";
  EXPECT_EQ(count(page, R"(data-from="60" data-to="90")"), 1U) << "landing, to the end of the log";
  EXPECT_EQ(count(page, "uav1 has 30 m up to 50 m: 7 goto"), 2U);
  EXPECT_EQ(count(page, "uav1 has up to 50 m: 8 land"), 1U);
}

constexpr const char* kPortions =
    R"({"at":5,"node":"uav1","kind":"air","uav":"uav1","task":7,"type":"goto","state":"had","waited":0,"air":[0,0,100,0,20,30,50,100,0,100,0,10,30,50]}
{"at":9,"node":"sim","kind":"task","uav":"uav1","task":7,"type":"goto","state":"scheduled"}
{"at":20,"node":"uav1","kind":"air","uav":"uav1","task":7,"type":"goto","state":"ahead","waited":0,"air":[100,0,200,0,20,30,50,200,0,200,0,10,30,50]}
{"at":30,"node":"uav1","kind":"air","uav":"uav1","task":7,"type":"goto","state":"had","waited":0,"air":[100,0,200,0,20,30,50,200,0,200,0,10,30,50]}
{"at":40,"node":"sim","kind":"task","uav":"uav1","task":7,"type":"goto","state":"ended"}
)";

TEST(AirView, TheNextPortionOfASweepIsOnTheMapBesideTheOneThatIsFlown) {
  const std::string log = std::string(kFlight) + kPortions;
  const std::string page = html_report({}, testing::salvage(log).journal);

  EXPECT_EQ(count(page, R"(data-from="5" data-to="30")"), 1U) << "the first, while it is flown";
  EXPECT_EQ(count(page, R"(data-from="20" data-to="30")"), 1U) << "the second, ahead";
  EXPECT_EQ(count(page, R"(data-from="30" data-to="40")"), 1U) << "the second, while it is flown";
  EXPECT_EQ(count(page_of_timeline(log), "class=\"joint-running\""), 2U) << "a bar for each";
}

TEST(AirView, WithoutMergingThereIsNothing) {
  EXPECT_EQ(count(page_of_timeline(kFlight), "Air of ways"), 0U);
}

}  // namespace
}  // namespace skein::report
