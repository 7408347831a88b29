// SPDX-License-Identifier: Apache-2.0
// What a UAV does by itself once it has lost the ground.
#pragma once

#include <optional>
#include <string_view>

#include "skein/foundation/time.hpp"

namespace skein::decision_node {

enum class ContactPolicy { kContinue, kHold, kReturn };
/// "continue", "hold", "return".
std::string_view to_text(ContactPolicy policy);

/// Tells, from whether the ground is heard, when the contact-loss policy is to be carried out: once
/// the silence has lasted `after`, at most once per loss. Contact regained leaves what was begun:
/// the ground decides what comes next. Before the ground was heard for the first time nothing is
/// lost. Source: T II.1.2, spec 1.2.
class ContactWatch {
 public:
  ContactWatch(ContactPolicy policy, Duration after) : policy_(policy), after_(after) {}

  void ground_heard(bool reachable, MissionTime now);
  /// The policy, if its instant has come and it is not `kContinue`; then not again for this loss.
  std::optional<ContactPolicy> due(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

 private:
  ContactPolicy policy_;
  Duration after_;
  std::optional<MissionTime> lost_at_;
};

}  // namespace skein::decision_node
