// SPDX-License-Identifier: Apache-2.0
// How many granted tasks each member has, and who is free for what follows in time.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "skein/auction/ledger.hpp"

namespace skein::auction {

/// Tasks granted to each member that are not over. Who is to follow one of them in time counts as
/// having as many as it may have: it is free when that ends.
class GrantLoad {
 public:
  /// `ledger` outlives this object. `ahead`: so many tasks may be granted to a member at a time.
  GrantLoad(const Ledger& ledger, std::uint32_t ahead);
  /// This entry is granted too.
  void add(const LedgerEntry& entry);
  /// Whether one of them may be granted nothing more.
  bool any_full(const std::vector<MemberNumber>& members) const;
  /// Whether all that is to follow the task in time may begin once this one ends: what it comes
  /// after besides is done, and its owners have no granted task; and, if `plans_count`, it is sold
  /// and its owners have nothing before it in their routes.
  bool may_be_followed(TaskNumber first, bool plans_count) const;

 private:
  std::uint32_t of(MemberNumber member) const;
  std::vector<const LedgerEntry*> followers(TaskNumber first) const;
  bool waits_for_more(TaskNumber then, TaskNumber first) const;
  bool has_before(MemberNumber member, TaskNumber then, TaskNumber first) const;

  const Ledger& ledger_;
  std::uint32_t ahead_;
  std::map<MemberNumber, std::uint32_t> load_;
};

}  // namespace skein::auction
