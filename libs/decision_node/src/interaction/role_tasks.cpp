// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_tasks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "interaction/sightings.hpp"
#include "path_query.hpp"
#include "skein/elementary/parameter_reader.hpp"
#include "skein/world/landing_ground.hpp"

namespace skein::decision_node {

namespace {

using interaction::Position;

constexpr double kNear = 1;  // [m]
/// Between two who come to one place [m]: what they keep from each other, and how far each of them
/// strays while it comes down.
constexpr double kBeside = 30;
constexpr double kTouchesWithin = 3;  // [m]

Result<Argument, Failure> argument(const interaction::Task& task, const char* name,
                                   const RolePlay& play) {
  const config::Value* given = task.parameters.find(name);
  if (given == nullptr) return failure("it has no '" + std::string(name) + "'");
  return play.value(*given);
}

// ---- goto ----

/// Of a place that is given to several each has a place of its own, on a circle around it in the
/// order of their names: they come there together, and some land there. Whoever could not land on
/// its own comes to the middle.
Position own_place(const Argument& to, const Position& place, const RoleTaskContext& context) {
  const std::vector<std::string> all = context.play.given(to);
  const auto self = std::find(all.begin(), all.end(), context.play.self());
  if (all.size() < 2 || self == all.end()) return place;
  const double turn = 2 * std::numbers::pi / static_cast<double>(all.size());
  const double radius = kBeside / 2 / std::sin(turn / 2);
  const double angle = turn * static_cast<double>(self - all.begin());
  const world::Vector2 at(place[0] + radius * std::cos(angle), place[1] + radius * std::sin(angle));
  const world::Terrain& terrain = context.outlook.world.terrain;
  if (world::landing_problem(terrain, at, kTouchesWithin)) return place;
  const double rises = terrain.elevation(at.x(), at.y()) - terrain.elevation(place[0], place[1]);
  return {at.x(), at.y(), place[2] + rises};
}

/// Around what is in between.
Result<refiners::Way, Failure> way_to(const Position& place, const RoleTaskContext& context) {
  const refiners::PathQuery query =
      path_query(context.outlook.knowledge.vehicle, context.state.position, vector_of(place),
                 context.outlook.now);
  if ((query.to - query.from).norm() < kNear) return refiners::Way{query.to};
  const auto path = refine(query, refiners::Setting{context.outlook.world, {}});
  if (!path) return failure("no way there: " + path.error().why);
  return refiners::Way(path->task.way.begin() + 1, path->task.way.end());
}

Result<executive::Task, Failure> goto_of(const interaction::Task& role,
                                         const RoleTaskContext& context) {
  const auto to = argument(role, "to", context.play);
  if (!to) return tl::unexpected(to.error());
  const auto aim = aim_of(*to, context.outlook);
  if (!aim) return tl::unexpected(aim.error());
  const Position own = own_place(*to, *aim, context);
  auto way = way_to(own, context);
  if (!way && own != *aim) way = way_to(*aim, context);
  if (!way) return tl::unexpected(way.error());
  executive::Task task = flight_along(*way);
  if (const auto speed = argument(role, "speed", context.play);
      speed && std::holds_alternative<double>(*speed)) {
    task.parameters.add("speed", std::get<double>(*speed));
  }
  return task;
}

// ---- perceptions ----

Result<executive::Task, Failure> perception_of(const interaction::Task& role,
                                               const RoleTaskContext& context) {
  executive::Task task;
  task.type = "perceive";
  const world::VehicleModel& vehicle = context.outlook.knowledge.vehicle;
  const std::string device = device_of(context.play.model(), vehicle);
  if (device.empty()) return failure("it has nothing to perceive with");
  task.parameters.add("device", device);
  const auto target = argument(role, "target", context.play);
  if (target) {
    const auto* name = std::get_if<std::string>(&*target);
    const auto seen = name == nullptr ? std::nullopt : context.outlook.observer(*name);
    const auto* point = std::get_if<Position>(&*target);
    if (!seen && point == nullptr) return failure("nobody knows where its target is");
    const Position at = seen ? seen->position : *point;
    task.parameters.add("target", {at[0], at[1], at[2]});
  }
  task.parameters.add("duration", (duration_of(role, context.play) - context.done).to_seconds());
  return task;
}

// ---- meetings ----

// FNV-1a, cut to what is exact as a JSON number.
std::uint64_t number_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char one : text) {
    hash = (hash ^ static_cast<unsigned char>(one)) * 1099511628211ULL;
  }
  return hash >> 12U;
}

std::size_t rank_of(const std::string& id, const interaction::Automaton& automaton) {
  std::size_t rank = 0;
  for (const interaction::Componel& one : automaton.componels()) {
    if (one.id == id) return rank;
    if (one.task() != nullptr && is_meeting(*one.task())) ++rank;
  }
  return rank;
}

Result<executive::Task, Failure> meeting_of(const interaction::Componel& componel,
                                            const std::string& subject,
                                            const RoleTaskContext& context) {
  executive::Task task;
  task.type = "rendezvous";
  executive::Synchronisation& sync = task.synchronisation.emplace();
  const std::size_t rank = rank_of(componel.id, context.play.automaton());
  const Holders& holders = context.play.holders();
  for (const auto& [name, into] :
       {std::pair("senders", &sync.senders), std::pair("receivers", &sync.receivers)}) {
    const auto uavs = argument(*componel.task(), name, context.play);
    if (!uavs) return tl::unexpected(uavs.error());
    const auto* names = std::get_if<std::vector<std::string>>(&*uavs);
    if (names == nullptr) return failure("its " + std::string(name) + " are no UAVs");
    *into = *names;
    std::erase_if(*into, [&](const std::string& uav) { return !holders.contains(uav); });
  }
  std::string who;
  for (const auto& [uav, role] : holders) who += "/" + uav;
  sync.id = number_of(subject + "/" + context.allocation + "/" + std::to_string(rank) + who);
  return task;
}

}  // namespace

bool is_meeting(const interaction::Task& task) {
  return task.type == "synchro" || task.type == "wait-until-synchro";
}

bool is_mapping(const interaction::Task& task) { return task.type == kMapArea; }

std::optional<world::Polygon> zone_of(const config::Value& named, const Arguments& scope,
                                      const world::World& world) {
  const auto value = value_of(named, scope);
  const auto* name = value ? std::get_if<std::string>(&*value) : nullptr;
  if (name == nullptr) return std::nullopt;
  const auto found = std::find_if(world.zones.begin(), world.zones.end(),
                                  [&](const world::Zone& zone) { return zone.name == *name; });
  return found == world.zones.end() ? std::nullopt : std::optional(found->polygon);
}

executive::Task flight_along(const refiners::Way& way) {
  executive::Task task;
  task.type = "goto";
  task.parameters.add(elementary::points_parameter("waypoints", way));
  return task;
}

executive::Task look_along(executive::TaskId flight, const std::string& device) {
  using executive::TaskInState;
  using executive::TaskState;
  const auto when = [&](TaskState state) {
    return executive::Literal{TaskInState{flight, state}, false, executive::Modality::kMandatory};
  };
  executive::Task task;
  task.type = "takeshot";
  task.parameters.add("device", device);
  task.preconditions = {{when(TaskState::kRunning)}};
  task.exit = {{when(TaskState::kEnded), when(TaskState::kAborted)}};
  return task;
}

Duration duration_of(const interaction::Task& task, const RolePlay& play) {
  const auto seconds = argument(task, "duration", play);
  const double* number = seconds ? std::get_if<double>(&*seconds) : nullptr;
  return number == nullptr ? Duration() : Duration::seconds(*number);
}

Result<executive::Task, Failure> make_task(const interaction::Componel& componel,
                                           const std::string& subject,
                                           const RoleTaskContext& context) {
  const interaction::Task& role = *componel.task();
  if (role.type == "goto") return goto_of(role, context);
  if (role.type == "takeshot-while-waiting") return perception_of(role, context);
  if (is_meeting(role)) return meeting_of(componel, subject, context);
  return failure("nobody carries out '" + role.type + "'");
}

}  // namespace skein::decision_node
