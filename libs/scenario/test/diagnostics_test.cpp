// SPDX-License-Identifier: Apache-2.0
// What a wrong file is told: golden diagnostics, one change of a valid file each.
#include <gtest/gtest.h>

#include <ostream>

#include "testing/files.hpp"

namespace skein::scenario {
namespace {

using testing::errors_of;
using testing::scenario_with;
using testing::TemporaryFolder;

struct Wrong {
  const char* name;
  std::string piece;    ///< of the valid file
  std::string instead;  ///< what stands there
  std::string says;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongFile : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongFile, IsToldWhatIsWrongWhereAndWhatWasMeant) {
  const Wrong& wrong = GetParam();

  EXPECT_EQ(errors_of(scenario_with(wrong.piece, wrong.instead)), wrong.says);
}

const std::string kTask = "{id: 1, type: takeoff, params: {altitude: 40}}";
const std::string kExpectation =
    "{name: flies, event: {kind: task, uav: marvin, task: 1, state: ended}}";
const std::string kFault = "{at: 100, kill: heliv, restart_after: 5}";
const std::string kCut = "{between: [heliv, ground], from: 30, until: 40}";

std::string name_of_case(const ::testing::TestParamInfo<Wrong>& info) { return info.param.name; }

#define SKEIN_WRONG_FILES(group, ...) \
  INSTANTIATE_TEST_SUITE_P(group, WrongFile, ::testing::Values(__VA_ARGS__), name_of_case)

SKEIN_WRONG_FILES(
    Top,
    Wrong{"UnknownKey", "duration_limit: 600", "duration_limit: 600\nsede: 4",
          "4:7: sede: unknown key 'sede'; expected one of scenario, epoch, duration_limit, rate, "
          "seed, world, uavs, radio, slots, ground, planning, interaction, …; did you mean "
          "'seed'?\n"},
    Wrong{"MissingKey", "duration_limit: 600\n", "", "1:1: duration_limit: missing\n"},
    Wrong{"WrongType", "duration_limit: 600", "duration_limit: soon",
          "3:17: duration_limit: 'soon'; expected a number from 0 to 1e+07 s\n"},
    Wrong{"EpochThatIsNone", "2005-05-19T09:00:00Z", "yesterday",
          "2:8: epoch: 'yesterday'; expected an instant in UTC such as 2005-05-19T09:00:00Z\n"},
    Wrong{"EpochOfNoCalendar", "2005-05-19T09:00:00Z", "2005-02-30T09:00:00Z",
          "2:8: epoch: '2005-02-30T09:00:00Z'; expected an instant in UTC such as "
          "2005-05-19T09:00:00Z\n"},
    Wrong{"RateOutOfRange", "duration_limit: 600", "duration_limit: 600\nrate: 0",
          "4:7: rate: '0'; expected a number from 0.01 to 1000 mission seconds per second\n"},
    Wrong{"NegativeSeed", "duration_limit: 600", "duration_limit: 600\nseed: -1",
          "4:7: seed: '-1'; expected a whole number, not negative\n"},
    Wrong{"KeyTwice", "duration_limit: 600", "duration_limit: 600\nduration_limit: 700",
          "4:1: duration_limit: key 'duration_limit' given twice\n"});

SKEIN_WRONG_FILES(
    World,
    Wrong{"NotAMap", "  origin: {latitude: 40.1, longitude: -8.2, altitude: 200}",
          "  origin: Lousa", "5:11: world.origin: 'Lousa' where a map was expected\n"},
    Wrong{"LatitudeOutOfRange", "latitude: 40.1", "latitude: 140.1",
          "5:22: world.origin.latitude: '140.1'; expected a number from -90 to 90 degrees\n"},
    Wrong{"TerrainInsideOut", "east: 500", "east: -600",
          "6:12: world.terrain: terrain: east must be greater than west\n"},
    Wrong{"TerrainTooFine", "cell: 20", "cell: 0.1",
          "6:12: world.terrain: terrain: more than 4 million cells; use a larger cell\n"},
    Wrong{"ZoneWithoutArea", "[[0, 0], [200, 0], [200, 100]]", "[[0, 0], [200, 0]]",
          "8:8: world.zones.Z: 2 corners enclose nothing: at least three; expected the corners [x, "
          "y] "
          "of a simple polygon in order\n"},
    Wrong{"ZoneThatCrossesItself", "[[0, 0], [200, 0], [200, 100]]",
          "[[0, 0], [200, 0], [0, 100], [200, 100]]",
          "8:8: world.zones.Z: the edges after corner 2 and corner 4 cross or touch; expected the "
          "corners [x, y] of a simple polygon in order\n"},
    Wrong{"PlaceOfOneNumber", "base: [0, 0, 0]", "base: [0]",
          "9:18: world.places.base: this is not a point; expected [x, y, z] in metres\n"},
    Wrong{"PlaceWithoutName", "aside: [50", "'': [50", "9:33: world.places.: an empty name\n"},
    Wrong{"PlaceThatIsEverybodysHome", "aside: [50", "Home: [50",
          "9:35: world.places.Home: 'Home' is each UAV's own home; expected another name for the "
          "place\n"},
    Wrong{"PlaceOfNothing", "base: [0, 0, 0]", "base:",
          "9:17: world.places.base: nothing is said of 'base'\n"
          "26:61: ground.script[0].do[0].plan.tasks[1].params.to: unknown name 'base'; expected a "
          "place or [x, y, z]\n"},
    Wrong{"ObjectWithoutKind", "{kind: fire, position", "{position",
          "11:11: world.objects.fire.kind: missing\n"},
    Wrong{"FireThatSpreadsBackwards", "radius: 5}", "radius: 5, spread: {rate: -1}}",
          "11:71: world.objects.fire.spread.rate: '-1'; expected a number from 0.0001 to 10 m/s\n"},
    Wrong{"FireThatSpreadsAndGoes", "radius: 5}", "radius: 5, speed: 2, spread: {rate: 0.1}}",
          "11:63: world.objects.fire.speed: what spreads does not go along a way; expected no "
          "speed\n"});

SKEIN_WRONG_FILES(
    Uavs,
    Wrong{"DegreeOutOfRange", "degree: 2", "degree: 7",
          "14:61: uavs.heliv.degree: '7'; expected a whole number from 1 to 5\n"},
    Wrong{"ModelThatIsNotThere", "models/marvin.yaml", "models/marvn.yaml",
          "13:19: uavs.marvin.model: model file 'models/marvn.yaml' cannot be read\n"},
    Wrong{"ModelThatIsAFolder", "models/marvin.yaml", "models",
          "13:19: uavs.marvin.model: model file 'models' cannot be read\n"},
    Wrong{"NameOfAnotherNode", "  heliv: {model", "  sim: {model",
          "14:8: uavs.sim: 'sim' cannot be a UAV's name; expected 1 to 32 letters, digits, '-' or "
          "'_', and none of ground, sim, runner\n"
          "16:21: radio.cuts[0].between[0]: unknown name 'heliv'; expected a UAV or ground\n"
          "32:21: faults[0].kill: unknown name 'heliv'; expected a UAV, ground or sim\n"},
    Wrong{"PolicyMisspelt", "degree: 2", "contact_loss: {policy: hodl}",
          "14:76: uavs.heliv.contact_loss.policy: 'hodl'; expected one of continue, hold, return; "
          "did you mean 'hold'?\n"},
    Wrong{"UavOfNothing", "  heliv: {model: models/heliv.yaml, start: [10, 0], degree: 2}",
          "  heliv:",
          "15:1: uavs.heliv: nothing is said of 'heliv'\n"
          "16:21: radio.cuts[0].between[0]: unknown name 'heliv'; expected a UAV or ground\n"
          "32:21: faults[0].kill: unknown name 'heliv'; expected a UAV, ground or sim\n"});

SKEIN_WRONG_FILES(
    Radio,
    Wrong{"UnknownNode", "[heliv, ground]", "[helif, ground]",
          "16:21: radio.cuts[0].between[0]: unknown name 'helif'; expected a UAV or ground; did "
          "you mean 'heliv'?\n"},
    Wrong{"CutOfANodeFromItself", "[heliv, ground]", "[heliv, heliv]",
          "16:10: radio.cuts[0]: a cut between a node and itself\n"},
    Wrong{"CutOfThree", "[heliv, ground]", "[heliv, marvin, ground]",
          "16:10: radio.cuts[0]: a cut is between two nodes; expected between: [NODE, NODE]\n"},
    Wrong{"CutOfSidesThatHaveOneInCommon", "[heliv, ground]", "[[heliv, ground], ground]",
          "16:10: radio.cuts[0]: a cut between a node and itself\n"},
    Wrong{"FlappingOfHalf", "until: 40", "until: 40, down: 1",
          "16:10: radio.cuts[0].up: missing\n"},
    Wrong{"FlappingTooOften", "until: 40", "until: 1e6, down: 0.05, up: 0.05",
          "16:10: radio.cuts[0]: a cut that comes too often; expected at most 100,000 times\n"},
    Wrong{"CutThatEndsFirst", "until: 40", "until: 20",
          "16:10: radio.cuts[0]: a cut that ends before it begins\n"},
    Wrong{"CutOfNothing", kCut, "~", "16:10: radio.cuts[0]: nothing in a list\n"},
    Wrong{"LossOfEverything", "  cuts:", "  loss: 1\n  cuts:",
          "16:9: radio.loss: '1'; expected a number from 0 to 0.99\n"},
    Wrong{"RangeBesideABudget", "  cuts:", "  range: 900\n  power: 20\n  sensitivity: -90\n  cuts:",
          "16:10: radio.range: a range beside a link budget, from which it follows; expected one "
          "of the two\n"},
    Wrong{"BudgetWithoutPower", "  cuts:", "  sensitivity: -90\n  cuts:",
          "16:16: radio.sensitivity: sensitivity without power; expected the emission power in "
          "dBm\n"},
    Wrong{"UnknownKeyOfTheRadio", "  cuts:", "  rage: 900\n  cuts:",
          "16:9: radio.rage: unknown key 'rage'; expected one of range, power, sensitivity, "
          "reference_loss, exponent, line_of_sight, latency, loss, capacity, hysteresis, cuts, "
          "links, …; did you mean 'range'?\n"},
    Wrong{"CutOneWayAndBoth", "between: [heliv, ground]",
          "between: [heliv, ground], one_way: [heliv, ground]",
          "16:20: radio.cuts[0].between: a cut has between beside one_way; expected one of the "
          "two\n"},
    Wrong{"LinkOfAStranger", "  cuts:", "  links: [{one_way: [karma, ground], loss: 0.5}]\n  cuts:",
          "16:22: radio.links[0].one_way[0]: unknown name 'karma'; expected a UAV or ground\n"},
    Wrong{"LinkOfNoCapacity",
          "  cuts:", "  links: [{between: [marvin, ground], capacity: 0}]\n  cuts:",
          "16:49: radio.links[0].capacity: '0'; expected a number from 1 to 1e+12 bit/s\n"},
    Wrong{"HeartbeatTooFast", "  cuts:", "  heartbeat: 0.01\n  cuts:",
          "16:14: radio.heartbeat: '0.01'; expected a number from 0.05 to 60 s\n"});

SKEIN_WRONG_FILES(
    Faults,
    Wrong{"OfNoKind", kFault, "{at: 100}",
          "32:5: faults[0]: a fault of no kind; expected one of kill, engine, sensor, slow, abort, "
          "energy, random\n"},
    Wrong{"OfTwoKinds", kFault, "{at: 100, kill: heliv, engine: marvin}",
          "32:36: faults[0].engine: 'engine' beside 'kill'; expected one of the two\n"},
    Wrong{"OfAStranger", kFault, "{at: 100, engine: karma}",
          "32:23: faults[0].engine: unknown name 'karma'; expected a UAV\n"},
    Wrong{"UnknownKind", kFault, "{at: 100, kil: heliv}",
          "32:20: faults[0].kil: unknown key 'kil'; expected one of at, kill, restart_after, "
          "forgets, "
          "engine, sensor, slow, abort, energy, random; did you mean 'kill'?\n"
          "32:5: faults[0]: a fault of no kind; expected one of kill, engine, sensor, slow, abort, "
          "energy, random\n"});

SKEIN_WRONG_FILES(
    Tasks,
    Wrong{"UnknownUav", "uav: marvin\n            tasks", "uav: mravin\n            tasks",
          "23:18: ground.script[0].do[0].plan.uav: unknown name 'mravin'; expected a UAV; did you "
          "mean 'marvin'?\n"},
    Wrong{"UnknownType", kTask, "{id: 1, type: takeof}",
          "25:31: ground.script[0].do[0].plan.tasks[0].type: unknown name 'takeof'; expected a "
          "task type; did you mean 'takeoff'?\n"},
    Wrong{"JointType", kTask, "{id: 1, type: joint:watch}",
          "25:31: ground.script[0].do[0].plan.tasks[0].type: joint tasks need a deliberative "
          "layer, degree 4 or 5\n"},
    Wrong{"UnknownMode", kTask, "{id: 1, type: land, mode: VTU}",
          "25:43: ground.script[0].do[0].plan.tasks[0].mode: 'VTU'; expected one of SEQ, VUT, DEP, "
          "NUT; did you mean 'VUT'?\n"},
    Wrong{"UnknownPlace", "to: base", "to: bsae",
          "26:61: ground.script[0].do[0].plan.tasks[1].params.to: unknown name 'bsae'; expected a "
          "place or [x, y, z]; did you mean 'base'?\n"},
    Wrong{"UnknownZone", kTask,
          "{id: 1, type: goto, params: {over: {zone: X, spacing: 10, altitude: 30}}}",
          "25:59: ground.script[0].do[0].plan.tasks[0].params.over.zone: unknown name 'X'; "
          "expected a zone; did you mean 'Z'?\n"},
    Wrong{"UnknownDevice", "device: visible", "device: visibel",
          "27:92: ground.script[0].do[0].plan.tasks[2].params.device: unknown name 'visibel'; "
          "expected a device of marvin; did you mean 'visible'?\n"},
    Wrong{"IdTwice", "{id: 2,", "{id: 1,",
          "26:22: ground.script[0].do[0].plan.tasks[1].id: task 1 of marvin is planned twice; "
          "expected ids that are unique for the whole mission\n"},
    Wrong{"IdTooLarge", kTask, "{id: 9000000000000000, type: land}",
          "25:22: ground.script[0].do[0].plan.tasks[0].id: too large for a task id\n"},
    Wrong{"TwoTargets", "to: base,",
          "to: base, near_alarm: {bearing: 0, distance: 1, altitude: 1},",
          "26:56: ground.script[0].do[0].plan.tasks[1].params: more than one of to, near_alarm, "
          "over\n"},
    Wrong{"SynchroniseWithoutParameters", kTask, "{id: 1, type: synchronise}",
          "25:17: ground.script[0].do[0].plan.tasks[0].params: missing\n"},
    Wrong{"SynchroniseWithAStranger", kTask,
          "{id: 1, type: synchronise, params: {id: 5, senders: [marvin], receivers: [karma]}}",
          "25:91: ground.script[0].do[0].plan.tasks[0].params.receivers[0]: unknown name 'karma'; "
          "expected a UAV\n"},
    Wrong{"ConditionMisspelt", "{task: 2, state: ended}", "{tsk: 2, state: ended}",
          "27:54: ground.script[0].do[0].plan.tasks[2].pre[0][0].tsk: unknown key 'tsk'; expected "
          "one of task, message, time, state, is, not, modality; did you mean 'task'?\n"
          "27:48: ground.script[0].do[0].plan.tasks[2].pre[0][0]: a condition of no kind; expected "
          "one of task, message, time\n"},
    Wrong{"ConditionOfNoKind", "{task: 2, state: ended}", "{state: ended}",
          "27:48: ground.script[0].do[0].plan.tasks[2].pre[0][0]: a condition of no kind; expected "
          "one of task, message, time\n"},
    Wrong{"ConditionOfTwoKinds", "{task: 2, state: ended}", "{task: 2, state: ended, message: go}",
          "27:81: ground.script[0].do[0].plan.tasks[2].pre[0][0].message: unknown key 'message'; "
          "expected one of task, state, not, modality; did you mean 'state'?\n"},
    Wrong{"StateMisspelt", "{task: 2, state: ended}", "{task: 2, state: endet}",
          "27:65: ground.script[0].do[0].plan.tasks[2].pre[0][0].state: 'endet'; expected one of "
          "scheduled, started, running, aborting, ended, aborted; did you mean 'ended'?\n"},
    Wrong{"ConditionsThatAreNoFormula", "[[{task: 2, state: ended}]]", "{task: 2, state: ended}",
          "27:46: ground.script[0].do[0].plan.tasks[2].pre: a map where a list was expected\n"});

SKEIN_WRONG_FILES(
    Script,
    Wrong{"UnknownStep", "when: {time: 5}", "when: {step: edn}",
          "20:20: ground.script[0].when.step: unknown name 'edn'; expected a step; "
          "did you mean 'end'?\n"},
    Wrong{"ExpiredStepThatIsUnknown", "when: {time: 5}", "when: {expired: edn}",
          "20:23: ground.script[0].when.expired: unknown name 'edn'; expected a step; "
          "did you mean 'end'?\n"},
    Wrong{"ExpiredBesideStep", "when: {time: 5}", "when: {step: end, expired: end}",
          "20:13: ground.script[0].when: a trigger is one thing; expected all: [...] "
          "or any: [...] for several\n"},
    Wrong{"ExpiredOfNothing", "when: {time: 5}", "when: {expired: }",
          "20:23: ground.script[0].when.expired: nothing is said of 'expired'\n"},
    Wrong{"SilentUnknownUav", "when: {time: 5}", "when: {silent: {uav: nobody, for: 60}}",
          "20:28: ground.script[0].when.silent.uav: unknown name 'nobody'; expected a UAV\n"},
    Wrong{
        "SilentForNoTime", "when: {time: 5}", "when: {silent: {uav: marvin, for: 0}}",
        "20:41: ground.script[0].when.silent.for: '0'; expected a number from 0.001 to 1e+07 s\n"},
    Wrong{"SilentHowLong", "when: {time: 5}", "when: {silent: {uav: marvin}}",
          "20:22: ground.script[0].when.silent.for: missing\n"},
    Wrong{"StepTwice", "step: end", "step: start", "18:3: ground: two steps are named 'start'\n"},
    Wrong{"StepWithoutName", "    - step: end\n      when", "    - when",
          "28:7: ground.script[1].step: missing\n"},
    Wrong{"StepWithoutTrigger", "      when: {time: 5}\n", "",
          "19:7: ground.script[0].when: missing\n"},
    Wrong{"TriggerOfTwoThings", "when: {time: 5}", "when: {time: 5, alarm: raised}",
          "20:13: ground.script[0].when: a trigger is one thing; expected all: [...] "
          "or any: [...] for several\n"},
    Wrong{"TriggerOfNothing", "when: {time: 5}", "when: {alarm: }",
          "20:21: ground.script[0].when.alarm: nothing is said of 'alarm'\n"},
    Wrong{"TriggerMisspelt", "when: {time: 5}", "when: {alarm: rased}",
          "20:21: ground.script[0].when.alarm: 'rased'; expected one of raised, "
          "confirmed, infirmed; did you mean 'raised'?\n"},
    Wrong{"OneOfNothing", "when: {time: 5}", "when: {any: []}",
          "18:3: ground: step 'start' waits for one of nothing\n"},
    Wrong{"ActionOfNoKind", "do: [{finish: true}]", "do: [{finish: false}]",
          "30:12: ground.script[1].do[0]: an action of no kind; expected one of "
          "plan, abort, message, update, mission, cancel, play, degree, take_in_hand, "
          "give_back, resume_plan, drop_plan, close_air, open_air, know_place, "
          "know_ground, global_mission, declare_lost, declare_found, finish: true\n"},
    Wrong{"ActionOfTwoKinds", "do: [{finish: true}]",
          "do: [{finish: true, message: {uav: heliv, text: go}}]",
          "30:21: ground.script[1].do[0].finish: 'finish' beside 'message'; expected "
          "one of the two\n"},
    Wrong{"ActionOfNothing", "do: [{finish: true}]", "do: [~]",
          "30:12: ground.script[1].do[0]: nothing in a list\n"},
    Wrong{"AbortOfSome", "do: [{finish: true}]", "do: [{abort: {uav: heliv, tasks: some}}]",
          "30:40: ground.script[1].do[0].abort.tasks: 'some'; expected one of all\n"},
    Wrong{"BeliefOutOfRange", "ground:\n", "ground:\n  pps: {confirm: 2}\n",
          "18:18: ground.pps.confirm: '2'; expected a number from 0 to 1\n"},
    Wrong{"ObjectFollowedFromNowhere", "ground:\n", "ground:\n  objects: {front: {kind: fire}}\n",
          "18:20: ground.objects.front: where it is at first is not said; expected a place of the "
          "world of this name\n"},
    Wrong{"CommandsThatExpireAtOnce", "ground:\n", "ground:\n  command_lifetime: 0\n",
          "18:3: ground: the lifetime of commands must be positive\n"});

SKEIN_WRONG_FILES(
    Expectations,
    Wrong{"OfNoKind", kExpectation, "{name: flies}",
          "34:5: expect[0]: an expectation of no kind; expected one of event, never, finally, "
          "measure\n"},
    Wrong{"Misspelt", "{name: flies, event", "{name: flies, evnt",
          "34:25: expect[0].evnt: unknown key 'evnt'; expected one of name, event, never, finally, "
          "measure; did you mean 'event'?\n"
          "34:5: expect[0]: an expectation of no kind; expected one of event, never, finally, "
          "measure\n"},
    Wrong{"WithoutName", "{name: flies, event", "{event", "34:5: expect[0].name: missing\n"},
    Wrong{"UnknownKindOfRecord", "kind: task, uav", "kind: taks, uav",
          "34:33: expect[0].event.kind: unknown name 'taks'; expected a kind of record "
          "(docs/journal.md); did you mean 'task'?\n"},
    Wrong{"UnknownKindInAList", "kind: task, uav", "kind: [task, alram], uav",
          "34:40: expect[0].event.kind[1]: unknown name 'alram'; expected a kind of record "
          "(docs/journal.md); did you mean 'alarm'?\n"},
    Wrong{"UnknownUav", "uav: marvin, task: 1", "uav: [marvin, karma], task: 1",
          "34:53: expect[0].event.uav[1]: unknown name 'karma'; expected a UAV\n"},
    Wrong{"FieldThatNoRecordOfThatKindHas", "uav: marvin, task: 1", "uav: marvin, tsak: 1",
          "34:58: expect[0].event.tsak: no record of this kind has a field 'tsak'; expected a "
          "field of docs/journal.md; did you mean 'task'?\n"},
    Wrong{"FieldOfNoneOfSeveralKinds", "kind: task, uav", "kind: [task, alarm], vua: 1, uav",
          "34:53: expect[0].event.vua: no record of this kind has a field 'vua'; expected a field "
          "of docs/journal.md; did you mean 'uav'?\n"},
    Wrong{"WordThatNoRecordOfThatKindSays", "task: 1, state: ended",
          "task: 1, state: [aborted, rejected]",
          "34:78: expect[0].event.state[1]: unknown name 'rejected'; expected one of scheduled, "
          "started, running, aborting, ended, aborted\n"},
    Wrong{"WordMisspelt", "task: 1, state: ended", "task: 1, state: endet",
          "34:68: expect[0].event.state: unknown name 'endet'; expected one of scheduled, started, "
          "running, aborting, ended, aborted; did you mean 'ended'?\n"},
    Wrong{"FieldOfWhatItIsFinally", kExpectation,
          "{name: down, finally: {kind: telemetry, uav: marvin}, is: {airborn: false}}",
          "34:73: expect[0].is.airborn: no record of this kind has a field 'airborn'; expected a "
          "field of docs/journal.md; did you mean 'airborne'?\n"},
    Wrong{"EmptyPattern", kExpectation, "{name: flies, never: {}}",
          "34:26: expect[0].never: an empty pattern matches anything\n"},
    Wrong{"WithinOfNothing", "{name: flies,", "{name: flies, within: 5,",
          "34:27: expect[0].within: 'within' counts from 'after', which is missing\n"},
    Wrong{"WindowThatEndsFirst", "{name: flies,", "{name: flies, from: 9, until: 5,",
          "34:5: expect[0]: a window that ends before it begins\n"},
    Wrong{"CountOfNoNumber", "{name: flies,", "{name: flies, count: {at_least: 3, at_most: 1},",
          "34:26: expect[0].count: no count is within these bounds\n"},
    Wrong{"KeyOfAnotherKind", kExpectation, "{name: flies, never: {kind: alarm}, count: 3}",
          "34:48: expect[0].count: unknown key 'count'; expected one of name, never, from, until, "
          "after, before, within\n"},
    Wrong{"UnknownMeasure", kExpectation, "{name: flies, measure: separation, at_least: 3}",
          "34:28: expect[0].measure: 'separation'; expected one of minimum-separation, "
          "distance-flown, mission-duration, energy-left, time-in-volume\n"},
    Wrong{"MeasureWithoutBounds", kExpectation, "{name: flies, measure: energy-left}",
          "34:5: expect[0]: a measure without bounds; expected at_least, at_most\n"},
    Wrong{"BoundsOfNoFigure", kExpectation,
          "{name: flies, measure: energy-left, at_least: 0.5, at_most: 0.4}",
          "34:5: expect[0]: no figure is within these bounds\n"});

SKEIN_WRONG_FILES(
    Extent,
    Wrong{"StartOutsideTheTerrain", "start: [10, 0]", "start: [9000, 0]",
          "14:44: uavs.heliv.start: outside the terrain; expected -500 to 500 m east and -500 to "
          "500 m north of the origin\n"},
    Wrong{"StartOnItsBorder", "start: [10, 0]", "start: [500, -500]", ""},
    Wrong{
        "ObjectOutsideTheTerrain", "position: [100, 50]", "position: [100, -501]",
        "11:34: world.objects.fire.position: outside the terrain; expected -500 to 500 m east and "
        "-500 to 500 m north of the origin\n"});

TEST(DoubtfulFiles, AKindThatNoObjectHasIsWarnedOfWithTheNearest) {
  const auto warnings_of = [](const std::string& piece, const std::string& instead) {
    return to_text(testing::read_valid(scenario_with(piece, instead)).warnings);
  };

  const std::string warnings = warnings_of("kind: fire", "kind: fier");

  EXPECT_NE(
      warnings.find("small.yaml:13:19: uavs.marvin.model: 'fire-sensor' sees 'fire', of which "
                    "kind no object is, and none of 'fier'; did you mean 'fier'?"),
      std::string::npos)
      << warnings;
  EXPECT_EQ(warnings_of("kind: fire", "kind: fire"), "");
  EXPECT_EQ(warnings_of("kind: fire", "kind: sheep"), "") << "of another mission";
}

TEST(WrongFiles, AllErrorsOfAFileAreToldAtOnce) {
  std::string text = scenario_with("degree: 2", "degree: 7");
  const auto put = [&](const std::string& piece, const std::string& instead) {
    text.replace(text.find(piece), piece.size(), instead);
  };
  put("to: base", "to: bsae");
  put("[heliv, ground]", "[heliv, heliv]");
  put("kill: heliv", "kill: helif");
  put("kind: task, uav", "kind: taks, uav");
  put("duration_limit", "duration_limt");

  EXPECT_EQ(
      errors_of(text),
      "3:16: duration_limt: unknown key 'duration_limt'; expected one of scenario, epoch, "
      "duration_limit, rate, seed, world, uavs, radio, slots, ground, planning, interaction, "
      "…; did you mean 'duration_limit'?\n"
      "1:1: duration_limit: missing\n"
      "14:61: uavs.heliv.degree: '7'; expected a whole number from 1 to 5\n"
      "16:10: radio.cuts[0]: a cut between a node and itself\n"
      "26:61: ground.script[0].do[0].plan.tasks[1].params.to: unknown name 'bsae'; expected "
      "a place or [x, y, z]; did you mean 'base'?\n"
      "32:21: faults[0].kill: unknown name 'helif'; expected a UAV, ground or sim; did you mean "
      "'heliv'?\n"
      "34:33: expect[0].event.kind: unknown name 'taks'; expected a kind of record "
      "(docs/journal.md); did you mean 'task'?\n");
}

TEST(WrongFiles, AFileThatIsNotThereIsAnErrorLikeAnyOther) {
  const TemporaryFolder folder;

  const auto scenario = read_scenario(folder.path("none.yaml"));

  ASSERT_FALSE(scenario.has_value());
  ASSERT_EQ(scenario.error().size(), 1U);
  EXPECT_EQ(scenario.error().all()[0].file, folder.path("none.yaml"));
}

TEST(WrongFiles, NothingAtAllIsNoScenario) {
  EXPECT_NE(errors_of(""), "");
  EXPECT_NE(errors_of("~"), "");
  EXPECT_NE(errors_of("# nothing\n"), "");
  EXPECT_NE(errors_of("[]"), "");
  EXPECT_NE(errors_of("word"), "");
  EXPECT_NE(errors_of("{}"), "");
}

TEST(WrongFiles, AnErrorOfAModelIsToldWithTheModelsNameAndLine) {
  const TemporaryFolder folder;
  folder.write("models/heliv.yaml", "model: heliv\nkind: helicopter\nclimb_rate: fast\n");
  folder.write("models/marvin.yaml", "model: [\n");
  const std::string path = folder.write("scenario.yaml", scenario_with("degree: 2", "degree: 9"));

  const auto scenario = read_scenario(path);

  ASSERT_FALSE(scenario.has_value());
  bool heliv = false, marvin = false, own = false;
  for (const Diagnostic& one : scenario.error().all()) {
    heliv = heliv || (one.file == folder.path("models/heliv.yaml") && one.line == 3 &&
                      one.path == "climb_rate");
    marvin = marvin || (one.file == folder.path("models/marvin.yaml") && one.line > 0);
    own = own || (one.file == path && one.path == "uavs.heliv.degree" && one.line == 14);
  }
  EXPECT_TRUE(heliv) << to_text(scenario.error());
  EXPECT_TRUE(marvin) << to_text(scenario.error());
  EXPECT_TRUE(own) << to_text(scenario.error());
}

}  // namespace
}  // namespace skein::scenario
