// SPDX-License-Identifier: Apache-2.0
// The whole that remains, planned anew without what cannot be.
#pragma once

#include "insertion/blocks.hpp"
#include "insertion/trials.hpp"
#include "skein/supervisor/repair.hpp"

namespace skein::supervisor {

/// A flight for nothing: no task that is free is left, and the UAV is on the ground.
bool is_futile(const Goals& order, Roles& roles, const PlanningRequest& base);

/// Leaves tasks out one by one until the rest can be planned: first those that cannot be planned
/// even alone, then what frees most energy where energy is short, else most time; waits, landings
/// and takeoffs last.
class Replan {
 public:
  Replan(Judge& judge, Roles& roles) : judge_(judge), roles_(roles) {}

  struct Outcome {
    const Verdict* verdict = nullptr;  ///< null: nothing is left
    Goals order;
    std::vector<Dropped> dropped;
    std::vector<std::string> reasons;  ///< of the last that was tried
  };
  Outcome run(Goals goals);

 private:
  struct Attempt {
    Goals order;
    const Verdict* verdict;
  };
  /// The best order of all of them; if none serves, the one nearest to it.
  Attempt best_of(const Goals& goals, bool well_ordered);
  std::optional<std::string> hopeless(const Goals& goals, const mission::HighLevelTask& goal);
  std::vector<Dropped> leave_out(const Goals& goals, const Attempt& attempt);
  std::vector<Dropped> leave_out_most(const Goals& goals, const Attempt& attempt);
  /// Those of the order that are of the mildest kind to leave out, and not after the culprit.
  std::vector<std::size_t> candidates(const Attempt& attempt);
  std::vector<Dropped> save_energy(const Attempt& attempt, const Sketch& sketch);

  Judge& judge_;
  Roles& roles_;
};

}  // namespace skein::supervisor
