// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/viewshed.hpp"

#include <algorithm>
#include <cmath>

#include "common/shared_checks.hpp"
#include "skein/refiners/budget.hpp"
#include "skein/refiners/checks.hpp"
#include "skein/world/viewshed.hpp"

namespace skein::refiners {
namespace {

using world::Grid;
using world::Vector2;

constexpr double kLeastHeight = 0.01;  ///< as world::ViewshedQuery has it: ground hides itself [m]
constexpr std::uint32_t kStride = 32;  ///< cells between two looks at the clock

struct Box {
  Vector2 low, high;
};

Box box_of(const ViewshedQuery& query, const world::TerrainSpec& ground) {
  if (query.area.empty()) return {{ground.west, ground.south}, {ground.east, ground.north}};
  Box box{query.area.front(), query.area.front()};
  for (const Vector2& corner : query.area) {
    box.low = box.low.cwiseMin(corner);
    box.high = box.high.cwiseMax(corner);
  }
  return box;
}

double cell_of(const ViewshedQuery& query, const world::World& world) {
  return query.cell > 0 ? query.cell : world.terrain.spec().cell;
}

Grid grid_of(const ViewshedQuery& query, const world::World& world) {
  const Box box = box_of(query, world.terrain.spec());
  const double cell = cell_of(query, world);
  const auto count = [&](double length) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(length / cell * (1 - 1e-12))));
  };
  const Vector2 size = box.high - box.low;
  return {box.low.x(), box.low.y(), cell, count(size.x()), count(size.y())};
}

std::optional<Refusal> check(const ViewshedQuery& query, const world::World& world) {
  if (auto problem = check_finite(query.from, "from")) return problem;
  if (!(query.height >= 0) || !std::isfinite(query.height))
    return bad("height", figure(query.height) + " m over the ground is no height");
  if (!(query.range > 0)) return bad("range", figure(query.range) + " m is no range");
  if (!(query.cell >= 0) || !std::isfinite(query.cell))
    return bad("cell", figure(query.cell) + " m is no side of a cell");
  const double ground = world.terrain.elevation(query.from.x(), query.from.y());
  if (query.from.z() < ground)
    return Refusal{RefusalKind::kBlocked, "from",
                   figure(ground - query.from.z()) + " m under the ground"};
  if (!query.area.empty()) {
    if (auto problem = check_polygon(query.area, "area")) return problem;
    if (auto problem = check_in_world(query.area, world, "area")) return problem;
  }
  const Box box = box_of(query, world.terrain.spec());
  const double cell = cell_of(query, world);
  const Vector2 size = (box.high - box.low) / cell;
  if (size.x() * size.y() > kMostSightCells)
    return bad("cell", "a raster of cells of " + figure(cell) + " m has more than " +
                           figure(kMostSightCells) + " cells here");
  return std::nullopt;
}

}  // namespace

Outcome<Viewshed> refine(const ViewshedQuery& query, const Setting& setting) {
  if (auto problem = check(query, setting.world)) return tl::unexpected<Refusal>(*problem);
  const world::ViewshedQuery sight{query.from, query.range, std::max(query.height, kLeastHeight)};
  Countdown countdown(setting.budget, kStride);
  Refined<Viewshed> refined;
  Viewshed& view = refined.task;
  view.grid = grid_of(query, setting.world);
  view.cells.assign(view.grid.size(), Sight::kLeftOut);
  for (std::size_t cell = 0; cell < view.grid.size(); ++cell) {
    const Vector2 centre = view.grid.centre(cell);
    if (!query.area.empty() && !world::contains(query.area, centre)) continue;
    if (!countdown.step())
      return refuse(RefusalKind::kBudgetExhausted, "",
                    "only " + std::to_string(cell) + " of " + std::to_string(view.grid.size()) +
                        " cells were looked at");
    const bool seen = world::is_seen(setting.world.terrain, centre, sight);
    view.cells[cell] = seen ? Sight::kSeen : Sight::kHidden;
    view.seen += seen ? 1 : 0;
    ++view.asked;
  }
  if (view.asked == 0)
    return tl::unexpected<Refusal>(
        bad("area", "no middle of a cell lies in it; give a smaller cell"));
  refined.cost = 1 - static_cast<double>(view.seen) / static_cast<double>(view.asked);
  refined.effort = {countdown.steps(), countdown.cut_short()};
  return refined;
}

}  // namespace skein::refiners
