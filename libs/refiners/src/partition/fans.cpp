// SPDX-License-Identifier: Apache-2.0
#include "partition/fans.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace skein::refiners::partition {
namespace {

using Who = std::vector<std::size_t>;
using Groups = std::array<Who, 3>;

/// More anchors than these in the place of the apex: no fans, their number would explode.
constexpr std::size_t kMostAtApex = 4;
/// Nor in pieces with more anchors than these.
constexpr std::size_t kMostAnchors = 8;
/// Positions of the first ray that are tried for one choice of groups, evenly over those that hold.
constexpr int kPositions = 5;

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A convex polygon seen from a point in it. Directions are told by the area swept from the first
/// corner counter-clockwise: along an edge that is linear.
class Sweep {
 public:
  Sweep(const Polygon& polygon, const Vector2& apex) : polygon_(polygon), apex_(apex), swept_{0} {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      swept_.push_back(swept_.back() + std::max(0.0, cross(spoke(i), spoke(i + 1)) / 2));
  }
  double whole() const { return swept_.back(); }

  double towards(const Vector2& point) const {
    const Vector2 to = point - apex_;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const double from = cross(spoke(i), to), until = cross(to, spoke(i + 1));
      if (from >= 0 && until >= 0 && from + until > 0)
        return swept_[i] + (swept_[i + 1] - swept_[i]) * from / (from + until);
    }
    return 0;
  }

  /// Between two rays, `area` further on; nothing when it would not be convex.
  std::optional<Polygon> sector(double from, double area) const {
    Polygon result = {apex_, border(from)};
    const double until = from + area;
    const std::size_t count = polygon_.size();
    const double slack = 1e-14 * whole();  // no two corners in one place
    for (std::size_t i = 0; i < 2 * count; ++i) {
      const double corner = swept_[i % count] + (i < count ? 0 : whole());
      if (corner > from + slack && corner < until - slack) result.push_back(polygon_[i % count]);
    }
    result.push_back(border(until));
    if (cross(result[1] - apex_, result.back() - apex_) < 0) return std::nullopt;
    return result;
  }

 private:
  Vector2 spoke(std::size_t i) const { return polygon_[i % polygon_.size()] - apex_; }
  Vector2 border(double area) const {
    area = std::fmod(area, whole());
    const auto next = std::upper_bound(swept_.begin() + 1, swept_.end() - 1, area);
    const auto i = static_cast<std::size_t>(next - swept_.begin()) - 1;
    const double width = swept_[i + 1] - swept_[i];
    const double along = width > 0 ? (area - swept_[i]) / width : 0;
    const Vector2 &p = polygon_[i], &q = polygon_[(i + 1) % polygon_.size()];
    return p + (q - p) * along;
  }

  const Polygon& polygon_;
  Vector2 apex_;
  std::vector<double> swept_;
};

/// The fans from one anchor.
class Apex {
 public:
  Apex(const Piece& piece, const Claims& claims, std::size_t anchor)
      : piece_(piece), claims_(claims), sweep_(piece.polygon, claims.anchors[anchor]) {
    for (const std::size_t i : piece.who) {
      const Vector2 from_apex = claims.anchors[i] - claims.anchors[anchor];
      if (from_apex.norm() <= claims.tolerance())
        here_.push_back(i);
      else
        around_.push_back({sweep_.towards(claims.anchors[i]), i});
    }
    std::sort(around_.begin(), around_.end());
  }
  bool is_first_here(std::size_t anchor) const { return here_.front() == anchor; }

  void find(std::vector<Fan>& fans) const {
    if (here_.size() > kMostAtApex) return;
    std::size_t choices = 1;
    for (std::size_t i = 0; i < here_.size(); ++i) choices *= 3;
    const std::size_t n = around_.size();
    for (std::size_t choice = 0; choice < choices; ++choice)
      for (std::size_t first = 0; first < std::max<std::size_t>(n, 1); ++first)
        for (std::size_t second = 0; second <= n; ++second)
          for (std::size_t third = 0; third <= n - second; ++third)
            place(choice, {first, second, third}, fans);
  }

 private:
  /// Group 0 begins at the anchor `start[0]` around and has `start[1]` of them, group 1 `start[2]`.
  void place(std::size_t choice, const std::array<std::size_t, 3>& start,
             std::vector<Fan>& fans) const {
    const std::size_t n = around_.size();
    const std::array<std::size_t, 4> bounds = {0, start[1], start[1] + start[2], n};
    Groups groups;
    for (const std::size_t i : here_) {
      groups[choice % 3].push_back(i);
      choice /= 3;
    }
    for (std::size_t g = 0; g < 3; ++g)
      for (std::size_t k = bounds[g]; k < bounds[g + 1]; ++k)
        groups[g].push_back(around_[(start[0] + k) % n].second);
    if (groups[0].empty() || groups[1].empty() || groups[2].empty()) return;

    const double whole = sweep_.whole(), total = claims_.sum(piece_.who);
    double least = around_.empty() ? 0 : at(start[0] + n - 1) - whole;
    double most = around_.empty() ? whole : at(start[0]);
    double before = 0;  // area of the groups so far
    for (std::size_t g = 0; g + 1 < 3; ++g) {
      before += claims_.sum(groups[g]) / total * whole;
      if (n == 0) continue;
      // The ray after group g lies between the last anchor of it and the next one.
      const std::size_t last = start[0] + bounds[g + 1];
      least = std::max(least, at(last + n - 1) - whole - before);
      most = std::min(most, at(last) - before);
    }
    if (least > most) return;
    add(groups, {least, most}, fans);
  }

  /// Where the k-th anchor around is seen, counted on over as many turns as it takes.
  double at(std::size_t k) const {
    const std::size_t n = around_.size();
    return around_[k % n].first + static_cast<double>(k / n) * sweep_.whole();
  }

  void add(const Groups& groups, const std::array<double, 2>& span, std::vector<Fan>& fans) const {
    const double whole = sweep_.whole(), total = claims_.sum(piece_.who);
    for (int step = 0; step < kPositions; ++step) {
      double from = span[0] + (span[1] - span[0]) * step / (kPositions - 1);
      Fan fan;
      bool convex = true;
      for (std::size_t g = 0; g < 3 && convex; ++g) {
        const double area = claims_.sum(groups[g]) / total * whole;
        const auto sector = sweep_.sector(from - whole * std::floor(from / whole), area);
        convex = sector.has_value();
        if (convex) fan[g] = {*sector, groups[g]};
        from += area;
      }
      if (!convex || !holds(fan)) continue;
      for (Piece& piece : fan) std::sort(piece.who.begin(), piece.who.end());
      fans.push_back(std::move(fan));
    }
  }

  bool holds(const Fan& fan) const {
    return std::all_of(fan.begin(), fan.end(), [&](const Piece& piece) {
      return std::all_of(piece.who.begin(), piece.who.end(), [&](std::size_t i) {
        const Vector2& anchor = claims_.anchors[i];
        return (nearest_inside(piece.polygon, anchor) - anchor).norm() <= claims_.tolerance();
      });
    });
  }

  const Piece& piece_;
  const Claims& claims_;
  Sweep sweep_;
  Who here_;
  std::vector<std::pair<double, std::size_t>> around_;  ///< where seen, who; in order
};

}  // namespace

std::vector<Fan> fans_of(const Piece& piece, const Claims& claims) {
  std::vector<Fan> fans;
  if (piece.who.size() < 3 || piece.who.size() > kMostAnchors) return fans;
  for (const std::size_t anchor : piece.who) {
    const Vector2& at = claims.anchors[anchor];
    const bool inside = is_inside(piece.polygon, at) &&
                        (nearest_on_border(piece.polygon, at) - at).norm() > claims.tolerance();
    if (!inside) continue;  // on the border a fan is two straight cuts
    const Apex apex(piece, claims, anchor);
    if (apex.is_first_here(anchor)) apex.find(fans);
  }
  const auto cost = [](const Fan& fan) {
    return slenderness(fan[0].polygon) + slenderness(fan[1].polygon) + slenderness(fan[2].polygon);
  };
  std::stable_sort(fans.begin(), fans.end(),
                   [&](const Fan& a, const Fan& b) { return cost(a) < cost(b); });
  return fans;
}

}  // namespace skein::refiners::partition
