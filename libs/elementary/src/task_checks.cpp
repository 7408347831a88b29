// SPDX-License-Identifier: Apache-2.0
#include "skein/elementary/task_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "skein/elementary/parameter_reader.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/world/landing_ground.hpp"
#include "skein/world/way_energy.hpp"

namespace skein::elementary {
namespace {

using world::Vector3;

constexpr double kMostShots = 1e6;
constexpr double kLongest = 1e6;  // [s]

/// What may still be used in flight [J]; negative below the reserve.
double spare_energy(const Situation& s) {
  return (s.state.energy - s.model.energy.reserve) * s.model.energy.capacity;
}

void need_energy(const Situation& s, double joules, const std::string& what,
                 ParameterReader& read) {
  const double spare = spare_energy(s);
  if (joules <= spare) return;
  read.refuse("energy too low for " + what + ": it takes " + figure(joules / 1e3) + " kJ, " +
              figure(std::max(0.0, spare) / 1e3) + " kJ are left above the reserve");
}

void need_flight(const Situation& s, const std::string& what, ParameterReader& read) {
  if (!s.engine_works) read.refuse("engine failure");
  if (s.model.ground) return;
  if (!s.state.airborne) read.refuse(what + " before takeoff: the vehicle is on the ground");
}

std::optional<Duration> read_duration(ParameterReader& read) {
  const auto duration = read.number("duration");
  if (!duration) return std::nullopt;
  if (*duration > 0 && *duration <= kLongest) return Duration::seconds(*duration);
  read.refuse("duration must be greater than 0 s and at most " + figure(kLongest) + " s");
  return std::nullopt;
}

constexpr const char* kKeepsToGround = "it keeps to the ground";

ElementaryTask read_takeoff(const Situation& s, ParameterReader& read) {
  if (s.model.ground) {
    read.refuse(kKeepsToGround);
    return TakeoffTask{};
  }
  const double altitude = read.number("altitude").value_or(s.model.ceiling / 2);
  if (!read.has("altitude")) read.refuse("altitude is missing");
  if (altitude < kLeastHeight || altitude > s.model.ceiling)
    read.refuse("altitude " + figure(altitude) + " m is not between " + figure(kLeastHeight) +
                " m and the ceiling of " + figure(s.model.ceiling) + " m above ground");
  if (!s.engine_works) read.refuse("engine failure");
  if (s.state.airborne) read.refuse("already in the air");
  const double time = std::max(0.0, altitude) / s.model.climb_rate;
  need_energy(s, time * world::flight_power(s.model, 0, s.model.climb_rate), "the takeoff", read);
  const Vector3& at = s.state.position;
  return TakeoffTask{s.terrain.elevation(at.x(), at.y()) + altitude};
}

ElementaryTask read_land(const Situation& s, ParameterReader& read) {
  if (s.model.ground) read.refuse(kKeepsToGround);
  if (!s.state.airborne) read.refuse("already on the ground");
  const Vector3& at = s.state.position;
  if (const auto problem = world::landing_problem(s.terrain, at.head<2>())) read.refuse(*problem);
  return LandTask{};
}

void check_waypoint(const Situation& s, const Vector3& point, const std::string& name,
                    ParameterReader& read) {
  if (!s.terrain.contains(point.x(), point.y())) {
    read.refuse(name + " is outside the terrain");
    return;
  }
  if (s.model.ground) return;
  const double height = point.z() - s.terrain.elevation(point.x(), point.y());
  if (height < 0)
    read.refuse(name + " is " + figure(-height) + " m under the ground");
  else if (height < kLeastHeight)
    read.refuse(name + " is only " + figure(height) + " m above the ground, less than " +
                figure(kLeastHeight) + " m");
  if (height > s.model.ceiling)
    read.refuse(name + " is " + figure(height) + " m above the ground, over the ceiling of " +
                figure(s.model.ceiling) + " m");
}

/// From ground that is too steep it may drive off.
void check_slopes(const Situation& s, const std::vector<Vector3>& way, ParameterReader& read) {
  const double step = s.terrain.spec().cell / 4;
  Vector3 from = s.state.position;
  bool is_off = false;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double length = (way[i] - from).head<2>().norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 0; k <= pieces; ++k) {
      const Vector3 at = from + (way[i] - from) * (static_cast<double>(k) / pieces);
      const bool steep = s.terrain.slope(at.x(), at.y()) > s.model.ground->steepest;
      if (is_off && steep)
        return read.refuse("the way to way-point " + std::to_string(i + 1) +
                           " is too steep for it at (" + figure(at.x()) + ", " + figure(at.y()) +
                           ")");
      is_off = is_off || !steep;
    }
    from = way[i];
  }
}

void check_legs(const Situation& s, const std::vector<Vector3>& way, ParameterReader& read) {
  if (s.model.ground) return check_slopes(s, way, read);
  Vector3 from = s.state.position;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (const auto hit = s.terrain.first_hit(from, way[i])) {
      const Vector3 at = from + *hit * (way[i] - from);
      read.refuse("the way to way-point " + std::to_string(i + 1) + " meets the ground at (" +
                  figure(at.x()) + ", " + figure(at.y()) + ")");
    }
    from = way[i];
  }
}

/// Whatever heights are given, one that drives is on the ground there.
std::vector<Vector3> read_waypoints(const Situation& s, ParameterReader& read) {
  std::vector<Vector3> way = read.points("waypoints");
  if (s.model.ground)
    for (Vector3& at : way) at.z() = s.terrain.elevation(at.x(), at.y());
  return way;
}

ElementaryTask read_goto(const Situation& s, ParameterReader& read) {
  GotoTask task{read_waypoints(s, read), read.number("speed").value_or(s.model.cruise_speed)};
  if (!read.has("waypoints")) read.refuse("waypoints is missing");
  const bool speed_known = task.speed > 0 && task.speed >= s.model.min_speed;
  if (!speed_known || task.speed > s.model.max_speed)
    read.refuse("speed " + figure(task.speed) + " m/s is not within what it can " +
                (s.model.ground ? "drive" : "fly") + ", " +
                (s.model.hovers ? "more than 0" : figure(s.model.min_speed)) + " to " +
                figure(s.model.max_speed) + " m/s");
  for (std::size_t i = 0; i < task.waypoints.size(); ++i)
    check_waypoint(s, task.waypoints[i], "way-point " + std::to_string(i + 1), read);
  need_flight(s, "goto", read);
  if (!read.refused()) check_legs(s, task.waypoints, read);
  if (speed_known)
    need_energy(s, world::energy_asked_for(s.model, s.state.position, task.waypoints, task.speed),
                "the way", read);
  return task;
}

void check_stay(const Situation& s, const std::optional<Duration>& duration, const char* what,
                ParameterReader& read) {
  if (!s.engine_works) read.refuse("engine failure");
  if (duration && (s.state.airborne || s.model.ground))
    need_energy(s, duration->to_seconds() * world::flight_power(s.model, s.model.min_speed, 0),
                what, read);
}

ElementaryTask read_wait(const Situation& s, ParameterReader& read) {
  const WaitTask task{read_duration(read)};
  check_stay(s, task.duration, "the wait", read);
  return task;
}

void check_device(const Situation& s, const std::string& device, ParameterReader& read) {
  if (world::find_sensor(s.model, device) != nullptr) return;
  std::vector<std::string> devices;
  for (const world::SensorModel& sensor : s.model.sensors) devices.push_back(sensor.device);
  read.refuse("no device '" + device + "' on board" + did_you_mean(nearest_name(device, devices)));
}

TakeshotTask read_shot(const Situation& s, ParameterReader& read) {
  TakeshotTask task;
  if (const auto device = read.text("device")) {
    check_device(s, *device, read);
    task.device = *device;
  } else if (!read.has("device")) {
    read.refuse("device is missing");
  }
  const std::vector<Vector3> target = read.points("target");
  if (target.size() > 1) read.refuse("target must be one point");
  if (target.size() == 1) task.target = target.front();
  if (task.target && !s.terrain.contains(task.target->x(), task.target->y()))
    read.refuse("target is outside the terrain");
  task.duration = read_duration(read);
  if (const auto shots = read.number("shots")) {
    if (*shots >= 1 && *shots <= kMostShots && *shots == std::floor(*shots))
      task.shots = static_cast<std::uint64_t>(*shots);
    else
      read.refuse("shots must be a whole number from 1 to " + figure(kMostShots));
  }
  return task;
}

ElementaryTask read_takeshot(const Situation& s, ParameterReader& read) {
  return read_shot(s, read);
}

ElementaryTask read_monitor(const Situation& s, ParameterReader& read) {
  PerceiveTask task{read_shot(s, read)};
  check_stay(s, task.shot.duration, "the perception", read);
  return task;
}

ElementaryTask read_perceive(const Situation& s, ParameterReader& read) {
  if (!read.has("duration")) read.refuse("duration is missing");
  return read_monitor(s, read);
}

using Read = ElementaryTask (*)(const Situation&, ParameterReader&);

const std::map<std::string, Read>& behaviours() {
  static const std::map<std::string, Read> all = {
      {"takeoff", read_takeoff}, {"land", read_land},         {"goto", read_goto},
      {"wait", read_wait},       {"takeshot", read_takeshot}, {"perceive", read_perceive},
      {"monitor", read_monitor}};
  return all;
}

std::string unknown(const std::string& type) {
  std::vector<std::string> known;
  for (const auto& [name, behaviour] : behaviours()) known.push_back(name);
  return "unknown task type '" + type + "'" + did_you_mean(nearest_name(type, known));
}

}  // namespace

Result<ElementaryTask, Failure> checked_task(const std::string& type,
                                             const functional::Parameters& parameters,
                                             const Situation& situation) {
  const auto behaviour = behaviours().find(type);
  if (behaviour == behaviours().end()) return failure(unknown(type));
  ParameterReader read(parameters);
  const auto& declared = functional::TaskTypes::shipped().of(type).parameters;
  if (declared) read.names(*declared);
  ElementaryTask task = behaviour->second(situation, read);
  if (read.refused()) return failure(read.reasons());
  return task;
}

}  // namespace skein::elementary
