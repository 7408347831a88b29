// SPDX-License-Identifier: Apache-2.0
// Header, expectations and tables; and the data for the script.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "builders.hpp"
#include "page/views.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::expectation;
using testing::message;
using testing::stamp;
using testing::task;
using testing::telemetry;

template <class Write>
std::string written(Journal journal, const RunInfo& info, Write write) {
  sort_by_time(journal);
  const Chronology story = tell(info, journal);
  const Statistics figures = measure(story, journal);
  Markup out;
  write(out, Run{info, journal, story, figures, tell_deliberation(journal)});
  return out.take();
}

TEST(Header, TheMissionLastsFromItsStartToItsEnd) {
  Journal j;
  j.missions = {{stamp(10), "started"}, {stamp(70), "time-limit"}};
  j.phases = {{stamp(90), "after"}};

  const std::string html = written(j, {}, write_header);

  EXPECT_EQ(count(html,
                  "<div class=\"value\">1:00</div><div class=\"name\">mission time</div>"
                  "<div class=\"note\">time-limit</div>"),
            1U);
}

TEST(Header, ALogWithoutAnEndSaysSo) {
  Journal j;
  j.missions = {{stamp(0), "started"}};

  EXPECT_EQ(count(written(j, {}, write_header), "no end in the log"), 1U);
}

TEST(Header, TellsTheSpeedOfTheRun) {
  RunInfo info;
  info.wall_seconds = 2;
  info.runtime = RuntimeKind::kDds;
  info.rate = 20;
  Journal j;
  j.phases = {{stamp(100), "end"}};

  const std::string html = written(j, info, write_header);

  EXPECT_EQ(count(html, "50 × real time"), 1U);
  EXPECT_EQ(count(html, "<b>runtime</b> DDS"), 1U);
  EXPECT_EQ(count(html, "<b>rate</b> × 20"), 1U);
}

TEST(Header, UnreadableLinesAreNotHidden) {
  Journal j;
  j.unreadable = 3;

  EXPECT_EQ(count(written(j, {}, write_header), "3 unreadable"), 1U);
}

TEST(Header, TheClosestPairIsNamed) {
  Journal j;
  j.telemetry = {telemetry(65, "a", {0, 0, 0}), telemetry(65, "b", {0, 0, 20})};

  EXPECT_EQ(count(written(j, {}, write_header), "a – b at 1:05"), 1U);
}

TEST(Expectations, TheFailedComeFirst) {
  Journal j;
  j.expectations = {expectation("one", true, "a"), expectation("two", false, "b"),
                    expectation("three", true, "c"), expectation("four", false, "d")};

  const std::string html = written(j, {}, write_expectations);

  const std::size_t two = html.find(">two<"), four = html.find(">four<");
  EXPECT_LT(two, four);
  EXPECT_LT(four, html.find(">one<"));
  EXPECT_LT(html.find(">one<"), html.find(">three<"));
  EXPECT_EQ(count(html, "class=\"failed\""), 2U);
}

TEST(UavTable, ShowsDegreesAsTheyChanged) {
  RunInfo info;
  info.uavs = {{"m", "heli", 4}};
  Journal j;
  j.degrees = {{stamp(5), "m", 1}, {stamp(9), "m", 4}};

  EXPECT_EQ(count(written(j, info, write_uav_table), "<td>4 → 1 → 4</td>"), 1U);
}

TEST(UavTable, WithoutUavsThereIsNone) { EXPECT_EQ(written({}, {}, write_uav_table), ""); }

TEST(UavTable, FiguresHaveUnits) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {0, 0, 0}, true, 1.0),
                 telemetry(10, "m", {300, 400, 0}, true, 0.875)};

  const std::string html = written(j, {}, write_uav_table);

  EXPECT_EQ(count(html, "<td>500 m</td><td>0:10</td><td>0.0 m</td><td>5 m/s</td><td>12.5 %</td>"),
            1U);
}

TEST(MessageTable, HasARowPerSlotAndChannel) {
  Journal j;
  for (int i = 0; i < 20; ++i) {
    j.messages.push_back(message(i, "a", "b", static_cast<std::uint64_t>(i), Direction::kSent));
    j.messages.push_back(
        message(i + 0.02, "a", "b", static_cast<std::uint64_t>(i), Direction::kReceived));
  }
  j.messages.push_back(message(5, "b", "a", 1, Direction::kSent, "Other"));

  const std::string html = written(j, {}, write_message_table);

  EXPECT_EQ(count(html,
                  "<td>Alarm</td><td>a → b</td><td>20</td><td>20</td><td>0</td><td>0</td>"
                  "<td>20 ms</td><td>20 ms</td>"),
            1U);
  EXPECT_EQ(count(html, "<td>Other</td><td>b → a</td><td>1</td><td>0</td>"), 1U);
}

TEST(MessageTable, WithoutMessagesThereIsNone) {
  EXPECT_EQ(written({}, {}, write_message_table), "");
}

TEST(LinkTable, TellsForHowLongABeliefWasWrong) {
  Journal j;
  j.links = {{stamp(0), "a", "b", true}, {stamp(40), "a", "b", false}, {stamp(60), "a", "b", true}};
  j.reaches = {
      {stamp(0, "a"), "b", true}, {stamp(43, "a"), "b", false}, {stamp(61, "a"), "b", true}};
  j.missions = {{stamp(100), "finished"}};

  const std::string html = written(j, {}, write_link_table);

  EXPECT_EQ(count(html, "<td>a → b</td><td>80.0 %</td><td>1</td><td>82.0 %</td><td>4.0 s</td>"),
            1U);
  EXPECT_EQ(count(html, "<td>b → a</td>"), 0U);
}

TEST(EventList, IsInTheOrderOfTimeAndSkipsRoutine) {
  Journal j;
  j.tasks = {task(3, "m", 1, TaskState::kRunning), task(9, "m", 1, TaskState::kAborted, "why")};
  j.processes = {{stamp(0), "ddn-m", "started", ""}, {stamp(4), "ddn-m", "crashed", "signal 9"}};
  j.links = {{stamp(0), "a", "b", true}, {stamp(6), "a", "b", false}};
  j.requests = {{stamp(2), "m", "START", "SEQ", 1, true, ""}};
  j.phases = {{stamp(1), "P"}};

  const std::string html = written(j, {}, write_event_list);

  EXPECT_EQ(count(html, "<tr "), 4U);
  EXPECT_LT(html.find("phase P"), html.find("ddn-m crashed: signal 9"));
  EXPECT_LT(html.find("ddn-m crashed"), html.find("link a → b down"));
  EXPECT_LT(html.find("link a → b down"), html.find("m: goto 1 aborted: why"));
}

TEST(EventList, AVeryLongOneIsCutWithANote) {
  Journal j;
  for (int i = 0; i < 1000; ++i) j.operators.push_back({stamp(i), "click"});

  const std::string html = written(j, {}, write_event_list);

  EXPECT_EQ(count(html, "<tr "), 400U);
  EXPECT_EQ(count(html, "and 600 more events"), 1U);
}

TEST(PageData, TracksAreInMapPixelsAndThinned) {
  Journal j;
  for (int t = 0; t < 50'000; ++t) {
    j.telemetry.push_back(telemetry(t, "m", {0.01 * t, 0, 30}, true, 1.0 - t / 60'000.0));
  }
  sort_by_time(j);
  const RunInfo info;
  const Chronology story = tell(info, j);
  const Statistics figures = measure(story, j);
  const MapFrame frame = frame_map(info, story);

  const auto data =
      nlohmann::json::parse(page_data({info, j, story, figures, tell_deliberation(j)}, frame));

  const auto& track = data.at("uavs").at(0);
  EXPECT_LE(track.at("t").size(), 30'001U);
  EXPECT_EQ(track.at("t").back(), 49'999.0);
  EXPECT_EQ(track.at("z").at(0), 30.0);
  EXPECT_NEAR(track.at("x").at(0).get<double>(), frame(0, 0).x, 0.1);
  EXPECT_NEAR(track.at("e").back().get<double>(), 1.0 - 49'999 / 60'000.0, 0.001);
}

TEST(PageData, TasksThatNeverBeganAreLeftOut) {
  Journal j;
  j.tasks = {task(1, "m", 1, TaskState::kScheduled), task(2, "m", 1, TaskState::kAborted),
             task(3, "m", 2, TaskState::kStarted), task(8, "m", 2, TaskState::kEnded)};
  const RunInfo info;
  const Chronology story = tell(info, j);
  const Statistics figures = measure(story, j);

  const auto data = nlohmann::json::parse(
      page_data({info, j, story, figures, tell_deliberation(j)}, frame_map(info, story)));

  EXPECT_EQ(data.at("tasks"), nlohmann::json::parse(R"([[0, 3.0, 8.0, "2 goto"]])"));
}

}  // namespace
}  // namespace skein::report
