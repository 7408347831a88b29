// SPDX-License-Identifier: Apache-2.0
// What a ledger has for sale, and what its members hold meanwhile.
#pragma once

#include <set>
#include <string>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/team_member.hpp"

namespace skein::auction {

bool all_before_done(const Ledger& ledger, const LedgerEntry& entry);

/// For sale once more, of nobody.
void put_up(LedgerEntry& entry, std::string why);

/// What is neither done nor with somebody who is not `here`; times count from `now`.
Lot lot_for_sale(const Ledger& ledger, const std::set<MemberNumber>& here, MissionTime now);

/// What the member has of that lot, in the order of its route.
Holding holding(const Ledger& ledger, const std::set<MemberNumber>& here, MemberNumber member);

/// The revision in which the last of what is for sale came there.
std::uint64_t newest_for_sale(const Ledger& ledger);

/// Something has no owner; what has one counts where somebody has `joined`, what nobody could do
/// also where it is to be called `again`.
bool worth_selling(const Ledger& ledger, bool joined, bool again);

}  // namespace skein::auction
