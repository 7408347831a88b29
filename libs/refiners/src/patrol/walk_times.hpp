// SPDX-License-Identifier: Apache-2.0
// Visit times of a walk, its badness, and the badness after a change.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "patrol/walk_graph.hpp"

namespace skein::refiners {

/// Weights of the badness of walks, in metres flown: each criterion counts 1 at these figures, the
/// risk-weighted mean idleness and the excess of gaps that are too long.
struct WalkMeasure {
  double mean_idleness = 1;
  double worst_risk_idleness = 1;
  double too_long = 1;  ///< weight of a gap that is too long by its whole length
  /// Evaluate changes by their effect on all gaps that are too long, not only those of their own
  /// places.
  bool looks_elsewhere = false;
};

/// A change of a walk: some visits after a given one are replaced by others.
struct WalkChange {
  std::size_t after = 0;
  std::size_t taken = 0;
  std::array<std::uint32_t, 4> put{};
  std::size_t puts = 0;
};

/// One walk with its times. Thread rule: one thread.
class WalkTimes {
 public:
  /// The graph must outlive this object.
  explicit WalkTimes(const WalkGraph& graph);

  /// Sets the measure for the current walk.
  void measure_by(const WalkMeasure& measure);
  /// Cost: O(places + visits).
  void take(Walk walk);
  const Walk& walk() const { return walk_; }
  double badness() const { return badness_; }
  const std::vector<std::size_t>& visits(std::uint32_t place) const { return visits_[place]; }

  /// The badness after a change; exact if `looks_elsewhere` is set and the change adds no more than
  /// a tenth of the gaps that may become too long. Precondition: the changed walk is a valid walk.
  /// Cost: O(visits to the places changed + gaps that are nearly too long).
  double badness_after(const WalkChange& change) const;
  Walk changed(const WalkChange& change) const;
  /// The badness of another walk. Cost: O(places + visits).
  double badness_of(const Walk& walk) const;

 private:
  /// Squares of gaps by risk, and what is too long.
  struct Share {
    double squares = 0, late = 0;
  };
  struct Stretch;
  /// From the first of two visits to the second, which comes earlier in the walk when it wraps.
  struct LongGap {
    std::uint32_t place;
    std::size_t from, to;
    double gap;
  };

  double too_long(double top, double gap) const;
  void add_gap(const WalkGraph::Place& place, double gap, Share& share) const;
  void add_left_out(const WalkGraph::Place& place, double period, Share& share) const;
  double later(const WalkChange& change, double longer, const std::uint32_t* judged,
               std::size_t count) const;
  double weighed(const Share& share, double period) const;
  void note_times();
  void note_gaps();
  Stretch stretch(const WalkChange& change) const;
  Share share_after(std::uint32_t place, const WalkChange& change, const Stretch& stretch) const;
  double open_gap(std::uint32_t place, std::size_t visit) const;
  std::size_t ahead(std::size_t i, std::size_t by) const { return (i + by) % walk_.size(); }

  const WalkGraph& graph_;
  WalkMeasure measure_;
  Walk walk_;
  std::vector<double> times_;                     ///< per visit [m]
  double period_ = 0;                             ///< [m]
  std::vector<std::vector<std::size_t>> visits_;  ///< per place, in order
  std::vector<Share> shares_;                     ///< per place
  Share all_;
  std::vector<double> growth_;      ///< per visit: risk × gap of all gaps that are open after it
  std::vector<LongGap> long_gaps_;  ///< those that are too long, or nearly so
  double badness_ = 0;
  mutable std::vector<double> scratch_, first_, last_;
};

}  // namespace skein::refiners
