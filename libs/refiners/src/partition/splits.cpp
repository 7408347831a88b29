// SPDX-License-Identifier: Apache-2.0
#include "partition/splits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

namespace skein::refiners::partition {
namespace {

constexpr double kPi = std::numbers::pi;
/// More anchors than these in one place are told apart in one order only, not in all subsets.
constexpr std::size_t kMostSubsets = 6;

using Who = std::vector<std::size_t>;

double half_turn(double angle) {
  const double wrapped = std::fmod(angle, kPi);
  return wrapped < 0 ? wrapped + kPi : wrapped;
}

/// The direction of the normal of the line through two points, [0, π).
double normal_through(const Vector2& a, const Vector2& b) {
  return half_turn(std::atan2(b.y() - a.y(), b.x() - a.x()) + kPi / 2);
}

/// Turns a line about one anchor of a piece.
class Pivot {
 public:
  Pivot(const Piece& piece, const Claims& claims, std::size_t anchor)
      : piece_(piece), claims_(claims), at_(claims.anchors[anchor]) {
    for (const std::size_t other : piece.who)
      if (near(other)) here_.push_back(other);
    whole_ = signed_area(piece.polygon);
    total_ = claims.sum(piece.who);
  }

  bool is_first_here(std::size_t anchor) const { return here_.front() == anchor; }

  /// Angles at which the anchors below, with which the piece is cut in the right proportion, are
  /// known.
  void find(std::map<Who, std::vector<double>>& found) const {
    const std::vector<double> events = this->events();
    double area = area_below(events[0]);
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      const double next = area_below(events[i + 1]);
      search({events[i], area}, {events[i + 1], next}, found);
      area = next;
    }
  }

 private:
  struct Sample {
    double angle, area;
  };

  bool near(std::size_t other) const {
    return (claims_.anchors[other] - at_).norm() <= claims_.tolerance();
  }
  double area_below(double angle) const {
    return partition::area_below(piece_.polygon, {angle, normal(angle).dot(at_)});
  }

  /// Between two of these the anchors below do not change and the area is monotone.
  std::vector<double> events() const {
    std::vector<double> angles = {0, kPi};
    for (const Vector2& corner : piece_.polygon)
      if ((corner - at_).norm() > claims_.tolerance())
        angles.push_back(normal_through(at_, corner));
    for (const std::size_t other : piece_.who)
      if (!near(other)) angles.push_back(normal_through(at_, claims_.anchors[other]));
    std::sort(angles.begin(), angles.end());
    const std::size_t count = angles.size();
    for (std::size_t i = 0; i + 1 < count; ++i)
      if (const auto angle = halved_chord(angles[i], angles[i + 1])) angles.push_back(*angle);
    std::inplace_merge(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count),
                       angles.end());
    return angles;
  }

  /// The area is extreme where the pivot halves the chord.
  std::optional<double> halved_chord(double from, double until) const {
    const Vector2 up = normal((from + until) / 2);
    const Polygon& polygon = piece_.polygon;
    std::vector<std::size_t> crossed;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2& q = polygon[(i + 1) % polygon.size()];
      if ((up.dot(polygon[i] - at_) < 0) != (up.dot(q - at_) < 0)) crossed.push_back(i);
    }
    if (crossed.size() != 2) return std::nullopt;
    const auto along = [&](std::size_t i) -> Vector2 {
      return polygon[(i + 1) % polygon.size()] - polygon[i];
    };
    const Vector2 &p = polygon[crossed[0]], &q = polygon[crossed[1]];
    const Vector2 d = along(crossed[0]), e = along(crossed[1]), sum = 2 * at_ - p - q;
    const double determinant = d.x() * e.y() - d.y() * e.x();
    if (determinant == 0) return std::nullopt;
    const Vector2 end = p + d * ((sum.x() * e.y() - sum.y() * e.x()) / determinant);
    const double angle = normal_through(at_, end);
    return angle > from && angle < until ? std::optional(angle) : std::nullopt;
  }

  void search(const Sample& from, const Sample& until,
              std::map<Who, std::vector<double>>& found) const {
    const Vector2 up = normal((from.angle + until.angle) / 2);
    Who below;
    for (const std::size_t other : piece_.who)
      if (!near(other) && up.dot(claims_.anchors[other] - at_) < 0) below.push_back(other);
    const std::size_t first = below.size();
    const double least = std::min(from.area, until.area), most = std::max(from.area, until.area);
    if (claims_.sum(below) / total_ * whole_ > most + slack()) return;
    for_subsets([&](const Who& subset) {
      below.resize(first);
      below.insert(below.end(), subset.begin(), subset.end());
      if (below.empty() || below.size() == piece_.who.size()) return;
      const double wanted = claims_.sum(below) / total_ * whole_;
      if (wanted < least - slack() || wanted > most + slack()) return;
      Who key = below;
      std::sort(key.begin(), key.end());
      found[key].push_back(root(from, until, wanted));
    });
  }

  double slack() const { return 1e-12 * whole_; }

  template <class Visit>
  void for_subsets(const Visit& visit) const {
    Who subset;
    if (here_.size() > kMostSubsets) {
      visit(subset);
      for (const std::size_t one : here_) {
        subset.push_back(one);
        visit(subset);
      }
      return;
    }
    for (std::size_t mask = 0; mask < (std::size_t{1} << here_.size()); ++mask) {
      subset.clear();
      for (std::size_t bit = 0; bit < here_.size(); ++bit)
        if ((mask >> bit & 1U) != 0) subset.push_back(here_[bit]);
      visit(subset);
    }
  }

  /// Where a monotone area takes a value between those at the ends (Illinois).
  double root(Sample from, Sample until, double wanted) const {
    double a = from.area - wanted, b = until.area - wanted;
    if (std::abs(a) <= slack()) return from.angle;
    if (std::abs(b) <= slack()) return until.angle;
    double middle = from.angle;
    for (int round = 0; round < 100; ++round) {
      middle = until.angle - b * (until.angle - from.angle) / (b - a);
      if (!(middle > from.angle && middle < until.angle)) middle = (from.angle + until.angle) / 2;
      const double value = area_below(middle) - wanted;
      if (std::abs(value) <= 1e-3 * slack() || until.angle - from.angle < 1e-15) break;
      if ((value < 0) == (a < 0)) {
        if (round % 3 == 2) b /= 2;
        from.angle = middle;
        a = value;
      } else {
        if (round % 3 == 2) a /= 2;
        until.angle = middle;
        b = value;
      }
    }
    return middle;
  }

  const Piece& piece_;
  const Claims& claims_;
  Vector2 at_;
  Who here_;  ///< anchors in the place of the pivot
  double whole_ = 0, total_ = 0;
};

/// The line of that angle with what these claim below it, if all anchors are where they belong.
std::optional<Split> split_at(const Piece& piece, const Claims& claims, const Who& below,
                              double angle) {
  const double part = claims.sum(below) / claims.sum(piece.who);
  const Cut cut = cut_with_area(piece.polygon, angle, part * signed_area(piece.polygon));
  Split split;
  split.below.who = below;
  std::set_difference(piece.who.begin(), piece.who.end(), below.begin(), below.end(),
                      std::back_inserter(split.above.who));
  const auto height = [&](std::size_t i) {
    return normal(angle).dot(claims.anchors[i]) - cut.offset;
  };
  for (const std::size_t i : split.below.who)
    if (height(i) > claims.tolerance()) return std::nullopt;
  for (const std::size_t i : split.above.who)
    if (height(i) < -claims.tolerance()) return std::nullopt;
  std::tie(split.below.polygon, split.above.polygon) = halves(piece.polygon, cut, claims.snap());
  if (split.below.polygon.size() < 3 || split.above.polygon.size() < 3) return std::nullopt;
  split.cost = slenderness(split.below.polygon) + slenderness(split.above.polygon);
  return split;
}

}  // namespace

double Claims::sum(const std::vector<std::size_t>& who) const {
  return std::accumulate(who.begin(), who.end(), 0.0,
                         [&](double total, std::size_t i) { return total + shares[i]; });
}

double slenderness(const Polygon& polygon) {
  const double length = perimeter(polygon);
  return length * length / signed_area(polygon);
}

std::vector<Split> splits_of(const Piece& piece, const Claims& claims) {
  std::map<Who, std::vector<double>> found;
  for (const std::size_t anchor : piece.who) {
    const Pivot pivot(piece, claims, anchor);
    if (pivot.is_first_here(anchor)) pivot.find(found);
  }
  std::vector<Split> splits;
  for (auto& [below, angles] : found) {
    std::sort(angles.begin(), angles.end());
    const std::size_t count = angles.size();
    for (std::size_t i = 0; i + 1 < count; ++i)
      angles.push_back(angles[i] + claims.between * (angles[i + 1] - angles[i]));
    for (const double angle : angles)
      if (auto split = split_at(piece, claims, below, angle)) splits.push_back(std::move(*split));
  }
  std::stable_sort(splits.begin(), splits.end(),
                   [](const Split& a, const Split& b) { return a.cost < b.cost; });
  return splits;
}

}  // namespace skein::refiners::partition
