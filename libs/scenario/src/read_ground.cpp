// SPDX-License-Identifier: Apache-2.0
// The ground station's part of a scenario file: its script and its perception processing.
#include <limits>

#include "read_missions.hpp"

namespace skein::scenario {

namespace {

using config::Reader;
using ground_station::Action;
using ground_station::Trigger;

// In place of a trigger that was reported; it breaks no other rule.
Trigger wrong_trigger() { return {ground_station::AtTime{}}; }

Trigger read_trigger(const Reader& reader, TaskContext& context);

std::vector<Trigger> read_triggers(const Reader& reader, TaskContext& context) {
  std::vector<Trigger> triggers;
  for (const Reader& item : items_of(reader)) triggers.push_back(read_trigger(item, context));
  return triggers;
}

std::string read_uav(const Reader& reader, const TaskContext& context) {
  return reader.required("uav").name_among(context.names.uavs, "a UAV");
}

ground_station::OnTask read_on_task(const Reader& reader, const TaskContext& context) {
  reader.keys({"uav", "id", "state"});
  return {read_uav(reader, context), read_task_id(reader.required("id")),
          read_task_state(reader.required("state"))};
}

ground_station::OnMission read_on_mission(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "id", "state"});
  ground_station::OnMission on{read_uav(reader, context), {}, {}};
  on.mission = read_mission_id(reader.required("id"), on.uav, context);
  on.state = static_cast<ground_station::MissionStage>(
      reader.required("state").choice({"planned", "refused", "achieved", "failed", "evaluated"}));
  return on;
}

ground_station::OnGoal read_on_goal(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "id", "state"});
  ground_station::OnGoal on{read_uav(reader, context), {}, {}};
  on.goal = read_goal_id(reader.required("id"), on.uav, context);
  on.state = static_cast<mission::GoalState>(reader.required("state").choice(
      {"received", "planned", "under-way", "achieved", "failed", "cancelled", "handed-over"}));
  return on;
}

ground_station::OnDegree read_on_degree(const Reader& reader, const TaskContext& context) {
  reader.keys({"uav", "is"});
  return {read_uav(reader, context), read_degree_number(reader.required("is"))};
}

ground_station::OnSilence read_on_silence(const Reader& reader, const TaskContext& context) {
  reader.keys({"uav", "for"});
  const std::string uav = read_uav(reader, context);
  return {uav, Duration::seconds(reader.required("for").number(1, {0.001, 1e7, "s"}))};
}

// Those about one UAV; absent: it is none of them.
std::optional<Trigger> read_uav_trigger(const Reader& reader, TaskContext& context) {
  const auto given = [&](const char* key) { return reader.optional(key).present(); };
  if (given("task")) return Trigger{read_on_task(reader.optional("task"), context)};
  if (given("mission")) return Trigger{read_on_mission(reader.optional("mission"), context)};
  if (given("goal")) return Trigger{read_on_goal(reader.optional("goal"), context)};
  if (given("degree")) return Trigger{read_on_degree(reader.optional("degree"), context)};
  if (given("silent")) return Trigger{read_on_silence(reader.optional("silent"), context)};
  if (given("held")) {
    return Trigger{
        ground_station::OnHeld{reader.optional("held").name_among(context.names.uavs, "a UAV")}};
  }
  if (given("restart")) {
    return Trigger{ground_station::OnRestart{
        reader.optional("restart").name_among(context.names.uavs, "a UAV")}};
  }
  return std::nullopt;
}

// A state, or {state: …, id: …} of one in particular.
ground_station::OnAlarm read_on_alarm(const Reader& reader) {
  ground_station::OnAlarm on;
  if (reader.is_map()) reader.keys({"state", "id"});
  const Reader state = reader.is_map() ? reader.required("state") : reader;
  on.state =
      static_cast<ground_station::AlarmState>(state.choice({"raised", "confirmed", "infirmed"}));
  if (!reader.is_map()) return on;
  const Reader id = reader.optional("id");
  if (!id.present()) return on;
  const std::int64_t number = id.integer(1, 0, std::numeric_limits<std::int32_t>::max());
  if (number == 0) id.error("0 is no id", "a whole number from 1");
  on.id = ground_station::AlarmId(static_cast<std::uint32_t>(number));
  return on;
}

// What came of a step; absent: it is none of them.
std::optional<Trigger> read_step_trigger(const Reader& reader, const TaskContext& context) {
  for (const char* key : {"step", "expired"}) {
    const Reader of = reader.optional(key);
    if (!of.present()) continue;
    const std::string step = of.name_among(context.names.steps, "a step");
    if (step.empty()) return wrong_trigger();
    return key == std::string_view("step") ? Trigger{ground_station::OnStep{step}}
                                           : Trigger{ground_station::OnExpired{step}};
  }
  return std::nullopt;
}

Trigger read_trigger(const Reader& reader, TaskContext& context) {
  if (!reader.keys({"time", "alarm", "task", "mission", "goal", "degree", "held", "operator",
                    "step", "expired", "restart", "silent", "team_task", "global_mission", "all",
                    "any"})) {
    return wrong_trigger();
  }
  if (entries_of(reader).size() > 1 || reader.entries().empty()) {
    reader.error("a trigger is one thing", "all: [...] or any: [...] for several");
  }
  const auto given = [&](const char* key) { return reader.optional(key).present(); };
  if (given("time")) return {ground_station::AtTime{read_instant(reader.optional("time"))}};
  if (given("alarm")) {
    return {read_on_alarm(reader.optional("alarm"))};
  }
  if (given("operator")) return {ground_station::OnOperator{reader.optional("operator").text()}};
  if (const auto of_step = read_step_trigger(reader, context)) return *of_step;
  if (given("all")) return {ground_station::AllOf{read_triggers(reader.optional("all"), context)}};
  if (given("any")) return {ground_station::AnyOf{read_triggers(reader.optional("any"), context)}};
  if (given("team_task")) return {read_on_team_task(reader.optional("team_task"), context)};
  if (given("global_mission")) {
    return {read_on_global_mission(reader.optional("global_mission"), context)};
  }
  return read_uav_trigger(reader, context).value_or(wrong_trigger());
}

Action read_plan(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "tasks"});
  ground_station::SendPlan plan{read_uav(reader, context), {}};
  for (const Reader& task : items_of(reader.required("tasks"))) {
    plan.tasks.push_back(read_task(task, plan.uav, context));
  }
  return plan;
}

Action read_abort(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "tasks"});
  ground_station::AbortTasks abort{read_uav(reader, context), std::nullopt};
  const Reader tasks = reader.optional("tasks");
  if (tasks.is_scalar()) {
    (void)tasks.choice({"all"});
  } else if (tasks.present()) {
    abort.tasks.emplace();
    for (const Reader& id : items_of(tasks)) abort.tasks->push_back(read_task_id(id));
  }
  return abort;
}

Action read_update(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "id", "pre", "exit"});
  ground_station::UpdateConditions result{read_uav(reader, context), {}};
  result.update.id = read_task_id(reader.required("id"));
  const Reader pre = reader.optional("pre");
  const Reader exit = reader.optional("exit");
  if (pre.present()) result.update.preconditions = read_formula(pre);
  if (exit.present()) result.update.exit = read_formula(exit);
  return result;
}

Action read_message(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "text"});
  return ground_station::SendMessage{read_uav(reader, context), reader.required("text").text()};
}

}  // namespace

std::optional<Action> read_action(const Reader& reader, TaskContext& context) {
  static const std::vector<MissionAction> kPlain{{"plan", read_plan},
                                                 {"abort", read_abort},
                                                 {"message", read_message},
                                                 {"update", read_update}};
  for (const auto* actions : {&kPlain, &mission_actions()}) {
    for (const MissionAction& action : *actions) {
      const Reader given = reader.optional(action.key);
      if (given.present()) return action.read(given, context);
    }
  }
  if (reader.optional("finish").boolean(false)) return ground_station::Finish{};
  return std::nullopt;
}

namespace {

std::vector<Action> read_actions(const Reader& reader, TaskContext& context) {
  std::vector<Action> actions;
  for (const Reader& item : items_of(reader)) {
    item.keys({"plan",        "abort",          "message",      "update",        "mission",
               "cancel",      "play",           "degree",       "take_in_hand",  "give_back",
               "resume_plan", "drop_plan",      "close_air",    "open_air",      "know_place",
               "know_ground", "global_mission", "declare_lost", "declare_found", "finish"});
    at_most_one_of(item,
                   {"plan",        "abort",          "message",      "update",        "mission",
                    "cancel",      "play",           "degree",       "take_in_hand",  "give_back",
                    "resume_plan", "drop_plan",      "close_air",    "open_air",      "know_place",
                    "know_ground", "global_mission", "declare_lost", "declare_found", "finish"});
    if (auto action = read_action(item, context)) {
      actions.push_back(std::move(*action));
    } else {
      item.error(
          "an action of no kind",
          "one of plan, abort, message, update, mission, cancel, play, degree, take_in_hand, "
          "give_back, resume_plan, drop_plan, close_air, open_air, know_place, know_ground, "
          "global_mission, declare_lost, declare_found, finish: true");
    }
  }
  return actions;
}

ground_station::Step read_step(const Reader& reader, TaskContext& context) {
  reader.keys({"step", "phase", "when", "after", "do", "repeats"});
  ground_station::Step step;
  step.name = reader.required("step").text("of line " + std::to_string(reader.line()));
  step.phase = reader.optional("phase").text();
  step.when = read_trigger(reader.required("when"), context);
  step.after = read_seconds(reader.optional("after"));
  step.actions = read_actions(reader.optional("do"), context);
  step.once = !reader.optional("repeats").boolean(false);
  return step;
}

ground_station::OperatorAction read_operator(const Reader& reader, TaskContext& context) {
  reader.keys({"does", "when", "after", "do"});
  ground_station::OperatorAction action;
  action.does = reader.required("does").text();
  action.when = read_trigger(reader.required("when"), context);
  action.after = read_seconds(reader.optional("after"));
  action.actions = read_actions(reader.optional("do"), context);
  return action;
}

// Volumes that the script closes; known beforehand, for steps may stand in any order.
void add_volume_names(const Reader& list, std::vector<std::string>& names) {
  if (!list.is_sequence()) return;
  for (const Reader& item : list.items()) {
    const Reader actions = item.optional("do");
    if (!actions.is_sequence()) continue;
    for (const Reader& action : actions.items()) {
      const Reader name = action.optional("close_air").optional("name");
      if (name.is_scalar()) names.push_back(name.text());
    }
  }
}

// Likewise: steps may wait for later ones.
std::vector<std::string> step_names(const Reader& script) {
  std::vector<std::string> names;
  if (!script.is_sequence()) return names;
  for (const Reader& step : script.items()) {
    const Reader name = step.optional("step");
    if (name.is_scalar()) names.push_back(name.text());
  }
  return names;
}

}  // namespace

void read_pps(const Reader& reader, ground_station::PpsConfig& pps) {
  if (!reader.keys({"prior", "raise", "confirm", "infirm", "gate", "least_separation", "forget",
                    "tell_again"}))
    return;
  pps.prior = reader.optional("prior").number(pps.prior, {0, 1, ""});
  pps.raise = reader.optional("raise").number(pps.raise, {0, 1, ""});
  pps.confirm = reader.optional("confirm").number(pps.confirm, {0, 1, ""});
  pps.infirm = reader.optional("infirm").number(pps.infirm, {0, 1, ""});
  pps.gate = reader.optional("gate").number(pps.gate, {0.1, 100, "standard deviations"});
  pps.least_separation =
      reader.optional("least_separation").number(pps.least_separation, {0, 10'000, "m"});
  pps.forget = read_seconds(reader.optional("forget"), pps.forget);
  pps.tell_again = read_seconds(reader.optional("tell_again"), pps.tell_again);
  for (const std::string& problem : ground_station::problems_of(pps)) reader.error(problem);
}

std::vector<ground_station::ObjectSpec> read_objects(const Reader& reader, const WorldSpec& world) {
  std::vector<ground_station::ObjectSpec> objects;
  for (const auto& [name, entry] : entries_of(reader)) {
    if (!entry.keys({"kind", "reach", "drift"})) continue;
    ground_station::ObjectSpec object;
    object.name = name;
    object.kind = entry.required("kind").text();
    object.reach = entry.optional("reach").number(object.reach, {1, 100'000, "m"});
    object.drift = entry.optional("drift").number(object.drift, {0.001, 100, "m/√s"});
    const auto place = world.places.find(name);
    if (place == world.places.end()) {
      entry.error("where it is at first is not said", "a place of the world of this name");
    } else {
      object.thought = place->second;
    }
    objects.push_back(std::move(object));
  }
  return objects;
}

// The greatest for each UAV; ids from those of plans that are given again on leave no room beyond.
std::map<std::string, executive::TaskId> last_ids(const TaskContext& context) {
  constexpr executive::TaskId kFirstGivenAgain{300'000'000};
  std::map<std::string, executive::TaskId> last;
  for (const auto& [uav, id] : context.planned)  // in the order of ids
    if (id < kFirstGivenAgain) last.insert_or_assign(uav, id);
  return last;
}

void read_script(const Reader& ground, const Scenario& scenario, GroundSpec& spec) {
  ground_station::Script& script = spec.script;
  // A terrain that cannot be made was already reported; tasks are then read over level ground.
  world::TerrainSpec level;
  level.west = level.south = -1000;
  level.east = level.north = 1000;
  const bool usable = world::problems_of(scenario.world.terrain).empty();
  const world::Terrain terrain(usable ? scenario.world.terrain : level);
  TaskContext context{scenario, names_of(scenario), terrain};
  context.names.steps = step_names(ground.optional("script"));
  add_volume_names(ground.optional("script"), context.names.volumes);
  add_volume_names(ground.optional("operator"), context.names.volumes);
  for (const Reader& step : items_of(ground.required("script"))) {
    script.steps.push_back(read_step(step, context));
  }
  for (const Reader& action : items_of(ground.optional("operator"))) {
    script.operators.push_back(read_operator(action, context));
  }
  check_references(context);
  spec.last_ids = last_ids(context);
  spec.asked = std::move(context.goals);
  spec.played = std::move(context.played);
  script.command_lifetime =
      read_seconds(ground.optional("command_lifetime"), script.command_lifetime);
  for (const std::string& problem : ground_station::problems_of(script)) ground.error(problem);
}

}  // namespace skein::scenario
