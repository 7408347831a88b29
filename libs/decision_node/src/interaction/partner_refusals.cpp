// SPDX-License-Identifier: Apache-2.0
#include "interaction/partner_refusals.hpp"

namespace skein::decision_node {

void PartnerRefusals::hear(const interaction::JointTaskStatus& status, MissionTime now) {
  using interaction::JointPhase;
  const std::pair about{status.subject, status.uav};
  if (status.phase != JointPhase::kNotLoaded && status.phase != JointPhase::kAborted) {
    refusals_.erase(about);
  } else {
    refusals_.try_emplace(about, Refusal{now, {}}).first->second.why = status.why;
  }
}

void PartnerRefusals::resume(MissionTime now) {
  for (auto& [about, refusal] : refusals_) refusal.since = now;
}

const PartnerRefusals::Refusal* PartnerRefusals::of(const std::string& subject,
                                                    const std::string& uav) const {
  const auto known = refusals_.find({subject, uav});
  return known == refusals_.end() ? nullptr : &known->second;
}

void PartnerRefusals::forget(const std::set<std::string>& subjects, Duration after,
                             MissionTime now) {
  std::erase_if(refusals_, [&](const auto& one) {
    return !subjects.contains(one.first.first) && one.second.since + after <= now;
  });
}

}  // namespace skein::decision_node
