// SPDX-License-Identifier: Apache-2.0
#include "testing/problem_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "flight/flight_times.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/duration_range.hpp"

namespace skein::supervisor::testing {

namespace {

/// Double precision: without the mark it would be read as single.
std::string figure(double value) {
  std::array<char, 40> buffer{};
  const bool whole = std::abs(value) < 1e15 && value == std::floor(value);
  const auto end = whole ? std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                         static_cast<std::int64_t>(value))
                         : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                         std::chars_format::fixed);
  std::string text(buffer.data(), end.ptr);
  return whole ? text : text + "d0";
}

/// A symbol; between bars what would be read as something else.
std::string symbol(const std::string& name) {
  bool plain = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0;
  for (const unsigned char c : name)
    plain = plain && c < 128 && (std::isalnum(c) != 0 || c == '-' || c == '_');
  if (plain) return name;
  std::string text = "|";
  for (const char c : name) {
    if (c == '|' || c == '\\') text += '\\';
    text += c;
  }
  return text + "|";
}

std::string location(const world::Vector3& at) {
  const auto part = [](double value) {
    const std::string text = figure(value);
    return text.ends_with("d0") ? text : text + ".0d0";
  };
  return "(loc " + part(at.x()) + " " + part(at.y()) + " " + part(at.z()) + ")";
}

std::string argument(const mission::Argument& value) {
  return std::visit(Overloaded{[](const std::string& name) { return symbol(name); },
                               [](double number) { return figure(number); },
                               [](const world::Vector3& at) { return location(at); },
                               [](const std::vector<std::string>& names) {
                                 std::string text;
                                 for (const std::string& name : names)
                                   text += (text.empty() ? "" : " ") + symbol(name);
                                 return "(" + text + ")";
                               }},
                    value);
}

std::string seconds(Duration duration) {
  return duration == Duration::max() ? "unlimited" : figure(duration.to_seconds());
}

std::string event(const std::optional<mission::Dependence>& after) {
  if (!after) return "end none";
  const char* kind = "end";
  if (after->kind == mission::DependenceKind::kOver) kind = "over";
  if (after->kind == mission::DependenceKind::kRunning) kind = "running";
  return std::string(kind) + " " + std::to_string(after->task.value());
}

std::string write_time(const std::string& resource, const Timeline& line) {
  return "   (my-write-time " + resource + " ((num " + seconds(line.free.least) + ") (num " +
         seconds(line.free.most) + ")) " + event(line.after) + ")\n";
}

std::string read_time(const std::string& resource, const Timeline& line = {}) {
  return "   (my-read-time " + resource + " ((num " + seconds(line.free.least) + ") (num " +
         seconds(line.free.most) + ")) " + event(line.after) + ")\n";
}

std::string device_facts(const world::SensorModel& sensor, const Situation& situation) {
  const std::string& device = sensor.device;
  const std::string name = "'" + symbol(device);
  if (situation.broken.contains(device)) return "   (perception-device broken " + name + ")\n";
  const auto line = situation.devices.find(device);
  const std::string resource = "perception-device " + name;
  std::string uses;
  for (const std::string& use : sensor.serves)
    uses += "   (device-serves " + symbol(device) + " " + symbol(use) + ")\n";
  return uses + "   (perception-device free " + name + ")\n" +
         write_time(resource, line == situation.devices.end() ? Timeline{} : line->second) +
         read_time(resource);
}

std::string whereabouts(const PlanningRequest& request) {
  const Situation& situation = request.situation;
  if (request.knowledge->vehicle.ground)
    return "(uavloc driving " + location(situation.position) + ")";
  if (situation.airborne) return "(uavloc flying " + location(situation.position) + ")";
  const world::Vector3 offset = situation.position - request.knowledge->home;
  const double near = 2 + arrival_distance(request.knowledge->vehicle, request.world->wind);
  return offset.head<2>().norm() <= near ? "(uavloc grounded home)"
                                         : "(uavloc grounded " + location(situation.position) + ")";
}

std::string constraints(const mission::TimeConstraints& time, MissionTime origin) {
  if (!time.any()) return "nil";
  std::string text;
  for (const auto& bound : {time.start_before, time.start_after, time.end_before, time.end_after})
    text += (text.empty() ? "" : " ") +
            (bound ? figure((*bound - origin).to_seconds()) : std::string("nil"));
  return "(" + text + ")";
}

bool is_duration(const mission::Vocabulary& vocabulary, const std::string& task,
                 std::size_t position) {
  const auto signature = vocabulary.tasks.find(task);
  return signature != vocabulary.tasks.end() && position < signature->second.parameters.size() &&
         signature->second.parameters[position] == mission::ParameterKind::kDuration;
}

// A duration that may be shorter is planned as long as may be.
std::string goal(const mission::HighLevelTask& task, const mission::Vocabulary& vocabulary,
                 MissionTime origin) {
  std::string text = "   (:task " + symbol(task.name);
  for (std::size_t i = 0; i < task.arguments.size(); ++i) {
    const auto range = mission::duration_range_of(task.arguments[i]);
    const bool longest = range && is_duration(vocabulary, task.name, i);
    text += " " + (longest ? figure(range->most) : argument(task.arguments[i]));
  }
  return text + " " + constraints(task.time, origin) + " " + std::to_string(task.id.value()) +
         ")\n";
}

std::string locations(const std::vector<world::Vector3>& points) {
  std::string text;
  for (const world::Vector3& point : points) text += " " + location(point);
  return text;
}

/// (progress 702 ((looked visible (loc …) 290) (reached (loc …)) …))
std::string progress(mission::GoalId goal, const mission::Progress& done) {
  std::string text;
  for (const mission::Progress::Look& look : done.looks)
    text += " (looked " + symbol(look.device) + " " + location(look.at) + " " +
            seconds(look.lasted) + ")";
  for (const world::Vector3& at : done.reached) text += " (reached " + location(at) + ")";
  if (done.waited > Duration()) text += " (waited " + seconds(done.waited) + ")";
  for (const std::uint64_t id : done.synchronised)
    text += " (synchronised " + std::to_string(id) + ")";
  if (done.rest) text += " (rest " + symbol(done.rest->device) + locations(done.rest->way) + ")";
  return "   (progress " + std::to_string(goal.value()) + " (" + text.substr(text.empty() ? 0 : 1) +
         "))\n";
}

std::string progress_facts(const PlanningRequest& request) {
  std::string text;
  for (const mission::HighLevelTask& task : request.tasks) {
    const auto done = request.situation.done.find(task.id);
    if (done != request.situation.done.end()) text += progress(task.id, done->second);
  }
  return text;
}

}  // namespace

std::string problem_text(const PlanningRequest& request, const std::string& name) {
  const Situation& situation = request.situation;
  std::string text = "(defproblem " + symbol(name) + "\n  ((current-plan main)\n" +
                     "   (takeoffloc home)\n   (landloc " +
                     (situation.land_at ? location(*situation.land_at) : std::string("home")) +
                     ")\n   " + whereabouts(request) + "\n" +
                     write_time("uavloc", situation.motion) + read_time("uavloc");
  for (const Timeline& rider : situation.riders) text += read_time("uavloc", rider);
  for (const world::SensorModel& sensor : request.knowledge->vehicle.sensors)
    text += device_facts(sensor, situation);
  text += progress_facts(request);
  text += "   (task-id " + std::to_string(situation.next_id.value()) + "))\n  (\n";
  for (const mission::HighLevelTask& task : request.tasks)
    text += goal(task, request.knowledge->vocabulary, situation.origin);
  return text + "  ))\n";
}

std::unique_ptr<htn::Problem> read_problem(const std::string& text, htn::TermStore& store,
                                           Diagnostics& errors) {
  htn::Definitions read;
  htn::read_definitions({"problem", text}, store, {}, read, errors);
  if (!errors.empty() || read.problems.size() != 1) return nullptr;
  return std::make_unique<htn::Problem>(make_problem(read.problems.front(), store));
}

}  // namespace skein::supervisor::testing
