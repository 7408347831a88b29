// SPDX-License-Identifier: Apache-2.0
// Bookkeeping of synchronisation messages: received, awaited, and to be repeated.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/executive/executive.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"

namespace skein::executive {

/// Keeps the last message of each partner, also if it comes before the task starts. The message is
/// valid for ever if it is kDone or if there is no validity, otherwise for `validity`; kWithdrawn
/// makes it void. Source: T III.2.3, spec 2.6.
class Synchroniser {
 public:
  Synchroniser(std::string own_name, std::optional<Duration> validity)
      : own_(std::move(own_name)), validity_(validity) {}

  /// The UAVs that this UAV sends messages to, in the order of the receivers, each once.
  std::vector<std::string> targets(const Synchronisation& synchronisation) const;

  /// From now on the task waits for its senders, and its own messages are repeated on demand
  /// (missed_by()). True if no sender is awaited any more.
  bool begin(TaskId task, const Synchronisation& synchronisation, MissionTime now);
  /// Whether all its senders have said that they have synchronised.
  bool met_before(const Synchronisation& synchronisation) const;
  /// The tasks that this message completes, in the order of their ids.
  std::vector<TaskId> received(const SyncReceived& message, MissionTime now);
  /// The tasks that wait, and for whom, in the order of the synchronisations.
  std::vector<Wait> waits(MissionTime now) const;
  /// The messages to be repeated to this UAV, one for each synchronisation: in the order of the
  /// tasks, then the withdrawn ones.
  std::vector<std::pair<std::uint64_t, SyncWord>> missed_by(const std::string& name) const;
  /// The task has synchronised and waits no more; its messages are still repeated until forget().
  void finish(TaskId task, const Synchronisation& synchronisation);
  void forget(TaskId task, const Synchronisation& synchronisation);
  /// As forget(). Returns the UAVs to which kWithdrawn is to be sent: those that got a message of
  /// this task and of no other task of the same synchronisation.
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

  struct Awaited {
    std::set<std::string> senders;
    MissionTime since;
  };

  bool counts(const Heard& heard, MissionTime now) const;
  /// The sender's last word; null: none.
  const Heard* last_of(std::uint64_t id, const std::string& sender) const;
  bool is_there(std::uint64_t id, const std::string& sender, MissionTime now) const;
  bool all_there(std::uint64_t id, const std::set<std::string>& senders, MissionTime now) const;
  bool tells(const std::string& name, std::uint64_t id) const;

  std::string own_;
  std::optional<Duration> validity_;
  std::map<std::uint64_t, std::map<std::string, Heard>> heard_;
  std::map<std::uint64_t, std::map<TaskId, Awaited>> waiting_;
  std::map<std::string, std::map<TaskId, Sent>> sent_;
  std::map<std::string, std::set<std::uint64_t>> withdrawn_;  ///< synchronisations by addressee
};

}  // namespace skein::executive
