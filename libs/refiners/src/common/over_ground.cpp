// SPDX-License-Identifier: Apache-2.0
#include "common/over_ground.hpp"

#include <algorithm>
#include <cmath>

#include "common/ground_profile.hpp"

namespace skein::refiners {
namespace {

/// About what it takes to look at the ground along one leg [ns].
constexpr std::uint32_t kLeg = 2000;

using world::Vector2;
using world::Vector3;

/// Of the way, closely enough for the terrain: which are corners, and how far along each is.
struct Samples {
  std::vector<Vector3> points;
  std::vector<double> along;
  std::vector<std::size_t> corners;
};

Samples sampled(const std::vector<Vector2>& way, const world::Terrain& terrain, double altitude,
                Deadline& deadline) {
  Samples samples;
  double along = 0;
  const auto add = [&](const Vector2& at, double ground) {
    samples.points.emplace_back(at.x(), at.y(), ground + altitude);
    samples.along.push_back(along);
  };
  for (std::size_t i = 0; i < way.size() && !deadline.passed_after(kLeg); ++i) {
    if (i > 0) {
      const Vector2 step = way[i] - way[i - 1];
      const double length = step.norm(), before = along;
      for (const GroundPoint& point : ground_along(terrain, way[i - 1], way[i])) {
        if (point.part <= 0 || point.part >= 1) continue;
        along = before + length * point.part;
        add(way[i - 1] + point.part * step, point.ground);
      }
      along = before + length;
    }
    samples.corners.push_back(samples.points.size());
    add(way[i], terrain.elevation(way[i].x(), way[i].y()));
  }
  return samples;
}

/// Raises what the vehicle would reach too late, or leave too early.
void flatten(Samples& samples, const HeightRule& rule) {
  for (std::size_t i = 1; i < samples.points.size(); ++i) {
    const double length = samples.along[i] - samples.along[i - 1];
    double& here = samples.points[i].z();
    here = std::max(here, samples.points[i - 1].z() - rule.descent * length);
  }
  for (std::size_t i = samples.points.size(); i-- > 1;) {
    const double length = samples.along[i] - samples.along[i - 1];
    double& here = samples.points[i - 1].z();
    here = std::max(here, samples.points[i].z() - rule.climb * length);
  }
}

/// Adds the points between two samples without which the leg would leave the heights.
void add_needed(const Samples& samples, std::size_t from, std::size_t until, double tolerance,
                Way& way) {
  std::vector<std::pair<std::size_t, std::size_t>> open = {{from, until}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    std::size_t worst = a;
    double most = tolerance;
    const double length = samples.along[b] - samples.along[a];
    for (std::size_t i = a + 1; i < b; ++i) {
      const double part = length > 0 ? (samples.along[i] - samples.along[a]) / length : 0;
      const double z =
          samples.points[a].z() + part * (samples.points[b].z() - samples.points[a].z());
      if (std::abs(samples.points[i].z() - z) <= most) continue;
      most = std::abs(samples.points[i].z() - z);
      worst = i;
    }
    if (worst == a) {
      way.push_back(samples.points[b]);
      continue;
    }
    open.emplace_back(worst, b);
    open.emplace_back(a, worst);
  }
}

}  // namespace

std::vector<Vector2> without_collinear(const std::vector<Vector2>& way) {
  std::vector<Vector2> kept;
  for (const Vector2& point : way) {
    if (!kept.empty() && (point - kept.back()).norm() < 1e-9) continue;
    if (kept.size() >= 2) {
      const Vector2 in = kept.back() - kept[kept.size() - 2], out = point - kept.back();
      const double turn = in.x() * out.y() - in.y() * out.x();
      if (std::abs(turn) <= 1e-9 * in.norm() * out.norm() && in.dot(out) > 0) kept.pop_back();
    }
    kept.push_back(point);
  }
  return kept;
}

std::vector<Vector2> first_part(const std::vector<Vector2>& way, double length) {
  std::vector<Vector2> part;
  for (const Vector2& point : way) {
    if (part.empty()) {
      part.push_back(point);
      continue;
    }
    const double leg = (point - part.back()).norm();
    if (leg >= length) {
      if (length > 0) part.push_back(part.back() + length / leg * (point - part.back()));
      return part;
    }
    length -= leg;
    part.push_back(point);
  }
  return part;
}

Way over_ground(const std::vector<Vector2>& way, const world::Terrain& terrain,
                const HeightRule& rule, Deadline& deadline) {
  Samples samples = sampled(without_collinear(way), terrain, rule.altitude, deadline);
  if (samples.points.empty()) return {};
  flatten(samples, rule);
  Way flown = {samples.points.front()};
  for (std::size_t i = 1; i < samples.corners.size(); ++i)
    add_needed(samples, samples.corners[i - 1], samples.corners[i],
               kHeightTolerance * rule.altitude, flown);
  return flown;
}

}  // namespace skein::refiners
