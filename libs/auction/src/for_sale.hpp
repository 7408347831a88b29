// SPDX-License-Identifier: Apache-2.0
// The lot and the holdings of the next sale, taken from a ledger.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/team_member.hpp"

namespace skein::auction {

/// Whether every predecessor of the task in the ledger's precedences is done.
bool all_before_done(const Ledger& ledger, const LedgerEntry& entry);

/// Removes the owners of a task and puts it back on sale.
void put_up(LedgerEntry& entry, std::string why);

/// Removes the owners of a task that nobody can do, whoever is asked.
void take_out(LedgerEntry& entry, std::string why);

/// The tasks of the next sale: all but those that are done, given up as unsold, or owned by a
/// member that is not in `here`. Times count from `now`; granted tasks have no deadline.
Lot lot_for_sale(const Ledger& ledger, const std::set<MemberNumber>& here, MissionTime now);

/// The tasks of that lot which `member` owns, in the order of its route; all up to its last granted
/// task are fixed.
Holding holding(const Ledger& ledger, const std::set<MemberNumber>& here, MemberNumber member);

/// The newest revision of an entry that is for sale; 0: there is none.
std::uint64_t newest_for_sale(const Ledger& ledger);

/// The tasks without an owner that are too late for everybody, and are not yet said to be.
std::vector<TaskNumber> newly_too_late(const Ledger& ledger, MissionTime now);

/// Those that are unsold, and may be called again: they are not too late.
std::vector<TaskNumber> unsold_in_time(const Ledger& ledger, MissionTime now);

/// Whether a sale may change anything: a task is for sale; or a member has `joined` and a task is
/// owned without a grant; or a task may be called again and a member has `joined` or `again` is set
/// (a retry is due).
bool worth_selling(const Ledger& ledger, bool joined, bool again, MissionTime now);

}  // namespace skein::auction
