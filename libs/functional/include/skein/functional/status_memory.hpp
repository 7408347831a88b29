// SPDX-License-Identifier: Apache-2.0
// The last status that a functional layer has reported of each of its tasks.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>

#include "skein/foundation/byte_book.hpp"
#include "skein/functional/port.hpp"

namespace skein::functional {

/// Lets a functional layer answer a repeated request, however late, without carrying it out again.
/// The last kKept terminal tasks are kept completely, older ones in about two bytes each: their
/// terminal state, without reason. Cost: a map look-up, and kKept comparisons when a task ends.
class StatusMemory {
 public:
  static constexpr std::size_t kKept = 256;

  void set(const Status& status);
  /// The task was accepted, without a status so far.
  void note(TaskId task) {
    if (!knows(task)) last_.try_emplace(task);
  }
  bool knows(TaskId task) const { return last_.contains(task) || past_.knows(task.value()); }
  /// The last status; absent if there is none yet. Precondition: knows(task).
  std::optional<Status> last(TaskId task) const;
  void forget() { *this = {}; }

 private:
  void let_go_of_oldest();

  std::map<TaskId, std::optional<Status>> last_;
  std::deque<TaskId> over_;  ///< the terminal ones of last_, the oldest first
  ByteBook past_;            ///< 1 + state of each task that was dropped from last_
};

}  // namespace skein::functional
