// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/volume.hpp"

#include <algorithm>

namespace skein::merging {

namespace {

using world::Vector2;

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

double squared_distance(const Vector2& point, const Vector2& from, const Vector2& to) {
  const Vector2 along = to - from;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - from - part * along).squaredNorm();
}

bool cross_each_other(const Volume& one, const Volume& other) {
  const Vector2 a = one.to - one.from, b = other.to - other.from;
  const double left = cross(a, other.from - one.from), right = cross(a, other.to - one.from);
  const double before = cross(b, one.from - other.from), behind = cross(b, one.to - other.from);
  return left * right < 0 && before * behind < 0;
}

double squared_distance(const Volume& one, const Volume& other) {
  if (cross_each_other(one, other)) return 0;
  return std::min({squared_distance(one.from, other.from, other.to),
                   squared_distance(one.to, other.from, other.to),
                   squared_distance(other.from, one.from, one.to),
                   squared_distance(other.to, one.from, one.to)});
}

}  // namespace

bool overlap(const Volume& one, const Volume& other) {
  if (one.ceiling <= other.floor || other.ceiling <= one.floor) return false;
  const double reach = one.radius + other.radius;
  return squared_distance(one, other) < reach * reach;
}

bool overlap(const Volumes& some, const Volumes& others) {
  return std::any_of(some.begin(), some.end(), [&](const Volume& one) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Volume& other) { return overlap(one, other); });
  });
}

}  // namespace skein::merging
