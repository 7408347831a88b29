// SPDX-License-Identifier: Apache-2.0
// The background routine: what the vehicle does in flight when no task moves it. Source: T VI.1.3.
#pragma once

#include <cstdint>
#include <optional>

#include "skein/executive/task_state.hpp"
#include "skein/foundation/time.hpp"
#include "skein/functional/task_type.hpp"

namespace skein::executive {

/// When a routine is wanted, and which one runs.
class Background {
 public:
  /// In flight, none runs, none was refused just now, and the executive is not at rest.
  bool wanted() const { return airborne_ && !resting_ && !task_ && !retry_; }
  std::optional<TaskId> task() const { return task_; }

  void flies(bool airborne) { airborne_ = airborne; }
  /// A task that leaves the vehicle there has ended.
  void left(functional::Leaves leaves);
  /// At rest: none until the next START.
  void rest(bool resting) { resting_ = resting; }
  /// The id of the one that begins.
  TaskId begin();
  /// It is over. With `retry` it ended or was refused by itself and is not tried again before;
  /// without, something displaced it.
  void over(std::optional<MissionTime> retry);
  bool retries_at(MissionTime at) const { return retry_ == at; }
  void retry() { retry_.reset(); }

 private:
  bool airborne_ = false;
  bool resting_ = false;
  std::optional<TaskId> task_;
  std::optional<MissionTime> retry_;
  std::uint64_t count_ = 0;
};

}  // namespace skein::executive
