// SPDX-License-Identifier: Apache-2.0
// Short closed rounds over blocks, and the choice of where to begin them.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/links.hpp"

namespace skein::refiners {

/// Length of a closed round [m].
double round_length(const std::vector<Visit>& ring, const PatrolLinks& links);

/// Shortens a closed round by reversals (2-opt) and by moving up to three visits elsewhere
/// (or-opt); the first visit stays the first. Cost: O(n²) a pass, a few passes; each pass is a
/// `step`. When the time is up, keeps the result so far.
void shorten(std::vector<Visit>& ring, const PatrolLinks& links, Deadline& deadline);

/// A round over all blocks: lanes in turn, with one column of blocks reserved for the way back if
/// that is shorter.
std::vector<Visit> lanes_in_turn(const std::vector<PatrolBlock>& blocks, const PatrolLinks& links);
/// The same, with each candidate shortened before the choice.
std::vector<Visit> round_over_all(const std::vector<PatrolBlock>& blocks, const PatrolLinks& links,
                                  Deadline& deadline);

/// Input to the choice of the first visit and the direction of a round.
struct RoundStart {
  Visit after = 0;                  ///< the visit before the round
  double speed = 1;                 ///< [m/s]
  const std::vector<double>& risk;  ///< per block: of its cell of the highest rank
  const std::vector<double>& idle;  ///< per block: idleness of that cell now [s]
  double most_risk = 1;
};

/// The round with the first visit and direction for which the greatest risk × idleness on it,
/// including the path to its beginning, is least. Cost: O(n × starts tried), at most some thirty.
std::vector<Visit> begun_best(const std::vector<Visit>& ring, const PatrolLinks& links,
                              const RoundStart& start);

}  // namespace skein::refiners
