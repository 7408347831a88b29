// SPDX-License-Identifier: Apache-2.0
// The states of one UAV's tasks, as reported to the ground station.
#pragma once

#include <bitset>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/foundation/byte_book.hpp"
#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

struct TaskOnBoard {
  executive::TaskId id;
  std::string type;
  executive::TaskState state = executive::TaskState::kScheduled;
  bool lost = false;  ///< its MLE restarted before the task was terminal
  std::string reason = {};
  MissionTime since;
  bool at_ground = false;  ///< the last report came from the MLE that runs here
};

/// Neither terminal nor lost.
bool is_open(const TaskOnBoard& task);

/// States come by events and by plan boards, in any order and more than once; the board never goes
/// back (scheduled, started, running, aborting, then ended or aborted), except for a task that was
/// lost and is started anew. The last `kept` tasks that are not open are stored fully; of older
/// ones only which states were told (two bytes each), not type, reason or instant. Cost of each
/// call: O(log n) for n tasks, plus the size of its result, so that it does not grow with the
/// mission's duration. Source: spec 8.1.
class TaskBoard {
 public:
  static constexpr std::size_t kKept = 256;

  explicit TaskBoard(std::size_t kept = kKept) : most_kept_(kept) {}

  /// Adds a report; returns whether this state of the task is new.
  bool learn(const TaskEventReceived& event, MissionTime now);
  /// The MLE restarted: open tasks are lost; the background routine is removed, since its numbering
  /// begins again. Returns the lost tasks, by id.
  std::vector<executive::TaskId> lose();

  /// The task; absent if unknown.
  std::optional<TaskOnBoard> find(executive::TaskId id) const;
  /// The task; null if unknown or no longer stored fully. Valid until the next change.
  const TaskOnBoard* kept(executive::TaskId id) const;
  /// Whether this state of the task was reported; false if the task is unknown or lost.
  bool has_told(executive::TaskId id, executive::TaskState state) const;
  /// The open tasks.
  const std::set<executive::TaskId>& open() const { return open_; }
  /// Of the tasks that are not open and stored fully, the `count` that changed last, latest first;
  /// at one instant by id. Valid until the next change.
  std::vector<const TaskOnBoard*> last_over(std::size_t count) const;

 private:
  struct Entry {
    TaskOnBoard task;
    std::bitset<8> told;  ///< states
  };
  struct Over {
    MissionTime since;
    executive::TaskId id;
    bool operator<(const Over& other) const {
      return since != other.since ? since > other.since : id < other.id;
    }
  };
  using Entries = std::map<executive::TaskId, Entry>;
  static bool tell(Entry& entry, const TaskEventReceived& event, MissionTime now);
  static std::uint8_t byte_of(const Entry& entry);
  static Entry from_byte(executive::TaskId id, std::uint8_t byte);
  void file(const TaskOnBoard& task);
  bool learn_of_past(const TaskEventReceived& event, MissionTime now);
  void let_go_of_oldest();
  ByteBook& past_of(executive::TaskId id);
  std::uint8_t past_byte(executive::TaskId id) const;

  std::size_t most_kept_;
  Entries entries_;
  std::set<executive::TaskId> open_;
  std::set<Over> over_;
  ByteBook past_, past_routine_;  ///< byte_of() each task that is no longer stored fully
};

}  // namespace skein::ground_station
