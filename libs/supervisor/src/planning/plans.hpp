// SPDX-License-Identifier: Apache-2.0
// Plans for the trials of one job: what one of them reads and refines serves the next.
#pragma once

#include <memory>
#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// The plans and failures of plan_tasks for requests one after another. What was read of a domain,
/// and what refiners answered from one origin in one world, is kept for the next request that is
/// of the same. Thread rule: one thread at a time. Cost: of a plan like one before mostly that of
/// the search; some tens of megabytes at most are kept.
class Plans {
 public:
  Plans();
  ~Plans();
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  Result<mission::ElementaryPlan, PlanningFailure> plan(const PlanningRequest& request,
                                                        PlanningEffort* effort = nullptr);

 private:
  class Workplace;
  std::vector<std::unique_ptr<Workplace>> workplaces_;
};

}  // namespace skein::supervisor
