// SPDX-License-Identifier: Apache-2.0
// Small geometry shared by the views: boxes, axes, round ticks, simplified lines, labels in a
// crowd.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skein::report {

/// A point of a drawing [px], y down.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Box {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  bool overlaps(const Box& o) const {
    return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
  }
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// Linear map of [from, to] to [low, high]; from < to.
struct Axis {
  double from = 0.0;
  double to = 1.0;
  double low = 0.0;
  double high = 1.0;
  double operator()(double value) const {
    return low + (value - from) / (to - from) * (high - low);
  }
};

/// The least of 1, 2, 5 × 10^n that is at least `least`.
double round_step(double least);

/// The same for time: 1, 2, 5, 10, 15, 30 s, 1, 2, 5, 10, 15, 30 min, 1, 2, 3, 6, 12 h, then days.
double round_time_step(double least);

/// The multiples of `step` in [from, to]; none when there would be more than 1000.
std::vector<double> ticks(double from, double to, double step);

/// The points that keep a line within `tolerance` of the whole (Douglas and Peucker 1973), at most
/// `most` of them: the tolerance doubles until they fit. Cost: O(n log n) expected.
std::vector<Point> simplified(const std::vector<Point>& line, double tolerance, std::size_t most);

/// Estimated width of text [px]; generous, so that what fits on paper fits on screen.
double text_width(std::string_view text, double font_size);

/// Places labels beside their points so that none covers another.
class LabelPlacer {
 public:
  struct Placed {
    double x;
    double y;            ///< of the base line
    const char* anchor;  ///< SVG text-anchor
  };

  explicit LabelPlacer(Box area) : area_(area) {}
  /// Reserves a box that labels must not overlap.
  void block(const Box& box) { taken_.push_back(box); }
  /// Adds a point that labels should not cover.
  void avoid(Point p) { avoided_.push_back(p); }
  /// Reserves the free place beside the mark at `at` (of the given radius) that covers the fewest
  /// points to avoid; preferably on the right-hand side. Nothing: no place is free.
  std::optional<Placed> place(Point at, double radius, std::string_view text, double font_size);

 private:
  bool is_free(const Box& box) const;
  std::size_t covered(const Box& box) const;

  Box area_;
  std::vector<Box> taken_;
  std::vector<Point> avoided_;
};

}  // namespace skein::report
