// SPDX-License-Identifier: Apache-2.0
// Blocks visited in turn, again and again: in a short order, begun where it is most needed.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/links.hpp"

namespace skein::refiners {

/// Length of a closed round [m].
double round_length(const std::vector<Visit>& ring, const PatrolLinks& links);

/// Shortens a closed round by reversals (2-opt) and by moving up to three visits elsewhere
/// (or-opt); the first visit stays the first. Cost: O(n²) a pass, a few passes; each pass is a
/// `step`. Ends as it is when the time is up.
void shorten(std::vector<Visit>& ring, const PatrolLinks& links, Deadline& deadline);

/// A round over all blocks: lanes in turn, with one column of blocks left for the way back if that
/// is shorter.
std::vector<Visit> lanes_in_turn(const std::vector<PatrolBlock>& blocks, const PatrolLinks& links);
/// The same, each shortened first.
std::vector<Visit> round_over_all(const std::vector<PatrolBlock>& blocks, const PatrolLinks& links,
                                  Deadline& deadline);

/// What decides where a round begins, and which way round it goes.
struct RoundStart {
  Visit after = 0;                  ///< the visit that was last
  double speed = 1;                 ///< [m/s]
  const std::vector<double>& risk;  ///< per block: of the cell that ranks highest there
  const std::vector<double>& idle;  ///< per block: idleness of that cell now [s]
  double most_risk = 1;
};

/// Begins the round, one way or the other, where the greatest risk × idleness on the round is
/// least, against the way there. Cost: O(n × starts tried), of which there are at most some thirty.
std::vector<Visit> begun_best(const std::vector<Visit>& ring, const PatrolLinks& links,
                              const RoundStart& start);

}  // namespace skein::refiners
