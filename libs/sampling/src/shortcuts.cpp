// SPDX-License-Identifier: Apache-2.0
#include "shortcuts.hpp"

#include <algorithm>
#include <vector>

namespace skein::sampling {
namespace {

using refiners::Way;
using world::Vector3;
using IsFree = std::function<bool(const Vector3&, const Vector3&)>;

/// A place on a way: a fraction of the leg that begins at a corner.
struct Place {
  std::size_t leg;
  double part;
};

/// A corner where it is nearer than a millimetre.
Vector3 point_at(const Way& way, const Place& place) {
  const Vector3 point = way[place.leg] + place.part * (way[place.leg + 1] - way[place.leg]);
  for (const std::size_t corner : {place.leg, place.leg + 1})
    if ((point - way[corner]).norm() < 1e-3) return way[corner];
  return point;
}

/// Uniform by length.
Place random_place(const Way& way, double length, Random& random) {
  double left = random.uniform(0, length);
  for (std::size_t leg = 0; leg + 1 < way.size(); ++leg) {
    const double here = (way[leg + 1] - way[leg]).norm();
    if (left < here) return {leg, left / here};
    left -= here;
  }
  return {way.size() - 2, 1};
}

/// From each corner straight on to the furthest that is free.
Way without_needless_corners(const Way& way, const IsFree& is_free) {
  Way kept = {way.front()};
  std::size_t here = 0;
  while (here + 1 < way.size()) {
    std::size_t next = way.size() - 1;
    while (next > here + 1 && !is_free(way[here], way[next])) --next;
    kept.push_back(way[next]);
    here = next;
  }
  return kept;
}

double detour(const Vector3& a, const Vector3& corner, const Vector3& b) {
  return (corner - a).norm() + (b - corner).norm();
}

/// Where a corner makes the way shortest on a line through it: detours are convex along lines.
Vector3 best_on_line(const Vector3& a, const Vector3& corner, const Vector3& b,
                     const Vector3& direction) {
  double low = -std::max((corner - a).norm(), (b - corner).norm()), high = -low;
  for (int i = 0; i < 40; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    const bool is_left =
        detour(a, corner + left * direction, b) < detour(a, corner + right * direction, b);
    (is_left ? high : low) = is_left ? right : left;
  }
  return corner + (low + high) / 2 * direction;
}

Vector3 random_direction(Random& random) {
  Vector3 ball;
  do {
    for (double& axis : ball) axis = random.uniform(-1, 1);
  } while (ball.squaredNorm() > 1 || ball.squaredNorm() < 0.01);
  return ball.normalized();
}

/// Draws the corners of a free way in. Every move keeps it free and makes it shorter; what could
/// gain less than `least_gain` [m] is not tried.
class Tightening {
 public:
  Tightening(const IsFree& is_free, double least_gain, Random& random)
      : is_free_(is_free), least_gain_(least_gain), random_(random) {}

  /// A corner moves as far as it is free to where the way would be shorter: towards the straight
  /// line between its neighbours; back along its two legs; up or down alone; and, since it may lie
  /// against something along which it can only slide, along lines drawn at random.
  void pull(Way& way, std::size_t i) {
    const Vector3 a = way[i - 1], b = way[i + 1];
    const Vector3 along = b - a;
    if (along.squaredNorm() > 0) {
      const double part = (way[i] - a).dot(along) / along.squaredNorm();
      pull_to(way, i, a + std::clamp(part, 0.0, 1.0) * along);
    }
    pull_to(way, i, a);
    pull_to(way, i, b);
    pull_to(way, i, best_on_line(a, way[i], b, Vector3::UnitZ()));
    for (int k = 0; k < 2; ++k)
      pull_to(way, i, best_on_line(a, way[i], b, random_direction(random_)));
  }

  /// The corners between two others take the heights of one slope, as far as that is free: all
  /// together, since one by one they would hold each other back. Then those of each half.
  void level(Way& way, std::size_t first, std::size_t last) const {
    if (last - first < 2) return;
    const Way before(way.begin() + static_cast<std::ptrdiff_t>(first),
                     way.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const Way sloped = on_one_slope(before);
    if (refiners::length_of(sloped) < refiners::length_of(before) - least_gain_) {
      const auto between = [&](double part) {
        Way moved = before;
        for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += part * (sloped[i] - before[i]);
        return moved;
      };
      const Way best = between(furthest([&](double part) {
        const Way moved = between(part);
        for (std::size_t i = 1; i < moved.size(); ++i)
          if (!is_free_(moved[i - 1], moved[i])) return false;
        return true;
      }));
      std::copy(best.begin(), best.end(), way.begin() + static_cast<std::ptrdiff_t>(first));
    }
    const std::size_t middle = (first + last) / 2;
    level(way, first, middle);
    level(way, middle, last);
  }

  /// A corner becomes two where the way cannot go straight past it but can turn in two steps.
  Way with_corners_cut(const Way& way) const {
    Way cut = {way.front()};
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
      const Vector3 before = cut.back(), corner = way[i], after = way[i + 1];
      const Vector3 to_a = (before - corner) / 2, to_b = (after - corner) / 2;
      const double most = to_a.norm() + to_b.norm() - (to_b - to_a).norm();
      const double part = most < least_gain_ ? 0 : furthest([&](double step) {
        const Vector3 p = corner + step * to_a, q = corner + step * to_b;
        return is_free_(p, q) && is_free_(before, p) && is_free_(q, after);
      });
      if (part * most >= least_gain_) {
        cut.push_back(corner + part * to_a);
        cut.push_back(corner + part * to_b);
      } else {
        cut.push_back(corner);
      }
    }
    cut.push_back(way.back());
    return cut;
  }

 private:
  /// The greatest step that halving finds free, 0 if none is.
  template <class Free>
  static double furthest(const Free& free_at) {
    if (free_at(1.0)) return 1;
    double free = 0, blocked = 1;
    for (int i = 0; i < 7; ++i) {
      const double middle = (free + blocked) / 2;
      (free_at(middle) ? free : blocked) = middle;
    }
    return free;
  }

  /// Ends stay; in between the height goes with the distance on the map.
  static Way on_one_slope(Way way) {
    std::vector<double> far = {0};
    for (std::size_t i = 1; i < way.size(); ++i)
      far.push_back(far.back() + (way[i] - way[i - 1]).head<2>().norm());
    const double rise = way.back().z() - way.front().z();
    for (std::size_t i = 1; far.back() > 0 && i + 1 < way.size(); ++i)
      way[i].z() = way.front().z() + rise * far[i] / far.back();
    return way;
  }

  void pull_to(Way& way, std::size_t i, const Vector3& target) const {
    const Vector3 a = way[i - 1], corner = way[i], b = way[i + 1];
    const double now = detour(a, corner, b);
    if (detour(a, target, b) > now - least_gain_) return;
    const double step = furthest([&](double part) {
      const Vector3 moved = corner + part * (target - corner);
      return is_free_(a, moved) && is_free_(moved, b);
    });
    const Vector3 moved = corner + step * (target - corner);
    if (detour(a, moved, b) < now) way[i] = moved;
  }

  const IsFree& is_free_;
  double least_gain_;
  Random& random_;
};

/// In rounds, until one gains too little.
void tighten(Way& way, const IsFree& is_free, const std::function<bool()>& is_over,
             Random& random) {
  constexpr int kMostRounds = 12;
  double before = refiners::length_of(way);
  Tightening tightening(is_free, 1e-5 * before, random);
  for (int round = 0; round < kMostRounds && way.size() > 2 && !is_over(); ++round) {
    for (std::size_t i = 1; i + 1 < way.size() && !is_over(); ++i) tightening.pull(way, i);
    tightening.level(way, 0, way.size() - 1);
    way = without_needless_corners(tightening.with_corners_cut(way), is_free);
    const double after = refiners::length_of(way);
    if (after > before * (1 - 1e-4)) return;
    before = after;
  }
}

}  // namespace

Way shortened(const Way& way, const IsFree& is_free, const std::function<bool()>& is_over,
              Random& random, int tries) {
  if (way.size() < 3) return way;
  Way best = without_needless_corners(way, is_free);
  double length = refiners::length_of(best);
  for (int in_vain = 0; in_vain < tries && best.size() > 2 && !is_over(); ++in_vain) {
    Place from = random_place(best, length, random), to = random_place(best, length, random);
    if (from.leg > to.leg) std::swap(from, to);
    if (from.leg == to.leg) continue;
    const Vector3 a = point_at(best, from), b = point_at(best, to);
    // Parts of free legs too: what is asked of samples may differ for them.
    if (!is_free(a, b) || !is_free(best[from.leg], a) || !is_free(b, best[to.leg + 1])) continue;
    Way cut(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(from.leg) + 1);
    for (const Vector3& point : {a, b})
      if (point != cut.back()) cut.push_back(point);
    for (std::size_t i = to.leg + 1; i < best.size(); ++i)
      if (best[i] != cut.back()) cut.push_back(best[i]);
    const double cut_length = refiners::length_of(cut);
    if (cut_length > length * (1 - 1e-4)) continue;
    best = std::move(cut);
    length = cut_length;
    in_vain = 0;
  }
  tighten(best, is_free, is_over, random);
  return best;
}

}  // namespace skein::sampling
