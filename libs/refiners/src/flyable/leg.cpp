// SPDX-License-Identifier: Apache-2.0
#include "flyable/leg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;
using Plane = std::vector<Vector2>;

/// More full circles than that climb nothing sensible.
constexpr double kMostCircles = 500;
/// About what it takes to find out whether a segment is free [ns].
constexpr std::uint32_t kAsked = 5000;

double length_of(const Plane& plane) {
  double length = 0;
  for (std::size_t i = 1; i < plane.size(); ++i) length += (plane[i] - plane[i - 1]).norm();
  return length;
}

/// Neighbours closer than `same` are one, since the direction between them is mostly rounding. Both
/// ends stay; any point left out was on the curve, so what remains is sampled from it too.
Plane without_doubles(const Plane& plane, double same) {
  Plane kept = {plane.front()};
  for (std::size_t i = 1; i + 1 < plane.size(); ++i)
    if ((plane[i] - kept.back()).norm() > same) kept.push_back(plane[i]);
  while (kept.size() > 1 && (kept.back() - plane.back()).norm() <= same) kept.pop_back();
  if (plane.back() != kept.back()) kept.push_back(plane.back());
  return kept;
}

/// The points of a curve with full circles at a distance along it.
Plane with_circles_at(const DubinsCurve& curve, double along, const DubinsCurve& circle, int count,
                      double tolerance) {
  const Pose start = curve.at(0), middle = circle.at(0), end = curve.at(curve.length());
  const double radius = circle.length() / (2 * std::numbers::pi);
  Plane plane = along <= 0 ? Plane{start.at}
                           : DubinsCurve::shortest(start, middle, radius).sampled(tolerance);
  const Plane round = circle.sampled(tolerance);
  for (int i = 0; i < count; ++i) plane.insert(plane.end(), round.begin() + 1, round.end());
  if (along >= curve.length()) return plane;
  const Plane rest = DubinsCurve::shortest(middle, end, radius).sampled(tolerance);
  plane.insert(plane.end(), rest.begin() + 1, rest.end());
  return plane;
}

/// How the height changes along a leg.
enum class Profile { kEven, kEarly, kLate };

/// The slope is the steepest there may be, upwards or downwards.
struct Climb {
  double from, to;
  double slope;
};

/// At `along` of a leg `length` long, with a slope that may be as steep as `slope` (signed).
double height_at(Profile profile, double along, double length, double rise, double slope) {
  if (profile == Profile::kEven) return length > 0 ? rise * along / length : 0;
  const double steepest = std::abs(rise) / std::abs(slope);  // level distance it takes
  const double begun = profile == Profile::kEarly ? 0 : std::max(0.0, length - steepest);
  return rise * std::clamp((along - begun) / steepest, 0.0, 1.0);
}

/// With a point more where an early or late profile bends on a line; the chords of arcs, which are
/// no longer than `chord`, stay whole, so that they still show how the arc turns.
Way profiled(const Plane& plane, const Climb& climb, Profile profile, double chord) {
  const auto [from, to, slope] = climb;
  const double rise = to - from;
  const double length = length_of(plane);
  const double steepest = rise == 0 ? 0 : std::abs(rise) / std::abs(slope);
  const double bend = profile == Profile::kEven    ? -1
                      : profile == Profile::kEarly ? steepest
                                                   : length - steepest;
  Way way;
  double along = 0;
  for (std::size_t i = 0; i < plane.size(); ++i) {
    if (i > 0) {
      const double step = (plane[i] - plane[i - 1]).norm();
      if (step > chord && bend > along + 1e-3 * step && bend < along + 0.999 * step) {
        const Vector2 at = plane[i - 1] + (bend - along) / step * (plane[i] - plane[i - 1]);
        way.emplace_back(at.x(), at.y(), from + height_at(profile, bend, length, rise, slope));
      }
      along += step;
    }
    way.emplace_back(plane[i].x(), plane[i].y(),
                     from + height_at(profile, along, length, rise, slope));
  }
  way.back().z() = to;
  return way;
}

}  // namespace

double level_length(const Way& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).head<2>().norm();
  return length;
}

double FlyableLegs::least_length(const Station& from, const Station& to) const {
  const double rise = to.z - from.z;
  const double climbing = std::max(rise / limits_.climb, -rise / limits_.descent);
  return std::max(DubinsCurve::shortest(from.pose, to.pose, limits_.radius).length(), climbing);
}

bool FlyableLegs::all_free(const Way& way) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (deadline_.passed_after(kAsked)) left_ = 0;
    if (left_ == 0) return false;
    --left_;
    if (is_free_ && !is_free_(way[i - 1], way[i])) return false;
  }
  return true;
}

/// Even first: nearest to the straight leg that was asked for. Then what keeps it high, then low.
std::optional<Way> FlyableLegs::lifted(const Plane& plane, double from, double to) {
  const double rise = to - from;
  const double slope = rise > 0 ? limits_.climb : -limits_.descent;
  if (std::abs(rise) > std::abs(slope) * length_of(plane) * (1 + 1e-9)) return std::nullopt;
  const auto high = rise > 0 ? Profile::kEarly : Profile::kLate;
  const auto low = rise > 0 ? Profile::kLate : Profile::kEarly;
  const double chord = limits_.radius * chord_angle(limits_.radius, limits_.tolerance);
  for (const Profile profile : {Profile::kEven, high, low}) {
    Way way = profiled(plane, {from, to, slope}, profile, chord);
    if (all_free(way)) return way;
    if (rise == 0) break;
  }
  return std::nullopt;
}

std::optional<Way> FlyableLegs::leg(const Station& from, const Station& to, bool thorough) {
  const auto curve = DubinsCurve::shortest(from.pose, to.pose, limits_.radius);
  const Plane plane = without_doubles(curve.sampled(limits_.tolerance), same_place());
  const double rise = to.z - from.z;
  const double needed = std::max(rise / limits_.climb, -rise / limits_.descent);
  if (needed <= length_of(plane)) return lifted(plane, from.z, to.z);
  return with_circles(curve, from, to, thorough);
}

/// A climb is turned at its foot first and a descent at its end, where that keeps the leg high over
/// the ground.
std::optional<Way> FlyableLegs::with_circles(const DubinsCurve& curve, const Station& from,
                                             const Station& to, bool thorough) {
  const double rise = to.z - from.z;
  const double needed = std::max(rise / limits_.climb, -rise / limits_.descent);
  constexpr std::array<double, 5> kPlaces = {0, 1, 0.5, 0.25, 0.75};
  const double flown = length_of(curve.sampled(limits_.tolerance));
  for (std::size_t i = 0; i < (thorough ? kPlaces.size() : 2); ++i)
    for (const bool left : {true, false}) {
      const double along = (rise > 0 ? kPlaces[i] : 1 - kPlaces[i]) * curve.length();
      const auto circle = DubinsCurve::circle(curve.at(along), limits_.radius, left);
      const double round = length_of(circle.sampled(limits_.tolerance));
      // Cutting the curve in two samples it anew, which may cost up to a chord's saving: hence 1 %.
      const double count = std::ceil((needed - 0.99 * flown) / round);
      if (count > kMostCircles) return std::nullopt;
      const Plane plane = without_doubles(
          with_circles_at(curve, along, circle, static_cast<int>(count), limits_.tolerance),
          same_place());
      if (auto way = lifted(plane, from.z, to.z)) return way;
    }
  return std::nullopt;
}

}  // namespace skein::refiners
