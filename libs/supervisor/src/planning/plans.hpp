// SPDX-License-Identifier: Apache-2.0
// Plans made one after another: what one of them reads and refines serves the next.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// The plans and failures of plan_tasks for requests one after another. The domain is read and
/// compiled once; what refiners answered from one origin in one world is kept until the job ends,
/// for the next request that is of the same. Thread rule: one thread at a time. Cost: of a plan
/// like one before mostly that of the search; some megabytes at most are kept between jobs.
class Plans {
 public:
  Plans();
  ~Plans();
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  Result<mission::ElementaryPlan, PlanningFailure> plan(const PlanningRequest& request,
                                                        PlanningEffort* effort = nullptr);
  /// What comes next is of another situation: of the answers of refiners none is kept.
  void end_job();

 private:
  class Shelf;
  class Workplace;
  Shelf& shelf_for(const DomainText& domain);
  Workplace& workplace_for(const PlanningRequest& request);

  /// Of terms, between jobs [bytes]; more than that is begun anew.
  static constexpr std::size_t kMostKept = std::size_t{1} << 20U;
  /// Inferences of one job; after so many it is begun anew. Not by memory: how often a job asks for
  /// the time must not depend on what was planned before it (a restarted node does jobs again).
  static constexpr std::uint64_t kMostEffort = 2'000'000;

  std::uint64_t effort_of_job_ = 0;
  std::unique_ptr<Shelf> shelf_;
  std::vector<std::unique_ptr<Workplace>> workplaces_;
};

}  // namespace skein::supervisor
