// SPDX-License-Identifier: Apache-2.0
// Synchronisation messages: who has sent, who is still waited for, who is to be sent to again.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/executive/task.hpp"

namespace skein::executive {

/// A message counts once and for ever: one that arrives before its task is kept.
/// Source: T III.2.3, spec 2.6.
class Synchroniser {
 public:
  explicit Synchroniser(std::string own_name) : own_(std::move(own_name)) {}

  /// The UAVs that this one sends to, in the order of the receivers, each once.
  std::vector<std::string> targets(const Synchronisation& synchronisation) const;

  /// From now on the task waits for senders and its messages are sent again. True when there is
  /// nobody (left) to wait for.
  bool begin(TaskId task, const Synchronisation& synchronisation);
  /// The tasks that this message completes, in the order of their ids.
  std::vector<TaskId> received(std::uint64_t id, const std::string& from);
  /// The ids of synchronisations whose message is to be sent again to this UAV.
  std::vector<std::uint64_t> missed_by(const std::string& name) const;
  /// The task waits no more; its messages go on being sent again until forget().
  void finish(TaskId task, const Synchronisation& synchronisation);
  void forget(TaskId task, const Synchronisation& synchronisation);

 private:
  std::string own_;
  std::map<std::uint64_t, std::set<std::string>> received_;
  std::map<std::uint64_t, std::map<TaskId, std::set<std::string>>> waiting_;
  std::map<std::string, std::map<TaskId, std::uint64_t>> sent_;
};

}  // namespace skein::executive
