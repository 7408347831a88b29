// SPDX-License-Identifier: Apache-2.0
// What a functional layer told last of each of its tasks.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>

#include "skein/foundation/byte_book.hpp"
#include "skein/functional/port.hpp"

namespace skein::functional {

/// So that a request that comes twice is answered twice and carried out once, however late. Of the
/// last kKept tasks that are over all is kept; of those before, two bytes each: that it ended or
/// was aborted, without the reason. Cost: of a map, and kKept comparisons when a task is over.
class StatusMemory {
 public:
  static constexpr std::size_t kKept = 256;

  void set(const Status& status);
  /// Taken on, though nothing can be told yet.
  void note(TaskId task) {
    if (!knows(task)) last_.try_emplace(task);
  }
  bool knows(TaskId task) const { return last_.contains(task) || past_.knows(task.value()); }
  /// Absent when nothing was told. Precondition: it is known.
  std::optional<Status> last(TaskId task) const;
  void forget() { *this = {}; }

 private:
  void let_go_of_oldest();

  std::map<TaskId, std::optional<Status>> last_;
  std::deque<TaskId> over_;  ///< of those, the oldest first
  ByteBook past_;            ///< 1 + state of each that was let go
};

}  // namespace skein::functional
