// SPDX-License-Identifier: Apache-2.0
// The sweep frame has axis u along the legs and v across them; the zone is cut in strips of equal
// height in v, and each strip gets one leg per connected stretch of u that the zone takes in it.
#include "skein/ground_station/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skein::ground_station {
namespace {

using world::Polygon;
using world::Vector2;

constexpr double kMaxLegs = 10'000;
constexpr double kSmall = 1e-9;  // [m], relative to nothing: zones are a metre to kilometres wide

struct Interval {
  double low;
  double high;
};

struct Strip {
  double v;  // of the leg
  double low;
  double high;
  std::vector<Interval> stretches;  // disjoint, ascending
};

struct Frame {
  Vector2 along;
  Vector2 across;
  double low = 0;     // of the zone, in v
  double height = 0;  // of the zone, in v

  Vector2 to_frame(const Vector2& p) const { return {p.dot(along), p.dot(across)}; }
  Vector2 from_frame(double u, double v) const { return u * along + v * across; }
};

Frame frame_along(const Polygon& zone, const Vector2& along) {
  Frame frame{along, {-along.y(), along.x()}};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vector2& p : zone) {
    low = std::min(low, p.dot(frame.across));
    high = std::max(high, p.dot(frame.across));
  }
  frame.low = low;
  frame.height = high - low;
  return frame;
}

// The frame along the edge that makes the zone lowest: it needs the fewest legs.
Frame lowest_frame(const Polygon& zone) {
  Frame best;
  best.height = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zone.size(); ++i) {
    const Vector2 edge = zone[(i + 1) % zone.size()] - zone[i];
    if (edge.norm() < kSmall) continue;
    const Frame frame = frame_along(zone, edge.normalized());
    if (frame.height < best.height - kSmall) best = frame;
  }
  return best;
}

// The stretches of u inside the zone on the line at v, by crossing parity.
void add_cross_section(const Polygon& zone, double v, std::vector<Interval>& out) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < zone.size(); ++i) {
    const Vector2& p = zone[i];
    const Vector2& q = zone[(i + 1) % zone.size()];
    if ((p.y() <= v) == (q.y() <= v)) continue;
    crossings.push_back(p.x() + (v - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    out.push_back({crossings[i], crossings[i + 1]});
  }
}

// The stretch of u of the part of the edge p-q that lies in the strip.
void add_edge(const Vector2& p, const Vector2& q, const Strip& strip, std::vector<Interval>& out) {
  const double rise = q.y() - p.y();
  double from = 0;
  double to = 1;
  if (std::abs(rise) < kSmall) {
    if (p.y() < strip.low || p.y() > strip.high) return;
  } else {
    const double a = (strip.low - p.y()) / rise;
    const double b = (strip.high - p.y()) / rise;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
    if (from > to) return;
  }
  const double u0 = p.x() + from * (q.x() - p.x());
  const double u1 = p.x() + to * (q.x() - p.x());
  out.push_back({std::min(u0, u1), std::max(u0, u1)});
}

std::vector<Interval> merged(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.low < b.low; });
  std::vector<Interval> out;
  for (const Interval& interval : intervals) {
    if (!out.empty() && interval.low <= out.back().high + kSmall) {
      out.back().high = std::max(out.back().high, interval.high);
    } else {
      out.push_back(interval);
    }
  }
  return out;
}

// A connected part of the zone within a strip projects on u as its outline does: parts of edges,
// and parts of the strip's two borders.
void find_stretches(const Polygon& in_frame, Strip& strip) {
  std::vector<Interval> found;
  for (std::size_t i = 0; i < in_frame.size(); ++i) {
    add_edge(in_frame[i], in_frame[(i + 1) % in_frame.size()], strip, found);
  }
  add_cross_section(in_frame, strip.low, found);
  add_cross_section(in_frame, strip.high, found);
  strip.stretches = merged(std::move(found));
}

std::vector<Strip> cut(const Polygon& zone, const Frame& frame, double spacing) {
  Polygon in_frame;
  for (const Vector2& p : zone) in_frame.push_back(frame.to_frame(p));
  const int count = static_cast<int>(std::max(1.0, std::ceil(frame.height / spacing - kSmall)));
  const double step = frame.height / count;
  std::vector<Strip> strips;
  for (int i = 0; i < count; ++i) {
    const double low = frame.low + i * step;
    strips.push_back({low + step / 2, low, low + step, {}});
    find_stretches(in_frame, strips.back());
  }
  return strips;
}

// From the leg nearest to the start, to the nearer side of the zone first, then to the other.
std::vector<std::size_t> flying_order(const std::vector<Strip>& strips, double start_v) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < strips.size(); ++i) {
    if (std::abs(strips[i].v - start_v) < std::abs(strips[first].v - start_v)) first = i;
  }
  const bool up_first = strips.size() - 1 - first <= first;
  std::vector<std::size_t> up;
  std::vector<std::size_t> down;
  for (std::size_t i = first + (up_first ? 0 : 1); i < strips.size(); ++i) up.push_back(i);
  for (std::size_t i = first + (up_first ? 0 : 1); i > 0; --i) down.push_back(i - 1);
  std::vector<std::size_t>& head = up_first ? up : down;
  const std::vector<std::size_t>& tail = up_first ? down : up;
  head.insert(head.end(), tail.begin(), tail.end());
  return head;
}

void fly(const Strip& strip, bool forward, const Frame& frame, std::vector<Vector2>& out) {
  const std::size_t n = strip.stretches.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Interval& stretch = strip.stretches[forward ? i : n - 1 - i];
    out.push_back(frame.from_frame(forward ? stretch.low : stretch.high, strip.v));
    out.push_back(frame.from_frame(forward ? stretch.high : stretch.low, strip.v));
  }
}

}  // namespace

std::vector<Vector2> boustrophedon(const Polygon& zone, double spacing,
                                   std::optional<Vector2> start) {
  const bool finite =
      std::all_of(zone.begin(), zone.end(), [](const Vector2& p) { return p.allFinite(); });
  if (zone.size() < 3 || !finite || !(spacing > 0) || !(world::area(zone) > kSmall)) return {};
  const Frame frame = lowest_frame(zone);
  if (!(frame.height / spacing <= kMaxLegs)) return {};

  const std::vector<Strip> strips = cut(zone, frame, spacing);
  const Vector2 begin = start ? frame.to_frame(*start) : frame.to_frame(zone.front());
  const std::vector<std::size_t> order = flying_order(strips, start ? begin.y() : frame.low);
  const std::vector<Interval>& first = strips[order.front()].stretches;
  bool forward = std::abs(first.front().low - begin.x()) <= std::abs(first.back().high - begin.x());
  std::vector<Vector2> way;
  for (const std::size_t i : order) {
    fly(strips[i], forward, frame, way);
    forward = !forward;
  }
  return way;
}

}  // namespace skein::ground_station
