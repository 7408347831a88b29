// SPDX-License-Identifier: Apache-2.0
// Records about the allocation of the team's tasks, with reasons (docs/journal.md).
#pragma once

#include <vector>

#include "skein/auction/auctioneer.hpp"
#include "skein/team/ownership.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::translation {

/// "sale" records, written by who holds the sale: one, or one for each contradiction; none of what
/// is not for people.
std::vector<journal::Record> sale_lines(const Writer& writer, const auction::SaleEffect& effect,
                                        const team::Roster& roster);
/// An "owner" record: state and owners of a task in the team's ledger.
journal::Record owner_line(const Writer& writer, const team::TaskStanding& standing);
/// A "token" record: this node took or lost the right to sell.
journal::Record token_line(const Writer& writer, bool held, std::uint64_t term);

}  // namespace skein::translation
