// SPDX-License-Identifier: Apache-2.0
// Orders tried one after another, of which the best is kept.
#include "insertion/trials.hpp"

#include <algorithm>

namespace skein::supervisor {

const Verdict& Trials::run(mission::Placement placement, const Goals& order) {
  const Verdict& verdict = judge_.of(order);
  Trial trial{placement,       ids_of(order),  0, verdict.serves, 0, total_of(verdict.shortened),
              verdict.reasons, verdict.culprit};
  if (verdict.plan) trial.cost = verdict.plan->cost;
  for (const mission::HighLevelTask& goal : order) {
    const auto share = share_of(goal);
    if (!share) continue;
    trial.part = *share;
    if (trial.culprit == goal.id) trial.culprit = whole_of(goal);
  }
  trials_.push_back(std::move(trial));
  if (verdict.serves && (!best_ || is_better(verdict, *best_->verdict)))
    best_ = Best{placement, order, &verdict};
  return verdict;
}

bool Trials::is_better(const Verdict& a, const Verdict& b) {
  const Duration less = total_of(a.shortened), more = total_of(b.shortened);
  return less != more ? less < more : a.plan->cost < b.plan->cost;
}

std::vector<std::string> Trials::reasons() const {
  std::vector<std::string> reasons;
  for (const Trial& trial : trials_)
    for (const std::string& reason : trial.reasons)
      if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
        reasons.push_back(reason);
  return reasons;
}

Sketch sketch_of(const Judge& judge, const Goals& order) {
  const double speed = judge.knowledge().vehicle.cruise_speed;
  if (const auto whole = judge.sketch(order)) return Sketch(*whole, speed);
  mission::ElementaryPlan apart;
  for (const mission::HighLevelTask& goal : order) {
    const auto alone = judge.sketch_in_the_air(goal);
    if (alone) apart.tasks.insert(apart.tasks.end(), alone->tasks.begin(), alone->tasks.end());
  }
  return Sketch(apart, speed);
}

}  // namespace skein::supervisor
