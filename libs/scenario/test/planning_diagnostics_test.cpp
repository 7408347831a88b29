// SPDX-License-Identifier: Apache-2.0
// What is wrong with the parts of a file about planning on board, degrees, closed air, variations.
#include <gtest/gtest.h>

#include <ostream>

#include "testing/files.hpp"

namespace skein::scenario {
namespace {

using testing::errors_of;
using testing::planning_scenario_with;

struct Wrong {
  const char* name;
  std::string piece;    ///< of the valid file
  std::string instead;  ///< what stands there
  std::string says;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongPlanning : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongPlanning, IsToldWhatIsWrongWhereAndWhatWasMeant) {
  const Wrong& wrong = GetParam();

  EXPECT_EQ(errors_of(planning_scenario_with(wrong.piece, wrong.instead)), wrong.says);
}

std::string name_of_case(const ::testing::TestParamInfo<Wrong>& info) { return info.param.name; }

#define SKEIN_WRONG_PLANNING(group, ...) \
  INSTANTIATE_TEST_SUITE_P(group, WrongPlanning, ::testing::Values(__VA_ARGS__), name_of_case)

// In place of the end's action.
Wrong action(const char* name, const std::string& action, const std::string& says) {
  return {name, "do: [{finish: true}]", "do: [{" + action + "}]", says};
}
Wrong trigger(const char* name, const std::string& trigger, const std::string& says) {
  return {name, "when: {goal: {uav: karma, id: 701, state: achieved}}", "when: {" + trigger + "}",
          says};
}
Wrong goal(const char* name, const std::string& goal, const std::string& says) {
  return {name, "{id: 701, task: [perceive, base, 20]}", goal, says};
}

TEST(PlanningScenario, IsValidAsItIs) { EXPECT_EQ(errors_of(planning_scenario_with()), ""); }

SKEIN_WRONG_PLANNING(
    Planning,
    Wrong{"DomainThatIsNotThere", "../domains/comets.lisp", "models/none.lisp",
          "13:20: planning.domain: domain file 'models/none.lisp' cannot be read\n"},
    Wrong{"WithoutADomain", "domain: ../domains/comets.lisp, ", "",
          "13:11: planning.domain: missing\n"},
    Wrong{"UnknownKey", "first_ids", "first_id",
          "13:54: planning.first_id: unknown key 'first_id'; expected one of domain, altitude, "
          "voxel, ceiling, risk, horizon, first_ids, altitudes, consistency, partner_lease, takes; "
          "did you mean "
          "'first_ids'?\n"},
    Wrong{
        "FirstIdOfAStranger", "first_ids: {karma", "first_ids: {krama",
        "13:63: planning.first_ids.krama: no UAV 'krama'; expected a UAV; did you mean 'karma'?\n"},
    Wrong{"ConsistencyByNothing", "first_ids: {karma: 100}", "consistency: dip-x",
          "13:57: planning.consistency: 'dip-x'; expected one of dip-m, dip-l, dip-g, cip, none"
          "; did you mean 'dip-m'?\n"},
    Wrong{"PartnerLeaseOfLessThanAMinute", "first_ids: {karma: 100}", "partner_lease: 59",
          "13:59: planning.partner_lease: '59'; expected a number from 60 to 86400 s\n"},
    Wrong{"PlanningThatTakesAtLeastMoreThanAtMost", "first_ids: {karma: 100}", "takes: [3, 2]",
          "13:51: planning.takes: no figure is between these; expected [LEAST, MOST]\n"},
    Wrong{"FirstIdOfNothing", "{karma: 100}", "{karma: 0}",
          "13:63: planning.first_ids.karma: '0'; expected a whole number from 1 to 400000000\n"},
    Wrong{
        "AltitudeOfAStranger", "first_ids: {karma: 100}", "altitudes: {krama: 60}",
        "13:63: planning.altitudes.krama: no UAV 'krama'; expected a UAV; did you mean 'karma'?\n"},
    Wrong{"RiskOfMoreThanAll", "first_ids: {karma: 100}", "risk: 2",
          "13:50: planning.risk: '2'; expected a number from 0 to 1\n"},
    Wrong{"RiskWithoutPeaks", "first_ids: {karma: 100}", "risk: {base: 0.2}",
          "13:50: planning.risk.peaks: missing\n"},
    Wrong{"MissingForTheDegreeAndTheMission",
          "planning: {domain: ../domains/comets.lisp, first_ids: {karma: 100}}\n", "",
          "11:60: uavs.karma.degree: nothing is said of planning on board; expected planning: "
          "{domain: FILE}\n"
          "18:20: ground.script[0].do[0].mission: nothing is said of planning on board; expected "
          "planning: {domain: FILE}\n"},
    Wrong{"VolumeUpsideDown", "ceiling: 90", "ceiling: 90, floor: 100",
          "8:20: world.volumes.tower: the ceiling is not above the floor\n"},
    Wrong{"VolumeWithoutExtent", "[[300, 300], [400, 300], [400, 400]]", "[[300, 300]]",
          "8:30: world.volumes.tower.polygon: 1 corners enclose nothing: at least three; expected "
          "the corners [x, y] of a simple polygon in order\n"},
    Wrong{"VolumeWithAnUnknownKey", "ceiling: 90", "cieling: 90",
          "8:77: world.volumes.tower.cieling: unknown key 'cieling'; expected one of polygon, "
          "floor, ceiling, from, until; did you mean 'ceiling'?\n"},
    Wrong{"DegreeThatIsNone", "degree: 4", "degree: 6",
          "11:60: uavs.karma.degree: '6'; expected a whole number from 1 to 5\n"});

SKEIN_WRONG_PLANNING(
    Missions,
    goal("GoalTwice", "{id: 700, task: [general-land]}",
         "19:89: ground.script[0].do[0].mission.tasks[1].id: high-level task 700 is asked of karma "
         "twice; expected ids that are unique for the whole mission\n"
         "21:37: ground.script[1].when.goal.id: high-level task 701 is never sent to karma; "
         "expected one that the script sends\n"),
    goal("GoalZero", "{id: 0, task: [general-land]}",
         "19:89: ground.script[0].do[0].mission.tasks[1].id: 0 is no id; expected a whole number "
         "from 1\n"
         "21:37: ground.script[1].when.goal.id: high-level task 701 is never sent to karma; "
         "expected one that the script sends\n"),
    goal("GoalWithoutId", "{task: [general-land]}",
         "19:84: ground.script[0].do[0].mission.tasks[1].id: missing\n"
         "21:37: ground.script[1].when.goal.id: high-level task 701 is never sent to karma; "
         "expected one that the script sends\n"),
    goal("GoalWithoutTask", "{id: 701}",
         "19:84: ground.script[0].do[0].mission.tasks[1].task: missing\n"),
    goal("GoalOfAnEmptyTask", "{id: 701, task: []}",
         "19:100: ground.script[0].do[0].mission.tasks[1].task: no task; expected [NAME, "
         "ARGUMENT...]\n"),
    goal("UnknownKeyOfAGoal", "{id: 701, task: [general-land], start_befor: 3}",
         "19:129: ground.script[0].do[0].mission.tasks[1].start_befor: unknown key 'start_befor'; "
         "expected one of id, task, start_before, start_after, end_before, end_after, "
         "start_after_goal, end_after_goal; did you mean 'start_before'?\n"),
    goal(
        "ABoundWithoutFigures", "{id: 701, task: [general-land], end_after_goal: {goal: 700}}",
        "19:132: ground.script[0].do[0].mission.tasks[1].end_after_goal: no bound; expected least: "
        "seconds, most: seconds, or both\n"),
    goal("NumbersAmongNames", "{id: 701, task: [synchro, 551, [karma, 3], [heliv]]}",
         "19:123: ground.script[0].do[0].mission.tasks[1].task[2][1]: a number among names; "
         "expected names, or [x, y, z]\n"),
    goal("PointOfTwoNumbers", "{id: 701, task: [perceive, [1, 2], 20]}",
         "19:111: ground.script[0].do[0].mission.tasks[1].task[1]: this is not a point; expected "
         "[x, y, z] in metres\n"),
    goal("UnknownArgument", "{id: 701, task: [perceive, {near: 3}, 20]}",
         "19:118: ground.script[0].do[0].mission.tasks[1].task[1].near: unknown key 'near'; "
         "expected one of near_alarm\n"
         "19:111: ground.script[0].do[0].mission.tasks[1].task[1].near_alarm: missing\n"),
    goal("BoundThatIsNoInstant", "{id: 701, task: [general-land], end_before: -3}",
         "19:128: ground.script[0].do[0].mission.tasks[1].end_before: '-3'; expected a number from "
         "0 to 1e+07 s\n"),
    Wrong{"UnknownUav", "mission: {uav: karma, id: 1", "mission: {uav: kamra, id: 1",
          "19:26: ground.script[0].do[0].mission.uav: unknown name 'kamra'; expected a UAV; did "
          "you mean 'karma'?\n"
          "21:37: ground.script[1].when.goal.id: high-level task 701 is never sent to karma; "
          "expected one that the script sends\n"},
    Wrong{"UnknownPlacement", "id: 1, tasks", "id: 1, placement: frist, tasks",
          "19:51: ground.script[0].do[0].mission.placement: 'frist'; expected one of best, last, "
          "in-time, tour, first; did you mean 'first'?\n"},
    Wrong{"InterruptWithoutBeingFirst", "id: 1, tasks", "id: 1, interrupt: true, tasks",
          "19:51: ground.script[0].do[0].mission.interrupt: only what comes first interrupts what "
          "is under way; expected placement: first\n"},
    action("MissionTwice", "mission: {uav: karma, id: 1, tasks: [{id: 9, task: [general-land]}]}",
           "22:39: ground.script[1].do[0].mission.id: mission 1 is sent to karma twice; expected "
           "ids that are unique for the whole mission\n"),
    action("CancelOfNothing", "cancel: {uav: karma}",
           "22:21: ground.script[1].do[0].cancel: nothing to cancel; expected goals: [ID...], "
           "goals: all or mission: ID\n"),
    action(
        "CancelOfAnEmptyList", "cancel: {uav: karma, goals: []}",
        "22:41: ground.script[1].do[0].cancel.goals: nothing to cancel; expected [ID...] or all\n"),
    action("CancelOfTwoThings", "cancel: {uav: karma, goals: all, mission: 1}",
           "22:55: ground.script[1].do[0].cancel.mission: 'mission' beside 'goals'; expected one "
           "of the two\n"),
    action("CancelOfAnUnknownGoal", "cancel: {uav: karma, goals: [704]}",
           "22:42: ground.script[1].do[0].cancel.goals[0]: high-level task 704 is never sent to "
           "karma; expected one that the script sends\n"),
    action("CancelOfAnUnknownMission", "cancel: {uav: karma, mission: 2}",
           "22:43: ground.script[1].do[0].cancel.mission: mission 2 is never sent to karma; "
           "expected one that the script sends\n"),
    action("CancelOfSome", "cancel: {uav: karma, goals: some}",
           "22:41: ground.script[1].do[0].cancel.goals: 'some'; expected one of all\n"));

SKEIN_WRONG_PLANNING(
    Degrees,
    action("DegreeOutOfRange", "degree: {uav: karma, to: 6}",
           "22:38: ground.script[1].do[0].degree.to: '6'; expected a whole number from 1 to 5\n"),
    action("DegreeWithoutOne", "degree: {uav: karma}",
           "22:21: ground.script[1].do[0].degree.to: missing\n"),
    action("TakenInHandByWhom", "take_in_hand: {uav: karm}",
           "22:33: ground.script[1].do[0].take_in_hand.uav: unknown name 'karm'; expected a UAV; "
           "did you mean 'karma'?\n"),
    action("GivenBackToo", "give_back: {uav: karma, interrupt: true}",
           "22:48: ground.script[1].do[0].give_back.interrupt: unknown key 'interrupt'; expected "
           "one of uav\n"),
    action("ResumedWithoutAName", "resume_plan: {uav: karma, without: [x]}",
           "22:49: ground.script[1].do[0].resume_plan.without[0]: 'x'; expected a whole number, "
           "not negative\n"),
    action("DroppedUnknown", "drop_plan: {}",
           "22:24: ground.script[1].do[0].drop_plan.uav: missing\n"),
    action("ClosedWithoutName", "close_air: {polygon: [[0, 0], [9, 0], [9, 9]]}",
           "22:24: ground.script[1].do[0].close_air.name: missing\n"),
    action("ClosedForAStranger",
           "close_air: {name: n, polygon: [[0, 0], [9, 0], [9, 9]], uavs: [krma]}",
           "22:76: ground.script[1].do[0].close_air.uavs[0]: unknown name 'krma'; expected a UAV; "
           "did you mean 'karma'?\n"),
    action("GroundOfWhichNothingIsSaid",
           "know_ground: {name: A, polygon: [[0, 0], [9, 0], [9, 9]]}",
           "22:26: ground.script[1].do[0].know_ground: nothing is said of the ground: risk, mapped "
           "or cells; expected risk, …\n"),
    action("OpenedThoughNeverClosed", "open_air: {name: towr}",
           "22:30: ground.script[1].do[0].open_air.name: unknown name 'towr'; expected a volume of "
           "closed air; did you mean 'tower'?\n"),
    trigger("GoalOfNoMission", "goal: {uav: karma, id: 9, state: achieved}",
            "21:37: ground.script[1].when.goal.id: high-level task 9 is never sent to karma; "
            "expected one that the script sends\n"),
    trigger("GoalOfAnotherUav", "goal: {uav: heliv, id: 701, state: achieved}",
            "21:37: ground.script[1].when.goal.id: high-level task 701 is never sent to heliv; "
            "expected one that the script sends\n"),
    trigger(
        "GoalStateMisspelt", "goal: {uav: karma, id: 701, state: acheived}",
        "21:49: ground.script[1].when.goal.state: 'acheived'; expected one of received, planned, "
        "under-way, achieved, failed, cancelled, handed-over; did you mean 'achieved'?\n"),
    trigger("MissionStateOfAGoal", "mission: {uav: karma, id: 1, state: received}",
            "21:50: ground.script[1].when.mission.state: 'received'; expected one of planned, "
            "refused, achieved, failed, evaluated; did you mean 'refused'?\n"),
    trigger("MissionNeverSent", "mission: {uav: karma, id: 7, state: failed}",
            "21:40: ground.script[1].when.mission.id: mission 7 is never sent to karma; expected "
            "one that the script sends\n"),
    trigger("DegreeThatIsNone", "degree: {uav: karma, is: 0}",
            "21:39: ground.script[1].when.degree.is: '0'; expected a whole number from 1 to 5\n"));

SKEIN_WRONG_PLANNING(
    Faults,
    Wrong{"SlowerByLess",
          "expect:", "faults: [{at: 1, slow: {uav: karma, factor: 0.5, for: 9}}]\nexpect:",
          "23:45: faults[0].slow.factor: '0.5'; expected a number from 1 to 100 times slower\n"},
    Wrong{"SlowForHowLong", "expect:", "faults: [{at: 1, slow: {uav: karma, factor: 2}}]\nexpect:",
          "23:24: faults[0].slow.for: missing\n"},
    Wrong{"AbortOfAnUnknownType",
          "expect:", "faults: [{at: 1, abort: {uav: karma, type: gote}}]\nexpect:",
          "23:44: faults[0].abort.type: unknown name 'gote'; expected a type of tasks; did you "
          "mean 'goto'?\n"},
    Wrong{"EnergyOfMoreThanAll",
          "expect:", "faults: [{at: 1, energy: {uav: karma, left: 2}}]\nexpect:",
          "23:45: faults[0].energy.left: '2'; expected a number from 0 to 1\n"},
    Wrong{"EnergyWhen", "expect:", "faults: [{energy: {uav: karma, left: 0.2}}]\nexpect:",
          "23:10: faults[0].at: missing\n"});

SKEIN_WRONG_PLANNING(
    Variations,
    Wrong{"RangeInsideOut", "expect:", "variations: {wind_speed: [4, 0]}\nexpect:",
          "23:26: variations.wind_speed: no figure is between these; expected [LEAST, MOST]\n"},
    Wrong{"RangeOfOne", "expect:", "variations: {latency: [4]}\nexpect:",
          "23:23: variations.latency: a list; expected a list of 2 numbers\n"},
    Wrong{"OutOfRange", "expect:", "variations: {loss: [0, 1]}\nexpect:",
          "23:24: variations.loss[1]: '1'; expected a number from 0 to 0.99\n"},
    Wrong{"Misspelt", "expect:", "variations: {wind_sped: [0, 1]}\nexpect:",
          "23:25: variations.wind_sped: unknown key 'wind_sped'; expected one of wind_speed, "
          "wind_toward, speed_factor, latency, loss, start_delay; did you mean 'wind_speed'?\n"});

TEST(WrongPlanning, MeasuringTimeInClosedAirNeedsClosedAir) {
  std::string text = planning_scenario_with(
      "  volumes: {tower: {polygon: [[300, 300], [400, 300], [400, 400]], ceiling: 90}}\n", "");
  text += "  - {name: keeps out, measure: time-in-volume, at_most: 0}\n";

  EXPECT_EQ(errors_of(text),
            "24:32: expect[1].measure: no air is closed; expected world.volumes, or close_air in "
            "the script\n");
}

}  // namespace
}  // namespace skein::scenario
