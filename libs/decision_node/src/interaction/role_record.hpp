// SPDX-License-Identifier: Apache-2.0
// How the tasks of a role went so far.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "skein/foundation/time.hpp"
#include "skein/interaction/automaton.hpp"

namespace skein::decision_node {

/// By componel: how long its task ran, why it failed, and whether it is worth while to begin it
/// again. A value.
class RoleRecord {
 public:
  /// Another role, or the same one once more: only the times for which tasks ran are kept.
  void begin_anew();
  /// The role asks for the task: it may be given up as often as any.
  void asked_for(const std::string& componel) { given_up_.erase(componel); }

  void runs(const std::string& componel, MissionTime now) { running_since_[componel] = now; }
  /// It runs no more; how long it did.
  Duration stopped(const std::string& componel, MissionTime now);
  /// For how long it ran until now, all its tasks together.
  Duration done(const std::string& componel) const;
  /// The same of all that were begun.
  const std::map<std::string, Duration>& done() const { return done_; }

  /// The task fails for this reason.
  void failed(const std::string& componel, const std::string& why) { failed_[componel] = why; }
  /// The task was aborted: a reason for which it was known to fail before stands.
  void aborted(const std::string& componel, const std::string& why) {
    failed_.try_emplace(componel, why);
  }
  /// The task ended: that one before it failed does not count.
  void ended(const std::string& componel) { failed_.erase(componel); }
  /// What is begun anew, with all in it, has another chance.
  void forget_failures_in(const std::string& componel, const interaction::Automaton& automaton);
  /// "componel: why" of the first by name; absent: none has failed.
  std::optional<std::string> failure() const;

  /// A task that the vehicle gave up after it `ran`: whether it is to be tried again. One that
  /// failed as it began is not, nor one that was given up for the third time.
  bool is_tried_again(const std::string& componel, Duration ran);
  /// It `ran` and was not stopped by the role.
  static bool failed_at_once(Duration ran) { return ran < kAtOnce; }
  /// Its task failed as it began; true: as the one before.
  bool fails_at_once_again(const std::string& componel);
  void did_not_fail_at_once(const std::string& componel) { fails_at_once_.erase(componel); }

 private:
  static constexpr Duration kAtOnce = Duration::milliseconds(1'000);  ///< less is as it began

  std::map<std::string, MissionTime> running_since_;
  std::map<std::string, Duration> done_;
  std::map<std::string, std::string> failed_;  ///< the reason of the last failure
  std::set<std::string> fails_at_once_;        ///< their last task did
  std::map<std::string, int> given_up_;        ///< how often, since the role asked for it
};

}  // namespace skein::decision_node
