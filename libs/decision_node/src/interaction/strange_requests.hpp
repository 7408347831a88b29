// SPDX-License-Identifier: Apache-2.0
// What partners ask of this UAV, or believe of it, that it has no joint task for.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "interaction/joint_host.hpp"
#include "skein/decision_node/messages.hpp"
#include "skein/negotiation/terms.hpp"

namespace skein::decision_node {

/// Tells partners of joint tasks in which this UAV takes no part, and notes those that they ask for
/// with other values, or for long and in vain.
class StrangeRequests {
 public:
  /// References that must outlive it.
  explicit StrangeRequests(JointHost& host) : host_(host) {}

  /// Tells the partners, now and when they ask for it, that this UAV takes no part.
  void decline(const Joint& joint, const std::string& why);
  /// It is asked for here: it is not declined any more.
  void wanted(const Joint& joint) {
    declined_.erase(joint.subject);
    in_vain_.erase(joint.subject);
  }
  /// Tells a partner that counts on this UAV that it plays no role: it had one before it came back
  /// without its memory.
  void disown(interaction::JointTaskStatus status);
  /// A partner opened a session of a joint task that is not asked for here. `loading`: those that
  /// are, and have not begun.
  void hear(const interaction::Terms& terms, const std::vector<const Joint*>& loading);
  /// How a partner asks for that joint task instead: "'heliv' asks for it with duration 400, not
  /// 315". Empty: nobody does.
  std::string asked_otherwise(const std::string& subject) const;
  /// What is long over. `subjects`: of joint tasks that are known here.
  void forget(const std::set<std::string>& subjects, Duration after);

 private:
  struct Declined {
    MissionTime at;
    JointTaskChanged told;
  };
  struct InVain {
    MissionTime first, last;
    bool noted = false;
  };
  /// It may be asked for here yet: the missions of a team are given one after the other.
  void ask_in_vain(const interaction::Terms& terms, const std::string& subject);

  JointHost& host_;
  std::map<std::string, Declined> declined_;      ///< by subject
  std::map<std::string, std::string> otherwise_;  ///< by subject
  std::map<std::string, InVain> in_vain_;         ///< by subject
};

}  // namespace skein::decision_node
