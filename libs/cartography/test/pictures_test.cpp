// SPDX-License-Identifier: Apache-2.0
#include "skein/cartography/pictures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "skein/cartography/map.hpp"

namespace skein::cartography {
namespace {

using refiners::Outcome;
using refiners::Refined;
using refiners::refuse;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using world::Vector3;

world::World small_world() {
  world::TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.hills = {{{100, 100}, 80, 300}};
  world::World world{.origin = {},
                     .terrain = world::Terrain(spec),
                     .wind = {},
                     .airspace = {},
                     .volumes = {},
                     .ground = {},
                     .radio = {},
                     .zones = {},
                     .places = {}};
  world.radio.range = 2000;
  world.zones = {{"forest", {{-400, -400}, {-100, -400}, {-100, -100}}}};
  world::Volume village;
  village.name = "village <old>";
  village.polygon = {{0, -300}, {200, -300}, {200, -100}};
  village.ceiling = 120;
  village.when.until = MissionTime::seconds(600);
  world.volumes = {village};
  world.ground.grid = {-400, -400, 100, 4, 4};
  return world;
}

/// By another's judgement.
bool is_well_formed(const std::string& svg) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("skein-picture-" + std::to_string(::getpid()) + ".svg");
  std::ofstream(file) << svg;
  const int status = std::system(("xmllint --noout " + file.string() + " 2>&1").c_str());
  std::filesystem::remove(file);
  return status == 0;
}

template <class Task>
Outcome<Task> solved(Task task) {
  Refined<Task> refined;
  refined.task = std::move(task);
  refined.cost = 12;
  refined.duration = {Duration::seconds(10), Duration::seconds(200), Duration::max()};
  return refined;
}

TEST(Pictures, AreWellFormedAndSelfContained) {
  const world::World world = small_world();
  refiners::PathQuery query;
  query.from = {-300, -300, 50};
  query.to = {300, 200, 120};
  query.contact = refiners::Contact{{0, 0, 90}, {{100, -200, 100}}};
  refiners::Path path;
  path.way = {query.from, {100, 0, 150}, query.to};

  const std::string svg = picture(world, query, solved(path));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr("data:image/png;base64,"), Not(HasSubstr("href=\"http")),
                         HasSubstr("village &lt;old&gt; …–120 m from 0 s to 600 s"),
                         HasSubstr("forest"), HasSubstr("from 50 m"), HasSubstr("relay")));
}

TEST(Pictures, SameQuestionAndAnswerSamePicture) {
  const world::World world = small_world();
  refiners::PathQuery query;
  query.to = {300, 200, 120};
  refiners::Path path;
  path.way = {query.from, query.to};

  EXPECT_EQ(picture(world, query, solved(path)), picture(world, query, solved(path)));
}

TEST(Pictures, ARefusalShowsWhatWasAskedAndWhyNot) {
  const std::string svg =
      picture(small_world(), refiners::PathQuery(),
              refuse(refiners::RefusalKind::kUnreachable, "to", "every way is closed"));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("no solution (unreachable, to): every way is closed"));
}

TEST(Pictures, PointsThatAreNoNumbersAreLeftOut) {
  refiners::PathQuery query;
  query.to.x() = std::numeric_limits<double>::quiet_NaN();

  const std::string svg =
      picture(small_world(), query, refuse(refiners::RefusalKind::kBadQuery, "to", "NaN"));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, Not(HasSubstr("\"nan")));
}

TEST(Pictures, ATourNumbersItsStopsInTheirOrder) {
  refiners::TourQuery query;
  query.stops = {{"west", {{{-300, 0, 90}, {-300, 0, 90}, {}}}},
                 {"east", {{{300, 0, 90}, {320, 50, 90}, {}}}}};
  refiners::Tour tour;
  tour.visits = {{1, 0, {{0, 0, 90}, {300, 0, 90}}}, {0, 0, {{320, 50, 90}, {-300, 0, 90}}}};

  const std::string svg = picture(small_world(), query, solved(tour));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr("1. east"), HasSubstr("2. west")));
}

TEST(Pictures, ASweepShowsItsLanesAsWideAsTheSwath) {
  refiners::CoverageQuery query;
  query.area = {{-200, -200}, {200, -200}, {200, 200}, {-200, 200}};
  query.holes = {{{-50, -50}, {50, -50}, {0, 50}}};
  query.swath = 100;
  refiners::Coverage coverage;
  coverage.lanes = {{{-200, -150}, {200, -150}}, {{200, -50}, {-200, -50}}};
  coverage.way = {{-200, -150, 60}, {200, -150, 60}, {200, -50, 60}, {-200, -50, 60}};

  const std::string svg = picture(small_world(), query, solved(coverage));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr("2 lanes of 100 m"), HasSubstr("left out")));
  EXPECT_THAT(svg, HasSubstr("height [m] upwards")) << "how high it is flown over the ground";
}

TEST(Pictures, OfALongPatrolOnlyAsMuchOfTheWayIsShownAsPassesOverTheZoneOnce) {
  refiners::PatrolQuery query;
  query.zone = {{-400, -400}, {0, -400}, {0, 0}, {-400, 0}};
  query.footprint = 100;
  refiners::Patrol patrol;
  patrol.potential.assign(16, 0.5);
  for (int i = 0; i < 200; ++i) patrol.way.emplace_back(i % 2 == 0 ? -400 : 0, -200, 60);

  const std::string svg = picture(small_world(), query, solved(patrol));

  EXPECT_THAT(svg, HasSubstr("the last 0.8 km of 79.6 km flown"));
}

TEST(Pictures, TheBarOfAPatrolBeginsAtTheLeastVisits) {
  refiners::PatrolQuery query;
  query.zone = {{-400, -400}, {0, -400}, {0, 0}, {-400, 0}};
  query.footprint = 60;
  refiners::Patrol patrol;
  patrol.potential.assign(16, std::numeric_limits<double>::quiet_NaN());
  patrol.potential[0] = patrol.potential[3] = 0.5;
  // Seven times over the south-western cell, three times over the south-eastern one.
  for (int i = 0; i < 7; ++i) {
    patrol.way.emplace_back(-350, -350, 60);
    patrol.way.emplace_back(-350, -150, 60);
    if (i < 3)
      patrol.way.insert(patrol.way.end(), {{-50, -150, 60}, {-50, -350, 60}, {-50, -150, 60}});
    patrol.way.emplace_back(-200, -150, 60);
  }

  const std::string svg = picture(small_world(), query, solved(patrol));

  EXPECT_THAT(svg, AllOf(HasSubstr(">3</text>"), HasSubstr(">7</text>")));
}

TEST(Pictures, LevelGroundHasNoContourLinesAndBordersHaveCoordinates) {
  world::World world = small_world();
  world::TerrainSpec level = world.terrain.spec();
  level.hills = {{{0, 0}, 0.4, 300}};
  world.terrain = world::Terrain(level);
  refiners::PathQuery query;
  query.from = {-400, -400, 50};
  query.to = {400, 400, 50};
  refiners::Path path;
  path.way = {query.from, query.to};

  const std::string svg = picture(world, query, solved(path));

  EXPECT_THAT(svg, AllOf(HasSubstr("level ground at 0 m"), Not(HasSubstr("contour lines"))));
  EXPECT_THAT(svg, AllOf(HasSubstr(">-400</text>"), HasSubstr(">200</text>")));
}

TEST(Pictures, APartitionGivesEachUavItsColour) {
  refiners::PartitionQuery query;
  query.area = {{-200, -200}, {200, -200}, {200, 200}, {-200, 200}};
  query.members.resize(2);
  query.members[0].uav = "marvin";
  query.members[1].uav = "karma";
  refiners::Partition partition;
  partition.parts.resize(2);
  partition.parts[0].uav = "marvin";
  partition.parts[0].polygon = {{-200, -200}, {0, -200}, {0, 200}, {-200, 200}};
  partition.parts[1].uav = "karma";
  partition.parts[1].polygon = {{0, -200}, {200, -200}, {200, 200}, {0, 200}};
  for (refiners::Part& part : partition.parts) part.share = 0.5;

  const std::string svg = picture(small_world(), query, solved(partition));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr("marvin: 50.0 % of the area"), HasSubstr("karma: 50.0 %")));
}

TEST(Pictures, APatrolShowsVisitsOfItsCellsAndItsLastLap) {
  refiners::PatrolQuery query;
  query.footprint = 60;
  query.zone = {{-400, -400}, {0, -400}, {0, 0}, {-400, 0}};
  refiners::Patrol patrol;
  patrol.potential.assign(16, 0.5);
  patrol.potential[3] = std::numeric_limits<double>::quiet_NaN();
  patrol.way = {{-400, -400, 60}, {0, 0, 60}};

  const std::string svg = picture(small_world(), query, solved(patrol));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr("visits of each cell"), HasSubstr("0.6 km flown")));
}

TEST(Pictures, AViewshedShowsWhatIsSeen) {
  refiners::ViewshedQuery query;
  query.from = {0, 0, 100};
  refiners::Viewshed view;
  view.grid = {-400, -400, 400, 2, 1};
  view.cells = {refiners::Sight::kSeen, refiners::Sight::kHidden};
  view.seen = 1;
  view.asked = 2;
  auto answer = solved(view);
  answer->cost = 0.5;

  const std::string svg = picture(small_world(), query, answer);

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg,
              AllOf(HasSubstr("1 of 2 cells of 400 m are seen: 50.0 %"), HasSubstr("from here")));
  EXPECT_NE(svg,
            picture(small_world(), query, refuse(refiners::RefusalKind::kBlocked, "from", "")));
}

TEST(Pictures, ViewpointsShowTheirCones) {
  refiners::ViewpointQuery query;
  query.vehicle.name = "h";
  query.device = "camera";
  query.target = {0, 0, 10};
  refiners::Viewpoints viewpoints;
  viewpoints.points = {{{100, 0, 80}, 3.14, -0.6, 0.9, 0.8}};

  const std::string svg = picture(small_world(), query, solved(viewpoints));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr("1. 80 m, utility 0.80"), HasSubstr("<polygon")));
}

TEST(Pictures, ARelayShowsTheMarginOfEachLink) {
  refiners::RelayQuery query;
  query.a = {-300, 0, 100};
  query.b = {300, 0, 100};
  refiners::Relay relay;
  relay.positions = {{0, 0, 200}};

  const std::string svg = picture(small_world(), query, solved(relay));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr(" dB, 316 m"), HasSubstr("relay 1 200 m")));
}

TEST(Pictures, AnEvaluationShowsWhereTheWayIsClosed) {
  refiners::EvaluateQuery query;
  query.way = {{-300, 0, 20}, {300, 0, 20}};
  refiners::Evaluation evaluation;
  evaluation.obstructions = {{0, {0, 0, 20}, "ground"}};
  evaluation.limits = {"too slow"};

  const std::string svg = picture(small_world(), query, solved(evaluation));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr("closed by ground"), HasSubstr("too slow")));
}

TEST(Pictures, AnInsertionShowsThePlanAndTheDetour) {
  refiners::InsertionQuery query;
  query.plan = {{{-100, 0, 90}, {-100, 0, 90}, {}}};
  query.task = {{100, 0, 90}, {100, 0, 90}, {}};
  refiners::Insertion insertion;
  insertion.added = {10, 12};
  insertion.to = {{0, 0, 90}, {100, 0, 90}};

  const std::string svg = picture(small_world(), query, solved(insertion));

  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("before task 1 of 2: +12 s"));
}

TEST(FrameBuilder, ShowsTheWholeTerrainWhereItIsNotMuchLarger) {
  const world::World world = small_world();
  FrameBuilder points;
  points.add(world::Vector2(-400, -400));
  points.add(world::Vector2(400, 400));

  const Frame frame = points.frame(world.terrain);

  EXPECT_EQ(frame.west, -500);
  EXPECT_EQ(frame.north, 500);
}

TEST(FrameBuilder, ComesCloseToWhatIsSmall) {
  const world::World world = small_world();
  FrameBuilder points;
  points.add(world::Vector2(0, 0));
  points.add(world::Vector2(50, 10));

  const Frame frame = points.frame(world.terrain);

  EXPECT_LT(frame.east - frame.west, 250);
  EXPECT_GE(frame.north - frame.south, 100);
}

TEST(FrameBuilder, WithoutPointsShowsTheTerrain) {
  EXPECT_EQ(FrameBuilder().frame(small_world().terrain).east, 500);
}

}  // namespace
}  // namespace skein::cartography
