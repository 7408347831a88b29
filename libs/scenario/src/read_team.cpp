// SPDX-License-Identifier: Apache-2.0
// The parts of a scenario about its team: who is in it, and global missions.
#include <algorithm>
#include <optional>
#include <string>

#include "read_missions.hpp"
#include "skein/scenario/narrowest.hpp"

namespace skein::scenario {

namespace {

using config::Range;
using config::Reader;
using mission::GoalId;
using mission::MissionId;

constexpr std::int64_t kGreatestNumber = 2'000'000'000;

/// Unless the scenario says otherwise. In the air every round of a sale is a message and its answer
/// on the radio, perhaps past a relay and beside what else it carries: there are few rounds, and
/// all wait longer where the narrowest link is narrow.
auction::TeamLimits limits_over(const RadioSpec& radio) {
  constexpr double kWord = 8'000;  // [bit]
  const auto least = narrowest(radio);
  const double airtime = least ? kWord / *least : 0;  // [s]
  auction::TeamLimits limits;
  limits.sale.trade = 3;
  limits.sale.patience = 8;
  limits.sale.most_rounds = 60;
  limits.sale.answer_within = Duration::seconds(2 + 8 * airtime);
  limits.beat = Duration::seconds(1 + 2 * airtime);
  limits.patience = Duration::seconds(4 + 8 * airtime);
  return limits;
}

std::uint64_t read_number(const Reader& reader) {
  return static_cast<std::uint64_t>(reader.integer(1, 1, kGreatestNumber));
}

std::set<std::string> read_uavs_of(const Reader& reader, const TaskContext& context) {
  std::set<std::string> uavs;
  for (const Reader& one : items_of(reader)) {
    uavs.insert(one.name_among(context.names.uavs, "a UAV"));
  }
  return uavs;
}

auction::Place middle_of(const world::Polygon& polygon) {
  auction::Place middle;
  for (const world::Vector2& corner : polygon) {
    middle.x += corner.x() / static_cast<double>(polygon.size());
    middle.y += corner.y() / static_cast<double>(polygon.size());
  }
  return middle;
}

// Of the first argument that names one.
auction::Place place_of(const mission::HighLevelTask& task, const WorldSpec& world) {
  for (const mission::Argument& argument : task.arguments) {
    if (const auto* at = std::get_if<world::Vector3>(&argument)) return {at->x(), at->y()};
    const auto* name = std::get_if<std::string>(&argument);
    if (name == nullptr) continue;
    if (const auto place = world.places.find(*name); place != world.places.end()) {
      return {place->second.x(), place->second.y()};
    }
    const auto zone = std::find_if(world.zones.begin(), world.zones.end(),
                                   [&](const world::Zone& one) { return one.name == *name; });
    if (zone != world.zones.end() && !zone->polygon.empty()) return middle_of(zone->polygon);
  }
  return {};
}

constexpr double kLongest = 1e6;  // [s]

// A number, or {task: NUMBER, least: s, most: s}.
void read_before(const Reader& reader, team::GlobalTask& asked) {
  if (!reader.is_map()) return void(asked.after.emplace_back(read_number(reader)));
  if (!reader.keys({"task", "least", "most"})) return;
  mission::GoalBound bound;
  bound.goal = GoalId(read_number(reader.required("task")));
  const Reader least = reader.optional("least"), most = reader.optional("most");
  if (least.present()) bound.least = Duration::seconds(least.number(0, {0, kLongest, "s"}));
  if (most.present()) bound.most = Duration::seconds(most.number(0, {0, kLongest, "s"}));
  if (bound.least > bound.most) most.error("less than least", "a number from least on");
  asked.after.push_back(bound.goal);
  asked.task.after.push_back(bound);
}

// A task of the team is a goal of that number at whoever does it.
std::optional<std::string> member_with_goal(GoalId goal, const TaskContext& context) {
  for (const auto& [key, mark] : context.goals)
    if (key.second == goal && is_of_team(key.first, context)) return key.first;
  return std::nullopt;
}

team::GlobalTask read_team_task(const Reader& reader, std::size_t number,
                                std::vector<ground_station::ArgumentTarget>& targets,
                                TaskContext& context) {
  team::GlobalTask asked;
  if (!reader.keys({"id", "task", "members", "needs", "after", "by", "not_by", "repeatable",
                    "start_before", "start_after", "end_before", "end_after"})) {
    return asked;
  }
  const Reader id = reader.required("id");
  asked.task.id = GoalId(read_number(id));
  if (id.present() && !context.team_tasks.insert(asked.task.id).second) {
    id.error("task " + to_text(asked.task.id) + " is given to the team twice",
             "ids that are unique among all global missions");
  }
  if (const auto uav = id.present() ? member_with_goal(asked.task.id, context) : std::nullopt) {
    id.error("task " + to_text(asked.task.id) + " is a high-level task of " + *uav + " already",
             "an id that no UAV of the team has a high-level task with");
  }
  context.goals.emplace(std::pair(std::string(), asked.task.id),
                        world::Mark{reader.line(), reader.path()});
  read_statement(reader.required("task"), asked.task, number, targets);
  asked.task.time = read_time_constraints(reader);
  asked.members = static_cast<std::uint32_t>(reader.optional("members").integer(1, 1, 100));
  if (const Reader needs = reader.optional("needs"); needs.present())
    asked.needs = interaction::read_requirements(needs);
  for (const Reader& before : items_of(reader.optional("after"))) read_before(before, asked);
  if (const Reader by = reader.optional("by"); by.present()) {
    asked.by = by.name_among(context.names.uavs, "a UAV");
  }
  asked.not_by = read_uavs_of(reader.optional("not_by"), context);
  asked.repeatable = reader.optional("repeatable").boolean(false);
  asked.at = place_of(asked.task, context.scenario.world);
  return asked;
}

}  // namespace

bool in_team(const Scenario& scenario, const std::string& uav) {
  return scenario.team && scenario.team->roster.number_of(uav).has_value();
}

std::optional<team::Config> read_team(const Reader& reader, const Names& names,
                                      const RadioSpec& radio, std::uint64_t seed) {
  if (!reader.present()) return std::nullopt;
  team::Config config;
  config.limits = limits_over(radio);
  config.seed = seed;
  if (!reader.keys({"members", "ground", "lease", "patience", "beat", "ahead", "equity"})) {
    return config;
  }
  std::vector<std::string> members;
  for (const Reader& one : items_of(reader.optional("members"))) {
    const std::string uav = one.name_among(names.uavs, "a UAV");
    if (std::find(members.begin(), members.end(), uav) != members.end()) {
      one.error("'" + uav + "' is named twice", "each member once");
    } else if (!uav.empty()) {
      members.push_back(uav);
    }
  }
  if (members.empty()) members = names.uavs;
  if (reader.optional("ground").boolean(true)) members.emplace_back("ground");
  config.roster = team::Roster(std::move(members));
  auction::TeamLimits& limits = config.limits;
  const auto seconds = [&](const char* key, Duration otherwise, Range range) {
    return Duration::seconds(reader.optional(key).number(otherwise.to_seconds(), range));
  };
  limits.lease = seconds("lease", limits.lease, {1, 3600, "s"});
  limits.patience = seconds("patience", limits.patience, {0.5, 600, "s"});
  limits.beat = seconds("beat", limits.beat, {0.1, 60, "s"});
  limits.ahead = static_cast<std::uint32_t>(reader.optional("ahead").integer(1, 1, 16));
  limits.aim.equity = reader.optional("equity").number(limits.aim.equity, {0, 1, ""});
  if (limits.patience < limits.beat + limits.beat) {
    reader.error("patience is less than two beats", "patience: seconds");
  }
  return config;
}

bool is_of_team(const std::string& uav, const TaskContext& context) {
  const auto& team = context.scenario.team;
  return !uav.empty() && team && team->roster.number_of(uav).has_value();
}

ground_station::Action read_global_mission(const Reader& reader, TaskContext& context) {
  ground_station::SendGlobalMission send;
  if (!reader.keys({"id", "tasks"})) return send;
  if (!context.scenario.team) reader.error("the scenario has no team", kTeamWanted);
  send.mission.id = MissionId(read_number(reader.required("id")));
  context.global_missions.insert(send.mission.id);
  for (const Reader& task : items_of(reader.required("tasks"))) {
    send.mission.tasks.push_back(
        read_team_task(task, send.mission.tasks.size(), send.targets, context));
  }
  return send;
}

namespace {

std::string read_declared(const Reader& reader, const TaskContext& context) {
  reader.keys({"uav"});
  return reader.required("uav").name_among(context.names.uavs, "a UAV");
}

}  // namespace

ground_station::Action read_declare_lost(const Reader& reader, TaskContext& context) {
  return ground_station::DeclareLost{read_declared(reader, context)};
}

ground_station::Action read_declare_found(const Reader& reader, TaskContext& context) {
  return ground_station::DeclareFound{read_declared(reader, context)};
}

ground_station::OnTeamTask read_on_team_task(const Reader& reader, TaskContext& context) {
  reader.keys({"id", "stage"});
  ground_station::OnTeamTask on;
  const Reader id = reader.required("id");
  on.task = GoalId(read_number(id));
  if (id.present()) context.references.push_back({id, "", on.task.value(), true});
  on.stage = static_cast<auction::Stage>(
      reader.required("stage").choice({"for-sale", "owned", "granted", "done", "unsold"}));
  return on;
}

ground_station::OnGlobalMission read_on_global_mission(const Reader& reader, TaskContext& context) {
  reader.keys({"id", "state"});
  ground_station::OnGlobalMission on;
  const Reader id = reader.required("id");
  on.mission = MissionId(read_number(id));
  if (id.present()) context.references.push_back({id, "", on.mission.value(), false});
  on.stage = static_cast<ground_station::GlobalStage>(
      reader.required("state").choice({"refused", "given", "done"}));
  return on;
}

}  // namespace skein::scenario
