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

/// More full circles than that climb nothing sensible.
constexpr double kMostCircles = 500;
/// So much longer than a climb needs are its turns made, relatively: for rounding, and so that a
/// point too many may be left out though that shortens it.
constexpr double kSlack = 5e-4;
/// About what it takes to find out whether a segment is free [ns].
constexpr std::uint32_t kAsked = 5000;
/// And to find out how far a climb has to turn [ns].
constexpr std::uint32_t kTurned = 50'000;

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
Way profiled(const LevelWay& plane, const Climb& climb, Profile profile, double chord) {
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
std::optional<Way> FlyableLegs::lifted(const LevelWay& plane, double from, double to) {
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
  const LevelWay plane = without_doubles(curve.sampled(limits_.tolerance), same_place());
  const double rise = to.z - from.z;
  const double needed = std::max(rise / limits_.climb, -rise / limits_.descent);
  if (needed <= length_of(plane)) return lifted(plane, from.z, to.z);
  return with_turns(from, to, thorough);
}

/// A climb is turned at its foot first and a descent at its end, where that keeps the leg high over
/// the ground.
std::optional<Way> FlyableLegs::with_turns(const Station& from, const Station& to, bool thorough) {
  const double rise = to.z - from.z;
  const double needed = std::max(rise / limits_.climb, -rise / limits_.descent) * (1 + kSlack);
  if (needed > kMostCircles * 2 * std::numbers::pi * limits_.radius) return std::nullopt;
  constexpr std::array<double, 5> kPlaces = {0, 1, 0.5, 0.25, 0.75};
  for (std::size_t i = 0; i < (thorough ? kPlaces.size() : 2); ++i)
    for (const bool left : {true, false}) {
      if (deadline_.passed_after(kTurned)) left_ = 0;
      if (left_ == 0) return std::nullopt;
      const double place = rise > 0 ? kPlaces[i] : 1 - kPlaces[i];
      const AddedTurn turn{place, left, place == 1};
      const LevelWay plane = without_doubles(
          lengthened(from.pose, to.pose, limits_.radius, turn, needed, limits_.tolerance),
          same_place());
      if (auto way = lifted(plane, from.z, to.z)) return way;
    }
  return std::nullopt;
}

}  // namespace skein::refiners
