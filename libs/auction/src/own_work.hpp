// SPDX-License-Identifier: Apache-2.0
// Execution of a member's own tasks: claims the next ones, begins granted ones, records ended ones.
#pragma once

#include <optional>
#include <vector>

#include "skein/auction/team_member.hpp"

namespace skein::auction {

/// Runs the tasks that the ledger assigns to this member, one at a time. Changes the member's Disk;
/// the caller has to store it when a method returns true or a claim.
class OwnWork {
 public:
  /// `disk` outlives this object.
  OwnWork(MemberNumber self, TeamLimits limits, Disk& disk)
      : self_(self), limits_(std::move(limits)), disk_(disk) {}

  /// Whether this member has done or given up the task under that sale or a later one.
  bool has_ended(const Claim& claim) const;
  /// The last sale under which this member has done the task; none: it has not. Also a later sale
  /// to it alone: the task was sold again while the others did not hear it at work or done.
  std::optional<std::uint64_t> done_under(TaskNumber task) const;
  /// Claims for the next `limits.ahead` tasks of the route whose predecessors are done; for all
  /// such tasks after it has waited for a grant for `limits.lease`, since routes that were sold in
  /// separate parts of the team may wait for each other.
  std::vector<Claim> wants(MissionTime now) const;

  /// The running task has ended and is done. False: `task` is not running.
  [[nodiscard]] bool done(TaskNumber task, MissionTime now);
  /// Gives a task of this member back for sale, or ends the running one, whoever owns it by now.
  /// False: it is neither.
  [[nodiscard]] bool put_back(const TaskPutBack& back);
  /// Gives up this member's parts of joint tasks that a partner gave up, unless they are running.
  /// True: there was one.
  [[nodiscard]] bool give_up_claims();
  /// Begins the task with the oldest grant of a revision up to `committed` (stored by a majority),
  /// so that partners begin joint tasks in the same order. Nothing while a task is running.
  std::optional<Claim> begin_next(std::uint64_t committed, MissionTime now);

 private:
  bool mine(const LedgerEntry& entry) const;
  bool ended(const LedgerEntry& entry) const;
  std::uint64_t sale_to_itself_alone(TaskNumber task) const;
  const Ledger& ledger() const { return *disk_.ledger; }
  std::vector<Claim> next_of_route(std::uint32_t most) const;

  MemberNumber self_;
  TeamLimits limits_;
  Disk& disk_;
  std::optional<Claim> running_;
  std::optional<MissionTime> waits_since_;  ///< idle, with tasks that could be granted
};

}  // namespace skein::auction
