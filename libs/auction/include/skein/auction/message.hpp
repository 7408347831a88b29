// SPDX-License-Identifier: Apache-2.0
// Messages between the auctioneer and the bidders of a sale.
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

/// Number of a sale, given by its auctioneer; answers to an earlier sale are ignored.
using SaleNumber = Id<struct SaleNumberTag, std::uint64_t>;

/// Call for bids, from the auctioneer to one member: what would these tasks cost you? Carries the
/// member's booked route, which replaces the member's own view of it. Idempotent.
struct Call {
  SaleNumber sale;
  std::uint32_t round = 0;
  std::shared_ptr<const Catalogue> lot;  ///< all tasks of the sale, the same in all its calls
  std::vector<TaskNumber> route;  ///< booked tasks in order, without those on sale in this call
  std::uint32_t fixed = 0;        ///< the first `fixed` tasks of the route keep their places
  std::vector<TaskNumber> items;  ///< on sale
  std::uint32_t gaps = 0;         ///< how many of the cheapest gaps to offer per item; 0: all
  bool between = false;           ///< the offer shall include the legs between items
};

/// The price of inserting an item into a gap of the route: gap g is before task g, the last gap
/// after all tasks.
struct GapPrice {
  std::uint32_t gap = 0;
  Leg in;
  Leg out;
};

/// The bid for one item, or the reason for none.
struct ItemPrice {
  TaskNumber item;
  double energy = 0;           ///< of the task itself [J]
  std::vector<GapPrice> gaps;  ///< in the order of gaps; empty: the member cannot do it
  std::string objection;       ///< why not
};

/// From a member to the auctioneer: its route without the items, and what each item would add.
struct Offer {
  SaleNumber sale;
  std::uint32_t round = 0;
  MemberNumber member;
  Abilities abilities = 0;
  double free_from = 0;          ///< [s]
  double energy = 0;             ///< available for the items [J]
  std::vector<Leg> legs;         ///< to each task of the route, then to its end
  std::vector<ItemPrice> items;  ///< in the order of the call
  std::vector<Leg> between;      ///< row-major, item to item, kNoWay where none; empty: not asked
};

/// From the auctioneer to a member: can you take this as your new route? It is booked once all
/// members of the deal have accepted theirs; the next call, or the end of the sale, carries the
/// booked route.
struct Award {
  SaleNumber sale;
  std::uint32_t round = 0;
  std::shared_ptr<const Catalogue> lot;
  std::vector<TaskNumber> route;
};

/// From a member to the auctioneer: whether it accepts the awarded route.
struct Answer {
  SaleNumber sale;
  std::uint32_t round = 0;
  MemberNumber member;
  std::optional<std::string> refusal;
  std::vector<Leg> legs;  ///< of the route: to each task, then to its end
  double energy = 0;      ///< remaining [J]
};

using ToMember = std::variant<Call, Award>;
using ToAuctioneer = std::variant<Offer, Answer>;

}  // namespace skein::auction
