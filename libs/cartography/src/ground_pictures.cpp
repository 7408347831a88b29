// SPDX-License-Identifier: Apache-2.0
// Pictures of ground that is swept, shared out, watched or seen: coverage, partition, patrol,
// viewshed.
#include <algorithm>
#include <cmath>
#include <limits>

#include "captions.hpp"
#include "palette.hpp"
#include "skein/cartography/pictures.hpp"
#include "skein/world/segment.hpp"

namespace skein::cartography {
namespace {

using refiners::Outcome;
using world::Vector2;
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

/// How often the way comes near each cell of the grid: those next to each other count once.
class Visits {
 public:
  Visits(const world::Grid& grid, double footprint)
      : grid_(grid), footprint_(footprint), count_(grid.size(), 0), last_(grid.size(), kNever) {}

  void fly(const refiners::Way& way) {
    for (std::size_t leg = 1; leg < way.size(); ++leg)
      fly(leg, way[leg - 1].head<2>(), way[leg].head<2>());
  }
  double of(std::size_t cell) const { return count_[cell]; }

 private:
  static constexpr std::size_t kNever = ~std::size_t{0} - 1;

  void fly(std::size_t leg, const Vector2& from, const Vector2& to) {
    const auto range = [&](double low, double high, double origin, std::size_t count) {
      const auto cell = [&](double at) {
        return std::clamp(std::floor((at - origin) / grid_.cell), 0.0, static_cast<double>(count));
      };
      return std::pair{static_cast<std::size_t>(cell(low - footprint_)),
                       std::min(count, static_cast<std::size_t>(cell(high + footprint_)) + 1)};
    };
    const auto [south, north] =
        range(std::min(from.y(), to.y()), std::max(from.y(), to.y()), grid_.south, grid_.rows);
    const auto [west, east] =
        range(std::min(from.x(), to.x()), std::max(from.x(), to.x()), grid_.west, grid_.columns);
    for (std::size_t row = south; row < north; ++row)
      for (std::size_t column = west; column < east; ++column) {
        const std::size_t cell = grid_.index(column, row);
        if (world::to_segment(grid_.centre(cell), from, to) > footprint_) continue;
        if (last_[cell] + 1 != leg) ++count_[cell];
        last_[cell] = leg;
      }
  }

  const world::Grid& grid_;
  double footprint_;
  std::vector<double> count_;
  std::vector<std::size_t> last_;  // leg that came near
};

/// How often each cell is visited all along the patrol; the bar begins at the least.
void draw_visits(Map& map, const world::World& world, const refiners::PatrolQuery& query,
                 const refiners::Patrol& patrol) {
  const world::Grid& grid = world.ground.grid;
  const bool known = patrol.potential.size() == grid.size();
  Visits visits(grid, query.footprint);
  visits.fly(patrol.way);
  std::vector<double> shown(grid.size(), std::numeric_limits<double>::quiet_NaN());
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const bool watched = known ? std::isfinite(patrol.potential[cell])
                               : world::contains(query.zone, grid.centre(cell));
    if (!watched) continue;
    shown[cell] = visits.of(cell);
    least = std::min(least, shown[cell]);
    most = std::max(most, shown[cell]);
  }
  if (!(least <= most)) return;
  map.heat(grid, shown,
           {.title = "visits of each cell, all along the patrol", .low = least, .high = most});
}

/// The last part of the way, so long as it takes to pass over the zone once.
refiners::Way last_lap(const refiners::PatrolQuery& query, const refiners::Way& way) {
  double left = world::area(query.zone) / (2 * query.footprint);
  std::size_t first = way.size() - 1;
  while (first > 0 && left > 0) {
    left -= (way[first] - way[first - 1]).norm();
    --first;
  }
  return {way.begin() + static_cast<std::ptrdiff_t>(first), way.end()};
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
    map.profile(outcome->task.way, kSweepColour);
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
  if (outcome) draw_visits(map, world, query, outcome->task);
  map.closed(world.volumes);
  map.area(query.zone, {.colour = "#303030"});
  if (outcome) {
    const refiners::PatrolFigures& p = outcome->task.predicted;
    const refiners::Way& way = outcome->task.way;
    if (way.size() > 1) {
      const refiners::Way lap = last_lap(query, way);
      map.way(lap, "#d55e00", 1.6);
      map.legend("#d55e00",
                 fmt::format("the last {:.1f} km of {:.1f} km flown",
                             refiners::length_of(lap) / 1000, refiners::length_of(way) / 1000));
    }
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

std::string picture(const world::World& world, const refiners::ViewshedQuery& query,
                    const Outcome<refiners::Viewshed>& outcome) {
  FrameBuilder points;
  points.add(query.from);
  points.add_all(query.area);
  if (outcome) {
    const world::Grid& grid = outcome->task.grid;
    points.add(grid.centre(0));
    points.add(grid.centre(grid.size() - 1));
  }
  Map map(world, points.frame(world.terrain));
  std::vector<std::string> lines;
  if (outcome) {
    std::vector<double> shown(outcome->task.cells.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t cell = 0; cell < shown.size(); ++cell)
      if (outcome->task.cells[cell] == refiners::Sight::kSeen) shown[cell] = 1;
    map.heat(outcome->task.grid, shown, {.title = "seen", .opacity = 0.5});
    lines.push_back(fmt::format("{} of {} cells of {:.0f} m are seen: {:.1f} %", outcome->task.seen,
                                outcome->task.asked, outcome->task.grid.cell,
                                100 * (1 - outcome->cost)));
  } else {
    lines.push_back(refusal_words(outcome.error()));
  }
  if (!query.area.empty()) map.area(query.area, {.colour = "#303030"});
  if (query.from.allFinite()) map.marker(query.from.head<2>(), kStartColour, "from here");
  return map.finish("What is seen", lines);
}

}  // namespace skein::cartography
