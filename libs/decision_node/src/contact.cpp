// SPDX-License-Identifier: Apache-2.0
#include "skein/decision_node/contact.hpp"

namespace skein::decision_node {

std::string_view to_text(ContactPolicy policy) {
  switch (policy) {
    case ContactPolicy::kHold:
      return "hold";
    case ContactPolicy::kReturn:
      return "return";
    case ContactPolicy::kContinue:
      break;
  }
  return "continue";
}

void ContactWatch::ground_heard(bool reachable, MissionTime now) {
  if (reachable) {
    lost_at_.reset();
  } else if (!lost_at_) {
    lost_at_ = now;
  }
}

std::optional<ContactPolicy> ContactWatch::due(MissionTime now) {
  const auto at = next_wakeup();
  if (!at || now < *at) return std::nullopt;
  lost_at_.reset();
  return policy_;
}

std::optional<MissionTime> ContactWatch::next_wakeup() const {
  if (!lost_at_ || policy_ == ContactPolicy::kContinue) return std::nullopt;
  return *lost_at_ + after_;
}

}  // namespace skein::decision_node
