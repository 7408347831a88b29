// SPDX-License-Identifier: Apache-2.0
// The tasks of one UAV, as far as the ground station was told of them.
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
  bool lost = false;  ///< its MLE restarted before it was terminal
  std::string reason = {};
  MissionTime since;
  bool at_ground = false;  ///< the MLE that runs here was the last to tell of it
};

/// Neither terminal nor lost.
bool is_open(const TaskOnBoard& task);

/// States come by events and by plan boards, in any order and more than once; the board never goes
/// back (scheduled, started, running, aborting, then ended or aborted), but for a task that was
/// lost and is started anew. Of the last `kept` that are not open all is kept; of those before, two
/// bytes each: which states were told, not the type, the reason or the instant. Cost: O(log n) of n
/// tasks for whatever is asked and told, and in proportion to what it gives; so that a mission of
/// days costs no more each second than one of minutes. Source: spec 8.1.
class TaskBoard {
 public:
  static constexpr std::size_t kKept = 256;

  explicit TaskBoard(std::size_t kept = kKept) : most_kept_(kept) {}

  /// Whether the state had not been told of the task before.
  bool learn(const TaskEventReceived& event, MissionTime now);
  /// The MLE restarted: open tasks are lost, the background routine is forgotten since it is
  /// numbered from the beginning again. Gives those that were lost, by id.
  std::vector<executive::TaskId> lose();

  /// Absent when unknown.
  std::optional<TaskOnBoard> find(executive::TaskId id) const;
  /// Null when unknown or let go. Valid until the next change.
  const TaskOnBoard* kept(executive::TaskId id) const;
  /// False when the task is unknown or lost.
  bool has_told(executive::TaskId id, executive::TaskState state) const;
  /// By id.
  const std::set<executive::TaskId>& open() const { return open_; }
  /// Of those that are not open and are kept, the `count` that changed last, the last first; of one
  /// instant by id. Valid until the next change.
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
  ByteBook past_, past_routine_;  ///< of each that was let go, what byte_of gives
};

}  // namespace skein::ground_station
