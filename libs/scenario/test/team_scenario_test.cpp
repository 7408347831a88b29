// SPDX-License-Identifier: Apache-2.0
// What a scenario says of its team and of global missions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/files.hpp"

namespace skein::scenario {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using testing::errors_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::planning_scenario_with;
using testing::read_valid;
using ::testing::SizeIs;

constexpr const char* kEnd = "do: [{finish: true}]";

std::string with_team(const std::string& team, const std::string& action) {
  return planning_scenario_with(kEnd, "do: [" + action + "]") + "team: " + team + "\n";
}

const ground_station::SendGlobalMission& mission_of(const Scenario& scenario) {
  return std::get<ground_station::SendGlobalMission>(
      scenario.ground.script.steps.back().actions.at(0));
}

TEST(TeamScenario, AllUavsAndTheGroundAreInItWhereNothingElseIsSaid) {
  const Scenario scenario = read_valid(with_team("{lease: 12}", "{finish: true}"));

  ASSERT_TRUE(scenario.team.has_value());
  EXPECT_THAT(scenario.team->roster.names(), ElementsAre("karma", "heliv", "ground"));
  EXPECT_EQ(scenario.team->limits.lease, Duration::seconds(12));
}

TEST(TeamScenario, MembersAndLimitsAreAsTheyAreGiven) {
  const Scenario scenario = read_valid(
      with_team("{members: [heliv], ground: false, patience: 4, beat: 1, ahead: 2, equity: 0.3}",
                "{finish: true}"));

  EXPECT_THAT(scenario.team->roster.names(), ElementsAre("heliv"));
  EXPECT_EQ(scenario.team->limits.patience, Duration::seconds(4));
  EXPECT_EQ(scenario.team->limits.beat, Duration::seconds(1));
  EXPECT_EQ(scenario.team->limits.ahead, 2U);
  EXPECT_EQ(scenario.team->limits.aim.equity, 0.3);
}

// At 9,600 bit/s a kilobyte takes 0.83 s, and a sale that allows 2 s for an answer sells nothing.
TEST(TeamScenario, WhoShareANarrowRadioWaitLongerForEachOther) {
  const auto over = [](const std::string& radio, const std::string& team) {
    return read_valid(with_team(team, "{finish: true}") + "radio: " + radio + "\n").team->limits;
  };
  const auction::TeamLimits wide = over("{}", "{}");
  const auction::TeamLimits narrow = over("{capacity: 8000}", "{}");

  EXPECT_EQ(wide.sale.answer_within, Duration::seconds(2));
  EXPECT_EQ(wide.beat, Duration::seconds(1));
  EXPECT_EQ(wide.patience, Duration::seconds(4));
  EXPECT_EQ(narrow.sale.answer_within, Duration::seconds(10));
  EXPECT_EQ(narrow.beat, Duration::seconds(3));
  EXPECT_EQ(narrow.patience, Duration::seconds(12));
  EXPECT_EQ(over("{capacity: 8000}", "{beat: 1}").beat, Duration::seconds(1));
}

TEST(TeamScenario, AGlobalMissionHasTasksWithTheirPlacesAndTheOperatorsWishes) {
  const Scenario scenario = read_valid(with_team(
      "{}",
      "{global_mission: {id: 3, tasks: [{id: 11, task: [perceive, base, 20], by: karma}, "
      "{id: 12, task: [perceive, [10, 20, 0], 20], not_by: [karma], after: [11], members: 2, "
      "repeatable: true, end_before: 90}]}}"));

  const auto& mission = mission_of(scenario).mission;
  EXPECT_EQ(mission.id, mission::MissionId(3));
  ASSERT_THAT(mission.tasks, SizeIs(2));
  EXPECT_EQ(mission.tasks[0].by, "karma");
  EXPECT_THAT(mission.tasks[1].not_by, ElementsAre("karma"));
  EXPECT_THAT(mission.tasks[1].after, ElementsAre(mission::GoalId(11)));
  EXPECT_EQ(mission.tasks[1].members, 2U);
  EXPECT_TRUE(mission.tasks[1].repeatable);
  EXPECT_EQ(mission.tasks[1].at, (auction::Place{10, 20}));
  EXPECT_EQ(mission.tasks[1].task.time.end_before, MissionTime::seconds(90));
}

TEST(TeamScenario, ATaskMayBeginSomeTimeAfterAnother) {
  const Scenario scenario = read_valid(
      with_team("{}",
                "{global_mission: {id: 3, tasks: [{id: 11, task: [perceive, base, 20]}, "
                "{id: 12, task: [perceive, base, 20], after: [{task: 11, least: 60, most: 300}]}, "
                "{id: 13, task: [perceive, base, 20], after: [11, {task: 12, most: 90.5}]}]}}"));

  const auto& tasks = mission_of(scenario).mission.tasks;
  ASSERT_THAT(tasks, SizeIs(3));
  EXPECT_THAT(tasks[1].after, ElementsAre(mission::GoalId(11)));
  EXPECT_THAT(tasks[1].task.after,
              ElementsAre(mission::GoalBound{mission::GoalId(11), false, Duration::seconds(60),
                                             Duration::seconds(300)}));
  EXPECT_THAT(tasks[2].after, ElementsAre(mission::GoalId(11), mission::GoalId(12)));
  EXPECT_THAT(tasks[2].task.after,
              ElementsAre(mission::GoalBound{mission::GoalId(12), false, Duration(),
                                             Duration::seconds(90.5)}));
}

TEST(TeamScenario, TimesAfterAnotherTaskThatMakeNoSenseAreSaidWithTheirPlace) {
  const auto after = [](const std::string& what) {
    return errors_of(with_team("{}",
                               "{global_mission: {id: 3, tasks: [{id: 11, task: [perceive, base, "
                               "20]}, {id: 12, task: [perceive, base, 20], after: [" +
                                   what + "]}]}}"));
  };
  EXPECT_THAT(after("{task: 11, least: 60, most: 30}"),
              AllOf(HasSubstr("tasks[1].after[0].most"), HasSubstr("less than least")));
  EXPECT_THAT(after("{task: 11, least: -1}"), HasSubstr("after[0].least"));
  EXPECT_THAT(after("{task: 11, least: soon}"), HasSubstr("after[0].least"));
  EXPECT_THAT(after("{least: 5}"), HasSubstr("after[0]"));
  EXPECT_THAT(after("{task: 11, mots: 5}"), HasSubstr("mots"));
}

TEST(TeamScenario, ATaskSaysWhatEachOfItsMembersNeeds) {
  const auto with_needs = [](const std::string& needs) {
    return with_team("{}",
                     "{global_mission: {id: 3, tasks: [{id: 11, task: [perceive, base, 20], "
                     "needs: " +
                         needs + "}]}}");
  };
  const Scenario scenario = read_valid(with_needs("[hovering, {camera: ir}, 'payload >= 2.5']"));
  using interaction::Requirement;
  EXPECT_THAT(mission_of(scenario).mission.tasks[0].needs,
              ElementsAre(Requirement{"hovering", {}}, Requirement{"camera", "ir"},
                          Requirement{"payload",
                                      Requirement::Bound{interaction::Relation::kAtLeast, 2.5}}));
  EXPECT_THAT(errors_of(with_needs("['payload >= much']")),
              AllOf(HasSubstr("tasks[0].needs[0]"), HasSubstr("is no condition")));
}

TEST(TeamScenario, DegreeFiveIsForMembersOfATeam) {
  EXPECT_THAT(errors_of(planning_scenario_with("degree: 4", "degree: 5")),
              HasSubstr("it is in no team"));
  EXPECT_THAT(
      errors_of(planning_scenario_with("degree: 4", "degree: 5") + "team: {members: [heliv]}\n"),
      HasSubstr("it is in no team"));
  EXPECT_EQ(errors_of(planning_scenario_with("degree: 4", "degree: 5") + "team: {}\n"), "");
}

TEST(TeamScenario, AGlobalMissionWithoutATeamIsAnError) {
  EXPECT_THAT(errors_of(planning_scenario_with(kEnd, "do: [{global_mission: {id: 1, tasks: []}}]")),
              HasSubstr("the scenario has no team"));
}

TEST(TeamScenario, TasksGivenTwiceStrangersAndWhatIsNeverGivenAreErrors) {
  EXPECT_THAT(errors_of(with_team("{}",
                                  "{global_mission: {id: 1, tasks: [{id: 11, task: [land]}, "
                                  "{id: 11, task: [land]}]}}")),
              HasSubstr("task 11 is given to the team twice"));
  EXPECT_THAT(errors_of(with_team("{members: [krama]}", "{finish: true}")),
              HasSubstr("did you mean 'karma'"));
  EXPECT_THAT(errors_of(with_team("{}", "{declare_lost: {uav: krama}}")),
              HasSubstr("did you mean 'karma'"));
  EXPECT_THAT(
      errors_of(planning_scenario_with("when: {goal: {uav: karma, id: 701, state: achieved}}",
                                       "when: {global_mission: {id: 9, state: done}}") +
                "team: {}\n"),
      HasSubstr("global mission 9 is never given to the team"));
  EXPECT_THAT(errors_of(with_team("{patience: 0.5, beat: 1}", "{finish: true}")),
              HasSubstr("patience is less than two beats"));
}

// Found by missions of an outsider: reports of the one were taken for reports of the other.
TEST(TeamScenario, ATaskOfTheTeamAndAGoalOfAMemberAreNotOfOneNumber) {
  const auto team_task = [](int id) {
    return "{global_mission: {id: 1, tasks: [{id: " + std::to_string(id) + ", task: [land]}]}}";
  };
  const std::string goal = "{mission: {uav: karma, id: 9, tasks: [{id: 11, task: [land]}]}}";

  EXPECT_THAT(errors_of(with_team("{}", team_task(701))),
              HasSubstr("task 701 is a high-level task of karma already"));
  EXPECT_THAT(errors_of(with_team("{}", team_task(11) + ", " + goal)),
              HasSubstr("high-level task 11 is a task of the team, which karma may be sold"));
  EXPECT_EQ(errors_of(with_team("{members: [heliv]}", team_task(11) + ", " + goal)), "");
}

}  // namespace
}  // namespace skein::scenario
