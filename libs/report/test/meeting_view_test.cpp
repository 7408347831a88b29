// SPDX-License-Identifier: Apache-2.0
// The report shows what a UAV knew of those who came to meet it.
#include <gtest/gtest.h>

#include "timeline_page.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::kFlight;
using testing::page_of_timeline;

constexpr const char* kWords =
    R"({"at":5,"node":"uav1","kind":"meeting","uav":"uav1","id":500,"known":true,"last":"heliv","there":false,"soonest":40,"slowest":70,"needed":80,"needed_by":"heliv"}
{"at":20,"node":"uav1","kind":"meeting","uav":"uav1","id":500,"known":true,"last":"heliv","there":false,"soonest":50}
{"at":52,"node":"uav1","kind":"meeting","uav":"uav1","id":500,"known":true,"last":"heliv","there":true,"soonest":52,"slowest":52}
{"at":53,"node":"uav1","kind":"meeting","uav":"uav1","id":500,"known":false}
{"at":54,"node":"uav1","kind":"meeting"}
)";

TEST(MeetingView, EachWordIsABarOverWhenTheOtherComes) {
  const std::string page = page_of_timeline(std::string(kFlight) + kWords);

  EXPECT_EQ(count(page, "Meetings: foretold"), 1U);
  EXPECT_EQ(count(page,
                  "known at 0:05: heliv comes between 0:40 and 1:10\n"
                  "heliv needs it there by 1:20"),
            1U);
  EXPECT_EQ(count(page, "known at 0:20: heliv comes from 0:50 on"), 1U);
  EXPECT_EQ(count(page, "known at 0:52: heliv is there, the last"), 1U);
  EXPECT_EQ(count(page, "class=\"joint-leaving\""), 2U);
  EXPECT_EQ(count(page, "class=\"joint-running\""), 1U);
}

TEST(MeetingView, WhoWaitsForItsAirHasARowOfItsOwn) {
  const std::string page = page_of_timeline(
      std::string(kFlight) +
      R"({"at":5,"node":"uav1","kind":"meeting","uav":"uav1","id":4503599627370497,"known":true,"order":true,"last":"heliv","there":false,"soonest":40,"slowest":70})"
      "\n");

  EXPECT_EQ(count(page, "known at 0:05: heliv leaves between 0:40 and 1:10"), 1U);
  EXPECT_EQ(count(page, "uav1 air"), 1U);
}

TEST(MeetingView, WithoutMeetingsThereIsNothing) {
  EXPECT_EQ(count(page_of_timeline(kFlight), "Meetings:"), 0U);
}

}  // namespace
}  // namespace skein::report
