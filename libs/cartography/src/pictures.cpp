// SPDX-License-Identifier: Apache-2.0
// Pictures of ways between places: path, tour, evaluate, insertion, relay, viewpoint.
#include "skein/cartography/pictures.hpp"

#include <algorithm>

#include "captions.hpp"
#include "palette.hpp"

namespace skein::cartography {
namespace {

using refiners::Outcome;
using world::Vector2;
using world::Vector3;

const std::string kWayColour = line_colour(0);

std::string height_words(const std::string& name, const Vector3& at) {
  return fmt::format("{} {:.0f} m", name, at.z());
}

/// A dot where it is finite.
void mark(Map& map, const Vector3& at, const char* colour, const std::string& name) {
  if (at.allFinite()) map.marker(at.head<2>(), colour, height_words(name, at));
}

void draw_contact(Map& map, const refiners::Contact& contact) {
  mark(map, contact.with, "#e69f00", "contact");
  for (const Vector3& relay : contact.relays) mark(map, relay, "#e69f00", "relay");
}

}  // namespace

std::string picture(const world::World& world, const refiners::PathQuery& query,
                    const Outcome<refiners::Path>& outcome) {
  FrameBuilder points;
  points.add(query.from);
  points.add(query.to);
  if (outcome) points.add_all(outcome->task.way);
  if (query.contact) {
    points.add(query.contact->with);
    points.add_all(query.contact->relays);
  }
  Map map(world, points.frame(world.terrain));
  draw_surroundings(map, world);
  map.closed(query.reserved);
  std::vector<std::string> lines;
  if (outcome) {
    map.way(outcome->task.way, kWayColour, 2.6);
    map.profile(outcome->task.way, kWayColour);
    lines.push_back(fmt::format("{}: {:.0f} m in {}, {:.1f} % of the energy", query.vehicle.name,
                                outcome->task.length, duration_words(outcome->duration),
                                100 * outcome->task.energy));
  } else {
    lines.push_back(refusal_words(outcome.error()));
  }
  if (query.contact) draw_contact(map, *query.contact);
  mark(map, query.from, kStartColour, "from");
  mark(map, query.to, kEndColour, "to");
  return map.finish("Path", lines);
}

std::string picture(const world::World& world, const refiners::TourQuery& query,
                    const Outcome<refiners::Tour>& outcome) {
  FrameBuilder points;
  points.add(query.start);
  if (query.end) points.add(*query.end);
  for (const refiners::Stop& stop : query.stops)
    for (const refiners::Gate& gate : stop.gates) {
      points.add(gate.entry);
      points.add(gate.exit);
    }
  if (outcome)
    for (const refiners::Visit& visit : outcome->task.visits) points.add_all(visit.way);
  Map map(world, points.frame(world.terrain));
  draw_surroundings(map, world);
  std::vector<std::string> lines;
  if (!outcome) {
    lines.push_back(refusal_words(outcome.error()));
    for (const refiners::Stop& stop : query.stops)
      if (!stop.gates.empty()) mark(map, stop.gates[0].entry, "#404040", stop.name);
  } else {
    lines.push_back(fmt::format("{}: {} stops, {:.0f} m between them, {}", query.vehicle.name,
                                query.stops.size(), outcome->task.length,
                                duration_words(outcome->duration)));
    std::size_t number = 0;
    for (const refiners::Visit& visit : outcome->task.visits) {
      const refiners::Stop& stop = query.stops[visit.stop];
      const refiners::Gate& gate = stop.gates[visit.gate];
      map.way(visit.way, kWayColour);
      if (gate.entry != gate.exit) {
        map.link(gate.entry, gate.exit, "#e69f00", "");
        map.marker(gate.exit.head<2>(), "#e69f00", "");
      }
      map.marker(gate.entry.head<2>(), "#404040", fmt::format("{}. {}", ++number, stop.name));
    }
    if (outcome->task.last.size() > 1) map.way(outcome->task.last, kWayColour);
  }
  mark(map, query.start, kStartColour, "start");
  if (query.end && *query.end != query.start) mark(map, *query.end, kEndColour, "end");
  map.legend(kWayColour, "ways between stops");
  map.legend("#e69f00", "inside a stop, from entry to exit");
  return map.finish("Tour", lines);
}

std::string picture(const world::World& world, const refiners::ViewpointQuery& query,
                    const Outcome<refiners::Viewpoints>& outcome) {
  FrameBuilder points;
  points.add(query.target);
  if (query.from) points.add(*query.from);
  if (outcome)
    for (const refiners::ViewPoint& point : outcome->task.points) points.add(point.position);
  Map map(world, points.frame(world.terrain));
  draw_surroundings(map, world);
  const world::SensorModel* sensor = world::find_sensor(query.vehicle, query.device);
  std::vector<std::string> lines;
  if (!outcome) {
    lines.push_back(refusal_words(outcome.error()));
  } else {
    const auto& found = outcome->task.points;
    lines.push_back(fmt::format("{} of {}: {} of {} asked for, {} sight checks", query.device,
                                query.vehicle.name, found.size(), query.count,
                                outcome->task.sight_checks));
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::string colour = line_colour(i);
      map.cone(found[i].position, query.target, sensor != nullptr ? sensor->aperture : 0.2, colour);
      map.marker(found[i].position.head<2>(), colour,
                 fmt::format("{}. {:.0f} m, utility {:.2f}", i + 1, found[i].position.z(),
                             found[i].utility));
      if (i == 0) map.profile({found[i].position, query.target}, colour);
    }
  }
  if (query.from) mark(map, *query.from, kStartColour, "from");
  mark(map, query.target, "#b3202c", "target");
  return map.finish("Viewpoints", lines);
}

std::string picture(const world::World& world, const refiners::RelayQuery& query,
                    const Outcome<refiners::Relay>& outcome) {
  FrameBuilder points;
  points.add(query.a);
  points.add(query.b);
  if (outcome) points.add_all(outcome->task.positions);
  Map map(world, points.frame(world.terrain));
  draw_surroundings(map, world);
  std::vector<std::string> lines;
  if (!outcome) {
    lines.push_back(refusal_words(outcome.error()));
    map.link(query.a, query.b, "#b3202c", "no contact");
  } else {
    refiners::Way chain = {query.a};
    chain.insert(chain.end(), outcome->task.positions.begin(), outcome->task.positions.end());
    chain.push_back(query.b);
    for (std::size_t i = 1; i < chain.size(); ++i)
      map.link(chain[i - 1], chain[i], line_colour(2),
               fmt::format("{:.1f} dB, {:.0f} m",
                           world.radio.margin(chain[i - 1], chain[i], world.terrain),
                           (chain[i] - chain[i - 1]).norm()));
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
      mark(map, chain[i], "#e69f00", fmt::format("relay {}", i));
    map.profile(chain, line_colour(2));
    lines.push_back(fmt::format("{} relays, {:.1f} dB on the weakest link",
                                outcome->task.positions.size(), outcome->task.margin));
  }
  mark(map, query.a, kStartColour, "a");
  mark(map, query.b, kEndColour, "b");
  return map.finish("Relay", lines);
}

std::string picture(const world::World& world, const refiners::EvaluateQuery& query,
                    const Outcome<refiners::Evaluation>& outcome) {
  FrameBuilder points;
  points.add_all(query.way);
  Map map(world, points.frame(world.terrain));
  draw_surroundings(map, world);
  map.closed(query.reserved);
  const bool drawable = std::all_of(query.way.begin(), query.way.end(),
                                    [](const Vector3& at) { return at.allFinite(); });
  if (drawable && query.way.size() > 1) {
    map.way(query.way, kWayColour, 2.6);
    map.profile(query.way, kWayColour);
  }
  std::vector<std::string> lines;
  if (!outcome) {
    lines.push_back(refusal_words(outcome.error()));
  } else {
    const refiners::Evaluation& e = outcome->task;
    lines.push_back(fmt::format("{}: {:.0f} m in {}, {:.1f} % of the energy, least height {:.0f} m",
                                query.vehicle.name, e.length, duration_words(outcome->duration),
                                100 * e.energy, e.least_height));
    for (const refiners::Obstruction& one : e.obstructions)
      map.marker(one.at.head<2>(), "#b3202c", "closed by " + one.by);
    for (const std::string& limit : e.limits) lines.push_back(limit);
  }
  return map.finish("Evaluation of a way", lines);
}

std::string picture(const world::World& world, const refiners::InsertionQuery& query,
                    const Outcome<refiners::Insertion>& outcome) {
  FrameBuilder points;
  points.add(query.start);
  if (query.end) points.add(*query.end);
  for (const refiners::PlannedTask& task : query.plan) {
    points.add(task.from);
    points.add(task.to);
  }
  points.add(query.task.from);
  points.add(query.task.to);
  Map map(world, points.frame(world.terrain));
  draw_surroundings(map, world);
  for (std::size_t i = 0; i < query.plan.size(); ++i) {
    map.link(query.plan[i].from, query.plan[i].to, "#5a5a5a", "");
    mark(map, query.plan[i].from, "#5a5a5a", fmt::format("task {}", i + 1));
  }
  std::vector<std::string> lines;
  if (!outcome) {
    lines.push_back(refusal_words(outcome.error()));
  } else {
    map.way(outcome->task.to, kWayColour);
    if (outcome->task.from.size() > 1) map.way(outcome->task.from, line_colour(1));
    lines.push_back(fmt::format("before task {} of {}: {:+.0f} s", outcome->task.position + 1,
                                query.plan.size() + 1, outcome->cost));
  }
  mark(map, query.task.from, "#b3202c", "inserted");
  mark(map, query.start, kStartColour, "start");
  if (query.end && *query.end != query.start) mark(map, *query.end, kEndColour, "end");
  map.legend(kWayColour, "way to the inserted task");
  map.legend(line_colour(1), "way on from it");
  return map.finish("Insertion in a plan", lines);
}

}  // namespace skein::cartography
