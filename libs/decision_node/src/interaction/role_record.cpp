// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_record.hpp"

namespace skein::decision_node {

void RoleRecord::begin_anew() {
  failed_.clear();
  fails_at_once_.clear();
  given_up_.clear();
}

Duration RoleRecord::stopped(const std::string& componel, MissionTime now) {
  const auto since = running_since_.find(componel);
  if (since == running_since_.end()) return {};
  const Duration ran = now - since->second;
  done_[componel] = done_[componel] + ran;
  running_since_.erase(since);
  return ran;
}

Duration RoleRecord::done(const std::string& componel) const {
  const auto found = done_.find(componel);
  return found == done_.end() ? Duration() : found->second;
}

void RoleRecord::forget_failures_in(const std::string& componel,
                                    const interaction::Automaton& automaton) {
  const auto outer = *automaton.find(componel);
  std::erase_if(failed_, [&](const auto& one) {
    const auto inner = *automaton.find(one.first);
    return inner == outer || automaton.contains(outer, inner);
  });
}

std::optional<std::string> RoleRecord::failure() const {
  if (failed_.empty()) return std::nullopt;
  const auto& [componel, why] = *failed_.begin();
  return componel + ": " + why;
}

bool RoleRecord::is_tried_again(const std::string& componel, Duration ran) {
  constexpr int kTries = 3;
  return !failed_at_once(ran) && ++given_up_[componel] < kTries;
}

bool RoleRecord::fails_at_once_again(const std::string& componel) {
  return !fails_at_once_.insert(componel).second;
}

}  // namespace skein::decision_node
