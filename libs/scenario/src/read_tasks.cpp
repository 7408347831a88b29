// SPDX-License-Identifier: Apache-2.0
#include "read_tasks.hpp"

#include <numbers>

#include "skein/functional/task_types.hpp"

namespace skein::scenario {

namespace {

using config::Reader;
using executive::Literal;
using ground_station::Target;

constexpr config::Range kAngle{-2 * std::numbers::pi, 2 * std::numbers::pi, "rad"};
constexpr config::Range kAltitude{0, 10'000, "m above the ground"};

Literal read_literal(const Reader& reader) {
  Literal literal;
  if (reader.optional("task").present()) {
    reader.keys({"task", "state", "not", "modality"});
    literal.condition = executive::TaskInState{read_task_id(reader.required("task")),
                                               read_task_state(reader.required("state"))};
  } else if (const Reader message = reader.optional("message"); message.present()) {
    reader.keys({"message", "not", "modality"});
    literal.condition = executive::MessageReceived{message.text()};
  } else if (const Reader time = reader.optional("time"); time.present()) {
    reader.keys({"time", "is", "not", "modality"});
    const bool passed = reader.required("is").choice({"passed", "not-yet-passed"}) == 0;
    literal.condition = executive::TimeIs{read_instant(time), passed};
  } else {
    reader.keys({"task", "message", "time", "state", "is", "not", "modality"});
    reader.error("a condition of no kind", "one of task, message, time");
  }
  literal.negated = reader.optional("not").boolean(false);
  const bool optional = reader.optional("modality").choice({"mandatory", "optional"}) == 1;
  literal.modality = optional ? executive::Modality::kOptional : executive::Modality::kMandatory;
  return literal;
}

executive::InsertionMode read_mode(const Reader& reader) {
  return static_cast<executive::InsertionMode>(reader.choice({"SEQ", "VUT", "DEP", "NUT"}));
}

// A place by name, or coordinates.
world::Vector3 read_place(const Reader& reader, const TaskContext& context) {
  if (reader.is_sequence()) return read_point(reader);
  const std::string name = reader.name_among(context.names.places, "a place or [x, y, z]");
  const auto found = context.scenario.world.places.find(name);
  return found == context.scenario.world.places.end() ? world::Vector3::Zero() : found->second;
}

// `altitude`, if given, puts a point at that height above the ground there.
world::Vector3 at_altitude(world::Vector3 point, const Reader& altitude,
                           const TaskContext& context) {
  if (altitude.present()) {
    point.z() = context.terrain.elevation(point.x(), point.y()) + altitude.number(0, kAltitude);
  }
  return point;
}

}  // namespace

std::vector<world::Vector3> read_points(const Reader& params, const TaskContext& context) {
  std::vector<world::Vector3> points;
  const Reader altitude = params.optional("altitude");
  const Reader to = params.optional("to");
  const bool several = to.is_sequence() && !to.items().empty() && !to.items()[0].is_scalar();
  if (several) {
    for (const Reader& one : items_of(to)) {
      points.push_back(at_altitude(read_place(one, context), altitude, context));
    }
  } else {
    points.push_back(at_altitude(read_place(to, context), altitude, context));
  }
  return points;
}

namespace {

Target to_points(const Reader& params, const TaskContext& context) {
  return {ground_station::AtPoints{read_points(params, context)}, "waypoints"};
}

Target over_zone(const Reader& reader, const TaskContext& context) {
  reader.keys({"zone", "spacing", "altitude", "around_alarm"});
  ground_station::OverZone over;
  const std::string zone = reader.required("zone").name_among(context.names.zones, "a zone");
  for (const world::Zone& one : context.scenario.world.zones) {
    if (one.name == zone) over.zone = one.polygon;
  }
  over.spacing = reader.required("spacing").number(1, {1, 100'000, "m"});
  over.altitude = reader.required("altitude").number(0, kAltitude);
  over.around_alarm = reader.optional("around_alarm").boolean(false);
  return {over, "waypoints"};
}

Target take_aim(const Reader& reader, const TaskContext& context) {
  if (reader.is_scalar() && reader.text() == "alarm") return {ground_station::TheAlarm{}, "target"};
  return {ground_station::AtPoints{{read_place(reader, context)}}, "target"};
}

std::vector<Target> read_targets(const Reader& params, const TaskContext& context) {
  std::vector<Target> targets;
  if (params.optional("to").present()) targets.push_back(to_points(params, context));
  if (const Reader near = params.optional("near_alarm"); near.present()) {
    targets.push_back({read_near_alarm(near), "waypoints"});
  }
  if (const Reader over = params.optional("over"); over.present()) {
    targets.push_back(over_zone(over, context));
  }
  if (targets.size() > 1) params.error("more than one of to, near_alarm, over");
  if (const Reader target = params.optional("target"); target.present()) {
    targets.push_back(take_aim(target, context));
  }
  return targets;
}

executive::Parameter read_parameter(const std::string& name, const Reader& reader) {
  if (reader.is_sequence()) return {name, "", reader.numbers()};
  if (const auto number = number_in(reader)) return {name, "", {*number}};
  return {name, reader.text(), {}};
}

void check_device(const Reader& device, const std::string& uav, const TaskContext& context) {
  const UavSpec* spec = context.scenario.find_uav(uav);
  if (spec == nullptr || spec->model.name.empty()) return;  // reported already
  std::vector<std::string> devices;
  for (const world::SensorModel& sensor : spec->model.sensors) devices.push_back(sensor.device);
  (void)device.name_among(devices, "a device of " + uav);
}

// Ids are unique within a UAV for the whole mission; one given twice in one script is a mistake
// that would only show in flight.
void check_id(const Reader& reader, executive::TaskId id, const std::string& uav,
              TaskContext& context) {
  if (uav.empty() || !reader.present() || context.planned.emplace(uav, id).second) return;
  reader.error("task " + to_text(id) + " of " + uav + " is planned twice",
               "ids that are unique for the whole mission");
}

// The parameters that go to the UAV as they are written.
void read_parameters(const Reader& params, executive::Parameters& parameters) {
  const bool resolved = params.optional("to").present();
  for (const auto& [name, value] : entries_of(params)) {
    if (name == "to" || name == "near_alarm" || name == "over" || name == "target") continue;
    if (name == "altitude" && resolved) continue;
    parameters.add(read_parameter(name, value));
  }
}

void read_synchronisation(const Reader& params, const TaskContext& context, executive::Task& task) {
  params.keys({"id", "senders", "receivers", "deadline"});
  executive::Synchronisation sync;
  sync.id = params.required("id").natural();
  for (const Reader& uav : items_of(params.required("senders"))) {
    sync.senders.push_back(uav.name_among(context.names.uavs, "a UAV"));
  }
  for (const Reader& uav : items_of(params.required("receivers"))) {
    sync.receivers.push_back(uav.name_among(context.names.uavs, "a UAV"));
  }
  const Reader deadline = params.optional("deadline");
  if (deadline.present()) sync.deadline = read_instant(deadline);
  task.synchronisation = std::move(sync);
}

void check_type(const Reader& type, const std::string& name) {
  const functional::TaskTypes& types = functional::TaskTypes::shipped();
  if (types.of(name).is_joint()) {
    type.error("joint tasks need a deliberative layer, degree 4 or 5");
  } else {
    (void)type.name_among(types.names(), "a task type");
  }
}

}  // namespace

ground_station::NearAlarm read_near_alarm(const Reader& reader) {
  reader.keys({"bearing", "distance", "altitude"});
  return {reader.required("bearing").number(0, kAngle),
          reader.required("distance").number(0, {0, 100'000, "m"}),
          reader.required("altitude").number(0, kAltitude)};
}

std::optional<double> number_in(const Reader& reader) {
  if (!reader.is_scalar()) return std::nullopt;
  config::Value scalar;
  scalar.kind = config::Value::Kind::kScalar;
  scalar.scalar = reader.text();
  Diagnostics not_a_number;
  const double number = Reader(scalar, "", not_a_number).number();
  return not_a_number.empty() ? std::optional(number) : std::nullopt;
}

executive::TaskId read_task_id(const Reader& reader) {
  const std::uint64_t id = reader.natural();
  if (id >= executive::kFirstBackgroundId.value()) reader.error("too large for a task id");
  return executive::TaskId(id);
}

executive::TaskState read_task_state(const Reader& reader) {
  return static_cast<executive::TaskState>(
      reader.choice({"scheduled", "started", "running", "aborting", "ended", "aborted"}));
}

executive::Formula read_formula(const Reader& reader) {
  executive::Formula formula;
  for (const Reader& clause : items_of(reader)) {
    executive::Clause literals;
    for (const Reader& literal : items_of(clause)) literals.push_back(read_literal(literal));
    formula.push_back(std::move(literals));
  }
  return formula;
}

ground_station::PlannedTask read_task(const Reader& reader, const std::string& uav,
                                      TaskContext& context) {
  ground_station::PlannedTask planned;
  reader.keys({"id", "type", "mode", "params", "pre", "exit"});
  executive::Task& task = planned.task;
  task.id = read_task_id(reader.required("id"));
  check_id(reader.optional("id"), task.id, uav, context);
  task.type = reader.required("type").text();
  check_type(reader.optional("type"), task.type);
  planned.mode = read_mode(reader.optional("mode"));
  task.preconditions = read_formula(reader.optional("pre"));
  task.exit = read_formula(reader.optional("exit"));
  const Reader params = reader.optional("params");
  if (functional::TaskTypes::shipped().of(task.type).synchronises()) {
    read_synchronisation(reader.required("params"), context, task);
  } else if (params.present()) {
    planned.targets = read_targets(params, context);
    read_parameters(params, task.parameters);
    check_device(params.optional("device"), uav, context);
  }
  return planned;
}

}  // namespace skein::scenario
