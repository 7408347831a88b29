// SPDX-License-Identifier: Apache-2.0
// The open jobs and what they wait for.
#include "relax_jobs.hpp"

#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

void RelaxJobs::open(std::optional<Origin> origin, std::set<Wait> waits) {
  SKEIN_EXPECTS(!waits.empty());
  jobs_.emplace(++last_, Job{std::move(origin), std::move(waits)});
}

std::optional<RelaxJobs::Origin> RelaxJobs::close(JobId job, const Wait& wait) {
  const auto found = jobs_.find(job);
  if (found == jobs_.end()) return std::nullopt;
  found->second.waits.erase(wait);
  if (!found->second.waits.empty()) return std::nullopt;
  auto origin = std::move(found->second.origin);
  jobs_.erase(found);
  return origin;
}

std::vector<Relax> RelaxJobs::begin_session(AgentIndex peer) {
  std::vector<Relax> again;
  for (auto& [id, job] : jobs_) {
    if (job.origin && job.origin->agent == peer) job.origin.reset();
    for (const Wait& wait : job.waits) {
      if (wait.agent == peer) again.push_back({wait.node, wait.bound, id});
    }
  }
  return again;
}

}  // namespace skein::temporal
