// SPDX-License-Identifier: Apache-2.0
// Plans all remaining tasks anew, without those that are infeasible.
#pragma once

#include "insertion/blocks.hpp"
#include "insertion/trials.hpp"
#include "skein/supervisor/repair.hpp"

namespace skein::supervisor {

/// Whether the order is a flight without purpose: it has no free task, and the UAV is on the
/// ground.
bool is_futile(const Goals& order, Roles& roles, const PlanningRequest& base);

/// Leaves tasks out one by one until the rest is feasible: first those that are infeasible even
/// alone, then the task that saves most energy if energy is short, else most time; waits, landings
/// and takeoffs last.
class Replan {
 public:
  Replan(Judge& judge, Roles& roles) : judge_(judge), roles_(roles) {}

  struct Outcome {
    const Verdict* verdict = nullptr;  ///< null: no task is left
    Goals order;
    std::vector<Dropped> dropped;
    std::vector<std::string> reasons;  ///< why the last infeasible attempt failed
  };
  Outcome run(Goals goals);

 private:
  struct Attempt {
    Goals order;
    const Verdict* verdict;
  };
  /// The best order of the goals; if none is feasible, the one nearest to it.
  Attempt best_of(const Goals& goals, bool well_ordered);
  std::optional<std::string> hopeless(const Goals& goals, const mission::HighLevelTask& goal);
  std::vector<Dropped> leave_out(const Goals& goals, const Attempt& attempt);
  std::vector<Dropped> leave_out_most(const Goals& goals, const Attempt& attempt);
  /// Indices of the tasks in the order to leave out first by their role, and not after the culprit.
  std::vector<std::size_t> candidates(const Attempt& attempt);
  std::vector<Dropped> save_energy(const Attempt& attempt, const Sketch& sketch);

  Judge& judge_;
  Roles& roles_;
};

}  // namespace skein::supervisor
