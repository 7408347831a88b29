// SPDX-License-Identifier: Apache-2.0
#include "questions.hpp"
#include "skein/world/environment_reader.hpp"

namespace skein::refine_tool {
namespace {

using config::Reader;

/// How far from below it a cell is perceived: half the swath.
double read_footprint(const Reader& reader, const Terms& terms, const world::VehicleModel& vehicle,
                      double altitude) {
  const Reader footprint = reader.optional("footprint");
  if (footprint.present() && !reader.optional("device").present())
    return footprint.number(0, {-world::kFarthest, world::kFarthest, "m"});
  if (footprint.present()) footprint.error("footprint beside device", "one of the two");
  return terms.swath(reader, vehicle, altitude) / 2;
}

Duration read_duration(const Reader& reader, Duration otherwise = {}) {
  if (!reader.present()) return otherwise;
  return Duration::seconds(reader.number(0, {-1e7, 1e7, "s"}));
}

refiners::Member read_member(const std::string& name, const Reader& reader, const Terms& terms) {
  refiners::Member member;
  member.uav = name;
  reader.keys({"vehicle", "start", "swath", "device", "altitude", "speed", "busy", "share"});
  member.vehicle = terms.vehicle(reader.required("vehicle"));
  const Reader start = reader.required("start");
  member.start = start.is_sequence() && start.items().size() == 2
                     ? world::read_point_2d(start)
                     : world::Vector2(terms.place(start).head<2>());
  member.altitude = metres(reader.required("altitude"));
  member.swath = terms.swath(reader, member.vehicle, member.altitude);
  member.speed = speed(reader.optional("speed"));
  if (const Reader busy = reader.optional("busy"); busy.present())
    member.busy = busy.number(0, {-1e7, 1e7, "s"});
  if (const Reader share = reader.optional("share"); share.present())
    member.share = share.number(1, {-1e9, 1e9, ""});
  return member;
}

}  // namespace

refiners::CoverageQuery read_sweep(const Reader& reader, const Terms& terms,
                                   world::VehicleModel vehicle) {
  refiners::CoverageQuery query;
  query.vehicle = std::move(vehicle);
  geodata::Shape area = terms.shape(reader.required("area"));
  query.area = std::move(area.outer);
  query.holes = std::move(area.holes);
  if (const Reader holes = reader.optional("holes"); holes.present())
    for (const Reader& hole : world::items_of(holes)) query.holes.push_back(terms.ground(hole));
  query.altitude = metres(reader.required("altitude"));
  query.swath = terms.swath(reader, query.vehicle, query.altitude);
  if (const Reader mode = reader.optional("mode"); mode.present())
    query.mode = static_cast<refiners::SweepMode>(
        mode.choice({"least-time", "minimum-width", "longest-line", "given"}));
  const bool given = query.mode == refiners::SweepMode::kGiven;
  const Reader direction = reader.optional("direction");
  if (given) {
    query.direction = angle(reader.required("direction"));
  } else if (direction.present()) {
    direction.error("a direction with another mode than given", "mode: given, or no direction");
  }
  query.speed = speed(reader.optional("speed"));
  return query;
}

Question read_coverage(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "area", "holes", "swath", "device",
               "altitude", "mode", "direction", "start", "end", "speed", "depart", "turns_inside"});
  refiners::CoverageQuery query =
      read_sweep(reader, terms, terms.vehicle(reader.required("vehicle")));
  query.start = terms.optional_place(reader.optional("start"));
  query.end = terms.optional_place(reader.optional("end"));
  query.depart = world::read_instant(reader.optional("depart"));
  query.turns_inside = reader.optional("turns_inside").boolean(false);
  return query;
}

Question read_partition(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "seed", "budget", "area", "members", "mode", "depart", "apart"});
  refiners::PartitionQuery query;
  query.area = terms.ground(reader.required("area"));
  for (const auto& [name, member] : world::entries_of(reader.required("members")))
    query.members.push_back(read_member(name, member, terms));
  if (const Reader mode = reader.optional("mode"); mode.present())
    query.mode = static_cast<refiners::ShareMode>(mode.choice({"proportional", "balanced"}));
  query.apart = metres(reader.optional("apart"), query.apart);
  query.depart = world::read_instant(reader.optional("depart"));
  return query;
}

Question read_patrol(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "vehicle", "seed", "budget", "zone", "start", "heading",
               "altitude", "footprint", "device", "duration", "time_scale", "least_risk", "speed",
               "mode"});
  refiners::PatrolQuery query;
  query.vehicle = terms.vehicle(reader.required("vehicle"));
  query.zone = terms.ground(reader.required("zone"));
  query.start = terms.place(reader.required("start"));
  query.heading = angle(reader.optional("heading"));
  query.altitude = metres(reader.required("altitude"));
  query.footprint = read_footprint(reader, terms, query.vehicle, query.altitude);
  query.duration = read_duration(reader.required("duration"));
  query.time_scale = read_duration(reader.optional("time_scale"), query.time_scale);
  query.least_risk = reader.optional("least_risk").number(query.least_risk, {-1, 1, ""});
  query.speed = speed(reader.optional("speed"));
  if (const Reader mode = reader.optional("mode"); mode.present())
    query.mode = static_cast<refiners::PatrolMode>(mode.choice({"committed", "gradient"}));
  return query;
}

Question read_viewshed(const Reader& reader, const Terms& terms) {
  reader.keys({"service", "world", "seed", "budget", "from", "height", "range", "cell", "area"});
  refiners::ViewshedQuery query;
  query.from = terms.place(reader.required("from"));
  query.height = metres(reader.optional("height"));
  if (const Reader range = reader.optional("range"); range.present()) query.range = metres(range);
  query.cell = metres(reader.optional("cell"));
  if (const Reader area = reader.optional("area"); area.present()) query.area = terms.ground(area);
  return query;
}

}  // namespace skein::refine_tool
