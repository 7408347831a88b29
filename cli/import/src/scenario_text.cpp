// SPDX-License-Identifier: Apache-2.0
#include "scenario_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace skein::import_tool {
namespace {

/// Of mission time; the wind may be against it, and pilots take their time.
constexpr double kSpare = 3;
constexpr double kAtLeast = 120;

/// A text as YAML takes any: in double quotes, with JSON's escapes.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// One line of a comment, whatever the text.
std::string comment(const std::string& text) {
  std::string line;
  for (const char c : text) line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  return "# " + line + "\n";
}

std::string polygon_text(const world::Polygon& polygon) {
  std::string text = "[";
  for (const world::Vector2& corner : polygon)
    text += fmt::format("{}[{}, {}]", text.size() == 1 ? "" : ", ", figure(corner.x()),
                        figure(corner.y()));
  return text + "]";
}

std::string ground_text(const Ground& ground) {
  if (!ground.world.empty()) return "  include: " + quoted(ground.world) + "\n";
  const auto& [west, south, east, north] = ground.sides;
  return fmt::format(
      "  origin: {{latitude: {:.8f}, longitude: {:.8f}, altitude: {}}}\n"
      "  terrain: {{west: {}, south: {}, east: {}, north: {}, cell: {}}}   # level: the file says "
      "no ground\n",
      ground.origin.latitude_degrees, ground.origin.longitude_degrees,
      figure(ground.origin.altitude), figure(west), figure(south), figure(east), figure(north),
      figure(ground.cell));
}

std::string head_text(const std::string& name, double limit) {
  return "scenario: " + quoted(name) +
         fmt::format("\nepoch: 2026-01-01T00:00:00Z\nduration_limit: {:.0f}\nrate: 10\nseed: 1\n\n",
                     limit) +
         "world:\n";
}

std::string uavs_text(const std::string& uav, const std::string& model,
                      const world::Vector3& start) {
  return fmt::format("\nuavs:\n  {}: {{model: {}, start: [{}, {}]}}\n\n", quoted(uav),
                     quoted(model), figure(start.x()), figure(start.y()));
}

std::string air_text(const Airspace& air) {
  std::string text;
  if (!air.zones.empty()) text += "  zones:\n";
  for (const world::Zone& zone : air.zones)
    text += "    " + quoted(zone.name) + ": " + polygon_text(zone.polygon) + "\n";
  if (!air.closed.empty()) text += "  volumes:\n";
  for (const world::Volume& volume : air.closed) {
    text += "    " + quoted(volume.name) + ": {polygon: " + polygon_text(volume.polygon);
    if (std::isfinite(volume.ceiling)) text += ", ceiling: " + figure(volume.ceiling);
    text += "}\n";
  }
  return text;
}

std::string places_text(const std::map<std::string, world::Vector3>& places) {
  std::string text = places.empty() ? "" : "  places:\n";
  for (const auto& [name, at] : places)
    text += fmt::format("    {}: [{}, {}, {}]\n", quoted(name), figure(at.x()), figure(at.y()),
                        figure(at.z()));
  return text;
}

std::string task_text(const FlightTask& task) {
  std::string text = fmt::format("              - {{id: {}, type: {}", task.id, task.type);
  if (task.after > 0) text += fmt::format(", pre: [[{{task: {}, state: ended}}]]", task.after);
  if (task.until_end_of > 0)
    text += fmt::format(", exit: [[{{task: {}, state: ended, modality: optional}}]]",
                        task.until_end_of);
  if (!task.params.empty()) text += ", params: " + task.params;
  return text + "}\n";
}

std::string script_text(const Parts& parts) {
  const Flight& flight = parts.flight;
  const world::Vector3& at = parts.start;
  std::string text = fmt::format("ground:\n  position: [{}, {}, {}]\n  script:\n", figure(at.x()),
                                 figure(at.y()), figure(std::ceil(at.z() + 2)));
  if (flight.tasks.empty())
    return text + "    - step: nothing-to-fly\n      when: {time: 1}\n      do: [{finish: true}]\n";
  text +=
      "    - step: mission\n      when: {time: 1}\n      do:\n        - plan:\n            uav: " +
      quoted(parts.uav) + "\n            tasks:\n";
  for (const FlightTask& task : flight.tasks) text += task_text(task);
  const int last = flight.last > 0 ? flight.last : flight.tasks.back().id;
  return text + fmt::format(
                    "    - step: end\n      when: {{task: {{uav: {}, id: {}, state: "
                    "ended}}}}\n      do: [{{finish: true}}]\n",
                    quoted(parts.uav), last);
}

std::string expectations_text(const Parts& parts) {
  const std::string uav = quoted(parts.uav);
  std::string text =
      "\nexpect:\n"
      "  - {name: the mission is carried out to its end, event: {kind: mission, state: "
      "finished}}\n";
  if (parts.flight.last == 0) return text;
  // Pictures until the end of a way end as aborted: they were interrupted.
  text += "  - {name: nothing that flies is given up, never: {kind: task, uav: " + uav +
          ", type: [takeoff, goto, wait, land], state: aborted}}\n";
  if (!parts.airspace.closed.empty())
    text += "  - {name: it keeps out of closed air, measure: time-in-volume, uavs: [" + uav +
            "], at_most: 0}\n";
  if (parts.flight.lands)
    text += "  - {name: it is down at the end, finally: {kind: telemetry, uav: " + uav +
            "}, is: {airborne: false}}\n";
  return text;
}

}  // namespace

std::string scenario_text(const Parts& parts, const Diagnostics& left_out) {
  std::string text = comment("Imported from " + parts.source + " by skein import.") +
                     comment("Metres, seconds, radians; x east, y north, z up.");
  if (!left_out.empty()) text += comment("Left out of it:");
  for (const Diagnostic& one : left_out.all()) text += comment("  " + to_text(one));
  const double limit = std::ceil(std::max(kAtLeast, parts.flight.seconds * kSpare + kAtLeast));
  return text + head_text(parts.name, limit) + ground_text(parts.ground) +
         air_text(parts.airspace) + places_text(parts.places) +
         uavs_text(parts.uav, parts.model, parts.start) + script_text(parts) +
         expectations_text(parts);
}

std::string empty_scenario_text(const Ground& ground, const std::string& uav,
                                const std::string& model) {
  return head_text("nothing", kAtLeast) + ground_text(ground) +
         uavs_text(uav, model, world::Vector3::Zero()) + "ground: {script: []}\n";
}

}  // namespace skein::import_tool
