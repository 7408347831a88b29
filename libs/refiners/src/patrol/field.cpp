// SPDX-License-Identifier: Apache-2.0
#include "patrol/field.hpp"

#include <algorithm>

namespace skein::refiners {
namespace {

/// About what it takes to look at a cell nearby, or at one corner of the zone [ns].
constexpr std::uint32_t kCellNear = 20, kCorner = 4;

/// Some open cell centre from which the cell is perceived.
bool can_be_perceived(const std::vector<bool>& open, const PatrolSight& sight, std::size_t cell) {
  if (open[cell]) return true;
  const world::Vector2 centre = sight.grid().centre(cell);
  bool found = false;
  sight.for_each_near(centre, centre, sight.footprint(), [&](std::size_t from, double, double) {
    if (found || !open[from] || sight.deadline().passed_after(kCellNear)) return;
    found = sight.is_unhidden(sight.grid().centre(from), cell);
  });
  return found;
}

}  // namespace

PatrolField make_patrol_field(const PatrolSpace& space, const PatrolSight& sight,
                              const world::Polygon& zone, const std::vector<double>& risk,
                              double least) {
  const world::Grid& grid = sight.grid();
  PatrolField field;
  field.slot.assign(grid.size(), PatrolField::kNone);
  field.open.assign(grid.size(), false);
  std::vector<std::size_t> of_zone;
  const auto work = kCorner * static_cast<std::uint32_t>(1 + zone.size());
  for (std::size_t cell = 0; cell < grid.size() && !sight.deadline().passed_after(work); ++cell) {
    const world::Vector2 centre = grid.centre(cell);
    if (!world::contains(zone, centre)) continue;
    of_zone.push_back(cell);
    field.open[cell] = space.is_clear(centre);
  }
  for (const std::size_t cell : of_zone) {
    if (sight.deadline().passed_after(kCellNear)) break;
    if (!can_be_perceived(field.open, sight, cell)) {
      ++field.hidden;
      continue;
    }
    field.slot[cell] = static_cast<std::uint32_t>(field.cells.size());
    field.cells.push_back(cell);
    field.risk.push_back(std::max(least, risk.empty() ? 0.5 : risk[cell]));
    field.total_risk += field.risk.back();
  }
  return field;
}

void leave_only(PatrolField& field, std::vector<PatrolBlock>& blocks,
                const std::vector<bool>& keep) {
  std::vector<bool> left(field.cells.size(), false);
  std::vector<PatrolBlock> kept;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!keep[b]) continue;
    for (const std::uint32_t cell : blocks[b].cells) left[cell] = true;
    kept.push_back(std::move(blocks[b]));
  }
  std::vector<std::uint32_t> moved(field.cells.size(), PatrolField::kNone);
  std::uint32_t count = 0;
  field.total_risk = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i]) {
      field.slot[field.cells[i]] = PatrolField::kNone;
      ++field.hidden;
      continue;
    }
    moved[i] = count;
    field.slot[field.cells[i]] = count;
    field.cells[count] = field.cells[i];
    field.risk[count] = field.risk[i];
    field.total_risk += field.risk[i];
    ++count;
  }
  field.cells.resize(count);
  field.risk.resize(count);
  for (PatrolBlock& block : kept)
    for (std::uint32_t& cell : block.cells) cell = moved[cell];
  blocks = std::move(kept);
}

}  // namespace skein::refiners
