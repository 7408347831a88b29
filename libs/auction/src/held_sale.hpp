// SPDX-License-Identifier: Apache-2.0
// A running sale as the token holder keeps it, with the reasons of its results.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/team_member.hpp"

namespace skein::auction {

constexpr int kSalesOfATerm = 24;  ///< low bits of a sale number: sale within the term above them

/// Names of members for texts that people read; a member without a name is told by its number.
struct MemberNames {
  std::map<MemberNumber, std::string> names;

  std::string of(MemberNumber member) const;
  std::string of(const std::vector<MemberNumber>& members) const;
};

struct HeldSale {
  Auctioneer auctioneer;
  SaleNumber number;                        ///< greater than of all sales before it
  std::uint64_t revision;                   ///< of the ledger when the sale began
  std::map<TaskNumber, std::string> why{};  ///< reason of each task's result, for people

  /// Records in `why` what the effect says about tasks.
  void explain(const SaleEffect& effect, const MemberNames& names);
  /// Writes the results of the sale into the next ledger, under its number. Entries that changed
  /// during the sale keep their change and may be sold anew.
  void book(Ledger& next) const;
};

}  // namespace skein::auction
