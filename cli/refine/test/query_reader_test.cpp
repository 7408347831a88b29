// SPDX-License-Identifier: Apache-2.0
#include "query_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "examples.hpp"
#include "skein/refine_tool/refine.hpp"
#include "testing/queries.hpp"

namespace skein::refine_tool {
namespace {

using ::testing::AllOf;
using testing::errors_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::question_of;
using testing::read;
using ::testing::SizeIs;
using world::Vector2;
using world::Vector3;

class EveryExample : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryExample, ReadsWithoutFiles) {
  const auto query = read_query(example_of(GetParam()), "example", testing::no_files());

  ASSERT_TRUE(query) << to_text(query.error());
  EXPECT_EQ(query->service, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Services, EveryExample, ::testing::ValuesIn(service_names()));

TEST(QueryReader, ReadsAPathWithAllItsOptions) {
  const auto path = question_of<refiners::PathQuery>("path", R"(
    "from": "pad", "to": [100, 200, 60], "heading_from": 1, "heading_to": -1, "clearance": 15,
    "speed": 8, "depart": 100,
    "reserved": {"marvin": {"polygon": [[0, 0], [50, 0], [0, 50]], "floor": 20, "ceiling": 80,
                            "from": 10, "until": 200}},
    "contact": {"with": "pad", "relays": ["far"]})");

  EXPECT_EQ(path.from, Vector3(-400, -400, 30));
  EXPECT_EQ(path.to, Vector3(100, 200, 60));
  EXPECT_EQ(path.heading_from, 1);
  EXPECT_EQ(path.heading_to, -1);
  EXPECT_EQ(path.clearance, 15);
  EXPECT_EQ(path.speed, 8);
  EXPECT_EQ(path.depart, MissionTime::seconds(100));
  ASSERT_THAT(path.reserved, SizeIs(1));
  EXPECT_EQ(path.reserved[0].name, "marvin");
  EXPECT_EQ(path.reserved[0].ceiling, 80);
  EXPECT_EQ(path.reserved[0].when.until, MissionTime::seconds(200));
  EXPECT_EQ(path.contact->relays, (std::vector<Vector3>{{400, 400, 60}}));
}

TEST(QueryReader, AClosedRingIsTheRingWithoutItsLastCorner) {
  const auto sweep = question_of<refiners::CoverageQuery>("coverage", R"(
    "area": [[0, 0], [200, 0], [200, 100], [0, 100], [0, 0]],
    "holes": [[[50, 20], [90, 20], [90, 60], [50, 20]]], "swath": 20, "altitude": 60)");

  EXPECT_THAT(sweep.area, SizeIs(4));
  ASSERT_THAT(sweep.holes, SizeIs(1));
  EXPECT_THAT(sweep.holes[0], SizeIs(3));
}

TEST(QueryReader, AreasAndPlacesMayBeInLongitudeAndLatitude) {
  const auto sweep = question_of<refiners::CoverageQuery>("coverage", R"(
    "area": {"lonlat": [[-8, 40], [-7.998, 40], [-7.998, 40.001], [-8, 40.001], [-8, 40]]},
    "start": {"lonlat": [-8.001, 39.999], "height": 30}, "swath": 20, "altitude": 60)");

  ASSERT_THAT(sweep.area, SizeIs(4));
  // A degree of latitude is 111,034 m there, one of longitude 85,394 m.
  EXPECT_NEAR(sweep.area[2].x(), 2 * 85.394, 0.1);
  EXPECT_NEAR(sweep.area[2].y(), 111.034, 0.1);
  EXPECT_NEAR(sweep.start->x(), -85.394, 0.1);
  EXPECT_NEAR(sweep.start->y(), -111.034, 0.1);

  EXPECT_THAT(errors_of("coverage", R"("area": {"lonlat": [[40, -98], [41, -98], [41, -97]]},
                                       "swath": 20, "altitude": 60)"),
              AllOf(HasSubstr("a latitude of -98"), HasSubstr("[longitude, latitude]")));
}

TEST(QueryReader, MoreCornersThanCanBeWorkedWithAreSimplifiedAndThatIsSaid) {
  std::string ring;
  for (int i = 0; i < 3000; ++i) {
    const double angle = i * 2 * 3.14159265358979 / 3000;
    ring += (i > 0 ? ", [" : "[") + std::to_string(200 * std::cos(angle)) + ", " +
            std::to_string(200 * std::sin(angle)) + "]";
  }
  const auto query = read("coverage", R"("area": [)" + ring + R"(], "swath": 20, "altitude": 60)");

  ASSERT_TRUE(query) << to_text(query.error());
  EXPECT_LE(std::get<refiners::CoverageQuery>(query->question).area.size(), 2000U);
  ASSERT_THAT(query->notes, SizeIs(1));
  EXPECT_THAT(query->notes[0], HasSubstr("area: 3000 corners were simplified to"));
  EXPECT_THAT(query->notes[0], HasSubstr("moves by more than 0.00 m"));
}

TEST(QueryReader, AnAreaThatReachesBeyondTheGroundIsSaidToDoSo) {
  const auto query =
      read("coverage",
           R"("area": [[0, 0], [800, 0], [800, 100], [0, 100]], "swath": 20, "altitude": 60)");

  ASSERT_TRUE(query);
  ASSERT_THAT(query->notes, SizeIs(1));
  EXPECT_THAT(query->notes[0], HasSubstr("area: it reaches 300 m beyond the ground"));
}

TEST(QueryReader, PlacesMayStandAtAHeightOverTheGround) {
  const auto path = question_of<refiners::PathQuery>(
      "path", R"("from": {"at": [0, 0], "height": 25}, "to": {"at": "far", "height": 10})");

  EXPECT_NEAR(path.from.z(), 65, 1e-9);
  EXPECT_EQ(path.to, Vector3(400, 400, 10));
}

TEST(QueryReader, AreasMayBeNamedByTheirZone) {
  const auto sweep = question_of<refiners::CoverageQuery>(
      "coverage", R"("area": "field", "swath": 50, "altitude": 60, "start": "pad")");

  EXPECT_THAT(sweep.area, SizeIs(4));
  EXPECT_EQ(sweep.mode, refiners::SweepMode::kLeastTime);
  EXPECT_EQ(sweep.start, Vector3(-400, -400, 30));
  EXPECT_FALSE(sweep.end);
}

TEST(QueryReader, TheSwathOfADeviceIsWhatItSeesOfTheGroundFromThere) {
  const auto sweep = question_of<refiners::CoverageQuery>(
      "coverage", R"("area": "field", "device": "down", "altitude": 80)");

  EXPECT_NEAR(sweep.swath, 80, 0.01);  // tan(0.4636) = 1/2 to either side
}

TEST(QueryReader, TheFootprintOfAPatrolIsHalfTheSwathOfItsDevice) {
  const auto patrol = question_of<refiners::PatrolQuery>(
      "patrol",
      R"("zone": "field", "start": "pad", "device": "down", "altitude": 80, "duration": 600)");

  EXPECT_NEAR(patrol.footprint, 40, 0.01);
  EXPECT_EQ(patrol.duration, Duration::seconds(600));
}

TEST(QueryReader, ADeviceThatLooksAheadHasNoSwath) {
  EXPECT_THAT(errors_of("coverage", R"("area": "field", "device": "ahead", "altitude": 80)"),
              HasSubstr("does not look down"));
}

TEST(QueryReader, ADeviceDoesNotSeeBeyondItsRange) {
  EXPECT_THAT(errors_of("coverage", R"("area": "field", "device": "down", "altitude": 180)"),
              HasSubstr("at most its range, 150 m"));
}

TEST(QueryReader, SwathAndDeviceExcludeEachOther) {
  EXPECT_THAT(
      errors_of("coverage", R"("area": "field", "swath": 4, "device": "down", "altitude": 80)"),
      HasSubstr("swath beside device"));
  EXPECT_THAT(errors_of("coverage", R"("area": "field", "altitude": 80)"),
              HasSubstr("neither swath nor device"));
}

TEST(QueryReader, StopsOfATourArePlacesGatesOrAreas) {
  const auto tour = question_of<TourWithAreas>("tour", R"("start": "pad", "stops": {
    "a": [1, 2, 60],
    "b": {"entry": [3, 4, 60], "exit": [5, 6, 60], "inside": 30},
    "c": {"gates": [{"entry": [7, 8, 60], "exit": "far"}, {"entry": "far", "exit": [7, 8, 60]}]},
    "d": {"area": "field", "swath": 100, "altitude": 60}})");

  ASSERT_THAT(tour.tour.stops, SizeIs(4));
  EXPECT_EQ(tour.tour.stops[0].gates[0].entry, tour.tour.stops[0].gates[0].exit);
  EXPECT_EQ(tour.tour.stops[1].gates[0].inside, Duration::seconds(30));
  EXPECT_THAT(tour.tour.stops[2].gates, SizeIs(2));
  EXPECT_THAT(tour.tour.stops[3].gates, IsEmpty());
  ASSERT_THAT(tour.areas, SizeIs(1));
  EXPECT_EQ(tour.areas[0].stop, 3U);
  EXPECT_EQ(tour.areas[0].coverage.swath, 100);
}

TEST(QueryReader, ADirectionGoesWithTheModeThatTakesIt) {
  EXPECT_EQ(question_of<refiners::CoverageQuery>(
                "coverage",
                R"("area": "field", "swath": 9, "altitude": 60, "mode": "given", "direction": 1)")
                .direction,
            1);
  EXPECT_THAT(errors_of("coverage", R"("area": "field", "swath": 9, "altitude": 60,
                                       "direction": 1)"),
              HasSubstr("mode: given"));
}

TEST(QueryReader, ConstraintsOfAViewpointHoldWhereTheySay) {
  const auto query = question_of<refiners::ViewpointQuery>("viewpoint", R"(
    "device": "ahead", "target": [0, 0, 41], "constraints": {
      "east": {"sector": [-0.5, 0.5]}, "in": {"within": "field"}, "out": {"outside": "field"},
      "behind": {"sector": [3, -3]}})");

  ASSERT_THAT(query.constraints, SizeIs(4));
  EXPECT_TRUE(query.constraints[0].holds({100, 10, 60}));
  EXPECT_FALSE(query.constraints[0].holds({-100, 10, 60}));
  EXPECT_TRUE(query.constraints[1].holds({100, 10, 60}));
  EXPECT_FALSE(query.constraints[2].holds({100, 10, 60}));
  EXPECT_TRUE(query.constraints[3].holds({-100, 1, 60}));
  EXPECT_FALSE(query.constraints[3].holds({100, 1, 60}));
}

TEST(QueryReader, AConstraintHasOneKind) {
  EXPECT_THAT(errors_of("viewpoint", R"("device": "ahead", "target": "far",
                        "constraints": {"c": {"within": "field", "sector": [0, 1]}})"),
              HasSubstr("constraints.c: a constraint of no kind, or of several"));
}

TEST(QueryReader, MembersOfAPartitionHaveTheirOwnVehicles) {
  const std::string member =
      R"({"start": [10, 20], "swath": 40, "altitude": 60, "busy": 30, "share": 2, )" +
      testing::kVehicle + "}";
  const auto query =
      read_query("{\"service\": \"partition\", " + testing::kWorld +
                     R"(, "area": "field", "mode": "balanced", "members": {"m": )" + member + "}}",
                 "q.json", testing::no_files());

  ASSERT_TRUE(query) << to_text(query.error());
  const auto& partition = std::get<refiners::PartitionQuery>(query->question);
  EXPECT_EQ(partition.mode, refiners::ShareMode::kBalanced);
  ASSERT_THAT(partition.members, SizeIs(1));
  EXPECT_EQ(partition.members[0].start, Vector2(10, 20));
  EXPECT_EQ(partition.members[0].busy, 30);
  EXPECT_EQ(partition.members[0].share, 2);
}

TEST(QueryReader, RelayEvaluateAndInsertionReadTheirPlaces) {
  const auto relay = question_of<refiners::RelayQuery>(
      "relay", R"("a": "pad", "b": "far", "most": 3, "least_margin": 2)");
  const auto evaluate =
      question_of<refiners::EvaluateQuery>("evaluate", R"("way": ["pad", [0, 0, 80], "far"])");
  const auto insertion = question_of<refiners::InsertionQuery>("insertion", R"(
    "start": "pad", "plan": [{"from": "pad", "to": "far", "duration": 5}],
    "task": {"at": [0, 0, 80]})");

  EXPECT_EQ(relay.most, 3U);
  EXPECT_THAT(evaluate.way, SizeIs(3));
  EXPECT_EQ(insertion.plan[0].duration, Duration::seconds(5));
  EXPECT_EQ(insertion.task.from, insertion.task.to);
}

TEST(QueryReader, BudgetSeedAndPlannerAreOfAllQueries) {
  const auto query = read("path", R"("from": "pad", "to": "far", "seed": 7, "planner": "sampling",
                                     "budget": {"seconds": 0.5, "steps": 1000})");

  ASSERT_TRUE(query) << to_text(query.error());
  EXPECT_EQ(query->seed, 7U);
  EXPECT_EQ(query->planner, Planner::kSampling);
  EXPECT_EQ(query->seconds, 0.5);
  EXPECT_EQ(query->steps, 1000U);
}

TEST(QueryReader, EveryErrorIsToldAtOnceWithItsPlace) {
  const std::string errors = errors_of("path", R"("form": "pad", "to": "fra", "speed": .nan,
                                       "contact": {"relays": [[1, 2]]})");

  EXPECT_THAT(errors,
              AllOf(HasSubstr("q.json:"), HasSubstr("form"), HasSubstr("from"), HasSubstr("'far'"),
                    HasSubstr("speed"), HasSubstr("contact"), HasSubstr("contact.relays")));
}

TEST(QueryReader, AnUnknownServiceIsToldWithTheNearest) {
  EXPECT_THAT(errors_of("pth", ""), HasSubstr("did you mean 'path'"));
}

TEST(QueryReader, AKeyOfAnotherServiceIsNoKeyOfThisOne) {
  EXPECT_THAT(errors_of("relay", R"("a": "pad", "b": "far", "swath": 3)"), HasSubstr("swath"));
}

TEST(QueryReader, AVolumeMustHaveRoomAndTime) {
  EXPECT_THAT(errors_of("path", R"("from": "pad", "to": "far", "reserved": {
                        "flat": {"polygon": "field", "floor": 9, "ceiling": 9},
                        "gone": {"polygon": "field", "from": 9, "until": 3}})"),
              AllOf(HasSubstr("floor is not below"), HasSubstr("ends before it begins")));
}

TEST(QueryReader, FilesThatAreMissingAreNamed) {
  const auto query = read_query(R"({"service": "path", "world": "w.yaml", "from": 1})", "q.json",
                                testing::no_files());

  ASSERT_FALSE(query);
  EXPECT_THAT(to_text(query.error()),
              AllOf(HasSubstr("q.json:1"), HasSubstr("w.yaml: there is no")));
}

TEST(QueryReader, ErrorsInsideTheWorldAreToldByTheirPathInTheQuery) {
  const auto query = read_query(R"({"service": "path", "world": {"terrain": {"west": 3}}})",
                                "q.json", testing::no_files());

  ASSERT_FALSE(query);
  EXPECT_THAT(to_text(query.error()), HasSubstr("world.terrain.east"));
}

TEST(QueryReader, WhatIsNoMapIsNoQuery) {
  EXPECT_FALSE(read_query("[1, 2]", "q", testing::no_files()));
  EXPECT_FALSE(read_query("", "q", testing::no_files()));
  EXPECT_FALSE(read_query("{\"service\": ", "q", testing::no_files()));
}

}  // namespace
}  // namespace skein::refine_tool
