// SPDX-License-Identifier: Apache-2.0
#include "skein/world/polygon_rings.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

#include "skein/world/segment.hpp"

namespace skein::world {
namespace {

constexpr double kAlways = std::numeric_limits<double>::infinity();

/// By how much the border moves, at most, if a corner is left out with all that matter no more. The
/// first corner, and that farthest from it, always stay.
class Importance {
 public:
  explicit Importance(const Polygon& polygon) : polygon_(polygon), importance_(polygon.size(), 0) {
    const std::size_t n = polygon.size();
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if ((polygon[i] - polygon[0]).norm() > (polygon[farthest] - polygon[0]).norm()) farthest = i;
    importance_[0] = importance_[farthest] = kAlways;
    spans_ = {{0, farthest, kAlways}, {farthest, n, kAlways}};
    while (!spans_.empty()) {
      const Span span = spans_.back();
      spans_.pop_back();
      split(span);
    }
  }
  const std::vector<double>& of_corners() const { return importance_; }

 private:
  struct Span {
    std::size_t from, until;  ///< corners; until may be the first again
    double least;             ///< of the corners that split it off
  };

  void split(const Span& span) {
    const Vector2& a = polygon_[span.from];
    const Vector2& b = polygon_[span.until % polygon_.size()];
    std::size_t worst = span.from;
    double most = -1;
    for (std::size_t i = span.from + 1; i < span.until; ++i)
      if (const double off = to_segment(polygon_[i], a, b); off > most) {
        most = off;
        worst = i;
      }
    if (worst == span.from) return;
    importance_[worst] = std::min(most, span.least);
    spans_.push_back({span.from, worst, importance_[worst]});
    spans_.push_back({worst, span.until, importance_[worst]});
  }

  const Polygon& polygon_;
  std::vector<double> importance_;
  std::vector<Span> spans_;
};

SimplifiedPolygon with_most(const Polygon& polygon, const std::vector<double>& importance,
                            std::size_t most) {
  std::vector<double> sorted = importance;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(most), sorted.end(),
                   std::greater<>());
  SimplifiedPolygon kept;
  kept.tolerance = sorted[most];  // the most important of those left out
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (importance[i] > kept.tolerance) kept.polygon.push_back(polygon[i]);
  return kept;
}

}  // namespace

Polygon without_closing_corner(Polygon ring) {
  if (ring.size() > 3 && (ring.front() - ring.back()).norm() <= kTouching) ring.pop_back();
  return ring;
}

std::optional<SimplifiedPolygon> simplified(const Polygon& polygon, std::size_t most_corners) {
  if (polygon.size() <= most_corners) return SimplifiedPolygon{polygon, 0};
  const Importance importance(polygon);
  for (std::size_t most = most_corners; most >= 3; most = most * 4 / 5) {
    SimplifiedPolygon kept = with_most(polygon, importance.of_corners(), most);
    if (!problem_of(kept.polygon)) return kept;
  }
  return std::nullopt;
}

}  // namespace skein::world
