// SPDX-License-Identifier: Apache-2.0
// What the ground asks of a UAV beyond elementary tasks: missions, degrees, closed air.
#include "skein/translation/missions.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/alarm_name.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/world/polygon_check.hpp"

namespace skein::translation {

namespace {

// The enumerations of both sides list the same values in the same order.
static_assert(static_cast<int>(wire::MissionPlacement::kFirst) ==
              static_cast<int>(mission::Placement::kFirst));
static_assert(static_cast<int>(wire::RequestKind::kWorld) ==
              static_cast<int>(mission::RequestKind::kWorld));

constexpr double kNoLevel = 1e9;  ///< [m] in place of infinity

tl::unexpected<wire::Violation> wrong(std::string field, std::string why) {
  return tl::unexpected<wire::Violation>({std::move(field), std::move(why)});
}

std::string at(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::int64_t to_wire(const std::optional<MissionTime>& instant) {
  return instant ? instant->count() : wire::kNoInstant;
}

std::optional<MissionTime> instant_of(std::int64_t count) {
  if (count == wire::kNoInstant) return std::nullopt;
  return MissionTime::nanoseconds(count);
}

// ---- high-level tasks ----

wire::Parameter to_wire(const mission::Argument& argument) {
  return std::visit(Overloaded{[](const std::string& name) {
                                 return wire::Parameter{"name", name, {}};
                               },
                               [](double number) {
                                 return wire::Parameter{"number", "", {number}};
                               },
                               [](const world::Vector3& v) {
                                 return wire::Parameter{"location", "", {v.x(), v.y(), v.z()}};
                               },
                               [](const std::vector<std::string>& names) {
                                 return wire::Parameter{"names", joined(names, " "), {}};
                               }},
                    argument);
}

Result<mission::Argument, std::string> argument_of(const wire::Parameter& argument) {
  const std::vector<double>& n = argument.numbers;
  if (argument.name == "name") return argument.text;
  if (argument.name == "names") return words_of(argument.text);
  if (argument.name == "number") {
    if (n.size() != 1) return tl::unexpected<std::string>("a number has 1 number");
    return n[0];
  }
  if (argument.name == "location") {
    if (n.size() != 3) return tl::unexpected<std::string>("a location has 3 numbers");
    return world::Vector3(n[0], n[1], n[2]);
  }
  return tl::unexpected<std::string>("'" + argument.name + "' is not a kind of argument");
}

wire::MissionTask wire_task(const mission::HighLevelTask& task) {
  wire::MissionTask result;
  result.id = task.id.value();
  result.name = task.name;
  for (const mission::Argument& one : task.arguments) result.arguments.push_back(to_wire(one));
  result.start_before = to_wire(task.time.start_before);
  result.start_after = to_wire(task.time.start_after);
  result.end_before = to_wire(task.time.end_before);
  result.end_after = to_wire(task.time.end_after);
  for (const mission::GoalBound& one : task.after) {
    result.after.push_back({one.goal.value(), one.on_end, one.least.count(), one.most.count()});
  }
  return result;
}

Read<mission::HighLevelTask> task_of(const wire::MissionTask& task, const std::string& path) {
  if (task.id == 0) return wrong(path + ".id", "0 is not an id");
  mission::HighLevelTask result;
  result.id = mission::GoalId(task.id);
  result.name = task.name;
  for (std::size_t i = 0; i < task.arguments.size(); ++i) {
    auto argument = argument_of(task.arguments[i]);
    if (!argument) return wrong(at(path + ".arguments", i), argument.error());
    result.arguments.push_back(std::move(*argument));
  }
  result.time = {instant_of(task.start_before), instant_of(task.start_after),
                 instant_of(task.end_before), instant_of(task.end_after)};
  for (std::size_t i = 0; i < task.after.size(); ++i) {
    const wire::GoalBound& one = task.after[i];
    if (one.goal == 0) return wrong(at(path + ".after", i) + ".goal", "0 is not an id");
    result.after.push_back({mission::GoalId(one.goal), one.on_end, Duration::nanoseconds(one.least),
                            Duration::nanoseconds(one.most)});
  }
  return result;
}

Read<mission::UnitMission> mission_of(const wire::MissionRequest& request) {
  if (request.unit_mission == 0) return wrong("unit_mission", "0 is not an id");
  if (!request.goals.empty()) return wrong("goals", "are for cancelling");
  mission::UnitMission result;
  result.id = mission::MissionId(request.unit_mission);
  result.placement = static_cast<mission::Placement>(request.placement);
  result.interrupt = request.interrupt;
  result.any = request.achieve_any;
  result.asked_by = request.asked_by;
  result.evaluate = request.evaluate;
  for (std::size_t i = 0; i < request.tasks.size(); ++i) {
    auto task = task_of(request.tasks[i], at("tasks", i));
    if (!task) return tl::unexpected(task.error());
    result.tasks.push_back(std::move(*task));
  }
  return result;
}

Read<mission::CancelGoals> cancellation_of(const wire::MissionRequest& request) {
  if (!request.tasks.empty()) return wrong("tasks", "what is cancelled is named by goals");
  mission::CancelGoals result;
  result.mission = mission::MissionId(request.unit_mission);
  result.interrupt = request.interrupt;
  for (std::size_t i = 0; i < request.goals.size(); ++i) {
    if (request.goals[i] == 0) return wrong(at("goals", i), "0 is not an id");
    result.goals.emplace_back(request.goals[i]);
  }
  return result;
}

}  // namespace

std::string to_text(const wire::Violation& violation) {
  return violation.field + ": " + violation.why;
}

wire::MissionTask to_wire(const mission::HighLevelTask& task) { return wire_task(task); }

Read<mission::HighLevelTask> from_wire(const wire::MissionTask& task, const std::string& path) {
  return task_of(task, path);
}

wire::RequestKind to_wire(mission::RequestKind kind) {
  return static_cast<wire::RequestKind>(kind);
}

mission::RequestKind from_wire(wire::RequestKind kind) {
  return static_cast<mission::RequestKind>(kind);
}

wire::MissionRequest to_wire(const mission::UnitMission& mission) {
  wire::MissionRequest result;
  result.unit_mission = mission.id.value();
  result.placement = static_cast<wire::MissionPlacement>(mission.placement);
  result.interrupt = mission.interrupt;
  result.achieve_any = mission.any;
  result.asked_by = mission.asked_by;
  result.evaluate = mission.evaluate;
  for (const mission::HighLevelTask& task : mission.tasks) result.tasks.push_back(wire_task(task));
  return result;
}

wire::MissionRequest to_wire(const mission::CancelGoals& cancel, const std::string& asked_by) {
  wire::MissionRequest result;
  result.cancel = true;
  result.unit_mission = cancel.mission.value();
  result.interrupt = cancel.interrupt;
  result.asked_by = asked_by;
  for (const mission::GoalId goal : cancel.goals) result.goals.push_back(goal.value());
  return result;
}

Read<std::variant<mission::UnitMission, mission::CancelGoals>> from_wire(
    const wire::MissionRequest& request) {
  if (request.cancel) return cancellation_of(request);
  return mission_of(request);
}

// ---- degree ----

wire::DegreeCommand to_wire(const mission::ChangeDegree& change, const std::string& asked_by) {
  wire::DegreeCommand command;
  command.degree = static_cast<std::uint8_t>(change.degree);
  command.interrupt = change.interrupt;
  command.resume = change.resume;
  command.asked_by = asked_by;
  return command;
}

Read<mission::ChangeDegree> from_wire(const wire::DegreeCommand& command) {
  const int degree = command.degree;
  if (degree < mission::kLeastDegree || degree > mission::kGreatestDegree) {
    return wrong("degree", std::to_string(degree) + " is not a degree from 1 to 5");
  }
  return mission::ChangeDegree{degree, command.interrupt, command.resume};
}

// ---- the world ----

namespace {

std::vector<double> corners_of(const world::Polygon& polygon) {
  std::vector<double> corners;
  for (const world::Vector2& corner : polygon) {
    corners.push_back(corner.x());
    corners.push_back(corner.y());
  }
  return corners;
}

Read<world::Polygon> polygon_of(const wire::WorldChange& change) {
  if (change.corners.size() % 2 != 0) return wrong("corners", "not pairs of numbers");
  world::Polygon polygon;
  for (std::size_t i = 0; i < change.corners.size(); i += 2) {
    polygon.emplace_back(change.corners[i], change.corners[i + 1]);
  }
  if (const auto why = world::problem_of(polygon)) return wrong("corners", *why);
  return polygon;
}

wire::CellChange cells_to_wire(const std::optional<world::CellState>& cells) {
  return cells ? static_cast<wire::CellChange>(static_cast<int>(*cells) + 1)
               : wire::CellChange::kAsBefore;
}

std::optional<world::CellState> cells_from_wire(wire::CellChange cells) {
  if (cells == wire::CellChange::kAsBefore) return std::nullopt;
  return static_cast<world::CellState>(static_cast<int>(cells) - 1);
}
static_assert(static_cast<int>(wire::CellChange::kFire) ==
              static_cast<int>(world::CellState::kFire) + 1);

void put(const world::Volume& volume, wire::WorldChange& result) {
  result.name = volume.name;
  result.corners = corners_of(volume.polygon);
  result.floor = std::max(volume.floor, -kNoLevel);
  result.ceiling = std::min(volume.ceiling, kNoLevel);
  result.from = volume.when.from.count();
  result.until = volume.when.until.count();
}

Read<mission::ChangeWorld> volume_from(const wire::WorldChange& change) {
  mission::ChangeWorld result;
  result.remove = change.remove;
  result.volume.name = change.name;
  if (change.remove) return result;
  auto polygon = polygon_of(change);
  if (!polygon) return tl::unexpected(polygon.error());
  if (change.floor >= change.ceiling) return wrong("ceiling", "not above the floor");
  if (change.from >= change.until) return wrong("until", "not later than from");
  result.volume.polygon = std::move(*polygon);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  result.volume.floor = change.floor <= -kNoLevel ? -kInfinity : change.floor;
  result.volume.ceiling = change.ceiling >= kNoLevel ? kInfinity : change.ceiling;
  result.volume.when = {MissionTime::nanoseconds(change.from),
                        MissionTime::nanoseconds(change.until)};
  return result;
}

Read<mission::ChangeWorld> ground_from(const wire::WorldChange& change) {
  auto polygon = polygon_of(change);
  if (!polygon) return tl::unexpected(polygon.error());
  if (change.risk > 1) return wrong("risk", "above 1");
  mission::ChangeWorld result;
  result.ground = {change.name, std::move(*polygon),
                   change.risk < 0 ? std::nullopt : std::optional(change.risk), change.mapped,
                   cells_from_wire(change.cells)};
  return result;
}

}  // namespace

wire::WorldChange to_wire(const mission::ChangeWorld& change) {
  wire::WorldChange result;
  if (change.place) {
    result.part = wire::WorldPart::kPlace;
    result.name = change.place->name;
    result.at = to_wire(change.place->at);
    result.radius = change.place->radius;
    result.cells = cells_to_wire(change.place->cells);
  } else if (change.ground) {
    result.part = wire::WorldPart::kGround;
    result.name = change.ground->name;
    result.corners = corners_of(change.ground->area);
    result.risk = change.ground->risk.value_or(-1);
    result.mapped = change.ground->mapped;
    result.cells = cells_to_wire(change.ground->cells);
  } else {
    result.remove = change.remove;
    if (change.remove) result.name = change.volume.name;
    if (!change.remove) put(change.volume, result);
  }
  return result;
}

mission::ChangeWorld change_of(const wire::Alarm& alarm) {
  mission::ChangeWorld result;
  auto cells = world::CellState::kAlarm;
  if (alarm.state == wire::AlarmState::kConfirmed) cells = world::CellState::kFire;
  if (alarm.state == wire::AlarmState::kInfirmed) cells = world::CellState::kQuiet;
  result.place = {mission::name_of_alarm(alarm.id), from_wire(alarm.position), alarm.radius, cells,
                  alarm.seen == wire::kNever ? std::nullopt
                                             : std::optional(MissionTime::nanoseconds(alarm.seen))};
  return result;
}

mission::ChangeWorld change_of(const wire::SeenObject& object) {
  mission::ChangeWorld result;
  result.place = {object.name, from_wire(object.at), object.spread, std::nullopt,
                  MissionTime::nanoseconds(object.seen)};
  return result;
}

Read<mission::ChangeWorld> from_wire(const wire::WorldChange& change) {
  if (change.part == wire::WorldPart::kPlace) {
    if (change.name.empty()) return wrong("name", "a place has a name");
    mission::ChangeWorld result;
    result.place = {change.name, from_wire(change.at), change.radius,
                    cells_from_wire(change.cells)};
    return result;
  }
  if (change.part == wire::WorldPart::kGround) return ground_from(change);
  if (change.name.empty()) return wrong("name", "a volume has a name");
  return volume_from(change);
}

}  // namespace skein::translation
