// SPDX-License-Identifier: Apache-2.0
#include "questions.hpp"

#include <cmath>
#include <numbers>

#include "skein/world/environment_reader.hpp"
#include "skein/world/geometry.hpp"

namespace skein::refine_tool {
namespace {

using config::Reader;
using world::Vector2;
using world::Vector3;

MissionTime instant(const Reader& reader) { return world::read_instant(reader); }

Question read_path(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "planner", "from", "to",
               "heading_from", "heading_to", "clearance", "speed", "depart", "reserved",
               "contact"});
  refiners::PathQuery query;
  query.vehicle = terms.vehicle(reader.required("vehicle"));
  query.from = terms.place(reader.required("from"));
  query.to = terms.place(reader.required("to"));
  query.heading_from = optional_angle(reader.optional("heading_from"));
  query.heading_to = optional_angle(reader.optional("heading_to"));
  query.clearance = metres(reader.optional("clearance"));
  query.speed = speed(reader.optional("speed"));
  query.depart = instant(reader.optional("depart"));
  query.reserved = terms.volumes(reader.optional("reserved"));
  if (const Reader contact = reader.optional("contact"); contact.present()) {
    contact.keys({"with", "relays"});
    query.contact = refiners::Contact{terms.place(contact.required("with")),
                                      terms.places(contact.optional("relays"))};
  }
  return query;
}

Duration inside(const Reader& reader) {
  if (!reader.present()) return {};
  return Duration::seconds(reader.number(0, {0, 1e7, "s"}));
}

refiners::Gate read_gate(const Reader& reader, const Terms& terms) {
  reader.keys({"entry", "exit", "inside"});
  return {terms.place(reader.required("entry")), terms.place(reader.required("exit")),
          inside(reader.optional("inside"))};
}

/// A place; {entry, exit, inside}; {gates: […]}; or an area that is to be swept.
void read_stop(const std::string& name, const Reader& reader, const Terms& terms,
               TourWithAreas& out) {
  refiners::Stop stop{name, {}};
  if (reader.optional("area").present()) {
    reader.keys({"area", "holes", "swath", "device", "altitude", "mode", "direction", "speed"});
    out.areas.push_back({out.tour.stops.size(), read_sweep(reader, terms, out.tour.vehicle)});
  } else if (const Reader gates = reader.optional("gates"); gates.present()) {
    reader.keys({"gates"});
    for (const Reader& gate : world::items_of(gates)) stop.gates.push_back(read_gate(gate, terms));
  } else if (reader.optional("entry").present()) {
    stop.gates.push_back(read_gate(reader, terms));
  } else {
    const Vector3 at = terms.place(reader);
    stop.gates.push_back({at, at, {}});
  }
  out.tour.stops.push_back(std::move(stop));
}

Question read_tour(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "planner", "start", "end", "stops",
               "clearance", "speed", "depart"});
  TourWithAreas query;
  query.tour.vehicle = terms.vehicle(reader.required("vehicle"));
  query.tour.start = terms.place(reader.required("start"));
  query.tour.end = terms.optional_place(reader.optional("end"));
  for (const auto& [name, stop] : world::entries_of(reader.required("stops")))
    read_stop(name, stop, terms, query);
  query.tour.clearance = metres(reader.optional("clearance"));
  query.tour.speed = speed(reader.optional("speed"));
  query.tour.depart = instant(reader.optional("depart"));
  return query;
}

/// Seen from the target, counter-clockwise from one bearing to the other.
bool in_sector(const Vector2& offset, double from, double to) {
  const double width =
      to - from - 2 * std::numbers::pi * std::floor((to - from) / (2 * std::numbers::pi));
  const double bearing = std::atan2(offset.y(), offset.x()) - from;
  return bearing - 2 * std::numbers::pi * std::floor(bearing / (2 * std::numbers::pi)) <= width;
}

refiners::PlaceConstraint read_constraint(const std::string& name, const Reader& reader,
                                          const Terms& terms, const Vector3& target) {
  const Reader sector = reader.optional("sector"), within = reader.optional("within");
  const Reader outside = reader.optional("outside");
  reader.keys({"sector", "within", "outside"});
  if (static_cast<int>(sector.present()) + static_cast<int>(within.present()) +
          static_cast<int>(outside.present()) !=
      1)
    reader.error("a constraint of no kind, or of several",
                 "one of sector: [from, to], within: AREA, outside: AREA");
  if (sector.present()) {
    const auto ends = sector.numbers(2, {-2 * std::numbers::pi, 2 * std::numbers::pi, "rad"});
    if (ends.size() != 2) return {name, {}};
    return {name, [target, from = ends[0], to = ends[1]](const Vector3& at) {
              return in_sector((at - target).head<2>(), from, to);
            }};
  }
  const bool wanted = within.present();
  return {name, [polygon = terms.area(wanted ? within : outside), wanted](const Vector3& at) {
            return world::contains(polygon, at.head<2>()) == wanted;
          }};
}

Question read_viewpoint(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "device", "target", "nearest",
               "farthest", "clearance", "count", "least_angle", "from", "cost_of_way", "at",
               "constraints"});
  refiners::ViewpointQuery query;
  query.vehicle = terms.vehicle(reader.required("vehicle"));
  query.device = reader.required("device").text();
  query.target = terms.place(reader.required("target"));
  query.nearest = metres(reader.optional("nearest"), query.nearest);
  query.farthest = metres(reader.optional("farthest"), query.farthest);
  query.clearance = metres(reader.optional("clearance"), query.clearance);
  query.count = static_cast<std::size_t>(reader.optional("count").integer(1, 1, 1000));
  query.least_angle = angle(reader.optional("least_angle"));
  query.from = terms.optional_place(reader.optional("from"));
  query.cost_of_way = reader.optional("cost_of_way").number(0, {0, 1000, "1/m"});
  query.at = instant(reader.optional("at"));
  if (const Reader all = reader.optional("constraints"); all.present())
    for (const auto& [name, constraint] : world::entries_of(all))
      query.constraints.push_back(read_constraint(name, constraint, terms, query.target));
  return query;
}

Question read_relay(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "a", "b", "most", "least_margin",
               "clearance", "at"});
  refiners::RelayQuery query;
  query.vehicle = terms.vehicle(reader.required("vehicle"));
  query.a = terms.place(reader.required("a"));
  query.b = terms.place(reader.required("b"));
  query.most = static_cast<std::size_t>(reader.optional("most").integer(1, 1, 64));
  query.least_margin = reader.optional("least_margin").number(0, {-1000, 1000, "dB"});
  query.clearance = metres(reader.optional("clearance"), query.clearance);
  query.at = instant(reader.optional("at"));
  return query;
}

Question read_evaluate(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "way", "clearance", "speed",
               "depart", "reserved"});
  refiners::EvaluateQuery query;
  query.vehicle = terms.vehicle(reader.required("vehicle"));
  query.way = terms.places(reader.required("way"));
  query.clearance = metres(reader.optional("clearance"));
  query.speed = speed(reader.optional("speed"));
  query.depart = instant(reader.optional("depart"));
  query.reserved = terms.volumes(reader.optional("reserved"));
  return query;
}

refiners::PlannedTask read_task(const Reader& reader, const Terms& terms) {
  reader.keys({"at", "from", "to", "duration"});
  refiners::PlannedTask task;
  task.duration = inside(reader.optional("duration"));
  if (const Reader at = reader.optional("at"); at.present()) {
    task.from = task.to = terms.place(at);
    if (reader.optional("from").present() || reader.optional("to").present())
      reader.error("at beside from or to", "at, or from and to");
    return task;
  }
  task.from = terms.place(reader.required("from"));
  task.to = terms.place(reader.required("to"));
  return task;
}

Question read_insertion(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "planner", "start", "plan", "task",
               "end", "clearance", "speed", "depart"});
  refiners::InsertionQuery query;
  query.vehicle = terms.vehicle(reader.required("vehicle"));
  query.start = terms.place(reader.required("start"));
  for (const Reader& task : world::items_of(reader.required("plan")))
    query.plan.push_back(read_task(task, terms));
  query.task = read_task(reader.required("task"), terms);
  query.end = terms.optional_place(reader.optional("end"));
  query.clearance = metres(reader.optional("clearance"));
  query.speed = speed(reader.optional("speed"));
  query.depart = instant(reader.optional("depart"));
  return query;
}

}  // namespace

const std::vector<ServiceReader>& service_readers() {
  static const std::vector<ServiceReader> readers = {
      {"path", read_path},           {"tour", read_tour},     {"coverage", read_coverage},
      {"partition", read_partition}, {"patrol", read_patrol}, {"viewpoint", read_viewpoint},
      {"viewshed", read_viewshed},   {"relay", read_relay},   {"evaluate", read_evaluate},
      {"insertion", read_insertion}};
  return readers;
}

}  // namespace skein::refine_tool
