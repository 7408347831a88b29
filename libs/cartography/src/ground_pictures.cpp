// SPDX-License-Identifier: Apache-2.0
// Pictures of ground that is swept, shared out or watched: coverage, partition, patrol.
#include <algorithm>

#include "captions.hpp"
#include "palette.hpp"
#include "skein/cartography/pictures.hpp"

namespace skein::cartography {
namespace {

using refiners::Outcome;
using world::Vector3;

const std::string kSweepColour = line_colour(0);

void draw_sweep(Map& map, const refiners::Coverage& coverage, double swath,
                const std::string& colour) {
  for (const refiners::Lane& lane : coverage.lanes) map.strip(lane.from, lane.to, swath, colour);
  map.way(coverage.way, colour, 1.6);
}

void mark_ends(Map& map, const std::optional<Vector3>& start, const std::optional<Vector3>& end) {
  if (start && start->allFinite()) map.marker(start->head<2>(), kStartColour, "start");
  if (end && end->allFinite() && end != start) map.marker(end->head<2>(), kEndColour, "end");
}

/// What each cell is worth to a patrol.
void draw_potential(Map& map, const world::World& world, const refiners::Patrol& patrol) {
  if (patrol.potential.size() != world.ground.grid.size()) return;
  double least = 1;
  for (const double value : patrol.potential)
    if (std::isfinite(value)) least = std::min(least, value);
  map.heat(world.ground.grid, patrol.potential,
           {.title = "potential P at the end: 1 just perceived, less the more in need",
            .low = std::floor(least * 20) / 20 - 0.05,
            .high = 1});
}

std::string idleness_words(const char* name, double value, double bound) {
  return fmt::format("{} {:.0f} s (bound {:.0f} s)", name, value, bound);
}

}  // namespace

std::string picture(const world::World& world, const refiners::CoverageQuery& query,
                    const Outcome<refiners::Coverage>& outcome) {
  FrameBuilder points;
  points.add_all(query.area);
  if (query.start) points.add(*query.start);
  if (query.end) points.add(*query.end);
  if (outcome) points.add_all(outcome->task.way);
  Map map(world, points.frame(world.terrain));
  map.closed(world.volumes);
  map.area(query.area, {.colour = "#303030", .opacity = 0.04});
  for (const world::Polygon& hole : query.holes)
    map.area(hole, {.colour = "#808080", .opacity = 0.25, .dashed = true, .label = "left out"});
  std::vector<std::string> lines;
  if (outcome) {
    draw_sweep(map, outcome->task, query.swath, kSweepColour);
    lines.push_back(fmt::format("{}: {} lanes of {:.0f} m, {} turns, {:.1f} km in {}",
                                query.vehicle.name, outcome->task.lanes.size(), query.swath,
                                outcome->task.turns, outcome->task.length / 1000,
                                duration_words(outcome->duration)));
  } else {
    lines.push_back(refusal_words(outcome.error()));
  }
  mark_ends(map, query.start, query.end);
  return map.finish("Coverage", lines);
}

std::string picture(const world::World& world, const refiners::PartitionQuery& query,
                    const Outcome<refiners::Partition>& outcome) {
  FrameBuilder points;
  points.add_all(query.area);
  for (const refiners::Member& member : query.members) points.add(member.start);
  if (outcome)
    for (const refiners::Part& part : outcome->task.parts) points.add_all(part.coverage.way);
  Map map(world, points.frame(world.terrain));
  map.closed(world.volumes);
  map.area(query.area, {.colour = "#303030"});
  std::vector<std::string> lines;
  if (!outcome) {
    lines.push_back(refusal_words(outcome.error()));
  } else {
    lines.push_back(fmt::format("{} UAVs, all done after {}; finishes spread by {:.1f} %",
                                query.members.size(), seconds(Duration::seconds(outcome->cost)),
                                100 * outcome->task.spread));
    for (std::size_t i = 0; i < outcome->task.parts.size(); ++i) {
      const refiners::Part& part = outcome->task.parts[i];
      const std::string colour = line_colour(i);
      map.area(part.polygon, {.colour = colour, .opacity = 0.14});
      draw_sweep(map, part.coverage, query.members[i].swath, colour);
      map.legend(colour, fmt::format("{}: {:.1f} % of the area, {}", part.uav, 100 * part.share,
                                     seconds(part.duration.expected)));
    }
  }
  for (std::size_t i = 0; i < query.members.size(); ++i)
    if (query.members[i].start.allFinite())
      map.marker(query.members[i].start, line_colour(i), query.members[i].uav);
  return map.finish("Partition", lines);
}

std::string picture(const world::World& world, const refiners::PatrolQuery& query,
                    const Outcome<refiners::Patrol>& outcome) {
  FrameBuilder points;
  points.add_all(query.zone);
  points.add(query.start);
  if (outcome) points.add_all(outcome->task.way);
  Map map(world, points.frame(world.terrain));
  std::vector<std::string> lines;
  if (outcome) draw_potential(map, world, outcome->task);
  map.closed(world.volumes);
  map.area(query.zone, {.colour = "#303030"});
  if (outcome) {
    const refiners::PatrolFigures& p = outcome->task.predicted;
    map.way(outcome->task.way, "#f7f7f7", 1.2);
    lines.push_back(fmt::format("{} for {}: {} cells, {} cannot be perceived, {} not seen",
                                query.vehicle.name, seconds(query.duration), p.cells, p.hidden,
                                p.unseen));
    lines.push_back(idleness_words("worst idleness", p.worst_idleness, p.worst_idleness_bound) +
                    "; " + idleness_words("mean by risk", p.mean_idleness, p.mean_idleness_bound));
  } else {
    lines.push_back(refusal_words(outcome.error()));
  }
  mark_ends(map, query.start, std::nullopt);
  return map.finish("Patrol", lines);
}

}  // namespace skein::cartography
