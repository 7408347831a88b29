// SPDX-License-Identifier: Apache-2.0
// When tasks ended, as far as the holder of the token knows, and what that leaves to those after.
#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "skein/auction/ledger.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

/// Bounds on the end of a task that is done.
struct TaskEnd {
  std::optional<MissionTime> after;  ///< none: nothing is known
  MissionTime by;
};

/// What the owners of tasks said of their ends. A task of several ends with the last of them.
class TaskEnds {
 public:
  /// Idempotent, and in any order.
  void said(MemberNumber owner, const DoneClaim& done);
  /// Of a task that is done now. Exact if all its owners said it to this holder of the token: who
  /// did not has ended it before.
  TaskEnd of(const LedgerEntry& entry, MissionTime now) const;

 private:
  std::map<std::pair<Claim, MemberNumber>, MissionTime> ends_;
};

/// The window of a task that begins some time after one that has ended: from the latest that it may
/// have ended, to the earliest. Without an earliest, a delay with a greatest leaves no time.
void bound_start(Task& then, const Delay& delay, const TaskEnd& first);

}  // namespace skein::auction
