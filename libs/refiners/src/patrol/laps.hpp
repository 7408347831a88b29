// SPDX-License-Identifier: Apache-2.0
// Which blocks to visit next, and in which order.
#pragma once

#include <vector>

#include "patrol/links.hpp"

namespace skein::refiners {

/// How the time is shared out.
struct LapRule {
  double length = 0;   ///< of a lap [m], > 0; infinite: every lap visits every block
  double power = 0.5;  ///< cells rank by risk^power × idleness: 0.5 is best for the mean, 1 for the
                       ///< worst
};

/// What laps are planned over. All must outlive the planner.
struct LapGround {
  const PatrolField& field;
  const std::vector<PatrolBlock>& blocks;
  const PatrolLinks& links;
  const std::vector<Visit>& whole;      ///< a round over all blocks
  double speed = 1;                     ///< [m/s]
  const PatrolSpace* walked = nullptr;  ///< where turns may be sharp; null: they may not
};

/// Patrols in laps. Each lap commits to targets: the blocks that would rank highest at its end had
/// they been left out, those whose risk × idleness would grow beyond what the most risky block has
/// to wait for anyway, and the one that is worst of all, however far. What ranks high against the
/// distance it adds is then swept on the way, until the lap is as long as the rule says. The order
/// is that of the lap before, and the lap begins where it keeps regular what is visited every lap;
/// what is left out ranks higher lap by lap, so that nothing is left out for ever. Thread rule: one
/// thread.
class LapPlanner {
 public:
  /// `deadline` must outlive it: a lap that is planned when it has passed is not wanted.
  LapPlanner(const LapGround& ground, const LapRule& rule, Deadline& deadline);

  /// The next lap, at an instant [s], with when each cell was last perceived [s]. At least one
  /// visit. Cost: O(blocks × blocks of the lap).
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
  double pitch_;  ///< mean way per block when all are visited in turn [m]
  double most_risk_;
  std::vector<double> weight_;   ///< risk^power, per cell
  std::vector<double> value_;    ///< Σ (weight × idleness)² at the end of the lap, per block
  std::vector<double> urgency_;  ///< greatest risk × idleness if it is left out, per block
  std::vector<double> risk_;     ///< of the cell of the block with the greatest risk × idleness
  std::vector<double> idle_;     ///< of that cell, now
  std::vector<Visit> lap_;       ///< this one; until it is made, the one before
  Visit last_ = kNowhere;        ///< visit of the lap before
  std::vector<Visit> next_;      ///< of the ring, per visit; kNowhere: not in it
  std::vector<Place> places_;    ///< per block that is not in the ring
  double length_ = 0;            ///< of the ring [m]
};

}  // namespace skein::refiners
