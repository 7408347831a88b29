// SPDX-License-Identifier: Apache-2.0
// Missions are checked against a vocabulary: every reason at once, whatever the mission.
#include "skein/mission/vocabulary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace skein::mission {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vocabulary comets() {
  using K = ParameterKind;
  Vocabulary all;
  const auto add = [&](const char* name, std::vector<K> kinds, std::vector<std::string> uses) {
    all.tasks[name] = {name, std::move(kinds), std::move(uses)};
  };
  add("general-takeoff", {}, {});
  add("general-gotoxyz", {K::kPlace}, {});
  add("perform-detection", {K::kZone, K::kPlace, K::kDuration}, {"detection"});
  add("perform-mapping", {K::kZone}, {"mapping"});
  add("perform-tour", {K::kPlaces}, {});
  add("synchro", {K::kSyncId, K::kUavs, K::kUavs}, {});
  add("follow", {K::kUav, K::kNumber}, {});
  add("look-with", {K::kDevice, K::kWord}, {});
  all.serves.emplace("fire-sensor", "detection");
  all.serves.emplace("ir", "detection");
  all.serves.emplace("mapper", "mapping");
  return all;
}

world::VehicleModel karma() {
  world::VehicleModel model;
  model.sensors.resize(2);
  model.sensors[0].device = "visible";
  model.sensors[1].device = "fire-sensor";
  return model;
}

class MissionCheck : public testing::Test {
 protected:
  std::vector<std::string> problems(const UnitMission& mission) const {
    return problems_of(mission, vocabulary_, surroundings_, now_);
  }
  std::vector<std::string> problems(std::string name, std::vector<Argument> arguments,
                                    TimeConstraints time = {}) const {
    UnitMission mission;
    mission.id = MissionId(1);
    mission.tasks = {{GoalId(701), std::move(name), std::move(arguments), time}};
    return problems(mission);
  }

  Vocabulary vocabulary_ = comets();
  world::VehicleModel vehicle_ = karma();
  Surroundings surroundings_{{"P1", "P2"}, {"Z1", "Z2"}, {"karma", "heliv", "marvin"}, &vehicle_};
  MissionTime now_ = MissionTime::seconds(50);
};

TEST(ParameterKind, IsReadBackFromItsWord) {
  for (int i = 0; i < static_cast<int>(ParameterKind::kCount); ++i) {
    const auto kind = static_cast<ParameterKind>(i);

    EXPECT_EQ(parameter_kind_from(to_text(kind)), kind);
  }
  EXPECT_EQ(parameter_kind_from("?"), std::nullopt);
}

TEST_F(MissionCheck, ADurationMayBeARange) {
  EXPECT_THAT(problems("perform-detection", {"Z2", "P2", "60..300"}), IsEmpty());
  EXPECT_THAT(problems("perform-detection", {"Z2", "P2", "300..60"}),
              ElementsAre("task 701 (perform-detection): argument 3 must be the least duration and "
                          "then the most, not 300..60"));
  EXPECT_EQ(problems("perform-detection", {"Z2", "P2", "0..60"}).size(), 1U);
}

TEST_F(MissionCheck, AcceptsWhatTheDomainTakes) {
  EXPECT_THAT(problems("general-takeoff", {}), IsEmpty());
  EXPECT_THAT(problems("perform-detection", {"Z2", "P2", 300.0}), IsEmpty());
  EXPECT_THAT(problems("general-gotoxyz", {world::Vector3(1, 2, 3)}), IsEmpty());
  EXPECT_THAT(problems("perform-tour", {std::vector<std::string>{"P1", "P2", "P1"}}), IsEmpty());
  EXPECT_THAT(problems("synchro", {551.0, std::vector<std::string>{"karma", "heliv"},
                                   std::vector<std::string>{"heliv"}}),
              IsEmpty());
  EXPECT_THAT(problems("look-with", {"visible", "anything"}), IsEmpty());
  EXPECT_THAT(problems("follow", {"heliv", -2.5}), IsEmpty());
}

TEST_F(MissionCheck, NamesTheNearestTaskOfAnUnknownOne) {
  EXPECT_THAT(
      problems("preform-detection", {"Z2"}),
      ElementsAre("task 701: unknown task 'preform-detection'; did you mean 'perform-detection'?"));
  EXPECT_THAT(problems("qq", {}), ElementsAre("task 701: unknown task 'qq'"));
}

TEST_F(MissionCheck, NamesTheNearestPlaceZoneUavAndDevice) {
  EXPECT_THAT(
      problems("perform-detection", {"z2", "P3", 300.0}),
      ElementsAre(
          "task 701 (perform-detection): argument 1: unknown zone 'z2'; did you mean 'Z2'?",
          "task 701 (perform-detection): argument 2: unknown place 'P3'; did you mean 'P1'?"));
  EXPECT_THAT(problems("follow", {"helv", 1.0}),
              ElementsAre("task 701 (follow): argument 1: unknown UAV 'helv'; did you mean "
                          "'heliv'?"));
  EXPECT_THAT(problems("look-with", {"visble", "w"}),
              ElementsAre("task 701 (look-with): argument 1: unknown device 'visble'; did you mean "
                          "'visible'?"));
}

TEST_F(MissionCheck, TellsHowManyArgumentsAreTakenAndStillChecksThoseGiven) {
  EXPECT_THAT(problems("perform-detection", {"Z9"}),
              ElementsAre("task 701 (perform-detection): takes 3 arguments (zone, place, duration),"
                          " not 1",
                          "task 701 (perform-detection): argument 1: unknown zone 'Z9'; did you "
                          "mean 'Z1'?"));
  EXPECT_THAT(problems("general-takeoff", {1.0}),
              ElementsAre("task 701 (general-takeoff): takes 0 arguments, not 1"));
}

TEST_F(MissionCheck, TellsWhatAnArgumentMustBe) {
  EXPECT_THAT(problems("perform-detection", {1.0, std::vector<std::string>{"P1"}, "long"}),
              ElementsAre("task 701 (perform-detection): argument 1 must be a zone",
                          "task 701 (perform-detection): argument 2 must be a place or a location",
                          "task 701 (perform-detection): argument 3 must be a duration above 0 s, "
                          "or two of them as in 60..120"));
  EXPECT_THAT(problems("perform-tour", {"P1"}),
              ElementsAre("task 701 (perform-tour): argument 1 must be a list of places"));
  EXPECT_THAT(problems("look-with", {"visible", ""}),
              ElementsAre("task 701 (look-with): argument 2 must be a word"));
}

TEST_F(MissionCheck, RefusesFiguresThatAreNotFiniteOrOutOfRange) {
  for (const double wrong : {0.0, -1.0, kNan, kInfinity, -kInfinity, 1e-12})
    EXPECT_EQ(problems("perform-detection", {"Z1", "P1", wrong}).size(), 1U) << wrong;
  for (const double wrong : {0.0, 1.5, -3.0, kNan, kInfinity, 1e17})
    EXPECT_EQ(problems("synchro", {wrong, std::vector<std::string>{"karma"},
                                   std::vector<std::string>{"karma"}})
                  .size(),
              1U)
        << wrong;
  EXPECT_THAT(problems("follow", {"karma", kNan}),
              ElementsAre("task 701 (follow): argument 2 must be a finite number, not nan"));
  EXPECT_THAT(problems("general-gotoxyz", {world::Vector3(0, kInfinity, 0)}),
              ElementsAre(HasSubstr("not finite")));
}

TEST_F(MissionCheck, RefusesListsThatNameNothingOrAUavTwice) {
  EXPECT_THAT(problems("perform-tour", {std::vector<std::string>{}}),
              ElementsAre(HasSubstr("names nothing")));
  EXPECT_THAT(problems("synchro", {1.0, std::vector<std::string>{"karma", "karma"},
                                   std::vector<std::string>{"karm"}}),
              ElementsAre("task 701 (synchro): argument 2 names 'karma' twice",
                          "task 701 (synchro): argument 3: unknown UAV 'karm'; did you mean "
                          "'karma'?"));
}

TEST_F(MissionCheck, NeedsADeviceOnBoardForEachUse) {
  EXPECT_THAT(problems("perform-mapping", {"Z1"}),
              ElementsAre("task 701 (perform-mapping): no device on board serves 'mapping'; one of "
                          "these would: mapper"));
  vocabulary_.serves.clear();
  EXPECT_THAT(problems("perform-mapping", {"Z1"}),
              ElementsAre("task 701 (perform-mapping): no device on board serves 'mapping'"));
}

TEST_F(MissionCheck, DoesNotCheckDevicesOfAnUnknownVehicle) {
  surroundings_.vehicle = nullptr;

  EXPECT_THAT(problems("perform-mapping", {"Z1"}), IsEmpty());
  EXPECT_THAT(problems("look-with", {"radar", "w"}), IsEmpty());
}

TEST_F(MissionCheck, RefusesConstraintsThatContradictEachOther) {
  TimeConstraints time;
  time.start_after = MissionTime::seconds(300);
  time.start_before = MissionTime::seconds(200);
  time.end_after = MissionTime::seconds(400);
  time.end_before = MissionTime::seconds(250);

  EXPECT_THAT(problems("general-takeoff", {}, time),
              ElementsAre("task 701: cannot start after 300 s and start before 200 s",
                          "task 701: cannot end after 400 s and end before 250 s",
                          "task 701: cannot start after 300 s and end before 250 s"));
}

TEST_F(MissionCheck, RefusesBoundsAfterGoalsThatMakeNoSense) {
  UnitMission mission;
  mission.id = MissionId(1);
  mission.tasks = {{GoalId(701), "general-takeoff", {}, {}}};
  mission.tasks[0].after = {{GoalId(701), false, Duration::seconds(60), Duration::seconds(10)},
                            {GoalId(), true, Duration::seconds(-1), Duration::max()}};

  EXPECT_THAT(problems(mission),
              ElementsAre("task 701: cannot start after goal 701: that is itself",
                          "task 701: cannot start after goal 701 by 60 s at least and 10 s at most",
                          "task 701: a bound after a goal needs its number",
                          "task 701: cannot end after goal 0 by less than 0 s"));
}

TEST_F(MissionCheck, RefusesConstraintsThatHavePassed) {
  TimeConstraints time;
  time.start_before = MissionTime::seconds(49);
  time.end_before = MissionTime::seconds(50);
  time.start_after = MissionTime::seconds(10);

  EXPECT_THAT(problems("general-takeoff", {}, time),
              ElementsAre("task 701: cannot start before 49 s: it is 50 s already"));
}

TEST_F(MissionCheck, RefusesMissionsWithoutTasksOrNumbersAndNumbersGivenTwice) {
  EXPECT_THAT(problems(UnitMission{}),
              ElementsAre("the mission needs a number above 0", "the mission has no tasks"));
  UnitMission mission;
  mission.id = MissionId(1);
  mission.tasks.assign(3, {GoalId(7), "general-takeoff", {}, {}});
  EXPECT_THAT(problems(mission), ElementsAre("task 7 is given twice"));
  mission.tasks = {{GoalId(), "general-takeoff", {}, {}}};
  EXPECT_THAT(problems(mission), ElementsAre("a task needs a number above 0"));
}

TEST_F(MissionCheck, GivesAllReasonsOfAllTasks) {
  UnitMission mission;
  mission.id = MissionId(1);
  mission.tasks = {{GoalId(1), "fly", {}, {}},
                   {GoalId(2), "general-gotoxyz", {"P9"}, {}},
                   {GoalId(3), "perform-mapping", {}, {}}};

  EXPECT_EQ(problems(mission).size(), 4U);
}

TEST_F(MissionCheck, AnEndlessNameIsShownInPart) {
  const auto all = problems(std::string(1'000'000, 'a'), {});

  ASSERT_EQ(all.size(), 1U);
  EXPECT_LT(all[0].size(), 200U);
}

// --- random missions -----------------------------------------------------------------------------

template <class T>
T one_of(const std::vector<T>& all) {
  return *rc::gen::elementOf(all);
}

Argument any_argument() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return one_of<std::string>({"P1", "Z1", "karma", "visible", "", "p1"});
    case 1:
      return one_of<double>({1, -1, 0, kNan, kInfinity, -kInfinity, 1e300, 5e-324, 0.5});
    case 2:
      return world::Vector3(one_of<double>({0, kNan, 1e300}), 1, 2);
    default:
      return *rc::gen::container<std::vector<std::string>>(
          rc::gen::element<std::string>("P1", "karma", "", "x"));
  }
}

TimeConstraints any_constraints() {
  const auto bound = [&]() -> std::optional<MissionTime> {
    if (*rc::gen::inRange(0, 2) == 0) return std::nullopt;
    return MissionTime::nanoseconds(one_of<std::int64_t>(
        {0, 50'000'000'000, std::numeric_limits<std::int64_t>::max(),
         std::numeric_limits<std::int64_t>::min(), *rc::gen::arbitrary<std::int64_t>()}));
  };
  return {bound(), bound(), bound(), bound()};
}

Argument a_valid_argument(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kPlace:
      if (*rc::gen::inRange(0, 2) == 0) return world::Vector3(1, 2, *rc::gen::inRange(0, 100));
      return one_of<std::string>({"P1", "P2"});
    case ParameterKind::kZone:
      return one_of<std::string>({"Z1", "Z2"});
    case ParameterKind::kPlaces:
      return *rc::gen::nonEmpty(
          rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>("P1", "P2")));
    case ParameterKind::kDuration:
      return one_of<double>({1e-9, 20, 86400});
    case ParameterKind::kNumber:
      return one_of<double>({-1e300, 0, 1e-300});
    case ParameterKind::kUavs:
      return one_of<std::vector<std::string>>({{"karma"}, {"heliv", "karma"}});
    case ParameterKind::kUav:
      return std::string("marvin");
    case ParameterKind::kDevice:
      return std::string("visible");
    case ParameterKind::kSyncId:
      return static_cast<double>(*rc::gen::inRange(1, 1'000'000));
    default:
      return std::string("word");
  }
}

RC_GTEST_FIXTURE_PROP(MissionCheck, AnyMissionHasAnAnswer, ()) {
  std::vector<std::string> names{"", "zz"};
  for (const auto& [name, signature] : vocabulary_.tasks) names.push_back(name);
  UnitMission mission;
  mission.id = MissionId(*rc::gen::inRange<std::uint64_t>(0, 2));
  const int count = *rc::gen::inRange(0, 6);
  for (int i = 0; i < count; ++i) {
    HighLevelTask task{GoalId(*rc::gen::inRange<std::uint64_t>(0, 4)), one_of(names), {}, {}};
    const int arguments = *rc::gen::inRange(0, 5);
    for (int k = 0; k < arguments; ++k) task.arguments.push_back(any_argument());
    task.time = any_constraints();
    mission.tasks.push_back(task);
  }

  const auto all = problems(mission);

  for (const std::string& one : all) RC_ASSERT(!one.empty());
  RC_ASSERT(count > 0 || !all.empty());
  for (const HighLevelTask& task : mission.tasks)
    RC_ASSERT(!to_text(task).empty() || task.name.empty());
}

RC_GTEST_FIXTURE_PROP(MissionCheck, AcceptsEveryMissionMadeAfterTheSignatures, ()) {
  vocabulary_.serves.emplace("visible", "mapping");
  std::vector<std::string> names;
  for (const auto& [name, signature] : vocabulary_.tasks) names.push_back(name);
  UnitMission mission;
  mission.id = MissionId(1);
  const auto count = *rc::gen::inRange<std::uint64_t>(1, 6);
  for (std::uint64_t i = 1; i <= count; ++i) {
    HighLevelTask task{GoalId(i), one_of(names), {}, {}};
    for (const ParameterKind kind : vocabulary_.tasks.at(task.name).parameters)
      task.arguments.push_back(a_valid_argument(kind));
    if (*rc::gen::inRange(0, 2) == 0) task.time.start_after = MissionTime::seconds(60);
    if (*rc::gen::inRange(0, 2) == 0) task.time.end_before = MissionTime::seconds(60);
    mission.tasks.push_back(task);
  }

  RC_ASSERT(problems(mission).empty());
}

}  // namespace
}  // namespace skein::mission
