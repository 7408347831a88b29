// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/area_gates.hpp"

#include <algorithm>

#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

using world::Vector3;

/// Where the first lane begins, as an index of the way.
std::size_t entry_of(const Coverage& coverage) {
  const auto distance = [&](const Vector3& at) {
    return (at.head<2>() - coverage.lanes.front().from).squaredNorm();
  };
  const auto nearest =
      std::min_element(coverage.way.begin(), coverage.way.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - coverage.way.begin());
}

/// The sweep without the way to it.
Gate gate_of(const Refined<Coverage>& sweep, const CoverageQuery& query, const Setting& setting) {
  const Way& way = sweep.task.way;
  const auto entry = static_cast<std::ptrdiff_t>(entry_of(sweep.task));
  const Way reach(way.begin(), way.begin() + entry + 1);
  const Flight flight = estimate_flight(reach, query.vehicle, setting.world.wind, query.speed);
  const Duration inside = sweep.duration.expected - flight.duration.expected;
  return {way[static_cast<std::size_t>(entry)], way.back(), std::max(inside, Duration())};
}

bool same(const Gate& a, const Gate& b) { return a.entry == b.entry && a.exit == b.exit; }

}  // namespace

Result<std::vector<Gate>, Refusal> gates_of(const CoverageQuery& query, const Setting& setting) {
  if (auto problem = check_polygon(query.area, "area")) return tl::make_unexpected(*problem);
  std::vector<Gate> gates;
  const std::size_t entries = std::min(query.area.size(), kMostEntries);
  for (std::size_t i = 0; i < entries; ++i) {
    const world::Vector2& corner = query.area[i * query.area.size() / entries];
    CoverageQuery from = query;
    const double ground = setting.world.terrain.elevation(corner.x(), corner.y());
    from.start = Vector3(corner.x(), corner.y(), ground + query.altitude);
    from.end.reset();
    const auto sweep = refine(from, setting);
    if (!sweep) return tl::make_unexpected(sweep.error());
    const Gate gate = gate_of(*sweep, from, setting);
    if (std::none_of(gates.begin(), gates.end(), [&](const Gate& g) { return same(g, gate); }))
      gates.push_back(gate);
    if (setting.budget.expired()) break;
  }
  return gates;
}

}  // namespace skein::refiners
