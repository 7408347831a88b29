// SPDX-License-Identifier: Apache-2.0
// Planning with caches: domain and refinements of one plan serve the next.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Gives the same plans and failures as plan_tasks. The domain is compiled once; refiners' answers
/// are cached until the job ends, for requests with the same origin and world. Thread rule: one
/// thread at a time. Cost: for a plan similar to an earlier one mostly the search; some megabytes
/// at most are kept between jobs.
class Plans {
 public:
  Plans();
  ~Plans();
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  Result<mission::ElementaryPlan, PlanningFailure> plan(const PlanningRequest& request,
                                                        PlanningEffort* effort = nullptr);
  /// The next request has another situation: drops the cached answers of refiners.
  void end_job();

 private:
  class Shelf;
  class Workplace;
  Shelf& shelf_for(const DomainText& domain);
  Workplace& workplace_for(const PlanningRequest& request);

  /// Term store kept between jobs [bytes]; if it is larger, the domain is compiled anew.
  static constexpr std::size_t kMostKept = std::size_t{1} << 20U;
  /// Inferences of one job after which caches and domain are made anew. Counted in inferences, not
  /// in bytes: how often a job polls the clock must not depend on earlier jobs (a restarted node
  /// repeats jobs).
  static constexpr std::uint64_t kMostEffort = 2'000'000;

  std::uint64_t effort_of_job_ = 0;
  std::unique_ptr<Shelf> shelf_;
  std::vector<std::unique_ptr<Workplace>> workplaces_;
};

}  // namespace skein::supervisor
