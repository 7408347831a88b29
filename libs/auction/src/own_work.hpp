// SPDX-License-Identifier: Apache-2.0
// What a member does of its own: it wants its next tasks, begins what it was granted, says what
// ended.
#pragma once

#include <optional>
#include <vector>

#include "skein/auction/team_member.hpp"

namespace skein::auction {

/// Who does what the ledger says that it owns, one task at a time. What must not be forgotten it
/// writes on the member's disk, which its holder stores when a method says so (true).
class OwnWork {
 public:
  /// `disk` outlives it.
  OwnWork(MemberNumber self, TeamLimits limits, Disk& disk)
      : self_(self), limits_(std::move(limits)), disk_(disk) {}

  /// Under that sale, by this member: done, or given up.
  bool has_ended(const Claim& claim) const;
  /// The next of its route that wait for nothing; all of them when it has been idle for long.
  std::vector<Claim> wants(MissionTime now) const;

  [[nodiscard]] bool done(TaskNumber task);
  [[nodiscard]] bool put_back(const TaskPutBack& back);
  /// A joint task that a partner gave up cannot be done any more.
  [[nodiscard]] bool give_up_claims();
  /// What it was granted first, by a ledger that a majority has up to `committed`: partners begin
  /// in the same order. Nothing while something runs. What begins is to be stored.
  std::optional<Claim> begin_next(std::uint64_t committed, MissionTime now);

 private:
  bool mine(const LedgerEntry& entry) const;
  bool ended(const LedgerEntry& entry) const;
  const Ledger& ledger() const { return *disk_.ledger; }

  MemberNumber self_;
  TeamLimits limits_;
  Disk& disk_;
  std::optional<Claim> running_;
  std::optional<MissionTime> idle_since_;
};

}  // namespace skein::auction
