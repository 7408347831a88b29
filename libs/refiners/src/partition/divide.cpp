// SPDX-License-Identifier: Apache-2.0
// Shares out a convex polygon by straight cuts.
#include "partition/divide.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "common/deadline.hpp"
#include "partition/fans.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/refiners/partition.hpp"

namespace skein::refiners {
namespace partition {
namespace {

/// Pieces cut in one search before it is given up; what can be cut is found within some dozens.
/// For each further way that is wanted, some more.
constexpr int kMostCuts = 300;
constexpr int kMoreCuts = 30;
/// Of the ways to cut a piece, how many are followed to the end for the most compact parts.
constexpr std::size_t kWaysTried = 4;
constexpr std::size_t kFewAnchors = 4;
/// Corners of pieces, times the anchors in each, that are still cut once the time is up.
constexpr std::size_t kCutLate = 2500;

/// Until when pieces are cut.
class Patience {
 public:
  explicit Patience(const Budget& budget) : deadline_(budget) {}

  bool lasts_for(const Piece& piece) {
    if (deadline_.passed()) late_ += piece.polygon.size() * piece.who.size();
    return !is_over();
  }
  bool is_over() const { return late_ > kCutLate; }

 private:
  Deadline deadline_;
  std::size_t late_ = 0;
};

/// A way to divide a piece: the parts in the order of who is in it.
struct Cutting {
  double cost = 0;
  std::vector<std::pair<std::size_t, Polygon>> parts;
};

class Search {
 public:
  Search(const Claims& claims, std::size_t most, Patience& patience)
      : claims_(claims),
        most_(most),
        patience_(patience),
        cuts_left_(kMostCuts + kMoreCuts * static_cast<int>(most)) {}

  /// The most compact first; empty: none found, or not in time.
  std::vector<Cutting> divide(const Piece& piece) {
    if (piece.who.size() == 1)
      return {{slenderness(piece.polygon), {{piece.who[0], piece.polygon}}}};
    std::vector<Cutting> found;
    if (--cuts_left_ < 0 || !patience_.lasts_for(piece)) return found;
    ++cuts_;
    const bool few = piece.who.size() <= kFewAnchors;
    std::size_t left = few ? std::max(kWaysTried, most_) : 1;
    for (const Split& split : splits_of(piece, claims_))
      if (follow({&split.below, &split.above}, found) && --left == 0) break;
    if (found.empty())
      for (const Fan& fan : fans_of(piece, claims_))
        if (follow({&fan[0], &fan[1], &fan[2]}, found)) break;
    std::stable_sort(found.begin(), found.end(),
                     [](const Cutting& a, const Cutting& b) { return a.cost < b.cost; });
    if (found.size() > most_) found.resize(most_);
    return found;
  }
  int cuts() const { return cuts_; }

 private:
  bool follow(std::initializer_list<const Piece*> pieces, std::vector<Cutting>& found) {
    std::vector<Cutting> whole(1);
    for (const Piece* piece : pieces) {
      std::vector<Cutting> longer;
      const std::vector<Cutting> cuttings = divide(*piece);
      for (const Cutting& so_far : whole)
        for (const Cutting& next : cuttings) {
          longer.push_back(so_far);
          longer.back().cost += next.cost;
          longer.back().parts.insert(longer.back().parts.end(), next.parts.begin(),
                                     next.parts.end());
        }
      whole = std::move(longer);
      if (whole.empty()) return false;
    }
    found.insert(found.end(), whole.begin(), whole.end());
    return true;
  }

  const Claims& claims_;
  std::size_t most_;
  Patience& patience_;
  int cuts_left_, cuts_ = 0;
};

/// Ways to choose which anchors inside give way that are tried before all do.
constexpr int kMostChoices = 100;
/// Nor are more pieces than these cut for that.
constexpr int kMostCutsInAll = 2000;
/// What rounding may do to a division of anchors on the border, of the size of the area. The first
/// has always been enough; the rest is for areas as thin as rounding itself.
constexpr std::array<double, 4> kRoundings = {1e-11, 1e-9, 1e-7, 1e-5};

/// Shares out a polygon around the origin; the anchors that cannot keep their place inside it are
/// moved to the border, as few as can be found.
class Divider {
 public:
  Divider(Polygon area, Claims claims, std::size_t most, const Budget& budget)
      : area_(std::move(area)), claims_(std::move(claims)), most_(most), patience_(budget) {
    for (std::size_t i = 0; i < claims_.anchors.size(); ++i) {
      Vector2& anchor = claims_.anchors[i];
      on_border_.push_back(nearest_on_border(area_, anchor));
      if (!is_inside(area_, anchor))
        anchor = on_border_[i];
      else if ((anchor - on_border_[i]).norm() > claims_.tolerance())
        inside_.push_back(i);
    }
  }

  std::vector<Division> run() {
    int choices = kMostChoices;
    for (std::size_t moved = 0; moved <= inside_.size() && may_go_on(choices); ++moved) {
      std::vector<bool> chosen(inside_.size(), false);
      std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(moved), true);
      do {
        if (auto divisions = attempt(chosen); !divisions.empty()) return divisions;
        --choices;
      } while (may_go_on(choices) && std::prev_permutation(chosen.begin(), chosen.end()));
    }
    std::vector<Division> divisions;
    for (const double rounding : kRoundings) {
      claims_.rounding = rounding;
      if (divisions.empty() && !patience_.is_over())
        divisions = attempt(std::vector<bool>(inside_.size(), true));
    }
    SKEIN_ENSURES(!divisions.empty() || patience_.is_over());
    return divisions;
  }

 private:
  bool may_go_on(int choices) const {
    return choices > 0 && cuts_ < kMostCutsInAll && !patience_.is_over();
  }

  std::vector<Division> attempt(const std::vector<bool>& moved) {
    Claims claims = claims_;
    for (std::size_t i = 0; i < inside_.size(); ++i)
      if (moved[i]) claims.anchors[inside_[i]] = on_border_[inside_[i]];
    Piece whole{area_, std::vector<std::size_t>(claims.anchors.size())};
    std::iota(whole.who.begin(), whole.who.end(), std::size_t{0});
    std::vector<Division> divisions;
    Search search(claims, most_, patience_);
    std::vector<Cutting> cuttings = search.divide(whole);
    cuts_ += search.cuts();
    for (Cutting& cutting : cuttings) {
      divisions.push_back({std::vector<Polygon>(claims.anchors.size()), claims.anchors});
      for (auto& [who, part] : cutting.parts) divisions.back().parts[who] = std::move(part);
    }
    return divisions;
  }

  Polygon area_;
  Claims claims_;
  std::size_t most_;
  Patience patience_;
  std::vector<Vector2> on_border_;
  std::vector<std::size_t> inside_;
  int cuts_ = 0;
};

}  // namespace

std::vector<Division> divisions(const Polygon& area, const std::vector<Vector2>& anchors,
                                const std::vector<double>& shares, std::size_t most,
                                const Budget& budget, double between) {
  SKEIN_EXPECTS(between > 0 && between < 1);
  SKEIN_EXPECTS(area.size() >= 3 && !anchors.empty() && anchors.size() == shares.size());
  SKEIN_EXPECTS(most > 0);
  Vector2 low = area[0], high = area[0];
  for (const Vector2& corner : area) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vector2 centre = (low + high) / 2;
  Polygon around_origin;
  for (const Vector2& corner : area) around_origin.emplace_back(corner - centre);
  if (signed_area(around_origin) < 0) std::reverse(around_origin.begin(), around_origin.end());
  Claims claims{{}, shares, (high - low).norm(), kRoundings.front(), between};
  for (const Vector2& anchor : anchors) claims.anchors.emplace_back(anchor - centre);
  auto result = Divider(std::move(around_origin), std::move(claims), most, budget).run();
  for (Division& division : result) {
    for (Polygon& part : division.parts)
      for (Vector2& corner : part) corner += centre;
    for (Vector2& anchor : division.anchors) anchor += centre;
  }
  return result;
}

}  // namespace partition

std::vector<world::Polygon> divide(const world::Polygon& area,
                                   const std::vector<world::Vector2>& anchors,
                                   const std::vector<double>& shares) {
  return partition::divisions(area, anchors, shares, 1).front().parts;
}

}  // namespace skein::refiners
