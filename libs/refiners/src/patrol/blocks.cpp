// SPDX-License-Identifier: Apache-2.0
// Lanes, and the pieces they are cut into.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "patrol/field.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;

/// Part of the footprint that lanes count on, so that neither rounding nor a slight deviation
/// leaves a row unseen.
constexpr double kCounted = 0.97;
/// About what it takes to look at a cell from a track, and at a place of a lane [ns].
constexpr std::uint32_t kCellSeen = 20, kPlace = 500;

double length_of(const std::vector<Vector2>& track) {
  double length = 0;
  for (std::size_t i = 1; i < track.size(); ++i) length += (track[i] - track[i - 1]).norm();
  return length;
}

/// The grid seen along or across: `along` runs along the lanes, `across` over them.
struct Axes {
  const world::Grid& grid;
  bool swapped;  ///< lanes run north

  std::size_t along() const { return swapped ? grid.rows : grid.columns; }
  std::size_t across() const { return swapped ? grid.columns : grid.rows; }
  std::size_t cell(std::size_t u, std::size_t v) const {
    return swapped ? grid.index(v, u) : grid.index(u, v);
  }
  Vector2 point(double u, double v) const {
    const Vector2 local((swapped ? v : u) + 0.5, (swapped ? u : v) + 0.5);
    return Vector2(grid.west, grid.south) + grid.cell * local;
  }
  double heading() const { return swapped ? std::numbers::pi / 2 : 0; }
};

/// Rows from first to end - 1.
struct Rows {
  std::size_t first, end;
  std::size_t size() const { return end - first; }
};

class Layouter {
 public:
  Layouter(const PatrolField& field, const PatrolSpace& space, const PatrolSight& sight,
           const PatrolLayout& layout)
      : field_(field),
        space_(space),
        sight_(sight),
        layout_(layout),
        axes_{sight.grid(), false},
        owned_(field.cells.size(), false) {
    const Rows rows = used_rows({sight.grid(), false}), columns = used_rows({sight.grid(), true});
    axes_.swapped = columns.size() < rows.size();
    used_ = axes_.swapped ? columns : rows;
    width_ = static_cast<std::size_t>(2 * kCounted * sight.footprint() / sight.grid().cell) + 1;
    const double longer =
        static_cast<double>(field.cells.size()) / static_cast<double>(width_ * layout.most_blocks);
    piece_ = std::max(width_, static_cast<std::size_t>(std::ceil(longer)));
  }

  std::vector<PatrolBlock> blocks() {
    const std::size_t lanes = (used_.size() + width_ - 1) / width_;
    for (std::size_t i = 0; i < lanes; ++i)
      add_lane(
          {used_.first + i * used_.size() / lanes, used_.first + (i + 1) * used_.size() / lanes});
    adopt_what_others_see();
    add_points();
    std::erase_if(blocks_, [](const PatrolBlock& block) { return block.cells.empty(); });
    for (PatrolBlock& block : blocks_) trim(block);
    return std::move(blocks_);
  }

 private:
  bool is_late(std::uint32_t work) const { return sight_.deadline().passed_after(work); }

  Rows used_rows(const Axes& axes) const {
    Rows used{axes.across(), 0};
    for (std::size_t v = 0; v < axes.across(); ++v)
      for (std::size_t u = 0; u < axes.along(); ++u)
        if (field_.slot[axes.cell(u, v)] != PatrolField::kNone) {
          used.first = std::min(used.first, v);
          used.end = v + 1;
        }
    return used;
  }

  bool has_cells(std::size_t u, Rows rows) const {
    for (std::size_t v = rows.first; v < rows.end; ++v)
      if (field_.slot[axes_.cell(u, v)] != PatrolField::kNone) return true;
    return false;
  }

  /// Where the lane passes at u: on its middle line, or the open cell nearest to it.
  std::optional<Vector2> position(std::size_t u, Rows rows) const {
    const double middle = (static_cast<double>(rows.first) + static_cast<double>(rows.end) - 1) / 2;
    const Vector2 wanted = axes_.point(static_cast<double>(u), middle);
    if (space_.is_open(wanted)) return wanted;
    std::optional<Vector2> best;
    for (std::size_t v = rows.first; v < rows.end; ++v) {
      if (!field_.open[axes_.cell(u, v)]) continue;
      const Vector2 at = axes_.point(static_cast<double>(u), static_cast<double>(v));
      if (!best || (at - wanted).norm() < (*best - wanted).norm()) best = at;
    }
    return best;
  }

  bool continues(const std::vector<Vector2>& run, const Vector2& to) const {
    if (!space_.is_open(run.back(), to)) return false;
    const Vector2 step = to - run.back();
    return !layout_.straight || std::abs(axes_.swapped ? step.x() : step.y()) < 1e-9;
  }

  void add_lane(Rows rows) {
    ++lane_;
    std::vector<Vector2> run;
    std::size_t first = 0;
    for (std::size_t u = 0; u < axes_.along() && !is_late(kPlace); ++u) {
      const auto at = has_cells(u, rows) ? position(u, rows) : std::nullopt;
      if (!run.empty() && (!at || !continues(run, *at))) {
        cut_up(run, first, rows);
        run.clear();
      }
      if (!at) continue;
      if (run.empty()) first = u;
      run.push_back(*at);
    }
    if (!run.empty()) cut_up(run, first, rows);
  }

  void cut_up(const std::vector<Vector2>& run, std::size_t first, Rows rows) {
    const std::size_t pieces = (run.size() + piece_ - 1) / piece_;
    for (std::size_t i = 0; i < pieces && !is_late(kPlace); ++i) {
      const std::size_t from = i * run.size() / pieces, until = (i + 1) * run.size() / pieces;
      PatrolBlock block;
      block.track.assign(run.begin() + static_cast<std::ptrdiff_t>(from),
                         run.begin() + static_cast<std::ptrdiff_t>(until));
      block.heading = axes_.heading();
      block.lane = lane_;
      const std::vector<std::uint32_t> seen = seen_from(block.track);
      for (const std::uint32_t cell : seen) {
        const auto [u, v] = place(cell);
        if (owned_[cell] || v < rows.first || v >= rows.end || u < first + from ||
            u >= first + until)
          continue;
        own(block, cell);
      }
      blocks_.push_back(std::move(block));
    }
  }

  std::pair<std::size_t, std::size_t> place(std::uint32_t cell) const {
    const std::size_t index = field_.cells[cell];
    const std::size_t column = index % axes_.grid.columns, row = index / axes_.grid.columns;
    return axes_.swapped ? std::pair{row, column} : std::pair{column, row};
  }

  void own(PatrolBlock& block, std::uint32_t cell) {
    owned_[cell] = true;
    block.cells.push_back(cell);
  }

  /// Cells of the field perceived along a track, sorted, within the counted part of the footprint
  /// where the lanes allow it. Not all, nor sorted, once the time is up: nothing is made of them.
  std::vector<std::uint32_t> seen_from(const std::vector<Vector2>& track, double part = 1) const {
    std::vector<std::uint32_t> seen;
    for (std::size_t i = 0; i < track.size() && !is_late(kCellSeen); ++i) {
      const Vector2& from = track[i == 0 ? 0 : i - 1];
      const Vector2& to = track[i];
      sight_.for_each_near(from, to, part * sight_.footprint(),
                           [&](std::size_t cell, double enter, double leave) {
                             const std::uint32_t slot = field_.slot[cell];
                             if (slot == PatrolField::kNone || is_late(kCellSeen)) return;
                             const Vector2 nearest = from + (enter + leave) / 2 * (to - from);
                             if (sight_.is_unhidden(nearest, cell)) seen.push_back(slot);
                           });
    }
    if (is_late(kCellSeen * static_cast<std::uint32_t>(seen.size()))) return seen;
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    return seen;
  }

  void adopt_what_others_see() {
    if (std::find(owned_.begin(), owned_.end(), false) == owned_.end()) return;
    for (PatrolBlock& block : blocks_)
      for (const std::uint32_t cell : seen_from(block.track, kCounted))
        if (!owned_[cell]) own(block, cell);
  }

  void add_points() {
    for (std::uint32_t cell = 0; cell < owned_.size(); ++cell)
      if (!owned_[cell] && !is_late(kCellSeen)) blocks_.push_back(best_point_for(cell));
  }

  /// A point that perceives the cell and as many others without an owner as any.
  PatrolBlock best_point_for(std::uint32_t cell) {
    const std::size_t index = field_.cells[cell];
    const Vector2 centre = axes_.grid.centre(index);
    std::vector<std::uint32_t> best;
    Vector2 best_at = centre;
    sight_.for_each_near(centre, centre, sight_.footprint(), [&](std::size_t from, double, double) {
      const Vector2 at = axes_.grid.centre(from);
      if (!field_.open[from] || is_late(kCellSeen) || !sight_.is_unhidden(at, index)) return;
      std::vector<std::uint32_t> seen = seen_from({at});
      std::erase_if(seen, [&](std::uint32_t other) { return owned_[other]; });
      if (seen.size() <= best.size()) return;
      best = std::move(seen);
      best_at = at;
    });
    PatrolBlock block;
    block.track = {best_at};
    block.heading = axes_.heading();
    block.lane = ++lane_;
    for (const std::uint32_t other : best) own(block, other);
    if (!owned_[cell]) own(block, cell);  // right below, where the ground hides even that
    return block;
  }

  /// Takes off both ends of a track what is not needed to perceive its cells.
  void trim(PatrolBlock& block) const {
    if (is_late(kPlace)) return;
    std::sort(block.cells.begin(), block.cells.end());
    const auto suffices = [&](const std::vector<Vector2>& track) {
      const std::vector<std::uint32_t> seen = seen_from(track, kCounted);
      return std::includes(seen.begin(), seen.end(), block.cells.begin(), block.cells.end());
    };
    if (suffices(block.track)) {
      bool shorter = true;
      while (shorter && block.track.size() > 1 && !is_late(0)) {
        shorter = false;
        std::vector<Vector2> fewer(block.track.begin() + 1, block.track.end());
        if (suffices(fewer)) block.track = fewer, shorter = true;
        if (block.track.size() < 2) break;
        fewer.assign(block.track.begin(), block.track.end() - 1);
        if (suffices(fewer)) block.track = fewer, shorter = true;
      }
    }
    if (block.track.size() > 1) {
      const Vector2 step = block.track.back() - block.track.front();
      if (layout_.straight) block.track = {block.track.front(), block.track.back()};
      block.heading = std::atan2(step.y(), step.x());
    }
    block.length = length_of(block.track);
  }

  const PatrolField& field_;
  const PatrolSpace& space_;
  const PatrolSight& sight_;
  const PatrolLayout& layout_;
  Axes axes_;
  Rows used_{0, 0};
  std::size_t width_ = 1, piece_ = 1, lane_ = 0;
  std::vector<bool> owned_;
  std::vector<PatrolBlock> blocks_;
};

}  // namespace

std::vector<PatrolBlock> make_patrol_blocks(const PatrolField& field, const PatrolSpace& space,
                                            const PatrolSight& sight, const PatrolLayout& layout) {
  if (field.cells.empty()) return {};
  return Layouter(field, space, sight, layout).blocks();
}

}  // namespace skein::refiners
