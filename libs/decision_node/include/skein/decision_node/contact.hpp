// SPDX-License-Identifier: Apache-2.0
// The contact-loss policy of a UAV.
#pragma once

#include <optional>
#include <string_view>

#include "skein/foundation/time.hpp"

namespace skein::decision_node {

enum class ContactPolicy { kContinue, kHold, kReturn };
/// "continue", "hold", "return".
std::string_view to_text(ContactPolicy policy);

/// Decides when the contact-loss policy is due: once the ground has been silent for `after`, at
/// most once per loss. When contact is regained, a policy that was begun goes on: the ground
/// decides what comes next. Silence before the ground was heard for the first time is no loss.
/// Source: T II.1.2, spec 1.2.
class ContactWatch {
 public:
  ContactWatch(ContactPolicy policy, Duration after) : policy_(policy), after_(after) {}

  void ground_heard(bool reachable, MissionTime now);
  /// The policy if it is due and not `kContinue`; returned once per loss.
  std::optional<ContactPolicy> due(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

 private:
  ContactPolicy policy_;
  Duration after_;
  std::optional<MissionTime> lost_at_;
};

}  // namespace skein::decision_node
