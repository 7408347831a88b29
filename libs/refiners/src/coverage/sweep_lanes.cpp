// SPDX-License-Identifier: Apache-2.0
#include "coverage/sweep_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Equal strips from the low to the high side of a region.
struct Strips {
  double low, height;
  std::size_t count;

  std::size_t index_of(double y) const {
    const double at = height > 0 ? std::floor((y - low) / height) : 0;
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
  }
  double border(std::size_t index) const { return low + static_cast<double>(index) * height; }
  double centre(std::size_t index) const {
    return low + (static_cast<double>(index) + 0.5) * height;
  }
};

Strips strips_of(const Polygon& turned, double swath) {
  const Breadth breadth = breadth_of(turned);
  const std::size_t count = lane_count(breadth.width(), swath);
  return {breadth.low, breadth.width() / static_cast<double>(count), count};
}

struct Interval {
  double from = kInfinity, to = -kInfinity;

  void widen(double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

/// An edge, upwards.
struct Edge {
  Vector2 low, high;

  double x_at(double y) const {
    if (y <= low.y()) return low.x();
    if (y >= high.y()) return high.x();
    return low.x() + (high.x() - low.x()) * (y - low.y()) / (high.y() - low.y());
  }
};

void add_edges(const Polygon& polygon, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2& b = polygon[(i + 1) % polygon.size()];
    if (a.y() < b.y()) edges.push_back({a, b});
    if (b.y() < a.y()) edges.push_back({b, a});
  }
}

/// What of a region lies between two levels, between a left and a right edge.
struct Slice {
  double low, high;
  Edge left, right;
};

/// Sweeps upwards over the levels of all corners: between two, the borders are straight and in the
/// same order. A slice lasts as long as its two edges stay neighbours, so that there are as many
/// slices as corners, and not as many as corners times the edges at their levels.
class Slicer {
 public:
  explicit Slicer(const Region& turned) {
    add_edges(turned.outer, edges_);
    for (const Polygon& hole : turned.holes) add_edges(hole, edges_);
    std::sort(edges_.begin(), edges_.end(),
              [](const Edge& a, const Edge& b) { return a.low.y() < b.low.y(); });
    for (const Edge& edge : edges_) {
      levels_.push_back(edge.low.y());
      levels_.push_back(edge.high.y());
    }
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
    begun_.resize(edges_.size());
  }

  std::vector<Slice> slices() {
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
      take_edges(levels_[i], levels_[i + 1]);
      pair_edges(levels_[i]);
    }
    for (const Across& left : across_) end_slice(left.edge, levels_.back());
    return std::move(slices_);
  }

 private:
  /// An edge of `edges_`, and where it is between the present levels.
  struct Across {
    std::size_t edge;
    double x;
  };
  /// The slice to the right of an edge.
  struct Begun {
    std::size_t right = kNone;
    double low = 0;
  };
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  void take_edges(double low, double high) {
    std::erase_if(across_, [&](const Across& one) {
      const bool over = edges_[one.edge].high.y() <= low;
      if (over) end_slice(one.edge, low);
      return over;
    });
    while (next_ < edges_.size() && edges_[next_].low.y() <= low) across_.push_back({next_++, 0});
    const double middle = low + (high - low) / 2;
    for (Across& one : across_) one.x = edges_[one.edge].x_at(middle);
    // Sorted already, but for what came in last.
    for (std::size_t i = 1; i < across_.size(); ++i)
      for (std::size_t k = i; k > 0 && across_[k].x < across_[k - 1].x; --k)
        std::swap(across_[k], across_[k - 1]);
  }

  void pair_edges(double low) {
    for (std::size_t i = 0; i < across_.size(); ++i) {
      const std::size_t left = across_[i].edge;
      const bool inside = i % 2 == 0 && i + 1 < across_.size();
      const std::size_t right = inside ? across_[i + 1].edge : kNone;
      if (begun_[left].right == right) continue;
      end_slice(left, low);
      begun_[left] = {right, low};
    }
  }

  void end_slice(std::size_t left, double high) {
    const Begun begun = std::exchange(begun_[left], {});
    if (begun.right != kNone)
      slices_.push_back({begun.low, high, edges_[left], edges_[begun.right]});
  }

  std::vector<Edge> edges_;
  std::vector<double> levels_;
  std::vector<Across> across_;
  std::vector<Begun> begun_;  // by the left edge
  std::vector<Slice> slices_;
  std::size_t next_ = 0;
};

/// What of every strip holds something to be swept, along x, in order and apart.
std::vector<std::vector<Interval>> intervals_of(const Region& turned, const Strips& strips,
                                                double gap) {
  std::vector<std::vector<Interval>> intervals(strips.count);
  for (const Slice& slice : Slicer(turned).slices()) {
    const std::size_t last = strips.index_of(slice.high);
    for (std::size_t i = strips.index_of(slice.low); i <= last; ++i) {
      const double low = std::max(slice.low, strips.border(i));
      const double high = std::min(slice.high, strips.border(i + 1));
      if (high <= low) continue;
      intervals[i].push_back({std::min(slice.left.x_at(low), slice.left.x_at(high)),
                              std::max(slice.right.x_at(low), slice.right.x_at(high))});
    }
  }
  for (std::vector<Interval>& row : intervals) {
    std::sort(row.begin(), row.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    std::size_t kept = 0;
    for (std::size_t i = 1; i < row.size(); ++i) {
      if (row[i].from <= row[kept].to + gap)
        row[kept].to = std::max(row[kept].to, row[i].to);
      else
        row[++kept] = row[i];
    }
    if (!row.empty()) row.resize(kept + 1);
  }
  return intervals;
}

bool overlap(const Interval& a, const Interval& b) { return a.from < b.to && b.from < a.to; }

/// The only one of `row` that overlaps, or none.
std::size_t only_neighbour(const Interval& interval, const std::vector<Interval>& row) {
  std::size_t found = row.size();
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!overlap(interval, row[i])) continue;
    if (found != row.size()) return row.size();
    found = i;
  }
  return found;
}

}  // namespace

SweepFrame::SweepFrame(double direction) : cos_(std::cos(direction)), sin_(std::sin(direction)) {}

Vector2 SweepFrame::in(const Vector2& point) const {
  return {cos_ * point.x() + sin_ * point.y(), cos_ * point.y() - sin_ * point.x()};
}

Vector2 SweepFrame::out(const Vector2& point) const {
  return {cos_ * point.x() - sin_ * point.y(), cos_ * point.y() + sin_ * point.x()};
}

void SweepFrame::turn(const Polygon& polygon, Polygon& into) const {
  into.resize(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) into[i] = in(polygon[i]);
}

Region SweepFrame::in(const Region& region) const {
  Region turned;
  turn(region.outer, turned.outer);
  turned.holes.resize(region.holes.size());
  for (std::size_t i = 0; i < region.holes.size(); ++i) turn(region.holes[i], turned.holes[i]);
  return turned;
}

Breadth breadth_of(const Polygon& turned) {
  Breadth breadth{kInfinity, -kInfinity};
  for (const Vector2& corner : turned) {
    breadth.low = std::min(breadth.low, corner.y());
    breadth.high = std::max(breadth.high, corner.y());
  }
  return breadth;
}

std::size_t lane_count(double width, double swath) {
  constexpr double kRounding = 1e-9;
  return static_cast<std::size_t>(std::max(1.0, std::ceil(width / swath * (1 - kRounding))));
}

void whole_strips(const Polygon& turned, double swath, Block& lanes) {
  const Strips strips = strips_of(turned, swath);
  lanes.resize(strips.count);
  for (std::size_t i = 0; i < strips.count; ++i)
    lanes[i] = {strips.centre(i), kInfinity, -kInfinity};
  const auto widen = [&](std::size_t index, double x) {
    lanes[index].from = std::min(lanes[index].from, x);
    lanes[index].to = std::max(lanes[index].to, x);
  };
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const Vector2& a = turned[i];
    const Vector2& b = turned[i + 1 == turned.size() ? 0 : i + 1];
    const Edge edge = a.y() <= b.y() ? Edge{a, b} : Edge{b, a};
    const std::size_t first = strips.index_of(edge.low.y()), last = strips.index_of(edge.high.y());
    widen(first, edge.low.x());
    widen(last, edge.high.x());
    for (std::size_t k = first; k < last; ++k) {
      const double x = edge.x_at(strips.border(k + 1));
      widen(k, x);
      widen(k + 1, x);
    }
  }
}

std::vector<Block> split_strips(const Region& turned, double swath, double gap) {
  const Strips strips = strips_of(turned.outer, swath);
  const auto rows = intervals_of(turned, strips, gap);
  std::vector<Block> blocks;
  std::vector<std::size_t> block_of, before;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    block_of.clear();
    for (const Interval& interval : rows[i]) {
      std::size_t block = blocks.size();
      if (i > 0) {
        const std::size_t below = only_neighbour(interval, rows[i - 1]);
        if (below < rows[i - 1].size() &&
            only_neighbour(rows[i - 1][below], rows[i]) < rows[i].size())
          block = before[below];
      }
      if (block == blocks.size()) blocks.emplace_back();
      blocks[block].push_back({strips.centre(i), interval.from, interval.to});
      block_of.push_back(block);
    }
    before.swap(block_of);
  }
  return blocks;
}

}  // namespace skein::refiners
