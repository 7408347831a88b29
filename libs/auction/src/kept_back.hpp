// SPDX-License-Identifier: Apache-2.0
// Tasks that could be granted, and wait until who is to follow them in time is free.
#pragma once

#include <map>

#include "grant_load.hpp"
#include "skein/auction/ledger.hpp"

namespace skein::auction {

/// By sale: what is sold again waits anew.
class KeptBack {
 public:
  /// Those that are not owned under that sale any more need not wait. Precondition: tasks are never
  /// taken out of the ledger.
  void forget_others_than_owned(const Ledger& ledger);
  /// Whether the entry may be granted at `now`. Routes that wait for each other, and what nobody
  /// buys, do not keep it back for longer than a lease.
  bool lets_go(const LedgerEntry& entry, const GrantLoad& load, MissionTime now, Duration lease);
  void clear() { since_.clear(); }

 private:
  std::map<Claim, MissionTime> since_;
};

}  // namespace skein::auction
