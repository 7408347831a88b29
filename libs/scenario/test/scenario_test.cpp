// SPDX-License-Identifier: Apache-2.0
// What a right file becomes.
#include "skein/scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "testing/files.hpp"

namespace skein::scenario {
namespace {

using ground_station::PlannedTask;
using testing::read_valid;
using testing::scenario_with;
using testing::TemporaryFolder;
using Vector2 = world::Vector2;
using Vector3 = world::Vector3;

Result<Scenario, Diagnostics> comets(const std::string& variant) {
  return read_scenario(SKEIN_SOURCE_DIR "/scenarios/comets/" + variant + ".yaml");
}

// The tasks of the n-th action of a step, which must be a plan.
const std::vector<PlannedTask>& tasks_of(const Scenario& scenario, std::size_t step,
                                         std::size_t action = 0) {
  return std::get<ground_station::SendPlan>(
             scenario.ground.script.steps.at(step).actions.at(action))
      .tasks;
}

// The one task of a plan for marvin with these contents after its id.
PlannedTask task_with(const std::string& contents) {
  const Scenario scenario = read_valid(
      scenario_with("{id: 1, type: takeoff, params: {altitude: 40}}", "{id: 1, " + contents + "}"));
  return tasks_of(scenario, 0).at(0);
}

template <class T>
T target_of(const PlannedTask& task) {
  EXPECT_EQ(task.targets.size(), 1U);
  return std::get<T>(task.targets.at(0).where);
}

ground_station::Trigger trigger_of(const std::string& text) {
  return read_valid(scenario_with("when: {time: 5}", "when: " + text)).ground.script.steps[0].when;
}

TEST(Scenario, BothVariantsOfCometsAreValid) {
  for (const char* variant : {"confirmed", "infirmed"}) {
    const auto scenario = comets(variant);
    ASSERT_TRUE(scenario.has_value()) << to_text(scenario.error());
    EXPECT_EQ(scenario->name, std::string("comets-") + variant);
    EXPECT_EQ(scenario->uav_names(), (std::vector<std::string>{"marvin", "heliv", "karma"}));
  }
}

TEST(Scenario, CometsSaysWhatItsFileSays) {
  const Scenario scenario = comets("confirmed").value();

  EXPECT_EQ(scenario.epoch, "2005-05-19T09:00:00Z");
  EXPECT_EQ(scenario.duration_limit, MissionTime::seconds(2100));
  EXPECT_EQ(scenario.rate, 20);
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_EQ(scenario.world.terrain.hills.size(), 3U);
  EXPECT_EQ(scenario.world.wind.speed, 2);
  ASSERT_EQ(scenario.world.zones.size(), 1U);
  EXPECT_EQ(scenario.world.zones[0].polygon[2], Vector2(900, 600));
  EXPECT_EQ(scenario.world.places.at("aside"), Vector3(420, 120, 0));
  EXPECT_EQ(scenario.radio.model.range, 2500);
  EXPECT_EQ(scenario.ground.position, Vector3(-20, -20, 8));
  EXPECT_EQ(scenario.ground.pps.confirm, 0.99999);
}

TEST(Scenario, CometsUavsCarryTheirModels) {
  const Scenario scenario = comets("confirmed").value();

  const UavSpec* marvin = scenario.find_uav("marvin");
  const UavSpec* karma = scenario.find_uav("karma");

  ASSERT_NE(marvin, nullptr);
  EXPECT_EQ(marvin->model.name, "marvin");
  EXPECT_EQ(marvin->degree, 3);
  EXPECT_EQ(marvin->contact_loss.policy, ContactLoss::Policy::kHold);
  EXPECT_EQ(karma->contact_loss.policy, ContactLoss::Policy::kReturn);
  EXPECT_EQ(karma->contact_loss.after, Duration::seconds(120));
  EXPECT_EQ(scenario.find_uav("nobody"), nullptr);
}

TEST(Scenario, CometsScriptKeepsItsStepsInOrder) {
  const auto script = comets("confirmed").value().ground.script;

  std::vector<std::string> phases;
  for (const auto& step : script.steps) phases.push_back(step.name + "/" + step.phase);
  EXPECT_EQ(phases,
            (std::vector<std::string>{"detection/Detection", "confirmation/Confirmation",
                                      "monitoring/Monitoring", "marvin-again/", "heliv-again/",
                                      "nothing-found/", "return/Return", "end/"}));
  ASSERT_EQ(script.operators.size(), 2U);
  EXPECT_EQ(script.operators[0].does, "end-monitoring");
  EXPECT_EQ(script.operators[0].after, Duration::seconds(30));
}

TEST(Scenario, WhatIsLeftOutHasADefault) {
  const Scenario scenario = read_valid(scenario_with());

  EXPECT_EQ(scenario.rate, 1);
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_EQ(scenario.world.wind.speed, 0);
  EXPECT_EQ(scenario.radio.model.range, 10'000);
  EXPECT_TRUE(scenario.radio.model.needs_line_of_sight);
  EXPECT_EQ(scenario.uavs[0].energy, 1);
  EXPECT_EQ(scenario.uavs[0].degree, 3);
  EXPECT_EQ(scenario.world.objects[0].disappears, MissionTime::max());
}

TEST(Scenario, AFireMaySpreadAndTheGroundStationFollowItsFront) {
  const Scenario scenario =
      read_valid(scenario_with("radius: 5}", "radius: 5, spread: {rate: 0.1, gain: 0.3}}"));
  const Scenario follows = read_valid(scenario_with(
      "ground:\n",
      "ground:\n  pps: {tell_again: 5}\n"
      "  objects: {base: {kind: fire, reach: 60, drift: 0.5}, aside: {kind: smoke}}\n"));

  EXPECT_EQ(scenario.world.objects[0].spread, (world::FireSpread{0.1, 0.3, {}}));
  EXPECT_EQ(follows.ground.pps.tell_again, Duration::seconds(5));
  ASSERT_EQ(follows.ground.objects.size(), 2U);
  const ground_station::ObjectSpec& base = follows.ground.objects[0];
  EXPECT_EQ(base.name, "base");
  EXPECT_EQ(base.kind, "fire");
  EXPECT_EQ(base.thought, Vector3(0, 0, 0));
  EXPECT_EQ(base.reach, 60);
  EXPECT_EQ(base.drift, 0.5);
  EXPECT_EQ(follows.ground.objects[1].thought, Vector3(50, 60, 70));
  EXPECT_TRUE(read_valid(scenario_with()).ground.objects.empty());
}

TEST(Scenario, ItsRadioMayBeALinkBudgetAsThatOfAWorldFile) {
  const Scenario scenario = read_valid(
      scenario_with("  cuts:", "  power: 27\n  sensitivity: -95\n  exponent: 2.2\n  cuts:"));

  EXPECT_EQ(scenario.radio.model.budget, (world::LinkBudget{27, -95, 40, 2.2}));
  EXPECT_EQ(scenario.radio.cuts.size(), 1U);
}

TEST(Scenario, ATeleoperatedUavHoldsWhenContactIsLostUnlessToldOtherwise) {
  const Scenario scenario = read_valid(scenario_with());
  const Scenario told = read_valid(
      scenario_with("degree: 2}", "degree: 2, contact_loss: {policy: continue, after: 5}}"));

  EXPECT_EQ(scenario.find_uav("marvin")->contact_loss.policy, ContactLoss::Policy::kContinue);
  EXPECT_EQ(scenario.find_uav("heliv")->contact_loss.policy, ContactLoss::Policy::kHold);
  EXPECT_EQ(told.find_uav("heliv")->contact_loss.policy, ContactLoss::Policy::kContinue);
  EXPECT_EQ(told.find_uav("heliv")->contact_loss.after, Duration::seconds(5));
}

TEST(Scenario, FaultsOfEveryKindAreKept) {
  const Scenario scenario =
      read_valid(scenario_with("  - {at: 100, kill: heliv, restart_after: 5}",
                               "  - {at: 100, kill: heliv, restart_after: 5}\n"
                               "  - {at: 110, kill: ground}\n"
                               "  - {at: 120, engine: marvin}\n"
                               "  - {at: 130, sensor: {uav: marvin, device: visible}}\n"
                               "  - {random: {cuts_per_hour: 6, kills_per_hour: 1}}"));

  ASSERT_EQ(scenario.faults.kills.size(), 2U);
  EXPECT_EQ(scenario.faults.kills[0].restart_after, Duration::seconds(5));
  EXPECT_FALSE(scenario.faults.kills[1].restart_after);
  ASSERT_EQ(scenario.faults.breaks.size(), 2U);
  EXPECT_EQ(scenario.faults.breaks[0].device, "");
  EXPECT_EQ(scenario.faults.breaks[1].device, "visible");
  EXPECT_EQ(scenario.faults.random.cuts_per_hour, 6);
  EXPECT_EQ(scenario.faults.random.mean_cut, 20);
}

TEST(Scenario, CutsAreKept) {
  const Scenario scenario = read_valid(scenario_with());

  ASSERT_EQ(scenario.radio.cuts.size(), 1U);
  EXPECT_EQ(scenario.radio.cuts[0].a, "heliv");
  EXPECT_EQ(scenario.radio.cuts[0].b, "ground");
  EXPECT_EQ(scenario.radio.cuts[0].from, MissionTime::seconds(30));
  EXPECT_EQ(scenario.radio.cuts[0].until, MissionTime::seconds(40));
}

std::string text_of(const std::vector<CutSpec>& cuts) {
  std::string text;
  for (const CutSpec& cut : cuts)
    text += cut.a + (cut.one_way ? " > " : " - ") + cut.b + " " + to_text(cut.from) + " to " +
            to_text(cut.until) + "\n";
  return text;
}

TEST(Scenario, CutsMayBeOfSeveralNodesAndOfAll) {
  const auto cuts = [](const std::string& ends) {
    return text_of(read_valid(scenario_with("between: [heliv, ground]", ends)).radio.cuts);
  };

  EXPECT_EQ(cuts("one_way: [heliv, all]"), "heliv > marvin 30 to 40\nheliv > ground 30 to 40\n");
  EXPECT_EQ(cuts("between: [[marvin, heliv], [ground]]"),
            "marvin - ground 30 to 40\nheliv - ground 30 to 40\n");
}

TEST(Scenario, ALinkMayFlap) {
  const Scenario scenario =
      read_valid(scenario_with("from: 30, until: 40", "from: 30, until: 38, down: 2, up: 1.5"));

  EXPECT_EQ(text_of(scenario.radio.cuts),
            "heliv - ground 30 to 32\nheliv - ground 33.5 to 35.5\nheliv - ground 37 to 38\n");
}

TEST(Scenario, NobodyNeedBeToldWhichLinksAreUp) {
  EXPECT_FALSE(read_valid(scenario_with()).radio.silent);
  EXPECT_TRUE(read_valid(scenario_with("  cuts:", "  silent: true\n  cuts:")).radio.silent);
}

TEST(Scenario, LinksMayBeUnlikeTheOthers) {
  const Scenario scenario = read_valid(scenario_with(
      "  cuts:",
      "  capacity: 64000\n  heartbeat: 2\n  links:\n"
      "    - {one_way: [heliv, ground], capacity: 9600}\n"
      "    - {between: [marvin, heliv], latency: 0.5, loss: 0.1, from: 10, until: 20}\n  cuts:"));

  EXPECT_EQ(scenario.radio.model.capacity, 64'000);
  EXPECT_EQ(scenario.radio.heartbeat, Duration::seconds(2));
  ASSERT_EQ(scenario.radio.links.size(), 2U);
  const LinkSpec& slow = scenario.radio.links[0];
  EXPECT_TRUE(slow.one_way);
  EXPECT_EQ(slow.capacity, 9600);
  EXPECT_FALSE(slow.latency || slow.loss);
  EXPECT_EQ(slow.until, MissionTime::max());
  const LinkSpec& bad = scenario.radio.links[1];
  EXPECT_FALSE(bad.one_way);
  EXPECT_EQ(bad.latency, Duration::seconds(0.5));
  EXPECT_EQ(bad.loss, 0.1);
  EXPECT_EQ(bad.from, MissionTime::seconds(10));
  EXPECT_EQ(read_valid(scenario_with()).radio.model.capacity, 0) << "unlimited";
}

TEST(Scenario, ACutMayBeOfOneDirection) {
  const Scenario scenario = read_valid(scenario_with("between: [heliv", "one_way: [heliv"));

  ASSERT_EQ(scenario.radio.cuts.size(), 1U);
  EXPECT_TRUE(scenario.radio.cuts[0].one_way);
}

TEST(ScenarioTasks, ModeParametersAndConditionsAreKept) {
  const PlannedTask task = task_with(
      "type: wait, mode: NUT, params: {duration: 120, note: front, list: [1, 2.5]}, "
      "pre: [[{task: 9, state: ended}, {message: go, modality: optional}], "
      "[{time: 30, is: passed, not: true}]], exit: [[{time: 60, is: not-yet-passed}]]");

  EXPECT_EQ(task.mode, executive::InsertionMode::kNut);
  EXPECT_EQ(task.task.parameters.find("duration")->numbers, std::vector<double>{120});
  EXPECT_EQ(task.task.parameters.find("note")->text, "front");
  EXPECT_EQ(task.task.parameters.find("list")->numbers, (std::vector<double>{1, 2.5}));
  const executive::Formula pre{
      {{executive::TaskInState{executive::TaskId(9), executive::TaskState::kEnded}, false,
        executive::Modality::kMandatory},
       {executive::MessageReceived{"go"}, false, executive::Modality::kOptional}},
      {{executive::TimeIs{MissionTime::seconds(30), true}, true, executive::Modality::kMandatory}}};
  EXPECT_EQ(task.task.preconditions, pre);
  EXPECT_EQ(std::get<executive::TimeIs>(task.task.exit[0][0].condition).passed, false);
}

TEST(ScenarioTasks, AnAltitudeIsAboveTheGroundOfThePlace) {
  const auto named = target_of<ground_station::AtPoints>(
      task_with("type: goto, params: {to: aside, altitude: 40}"));
  const auto given = target_of<ground_station::AtPoints>(
      task_with("type: goto, params: {to: [[1, 2, 3], [4, 5, 6]], altitude: 40}"));
  const auto plain =
      target_of<ground_station::AtPoints>(task_with("type: goto, params: {to: aside}"));

  EXPECT_EQ(named.points, std::vector<Vector3>{Vector3(50, 60, 50)});  // base of the terrain: 10
  EXPECT_EQ(given.points, (std::vector<Vector3>{Vector3(1, 2, 50), Vector3(4, 5, 50)}));
  EXPECT_EQ(plain.points, std::vector<Vector3>{Vector3(50, 60, 70)});
}

TEST(ScenarioTasks, ATakeoffKeepsItsAltitudeAsAParameter) {
  const PlannedTask takeoff = task_with("type: takeoff, params: {altitude: 40}");
  const PlannedTask way = task_with("type: goto, params: {to: base, altitude: 40, speed: 5}");

  EXPECT_EQ(takeoff.task.parameters.find("altitude")->numbers, std::vector<double>{40});
  EXPECT_EQ(way.task.parameters.find("altitude"), nullptr);  // it is in the way-points
  EXPECT_EQ(way.task.parameters.find("speed")->numbers, std::vector<double>{5});
}

TEST(ScenarioTasks, TargetsThatAreFoundInFlightAreKeptAsSuch) {
  const auto near = target_of<ground_station::NearAlarm>(
      task_with("type: goto, params: {near_alarm: {bearing: 1.5, distance: 90, altitude: 45}}"));
  const auto over = target_of<ground_station::OverZone>(
      task_with("type: goto, params: {over: {zone: Z, spacing: 70, altitude: 40, "
                "around_alarm: true}}"));
  const PlannedTask shot = task_with("type: takeshot, params: {device: visible, target: alarm}");

  EXPECT_EQ(near.bearing, 1.5);
  EXPECT_EQ(near.distance, 90);
  EXPECT_EQ(near.altitude, 45);
  EXPECT_EQ(over.zone.size(), 3U);
  EXPECT_TRUE(over.around_alarm);
  (void)target_of<ground_station::TheAlarm>(shot);
  EXPECT_EQ(shot.targets[0].parameter, "target");
}

TEST(ScenarioTasks, ASynchronisationIsKept) {
  const PlannedTask task = task_with(
      "type: synchronise, params: {id: 551, senders: [marvin], receivers: [heliv, marvin], "
      "deadline: 300}");

  ASSERT_TRUE(task.task.synchronisation.has_value());
  EXPECT_EQ(task.task.synchronisation->id, 551U);
  EXPECT_EQ(task.task.synchronisation->senders, std::vector<std::string>{"marvin"});
  EXPECT_EQ(task.task.synchronisation->receivers, (std::vector<std::string>{"heliv", "marvin"}));
  EXPECT_EQ(task.task.synchronisation->deadline, MissionTime::seconds(300));
}

TEST(ScenarioTriggers, EveryKindIsRead) {
  namespace gs = ground_station;

  EXPECT_EQ(std::get<gs::AtTime>(trigger_of("{time: 12}").what).at, MissionTime::seconds(12));
  EXPECT_EQ(std::get<gs::OnAlarm>(trigger_of("{alarm: infirmed}").what).state,
            gs::AlarmState::kInfirmed);
  const auto second = std::get<gs::OnAlarm>(trigger_of("{alarm: {state: raised, id: 2}}").what);
  EXPECT_EQ(second.state, gs::AlarmState::kRaised);
  EXPECT_EQ(second.id, gs::AlarmId(2));
  EXPECT_EQ(std::get<gs::OnOperator>(trigger_of("{operator: stop}").what).does, "stop");
  EXPECT_EQ(std::get<gs::OnStep>(trigger_of("{step: end}").what).step, "end");
  EXPECT_EQ(std::get<gs::OnExpired>(trigger_of("{expired: end}").what).step, "end");
  EXPECT_EQ(std::get<gs::OnHeld>(trigger_of("{held: heliv}").what).uav, "heliv");
  EXPECT_EQ(std::get<gs::OnSilence>(trigger_of("{silent: {uav: heliv, for: 90}}").what).lasts,
            Duration::seconds(90));
  EXPECT_EQ(std::get<gs::OnRestart>(trigger_of("{restart: heliv}").what).uav, "heliv");
  const auto on_task =
      std::get<gs::OnTask>(trigger_of("{task: {uav: heliv, id: 4, state: aborted}}").what);
  EXPECT_EQ(on_task.uav, "heliv");
  EXPECT_EQ(on_task.task, executive::TaskId(4));
  EXPECT_EQ(on_task.state, executive::TaskState::kAborted);
  const auto nested = trigger_of("{all: [{time: 1}, {any: [{time: 2}, {alarm: raised}]}]}");
  EXPECT_EQ(std::get<gs::AllOf>(nested.what).of.size(), 2U);
}

TEST(ScenarioActions, EveryKindIsRead) {
  namespace gs = ground_station;
  const Scenario scenario =
      read_valid(scenario_with("do: [{finish: true}]",
                               "after: 3\n      repeats: true\n      do:\n"
                               "        - abort: {uav: marvin, tasks: all}\n"
                               "        - abort: {uav: marvin, tasks: [1, 2]}\n"
                               "        - message: {uav: heliv, text: go}\n"
                               "        - update: {uav: marvin, id: 2, exit: []}\n"
                               "        - finish: true"));

  const auto& step = scenario.ground.script.steps.at(1);
  ASSERT_EQ(step.actions.size(), 5U);
  EXPECT_EQ(step.after, Duration::seconds(3));
  EXPECT_FALSE(step.once);
  EXPECT_FALSE(std::get<gs::AbortTasks>(step.actions[0]).tasks);
  EXPECT_EQ(std::get<gs::AbortTasks>(step.actions[1]).tasks->size(), 2U);
  EXPECT_EQ(std::get<gs::SendMessage>(step.actions[2]).text, "go");
  const auto& update = std::get<gs::UpdateConditions>(step.actions[3]).update;
  EXPECT_FALSE(update.preconditions);
  EXPECT_TRUE(update.exit && update.exit->empty());
  EXPECT_TRUE(std::holds_alternative<gs::Finish>(step.actions[4]));
}

TEST(ScenarioFiles, ModelsAreFoundBesideTheScenario) {
  const TemporaryFolder folder;
  std::string text = scenario_with("models/marvin.yaml", "own/marvin.yaml");
  text.replace(text.find("models/heliv.yaml"), 17, "own/marvin.yaml");
  folder.write("own/marvin.yaml",
               "model: own\nkind: helicopter\nhovers: true\nspeed: {cruise: 8, max: 14}\n"
               "climb_rate: 3\ndescent_rate: 2\nacceleration: 2\nyaw_rate: 0.8\nceiling: 300\n"
               "position_precision: 0.3\nwind_drift: 0.05\n"
               "energy: {capacity: 6.5e6, ground: 100, hover: 1700, cruise: 1500, climb: 400, "
               "reserve: 0.08}\n"
               "sensors:\n  visible: {aperture: 0.35, pitch: -0.6, range: 250, period: 1, "
               "position_spread: 3, sees: {fire: {probability: 0.9, confidence: 0.85}}}\n");
  const std::string path = folder.write("scenario.yaml", text);

  const auto scenario = read_scenario(path);

  ASSERT_TRUE(scenario.has_value()) << to_text(scenario.error());
  EXPECT_EQ(scenario->uavs[0].model.name, "own");
  EXPECT_EQ(scenario->file, path);
}

// ---- random faults ----

Scenario with_random_faults(std::uint64_t seed) {
  Scenario scenario = read_valid(scenario_with());
  scenario.seed = seed;
  scenario.faults.random = {60, 20, 30, 5};
  draw_random_faults(scenario);
  return scenario;
}

std::vector<std::string> drawn(const Scenario& scenario) {
  std::vector<std::string> all;
  for (const CutSpec& cut : scenario.radio.cuts) {
    all.push_back(cut.a + " " + cut.b + " " + to_text(cut.from) + " " + to_text(cut.until));
  }
  for (const KillSpec& kill : scenario.faults.kills) {
    all.push_back(kill.node + " " + to_text(kill.at) + " " + to_text(*kill.restart_after));
  }
  return all;
}

TEST(RandomFaults, FollowFromTheSeed) {
  EXPECT_EQ(drawn(with_random_faults(3)), drawn(with_random_faults(3)));
  EXPECT_NE(drawn(with_random_faults(3)), drawn(with_random_faults(4)));
}

TEST(RandomFaults, AreDrawnBesideThoseWrittenDown) {
  const Scenario written = read_valid(scenario_with());
  const Scenario scenario = with_random_faults(3);

  EXPECT_EQ(drawn(scenario).front(), drawn(written).front());
  EXPECT_GT(scenario.radio.cuts.size(), 1U);
  EXPECT_GT(scenario.faults.kills.size(), 1U);
}

TEST(RandomFaults, WithoutRatesNothingIsDrawn) {
  Scenario scenario = read_valid(scenario_with());
  const auto before = drawn(scenario);

  draw_random_faults(scenario);

  EXPECT_EQ(drawn(scenario), before);
}

TEST(RandomFaults, OfOneLinkDoNotOverlapAndLieWithinTheMission) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Scenario scenario = with_random_faults(seed);
    scenario.radio.cuts.erase(scenario.radio.cuts.begin());  // the one written down
    std::map<std::pair<std::string, std::string>, MissionTime> last;
    for (const CutSpec& cut : scenario.radio.cuts) {
      EXPECT_GE(cut.from, (last[{cut.a, cut.b}]));
      EXPECT_LT(cut.from, scenario.duration_limit);
      EXPECT_GT(cut.until, cut.from);
      EXPECT_NE(cut.a, cut.b);
      last[{cut.a, cut.b}] = cut.until;
    }
  }
}

TEST(RandomFaults, ComeAboutAsOftenAsAsked) {
  std::size_t cuts = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    cuts += with_random_faults(seed).radio.cuts.size() - 1;
  }

  // Three links of 600 s, 50 times; one cut in 60 s of being up, then 20 s down: about 7.5 each.
  EXPECT_NEAR(static_cast<double>(cuts) / 150, 7.5, 1);
}

}  // namespace
}  // namespace skein::scenario
