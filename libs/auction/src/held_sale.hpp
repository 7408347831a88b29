// SPDX-License-Identifier: Apache-2.0
// A sale as its holder keeps it: who was asked, why it ended as it did, what of it goes into the
// ledger.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/team_member.hpp"

namespace skein::auction {

constexpr int kSalesOfATerm = 24;  ///< bits of the number of a sale below its term's

/// Names of members in what is said to people.
struct MemberNames {
  std::map<MemberNumber, std::string> names;

  std::string of(MemberNumber member) const;
  std::string of(const std::vector<MemberNumber>& members) const;
};

struct HeldSale {
  Auctioneer auctioneer;
  std::uint64_t revision;  ///< of the ledger when it began
  std::map<TaskNumber, std::string> why{};

  /// Keeps in words what it says of tasks.
  void explain(const SaleEffect& effect, const MemberNames& names);
  /// What it sold, into the next ledger. What changed while it was being sold stays as it changed;
  /// it is sold anew if need be.
  void book(Ledger& next) const;
};

}  // namespace skein::auction
