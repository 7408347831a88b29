// SPDX-License-Identifier: Apache-2.0
// Figures for a paper: trajectories with meetings, chronology with temporal messages.
#include "skein/report/figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "builders.hpp"
#include "story/encounters.hpp"
#include "timeline_page.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::salvage;

constexpr const char* kRun =
    R"({"at":0,"node":"sim","kind":"telemetry","uav":"uav1","position":[0,0,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":0,"node":"sim","kind":"telemetry","uav":"uav2","position":[50,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":false}
{"at":0,"node":"sim","kind":"telemetry","uav":"uav3","position":[90,40,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":false}
{"at":5,"node":"uav1","kind":"frontier","uav":"uav1","direction":"sent","to":"uav2","meetings":1}
{"at":5.1,"node":"uav2","kind":"frontier","uav":"uav2","direction":"received","from":"uav1"}
{"at":5.3,"node":"uav3","kind":"frontier","uav":"uav3","direction":"received","from":"uav1"}
{"at":30,"node":"uav3","kind":"frontier","uav":"uav3","direction":"received","from":"uav1"}
{"at":10,"node":"uav1","kind":"task","uav":"uav1","task":3,"type":"rendezvous","state":"started"}
{"at":10,"node":"uav1","kind":"sync","id":500,"from":"uav1","to":"uav2","direction":"sent"}
{"at":11,"node":"uav2","kind":"sync","id":500,"from":"uav1","to":"uav2","direction":"received"}
{"at":20,"node":"uav2","kind":"sync","id":500,"from":"uav2","to":"uav1","direction":"sent"}
{"at":21,"node":"uav1","kind":"sync","id":500,"from":"uav2","to":"uav1","direction":"received"}
{"at":21,"node":"uav1","kind":"task","uav":"uav1","task":3,"type":"rendezvous","state":"ended"}
{"at":90,"node":"sim","kind":"telemetry","uav":"uav1","position":[100,0,40],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":90,"node":"sim","kind":"telemetry","uav":"uav2","position":[50,90,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":false}
)";

Journal journal() { return salvage(kRun).journal; }

TEST(Figures, EachIsThroughWithAMeetingWhenItIsThereAndHasHeardTheOther) {
  const auto met = encounters_of(tell({}, journal()));

  ASSERT_EQ(met.size(), 1U);
  EXPECT_EQ(met.front().id, "500");
  EXPECT_EQ(met.front().one_through, 21);
  EXPECT_EQ(met.front().other_through, 20);
  EXPECT_EQ(met.front().t(), 21);
}

TEST(Figures, WhatAllHearWithinASecondIsOneTemporalMessage) {
  const Journal log = journal();
  const auto messages = temporal_messages_of(log, tell({}, log));

  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].t, 5.1);
  EXPECT_EQ(messages[0].heard_by, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(messages[1].heard_by, (std::vector<std::size_t>{2}));
}

TEST(Figures, TheMapHasATrackForEachAndAMarkAtBothEndsOfAMeeting) {
  const std::string figure = trajectories_svg({}, journal());

  EXPECT_EQ(count(figure, "stroke-dasharray=\"5 3\""), 1U) << "what flies is dashed";
  EXPECT_EQ(count(figure, "<circle"), 2U);
  EXPECT_EQ(count(figure, ">500<"), 1U);
  for (const char* name : {">uav1<", ">uav2<", ">uav3<"}) EXPECT_EQ(count(figure, name), 1U);
}

TEST(Figures, TheChronologyHasABarForEachTemporalMessageAndNamesWhomOneMeets) {
  const std::string figure = chronology_svg({}, journal());

  EXPECT_EQ(count(figure, "uav1 at 0:05"), 1U);
  EXPECT_EQ(count(figure, "uav1 at 0:30"), 1U);
  EXPECT_EQ(count(figure, ">uav2<"), 2U) << "its row, and over the meeting of uav1";
  EXPECT_EQ(count(figure, "2 messages"), 1U);
}

TEST(Figures, TheReportHasABarForEachTemporalMessageWithWhoHeardIt) {
  const std::string page = testing::page_of_timeline(kRun);

  EXPECT_EQ(count(page, "between the meetings of uav1, heard by uav2, uav3"), 1U);
  EXPECT_EQ(count(page, "between the meetings of uav1, heard by uav3"), 1U);
}

TEST(Figures, OfARunInWhichNothingHappenedAreDrawnToo) {
  EXPECT_THAT(trajectories_svg({}, {}), ::testing::StartsWith("<svg "));
  EXPECT_THAT(chronology_svg({}, {}), ::testing::StartsWith("<svg "));
}

}  // namespace
}  // namespace skein::report
