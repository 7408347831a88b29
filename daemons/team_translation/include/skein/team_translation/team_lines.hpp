// SPDX-License-Identifier: Apache-2.0
// Records about who has which task of the team, and why (docs/journal.md).
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
/// An "owner" record: where a task stands in the team's book.
journal::Record owner_line(const Writer& writer, const team::TaskStanding& standing);
/// A "token" record: the right to sell is here, or is no more.
journal::Record token_line(const Writer& writer, bool held, std::uint64_t term);

}  // namespace skein::translation
