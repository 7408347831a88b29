// SPDX-License-Identifier: Apache-2.0
// What auctioneer and bidders say to each other.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/auction/catalogue.hpp"
#include "skein/auction/craft.hpp"
#include "skein/auction/task.hpp"

namespace skein::auction {

/// A sale: numbered by who holds it, so that answers to an earlier one count no more.
using SaleNumber = Id<struct SaleNumberTag, std::uint64_t>;

/// Auctioneer to one member: what would these tasks cost you? It names the route that the member
/// has in the books, which replaces whatever the member took it for: said again, it changes
/// nothing.
struct Call {
  SaleNumber sale;
  std::uint32_t round = 0;
  std::shared_ptr<const Catalogue> lot;  ///< everything of the sale, the same in all its calls
  std::vector<TaskNumber>
      route;                ///< in the books, in order; tasks on sale in this call are not in it
  std::uint32_t fixed = 0;  ///< so many at its beginning are not moved
  std::vector<TaskNumber> items;  ///< on sale
  std::uint32_t gaps = 0;         ///< wanted of each item: the cheapest; 0: all
  bool between = false;           ///< also the ways between items
};

/// Putting an item into a gap of the route: gap g lies before its g-th task, the last after all.
struct GapPrice {
  std::uint32_t gap = 0;
  Leg in;
  Leg out;
};

/// What one item would take, or why not.
struct ItemPrice {
  TaskNumber item;
  double energy = 0;           ///< of the task itself [J]
  std::vector<GapPrice> gaps;  ///< by gap; empty: it cannot be done
  std::string objection;       ///< why it cannot
};

/// Member to auctioneer: its route without the items, and what each item would add to it.
struct Offer {
  SaleNumber sale;
  std::uint32_t round = 0;
  MemberNumber member;
  Abilities abilities = 0;
  double free_from = 0;          ///< [s]
  double energy = 0;             ///< left for the items [J]
  std::vector<Leg> legs;         ///< to each task of the route, then to its end
  std::vector<ItemPrice> items;  ///< in the order of the call
  std::vector<Leg> between;      ///< row-major, item to item, kNoWay if none; empty: not asked
};

/// Auctioneer to member: this is to be your route; can you still fly it? It counts once all members
/// of the deal took theirs: the next call, or the end of the sale, says what is in the books.
struct Award {
  SaleNumber sale;
  std::uint32_t round = 0;
  std::shared_ptr<const Catalogue> lot;
  std::vector<TaskNumber> route;
};

/// Member to auctioneer: whether it takes the route.
struct Answer {
  SaleNumber sale;
  std::uint32_t round = 0;
  MemberNumber member;
  std::optional<std::string> refusal;
  std::vector<Leg> legs;  ///< of the route: to each task, then to its end
  double energy = 0;      ///< left [J]
};

using ToMember = std::variant<Call, Award>;
using ToAuctioneer = std::variant<Offer, Answer>;

}  // namespace skein::auction
