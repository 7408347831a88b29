// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/way.hpp"

#include <algorithm>
#include <cmath>

#include "skein/foundation/contract.hpp"
#include "skein/world/segment.hpp"

namespace skein::merging {

namespace {

using world::Vector3;

constexpr double kNear = 10;  // [m] a bend is taken within it, or half of what the way takes
/// Who cannot hover turns back to a way-point that it missed: so much it keeps behind, of what it
/// takes around a bend.
constexpr double kTurnsBack = 4;
constexpr double kAlmost = 1 - 1e-6;
constexpr double kLevel = 0.5;  // [m] of height that a level piece may gain, or the reverse

bool is_upright(const Vector3& from, const Vector3& to) {
  return (to - from).head<2>().norm() <= kLevel;
}

std::size_t pieces_of(double length, double longest) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / longest)));
}

std::vector<Vector3> stretched(const std::vector<Vector3>& points, double longest) {
  std::vector<Vector3> result{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector3 from = points[i - 1], along = points[i] - from;
    const auto pieces = static_cast<double>(pieces_of(along.head<2>().norm(), longest));
    for (double n = 1; n <= pieces; ++n) result.push_back(from + n / pieces * along);
  }
  return result;
}

/// The first as far off as may be: who cannot hover leaves its circle in any direction, and would
/// turn back to one that is nearer, and come to the next from elsewhere than the way does.
std::vector<Vector3> stretched_from_rest(const std::vector<Vector3>& points, double longest) {
  std::vector<Vector3> corners = points;
  const Vector3 along = points[1] - points[0];
  const double length = along.head<2>().norm();
  if (length > longest)
    corners.insert(corners.begin() + 1, points[0] + kAlmost * longest / length * along);
  return stretched(corners, longest);
}

bool slopes(const Vector3& from, const Vector3& to) { return std::abs(from.z() - to.z()) > kLevel; }

/// Way-points where wind carries off; and where the way slopes and in the piece beside that, since
/// a height that is not reached yet where a slope ends is made up for until the next way-point.
std::vector<Vector3> steered_along(const std::vector<Vector3>& points, const Margins& margins) {
  std::vector<Vector3> result{points.front()};
  const auto slopes_at = [&](std::size_t i) {
    return i >= 1 && i < points.size() && slopes(points[i - 1], points[i]);
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector3 from = points[i - 1], along = points[i] - from;
    const std::size_t pieces = pieces_of(along.head<2>().norm(), margins.stretch);
    const Vector3 piece = along / static_cast<double>(pieces);
    std::vector<Vector3> corners{from};
    if (slopes_at(i - 1) && pieces > 1) corners.push_back(from + piece);
    if (slopes_at(i + 1) && pieces > corners.size()) corners.push_back(points[i] - piece);
    corners.push_back(points[i]);
    const double longest = slopes_at(i) ? margins.stretch : margins.steered;
    const std::vector<Vector3> all = stretched(corners, longest);
    result.insert(result.end(), all.begin() + 1, all.end());
  }
  return result;
}

/// A first part that is left along with less than a way takes, long enough that what follows does
/// not reach back to where it begins. Returns how many pieces it will be.
std::size_t leaves_narrowly(std::vector<Vector3>& corners, const Margins& margins) {
  const double length = 2 * margins.way;
  const Vector3 along = corners[1] - corners[0];
  const bool level = std::abs(along.z()) <= kLevel;
  if (!level || along.norm() < 1.5 * length) return 0;
  corners.insert(corners.begin() + 1, corners[0] + length / along.norm() * along);
  return pieces_of(length, margins.stretch);
}

}  // namespace

Volume stay_at(const Vector3& place, const Margins& margins) {
  return column(place.head<2>(), place.z(), place.z(), margins);
}

Volume column(const world::Vector2& place, double low, double high, const Margins& margins) {
  return {place, place, margins.hold, low - margins.level, high + margins.level};
}

Way::Way(const std::vector<Vector3>& points, const Margins& margins, bool from_rest)
    : hovers_(margins.hovers), near_(std::max(kNear, margins.way / 2)) {
  SKEIN_EXPECTS(points.size() >= 2);
  std::vector<Vector3> corners = points;
  const std::size_t narrow = from_rest ? leaves_narrowly(corners, margins) : 0;
  points_ = stretched(corners, margins.stretch);
  const bool steered = margins.steered > margins.stretch;
  if (!hovers_)
    way_points_ = from_rest ? stretched_from_rest(points, margins.steered)
                            : stretched(points, margins.steered);
  else
    way_points_ = steered ? steered_along(points, margins) : points_;
  const auto is_lower = [](const Vector3& a, const Vector3& b) { return a.z() < b.z(); };
  const auto [lowest, highest] = std::minmax_element(points_.begin(), points_.end(), is_lower);
  // Whatever it has not reached yet, it is no lower and no higher than the way anywhere is.
  const double under = lowest->z() - margins.level, over = highest->z() + margins.level;
  bool rises = from_rest;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Vector3 &from = points_[i - 1], &to = points_[i];
    rises = rises && is_upright(from, to);
    if (rises) {
      pieces_.push_back(
          column(to.head<2>(), std::min(from.z(), to.z()), std::max(from.z(), to.z()), margins));
      continue;
    }
    // A bend is taken before it is reached, so a slope goes on into the pieces beside it.
    const bool steep = slopes(from, to) || (i >= 2 && slopes(points_[i - 2], from)) ||
                       (i + 1 < points_.size() && slopes(to, points_[i + 1]));
    const double height = steep ? margins.slope : margins.level;
    pieces_.push_back({from.head<2>(), to.head<2>(), margins.way,
                       std::max(under, std::min(from.z(), to.z()) - height),
                       std::min(over, std::max(from.z(), to.z()) + height)});
  }
  for (std::size_t i = 0; i < narrow; ++i) pieces_[i].radius = margins.hold;
  pieces_.push_back(stay_at(points_.back(), margins));
  note_rounds();
}

void Way::note_rounds() {
  for (auto one = pieces_.begin(); one != pieces_.end(); ++one) {
    again_.push_back(std::find(one + 1, pieces_.end(), *one) != pieces_.end());
    if (!again_.back()) volumes_.push_back(*one);
  }
}

bool Way::passed(const Vector3& position) {
  const std::size_t before = piece_;
  // Of bends near each other all are near at once, with the vehicle before the first of them.
  const auto is_beside = [&](std::size_t piece) {
    const double way = std::max(near_, pieces_[piece].radius);
    return world::to_segment(position, points_[piece], points_[piece + 1]) <= way;
  };
  while (piece_ + 2 < points_.size()) {
    if (hovers_ && piece_ > 0 && is_beside(piece_ - 1)) break;
    const Vector3 along = points_[piece_ + 1] - points_[piece_];
    const Vector3 off = position - points_[piece_ + 1];
    if (off.norm() > near_ && off.dot(along) < 0) break;
    ++piece_;
  }
  return piece_ != before;
}

std::size_t Way::first_left() const {
  std::size_t first = piece_;
  const double behind = hovers_ ? 0 : kTurnsBack * near_;
  double kept = 0;
  do {
    if (first == 0) break;
    --first;
    kept += (points_[first + 1] - points_[first]).norm();
  } while (kept < behind);
  return first;
}

Volumes Way::left() const {
  Volumes left;
  for (std::size_t i = first_left(); i < pieces_.size(); ++i)
    if (!again_[i]) left.push_back(pieces_[i]);
  return left;
}

double Way::length_left() const {
  double length = 0;
  for (std::size_t i = piece_ + 1; i < points_.size(); ++i)
    length += (points_[i] - points_[i - 1]).norm();
  return length;
}

}  // namespace skein::merging
