// SPDX-License-Identifier: Apache-2.0
// Search for the best view point: branch and bound over bearings, then local refinement.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "common/deadline.hpp"
#include "skein/refiners/budget.hpp"
#include "viewpoint/field.hpp"

namespace skein::refiners {

/// A place that passed all checks.
struct Found {
  Bearing bearing;
  world::Vector3 position = world::Vector3::Zero();
  double utility = 0;
};

/// Expands boxes of bearings in the order of their upper bounds on utility, and splits them until
/// no bound exceeds the best place found by a relevant amount. A box with no good place at its
/// corners is discarded if all corners fail the same check, or if it is a quarter as wide as the
/// first lattice; smaller isolated regions of good places can thus be missed. The best place is
/// then refined off the lattice. A step is one checked place.
class ViewpointSearch {
 public:
  ViewpointSearch(ViewpointField& field, Countdown& countdown)
      : field_(field), countdown_(countdown) {}

  /// Whether a bearing is apart from the view points chosen before; empty: always.
  using IsApart = std::function<bool(const Bearing&, const world::Vector3& position)>;

  /// The best place of all, or nothing.
  std::optional<Found> best(const IsApart& is_apart);
  /// The best place of one azimuth, or nothing.
  std::optional<Found> best_along(std::int32_t azimuth);

  /// Check results of the places of a coarse lattice, and the best of them.
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
