// SPDX-License-Identifier: Apache-2.0
// The background routine: what the vehicle does in flight when no task moves it. Source: T VI.1.3.
#pragma once

#include <cstdint>
#include <optional>

#include "skein/executive/task_state.hpp"
#include "skein/functional/task_type.hpp"

namespace skein::executive {

/// Decides when a background routine is to run, and knows the task that runs it.
class Background {
 public:
  /// Whether a routine is to begin: the vehicle flies, none runs, none is to be retried later, and
  /// the executive is not at rest.
  bool wanted() const { return airborne_ && !resting_ && !task_ && !pauses_; }
  std::optional<TaskId> task() const { return task_; }

  void flies(bool airborne) { airborne_ = airborne; }
  /// A task has ended whose type leaves the vehicle in this condition.
  void left(functional::Leaves leaves);
  /// While resting (until the next START) no routine is wanted.
  void rest(bool resting) { resting_ = resting; }
  /// Begins a routine and returns its task id.
  TaskId begin();
  /// The routine is over. `pauses`: it ended or was refused by itself, and no other begins before
  /// retry(); false if another task displaced it.
  void over(bool pauses);
  void retry() { pauses_ = false; }

 private:
  bool airborne_ = false;
  bool resting_ = false;
  std::optional<TaskId> task_;
  bool pauses_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace skein::executive
