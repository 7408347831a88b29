// SPDX-License-Identifier: Apache-2.0
// Plans the laps of a patrol: the blocks to visit next, and their order.
#pragma once

#include <vector>

#include "patrol/links.hpp"

namespace skein::refiners {

/// Parameters of lap planning.
struct LapRule {
  double length = 0;   ///< of a lap [m], > 0; infinite: every lap visits every block
  double power = 0.5;  ///< cells rank by risk^power × idleness: 0.5 is best for the mean, 1 for the
                       ///< worst
};

/// The input of lap planning. All must outlive the planner.
struct LapGround {
  const PatrolField& field;
  const std::vector<PatrolBlock>& blocks;
  const PatrolLinks& links;
  const std::vector<Visit>& whole;      ///< a round over all blocks
  double speed = 1;                     ///< [m/s]
  const PatrolSpace* walked = nullptr;  ///< space for sharp turns; null: no sharp turns possible
};

/// Plans a patrol in laps. Each lap commits to targets: the blocks that would rank highest at its
/// end if left out, the blocks whose risk × idleness would exceed the unavoidable one of the most
/// risky block, and the worst block of all, however far away. Then blocks with a high rank for the
/// distance they add are inserted until the lap has its length. The order follows the lap before,
/// and the lap begins where it keeps the visits of every-lap blocks regular. The rank of a block
/// that is left out grows from lap to lap, so every block is visited eventually. Thread rule: one
/// thread.
class LapPlanner {
 public:
  /// `deadline` must outlive the planner; a lap planned after it has passed must be discarded.
  LapPlanner(const LapGround& ground, const LapRule& rule, Deadline& deadline);

  /// The next lap from the instant `now` [s], given the last perception of each cell [s]. At least
  /// one visit. Cost: O(blocks × blocks of the lap).
  const std::vector<Visit>& next(const std::vector<double>& last_seen, double now);

 private:
  static constexpr Visit kNowhere = ~Visit{0};
  /// The cheapest place for a block in the ring.
  struct Place {
    double added;  ///< [m]
    Visit after;
    Visit as;  ///< the block forwards or backwards
  };

  double wait() const;
  void rank(const std::vector<double>& last_seen, double now);
  std::vector<std::size_t> targets() const;
  void add_due(std::vector<std::size_t>& targets, std::vector<bool>& is_target) const;
  void keep(const std::vector<std::size_t>& targets);
  void fill();
  std::size_t best_of(const std::vector<std::size_t>& left_out) const;
  void update_places(const std::vector<std::size_t>& left_out, const Place& placed);
  Place place_between(std::size_t block, Visit after, Visit before) const;
  void find_place(std::size_t block);
  void insert(std::size_t block);
  bool is_in(std::size_t block) const {
    return next_[2 * block] != kNowhere || next_[2 * block + 1] != kNowhere;
  }
  std::vector<Visit> in_order() const;

  const PatrolField& field_;
  const std::vector<PatrolBlock>& blocks_;
  const PatrolLinks& links_;
  Deadline& deadline_;
  double speed_;
  LapRule rule_;
  double pitch_;  ///< mean distance per block when all are visited in turn [m]
  double most_risk_;
  std::vector<double> weight_;   ///< risk^power, per cell
  std::vector<double> value_;    ///< Σ (weight × idleness)² at the end of the lap, per block
  std::vector<double> urgency_;  ///< greatest risk × idleness if the block is left out, per block
  std::vector<double> risk_;     ///< of the cell of the block with the greatest risk × idleness
  std::vector<double> idle_;     ///< of that cell, now
  std::vector<Visit> lap_;       ///< this lap; during its planning the previous one
  Visit last_ = kNowhere;        ///< visit of the lap before
  std::vector<Visit> next_;      ///< successor in the ring, per visit; kNowhere: not in the ring
  std::vector<Place> places_;    ///< per block that is not in the ring
  double length_ = 0;            ///< of the ring [m]
};

}  // namespace skein::refiners
