// SPDX-License-Identifier: Apache-2.0
#include "timeline/timeline.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "builders.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::message;
using testing::stamp;
using testing::task;
using testing::telemetry;

std::string timeline_of(Journal journal, const RunInfo& info = {}) {
  sort_by_time(journal);
  const Chronology story = tell(info, journal);
  const Statistics figures = measure(story, journal);
  Markup out;
  const Deliberation plans = tell_deliberation(journal);
  write_timeline(out, {info, journal, story, figures, plans});
  return out.take();
}

TaskBar bar(double scheduled, double started, double end) {
  TaskBar b;
  b.id = 1;
  b.type = "goto";
  b.segments = {{TaskState::kScheduled, {scheduled, started}},
                {TaskState::kRunning, {started, end}}};
  b.span = {scheduled, end};
  b.outcome = TaskState::kEnded;
  return b;
}

const Axis kWide{0, 1000, 0, 1000};

TEST(Pack, BarsThatFollowEachOtherShareALane) {
  const TaskBar a = bar(0, 0, 100), b = bar(200, 200, 300), c = bar(400, 400, 600);

  const std::vector<PlacedBar> placed = pack({&a, &b, &c}, kWide, false);

  for (const PlacedBar& p : placed) EXPECT_EQ(p.lane, 0U);
}

TEST(Pack, APlanSentAtOnceIsAWaterfall) {
  const TaskBar a = bar(0, 0, 100), b = bar(0, 100, 200), c = bar(0, 200, 300);

  const std::vector<PlacedBar> placed = pack({&a, &b, &c}, kWide, false);

  EXPECT_EQ(placed[0].lane, 0U);
  EXPECT_EQ(placed[1].lane, 1U);
  EXPECT_EQ(placed[2].lane, 2U);
}

TEST(Pack, WithoutTheWaitingAPlanNeedsOneLane) {
  const TaskBar a = bar(0, 0, 100), b = bar(0, 110, 200), c = bar(0, 210, 300);

  for (const PlacedBar& p : pack({&a, &b, &c}, kWide, true)) EXPECT_EQ(p.lane, 0U);
}

TEST(Pack, AShortBarKeepsRoomForItsLabel) {
  const TaskBar a = bar(0, 0, 5), b = bar(12, 12, 300);

  const std::vector<PlacedBar> placed = pack({&a, &b}, kWide, false);

  EXPECT_EQ(placed[1].lane, 1U);
}

RC_GTEST_PROP(Pack, NoTwoBarsOfALaneOverlap, ()) {
  const auto spans = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 900), rc::gen::inRange(1, 90)));
  std::vector<TaskBar> bars;
  for (const auto& [from, length] : spans) bars.push_back(bar(from, from, from + length));
  std::vector<const TaskBar*> pointers;
  for (const TaskBar& b : bars) pointers.push_back(&b);

  const std::vector<PlacedBar> placed = pack(pointers, kWide, false);

  RC_ASSERT(placed.size() == bars.size());
  for (const PlacedBar& p : placed) {
    for (const PlacedBar& q : placed) {
      if (p.bar == q.bar || p.lane != q.lane) continue;
      RC_ASSERT(p.bar->span.to <= q.bar->span.from || q.bar->span.to <= p.bar->span.from);
    }
  }
}

TEST(Timeline, ATaskIsDrawnWithASegmentPerState) {
  Journal j;
  j.tasks = {task(0, "m", 3, TaskState::kScheduled), task(100, "m", 3, TaskState::kStarted),
             task(110, "m", 3, TaskState::kRunning), task(400, "m", 3, TaskState::kAborting),
             task(420, "m", 3, TaskState::kAborted, "too <late>")};

  const std::string svg = timeline_of(j);

  EXPECT_EQ(count(svg, "class=\"scheduled\""), 1U);
  EXPECT_EQ(count(svg, "class=\"started\""), 1U);
  EXPECT_EQ(count(svg, "class=\"running\""), 1U);
  EXPECT_EQ(count(svg, "class=\"hatched\""), 1U);
  EXPECT_EQ(count(svg, "class=\"cross\""), 1U);
  EXPECT_EQ(count(svg, ">3 goto</text>"), 1U);
  EXPECT_EQ(count(svg, "too &lt;late&gt;"), 1U);
}

TEST(Timeline, EndedAndStillAliveLookDifferent) {
  Journal j;
  j.tasks = {task(0, "m", 1, TaskState::kRunning), task(50, "m", 1, TaskState::kEnded),
             task(60, "m", 2, TaskState::kRunning)};
  j.phases = {{stamp(100), "P"}};

  const std::string svg = timeline_of(j);

  EXPECT_EQ(count(svg, "class=\"cap\""), 1U);
  EXPECT_EQ(count(svg, "class=\"alive\""), 1U);
}

TEST(Timeline, ARunningBarSpansItsTimeOnTheAxis) {
  Journal j;
  j.tasks = {task(250, "m", 1, TaskState::kRunning), task(750, "m", 1, TaskState::kEnded)};
  j.phases = {{stamp(1000), "end"}};

  const std::string svg = timeline_of(j);

  // 132 + 1086 × 0.25 = 403.5; 1086 × 0.5 = 543
  EXPECT_EQ(count(svg, "class=\"running\" x=\"403.5\""), 1U);
  EXPECT_EQ(count(svg, "width=\"543\""), 1U);
}

TEST(Timeline, PhasesAreBandsAndAlarmsAreFlags) {
  Journal j;
  j.phases = {{stamp(0), "Detection"}, {stamp(500), "Confirmation"}};
  j.alarms = {{stamp(400), 1, AlarmState::kRaised, {}, 0.5}};
  j.operators = {{stamp(600), "stop"}};
  j.faults = {{stamp(700), "kill", "karma"}};
  j.missions = {{stamp(1000), "finished"}};

  const std::string svg = timeline_of(j);

  EXPECT_EQ(count(svg, "class=\"band\""), 2U);
  EXPECT_EQ(count(svg, ">Detection</text>"), 1U);
  EXPECT_EQ(count(svg, ">alarm 1 raised</text>"), 1U);
  EXPECT_EQ(count(svg, ">operator: stop</text>"), 1U);
  EXPECT_EQ(count(svg, ">kill karma</text>"), 1U);
}

TEST(Timeline, SynchronisationsRunFromRailToRail) {
  RunInfo info;
  info.uavs = {{"a", "", 4}, {"b", "", 4}};
  Journal j;
  j.syncs = {{stamp(10, "a"), "551", "a", "b", Direction::kSent},
             {stamp(10, "b"), "551", "a", "b", Direction::kReceived},
             {stamp(60, "b"), "552", "b", "a", Direction::kSent},
             {stamp(100, "b"), "553", "b", "elsewhere", Direction::kSent}};

  const std::string svg = timeline_of(j, info);

  EXPECT_EQ(count(svg, "class=\"sync\""), 1U);
  EXPECT_EQ(count(svg, "class=\"sync cut\""), 1U);
  EXPECT_EQ(count(svg, ">sync 551</text>"), 1U);
}

TEST(Timeline, ASynchronisationThatIsSaidAgainIsPaleAndHasNoName) {
  RunInfo info;
  info.uavs = {{"a", "", 4}, {"b", "", 4}};
  Journal j;
  for (const int at : {200, 400}) {
    j.syncs.push_back({stamp(at, "a"), "551", "a", "b", Direction::kSent});
    j.syncs.push_back({stamp(at + 1, "b"), "551", "a", "b", Direction::kReceived});
  }

  const std::string svg = timeline_of(j, info);

  EXPECT_EQ(count(svg, "class=\"sync\""), 1U);
  EXPECT_EQ(count(svg, "class=\"sync again\""), 1U);
  EXPECT_EQ(count(svg, ">sync 551</text>"), 1U);
}

TEST(Timeline, ManyMessagesAreHiddenAtFirstAndThinned) {
  RunInfo info;
  info.uavs = {{"a", "", 4}, {"b", "", 4}};
  Journal few, many;
  for (int i = 0; i < 9000; ++i) {
    many.messages.push_back(message(i, "a", "b", i, Direction::kSent));
    if (i < 10) few.messages.push_back(many.messages.back());
  }

  const std::string svg = timeline_of(many, info);

  EXPECT_EQ(count(svg, "class=\"no-messages\""), 1U);
  EXPECT_LE(count(svg, "class=\"message cut\""), 3000U);
  EXPECT_EQ(count(timeline_of(few, info), "class=\"no-messages\""), 0U);
}

TEST(Timeline, LinksShowTruthAndBelief) {
  Journal j;
  j.links = {{stamp(0), "a", "b", true}, {stamp(40), "a", "b", false}, {stamp(60), "a", "b", true}};
  j.reaches = {{stamp(1, "a"), "b", true}};
  j.missions = {{stamp(100), "finished"}};

  const std::string svg = timeline_of(j);

  EXPECT_EQ(count(svg, ">a – b</text>"), 1U);
  EXPECT_EQ(count(svg, "class=\"up\""), 2U);
  EXPECT_EQ(count(svg, "class=\"down\""), 1U);
  EXPECT_EQ(count(svg, "class=\"believed\""), 1U);
}

TEST(Timeline, OfVeryManyLinksTheSteadyAreLeftOut) {
  Journal j;
  for (int i = 0; i < 100; ++i) {
    j.links.push_back({stamp(0), "n" + std::to_string(i), "z", true});
  }
  j.links.push_back({stamp(5), "n3", "z", false});
  j.links.push_back({stamp(7), "n3", "z", true});

  const std::string svg = timeline_of(j);

  EXPECT_EQ(count(svg, "<g class=\"link\">"), 1U);
  EXPECT_EQ(count(svg, "and 99 more links, not drawn"), 1U);
}

TEST(Timeline, ProfilesHaveOneLinePerUavAndAPanelForSeparation) {
  Journal j;
  for (int t = 0; t < 100; ++t) {
    j.telemetry.push_back(telemetry(t, "a", {0, 0, 10.0 + t % 7}));
    j.telemetry.push_back(telemetry(t, "b", {50, 0, 20.0 + t % 5}));
  }

  const std::string svg = timeline_of(j);

  EXPECT_EQ(count(svg, "class=\"profile u0\""), 2U);
  EXPECT_EQ(count(svg, "class=\"profile u1\""), 2U);
  EXPECT_EQ(count(svg, "class=\"profile separation\""), 1U);
  EXPECT_EQ(count(svg, ">Altitude</text>"), 1U);
}

TEST(Timeline, ProcessesStandOnTheRailOfTheirUav) {
  RunInfo info;
  info.uavs = {{"karma", "", 4}};
  Journal j;
  j.processes = {{stamp(0), "ddn-karma", "started", ""},
                 {stamp(5), "ddn-karma", "crashed", "signal 9"},
                 {stamp(9), "ddn-karma", "restarted", ""},
                 {stamp(9), "ground", "crashed", "signal 6"}};

  const std::string svg = timeline_of(j, info);

  EXPECT_EQ(count(svg, "class=\"at process\""), 2U);
  EXPECT_EQ(count(svg, "class=\"at process back\""), 1U);
  EXPECT_EQ(count(svg, "ddn-karma crashed: signal 9"), 1U);
}

TEST(Timeline, RefusalsAndLossesAreMarked) {
  RunInfo info;
  info.uavs = {{"m", "", 4}};
  Journal j;
  j.requests = {{stamp(1), "m", "ABORT", "", 4, false, "unknown"},
                {stamp(2), "m", "START", "SEQ", 5, true, ""}};
  j.commands = {{stamp(3), "m", 1, "goto", CommandState::kIssued, ""},
                {stamp(4), "m", 1, "goto", CommandState::kExpired, "late"}};
  j.undelivered = {{stamp(5, "m"), true, "Alarm", "ground", 1}};
  j.dropped = {{stamp(6, "ground"), "Alarm", "x", "belief", "bad"}};
  j.degrees = {{stamp(7), "m", 2}};

  const std::string svg = timeline_of(j, info);

  EXPECT_EQ(count(svg, "class=\"at request refused\""), 2U);
  EXPECT_EQ(count(svg, "class=\"at request u0\""), 2U);
  EXPECT_EQ(count(svg, "class=\"at trouble\""), 2U);
  EXPECT_EQ(count(svg, "class=\"at degree\""), 1U);
}

TEST(Timeline, AnEmptyRunHasAnAxisAndNothingElse) {
  const std::string svg = timeline_of({});

  EXPECT_EQ(count(svg, "<svg "), 1U);
  EXPECT_EQ(count(svg, "class=\"bar"), 0U);
  EXPECT_EQ(count(svg, ">0:00</text>"), 2U);  // the rulers above and below
}

}  // namespace
}  // namespace skein::report
