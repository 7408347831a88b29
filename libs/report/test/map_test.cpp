// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "builders.hpp"
#include "map/map_marks.hpp"
#include "synthetic_mission.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::stamp;
using testing::task;
using testing::telemetry;

std::string map_of(Journal journal, const RunInfo& info = {}) {
  sort_by_time(journal);
  const Chronology story = tell(info, journal);
  const Statistics figures = measure(story, journal);
  const Deliberation plans = tell_deliberation(journal);
  const Run run{info, journal, story, figures, plans};
  Markup out;
  write_map(out, run, frame_map(info, story));
  return out.take();
}

TEST(FrameMap, EverythingThatHappenedIsInside) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {-500, 20, 0}), telemetry(1, "m", {900, 300, 0})};
  j.alarms = {{stamp(1), 1, AlarmState::kRaised, {0, -700, 0}, 1}};

  const MapFrame f = frame_map({}, tell({}, j));

  for (const auto& [x, y] : {std::pair{-500, 20}, {900, 300}, {0, -700}}) {
    const Point p = f(x, y);
    EXPECT_GE(p.x, 40);
    EXPECT_LE(p.x, f.width - 40);
    EXPECT_GE(p.y, 40);
    EXPECT_LE(p.y, f.height - 40);
  }
}

TEST(FrameMap, NorthIsUpAndTheScaleIsTheSameBothWays) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {0, 0, 0}), telemetry(1, "m", {100, 100, 0})};

  const MapFrame f = frame_map({}, tell({}, j));

  EXPECT_LT(f(0, 100).y, f(0, 0).y);
  EXPECT_NEAR(f(100, 0).x - f(0, 0).x, f(0, 0).y - f(0, 100).y, 1e-9);
}

TEST(FrameMap, WithoutEventsTheGivenExtentsAreShown) {
  RunInfo info;
  info.extents = Extents{1000, 2000, 1400, 2300};

  const MapFrame f = frame_map(info, tell(info, {}));

  EXPECT_LE(f.view.west, 1000);
  EXPECT_GE(f.view.north, 2300);
}

RC_GTEST_PROP(FrameMap, AnyPositionsGiveAFiniteFrame, ()) {
  const auto limit = 1'000'000'000;
  const auto points = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-limit, limit), rc::gen::inRange(-limit, limit)));
  Journal j;
  for (std::size_t i = 0; i < points.size(); ++i) {
    j.telemetry.push_back(telemetry(
        static_cast<double>(i), "m",
        {static_cast<double>(points[i].first), static_cast<double>(points[i].second), 0}));
  }

  const MapFrame f = frame_map({}, tell({}, j));

  RC_ASSERT(f.scale > 0 && f.width > 0 && f.height > 0 && f.height <= 1000);
  RC_ASSERT(f.view.west < f.view.east && f.view.south < f.view.north);
}

TEST(Map, ATrackIsSplitWhereItLeavesTheGround) {
  Journal j;
  for (int t = 0; t < 30; ++t) {
    j.telemetry.push_back(telemetry(t, "m", {10.0 * t, 0, 0}, t >= 10 && t < 20));
  }

  const std::string svg = map_of(j);

  EXPECT_EQ(count(svg, "class=\"air\""), 1U);
  EXPECT_EQ(count(svg, "class=\"land\""), 2U);
  EXPECT_EQ(count(svg, "class=\"takeoff u0\""), 1U);
  EXPECT_EQ(count(svg, "class=\"landing u0\""), 1U);
  EXPECT_EQ(count(svg, "m takes off at 0:10"), 1U);
}

TEST(Map, OfWhatKeepsToTheGroundAllOfItsWayIsDrawn) {
  Journal j;
  for (int t = 0; t < 30; ++t) j.telemetry.push_back(telemetry(t, "m", {10.0 * t, 0, 0}, false));

  EXPECT_EQ(count(map_of(j), "class=\"air\""), 1U);
}

TEST(Map, AlarmsShowTheirStateAndTheirError) {
  Journal j;
  j.objects = {{stamp(0), "fire", "fire", {100, 100, 0}, 6, true}};
  j.alarms = {{stamp(5), 1, AlarmState::kRaised, {103, 104, 0}, 0.5},
              {stamp(8), 1, AlarmState::kConfirmed, {103, 104, 0}, 0.9},
              {stamp(5), 2, AlarmState::kInfirmed, {150, 150, 0}, 0.1}};

  const std::string svg = map_of(j);

  EXPECT_EQ(count(svg, "class=\"alarm confirmed\""), 1U);
  EXPECT_EQ(count(svg, "class=\"alarm infirmed\""), 1U);
  EXPECT_EQ(count(svg, "class=\"error\""), 1U);
  EXPECT_EQ(count(svg, ">alarm 1 confirmed · 5 m off</text>"), 1U);
  EXPECT_EQ(count(svg, "class=\"object fire\""), 1U);
}

TEST(Map, AFireThatSpreadsIsDrawnFrontByFrontAndWhereItWasFollowed) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {-100, -100, 0}), telemetry(100, "m", {-100, 200, 0})};
  for (int t = 0; t <= 100; ++t)
    j.objects.push_back({stamp(t),
                         "blaze",
                         "fire",
                         {100.0 + t, 50, 0},
                         20.0 + t,
                         true,
                         10.0 + t,
                         Position{100, 50, 0}});
  for (const double x : {110.0, 130.0, 150.0}) {
    j.seen.push_back({stamp(x / 2), {.name = "fire-front", .position = {x, 50, 0}}});
  }
  j.seen.push_back({stamp(70), {.name = "odd", .position = {50, 0}}});

  const std::string svg = map_of(j);

  EXPECT_EQ(count(svg, "class=\"front\""), 6U);
  EXPECT_EQ(count(svg, "class=\"front last\""), 1U);
  EXPECT_EQ(count(svg, "front of fire blaze at 1:40"), 1U);
  EXPECT_EQ(count(svg, "class=\"object-way\""), 0U);
  EXPECT_EQ(count(svg, "<path class=\"followed\""), 1U);
  EXPECT_EQ(count(svg, ">fire-front</text>"), 1U);
  EXPECT_EQ(count(svg, "odd"), 0U);
}

TEST(Map, ShotsAreDrawnWhereTheyBegan) {
  Journal j;
  j.telemetry = {telemetry(0, "m", {0, 0, 0}), telemetry(10, "m", {100, 0, 0})};
  j.tasks = {task(5, "m", 4, TaskState::kRunning)};
  j.tasks[0].type = "takeshot";

  const std::string svg = map_of(j);

  EXPECT_EQ(count(svg, "class=\"view u0\""), 1U);
  EXPECT_EQ(count(svg, "m: takeshot 4 at 0:05"), 1U);
}

TEST(Map, ReliefIsOneEmbeddedImage) {
  const RunInfo info = testing::comets_info();

  const std::string svg = map_of({}, info);

  EXPECT_EQ(count(svg, "href=\"data:image/png;base64,iVBORw0KGgo"), 1U);
  EXPECT_GE(count(svg, "class=\"contour\""), 4U);
  EXPECT_EQ(count(svg, "class=\"zone\""), 1U);
  EXPECT_EQ(count(svg, ">base</text>"), 1U);
}

TEST(Map, ATerrainThatDoesNotAddUpIsLeftOut) {
  RunInfo info;
  info.terrain = TerrainGrid{0, 0, 1, 10, 10, {1, 2}};

  EXPECT_EQ(count(map_of({}, info), "<image"), 0U);
}

TEST(Map, AWorldOfAnySizeHasAScaleBar) {
  for (const double size : {1.0, 90.0, 5'000.0, 200'000.0}) {
    Journal j;
    j.telemetry = {telemetry(0, "m", {0, 0, 0}), telemetry(1, "m", {size, size, 0})};

    const std::string svg = map_of(j);

    EXPECT_EQ(count(svg, "class=\"furniture\""), 1U);
    EXPECT_EQ(count(svg, size > 1000 ? " km</text>" : " m</text>"), 1U) << size;
  }
}

TEST(NearestObject, IsTheNearestActiveOneWhenTheAlarmWasRaised) {
  Journal j;
  j.objects = {{stamp(0), "far", "fire", {100, 0, 0}, 6, true},
               {stamp(0), "near", "fire", {10, 0, 0}, 6, false},
               {stamp(50), "near", "fire", {10, 0, 0}, 6, true}};
  j.alarms = {{stamp(20), 1, AlarmState::kRaised, {0, 0, 0}, 1},
              {stamp(60), 2, AlarmState::kRaised, {0, 0, 0}, 1},
              {stamp(60), 3, AlarmState::kRaised, {5000, 0, 0}, 1}};
  const Chronology story = tell({}, j);

  EXPECT_EQ(nearest_object(story, story.alarms[0])->name, "far");
  EXPECT_EQ(nearest_object(story, story.alarms[1])->name, "near");
  EXPECT_DOUBLE_EQ(nearest_object(story, story.alarms[1])->metres, 10);
  EXPECT_FALSE(nearest_object(story, story.alarms[2]));
}

}  // namespace
}  // namespace skein::report
