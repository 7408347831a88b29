// SPDX-License-Identifier: Apache-2.0
// What partners said last of joint tasks: that they take no part, or not any more.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "skein/foundation/time.hpp"
#include "skein/negotiation/joint_task_status.hpp"

namespace skein::decision_node {

class PartnerRefusals {
 public:
  struct Refusal {
    MissionTime since;
    std::string why;
  };

  /// A refusal counts from the first of those that follow one another.
  void hear(const interaction::JointTaskStatus& status, MissionTime now);
  /// Nothing was heard until now, as after a restart: they may have taken it back meanwhile.
  void resume(MissionTime now);
  /// Null: the UAV has not said so, says something else since, or it is long over.
  const Refusal* of(const std::string& subject, const std::string& uav) const;
  /// What is that old and of none of these joint tasks.
  void forget(const std::set<std::string>& subjects, Duration after, MissionTime now);

 private:
  std::map<std::pair<std::string, std::string>, Refusal> refusals_;  ///< by subject and UAV
};

}  // namespace skein::decision_node
