// SPDX-License-Identifier: Apache-2.0
// Synchronisation messages: who has sent, who is still waited for, who is to be sent to again.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"

namespace skein::executive {

/// What a partner said last is kept, also before the task: it counts for ever when it is done or
/// without a validity, else for that long, and not at all once withdrawn.
/// Source: T III.2.3, spec 2.6.
class Synchroniser {
 public:
  Synchroniser(std::string own_name, std::optional<Duration> validity)
      : own_(std::move(own_name)), validity_(validity) {}

  /// The UAVs that this one sends to, in the order of the receivers, each once.
  std::vector<std::string> targets(const Synchronisation& synchronisation) const;

  /// From now on the task waits for senders and its messages are sent again. True when there is
  /// nobody (left) to wait for.
  bool begin(TaskId task, const Synchronisation& synchronisation, MissionTime now);
  /// The tasks that this message completes, in the order of their ids.
  std::vector<TaskId> received(const SyncReceived& message, MissionTime now);
  /// What is to be said again to this UAV, once for each synchronisation: in the order of its
  /// tasks, then what was withdrawn.
  std::vector<std::pair<std::uint64_t, SyncWord>> missed_by(const std::string& name) const;
  /// The task waits no more; its messages go on being sent again until forget().
  void finish(TaskId task, const Synchronisation& synchronisation);
  void forget(TaskId task, const Synchronisation& synchronisation);
  /// As forget(); the UAVs that this task had told of, and no other task of that synchronisation
  /// has: they are to be told that it is withdrawn.
  std::vector<std::string> withdraw(TaskId task, const Synchronisation& synchronisation);

 private:
  struct Heard {
    SyncWord word = SyncWord::kThere;
    MissionTime said;
  };
  struct Sent {
    std::uint64_t id = 0;
    bool done = false;
  };

  bool counts(const Heard& heard, MissionTime now) const;
  bool all_there(std::uint64_t id, const std::set<std::string>& senders, MissionTime now) const;
  bool tells(const std::string& name, std::uint64_t id) const;

  std::string own_;
  std::optional<Duration> validity_;
  std::map<std::uint64_t, std::map<std::string, Heard>> heard_;
  std::map<std::uint64_t, std::map<TaskId, std::set<std::string>>> waiting_;  ///< task → senders
  std::map<std::string, std::map<TaskId, Sent>> sent_;
  std::map<std::string, std::set<std::uint64_t>> withdrawn_;  ///< told to whom
};

}  // namespace skein::executive
