// SPDX-License-Identifier: Apache-2.0
// The best place to look from: branch and bound over bearings, then polishing.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "common/deadline.hpp"
#include "skein/refiners/budget.hpp"
#include "viewpoint/field.hpp"

namespace skein::refiners {

/// A good place.
struct Found {
  Bearing bearing;
  world::Vector3 position = world::Vector3::Zero();
  double utility = 0;
};

/// Boxes of bearings are looked at in the order of what they could be worth at most, so that what
/// is worth less than the best place found is never looked at, and cut in two until what they could
/// be worth more than it is nothing to speak of. A box with no good place at its corners is left
/// aside when all of them fall to the same check, or when it is a quarter as wide as the first
/// lattice: what is smaller than that and lies apart can be missed. The best place is then
/// polished, off the lattice. A step is a place that is judged.
class ViewpointSearch {
 public:
  ViewpointSearch(ViewpointField& field, Countdown& countdown)
      : field_(field), countdown_(countdown) {}

  /// Which bearings are apart from what was chosen before; empty: all.
  using IsApart = std::function<bool(const Bearing&, const world::Vector3& position)>;

  /// The best in the whole, or nothing.
  std::optional<Found> best(const IsApart& is_apart);
  /// The best of one azimuth.
  std::optional<Found> best_along(std::int32_t azimuth);

  /// What became of the places of a coarse lattice, and the best of them.
  struct Survey {
    std::map<Verdict, std::size_t> fates;
    std::size_t places = 0;
    std::optional<Found> best;
  };
  /// Ends when the time is up.
  Survey survey(Deadline& deadline);

 private:
  struct Open {
    BearingCell cell;
    double bound;
    std::uint64_t order;
    bool operator<(const Open& other) const {
      return bound != other.bound ? bound < other.bound : order > other.order;
    }
  };

  std::optional<Found> search(const BearingCell& whole, const IsApart& is_apart);
  void open(const BearingCell& cell, const Aspect& aspect);
  void open_directions(const BearingCell& all);
  void open_lattice(const BearingCell& whole);
  bool explore(const BearingCell& cell);
  void split(const BearingCell& cell);
  void polish(bool turn);
  bool improve(const Bearing& around, std::int32_t turn, double tilt, double reach);
  bool is_small(const BearingCell& cell) const;
  bool consider(const Bearing& bearing, Verdict* verdict);
  bool is_settled(double bound) const;

  ViewpointField& field_;
  Countdown& countdown_;
  const IsApart* is_apart_ = nullptr;
  std::vector<Open> heap_;
  std::optional<Found> best_;
  std::uint64_t opened_ = 0;
};

}  // namespace skein::refiners
