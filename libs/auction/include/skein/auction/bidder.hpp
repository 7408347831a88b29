// SPDX-License-Identifier: Apache-2.0
// The bidder of a contract-net sale.
#pragma once

#include <string>
#include <vector>

#include "skein/auction/message.hpp"

namespace skein::auction {

/// Computes the bids of one vehicle. Stateless: the current route comes with the call, so bidding
/// has no side effect and a repeated call gets the same answer. Cost: items times gaps.
/// Source: spec 6.3; [Smith 80].
class Bidder {
 public:
  /// `craft` outlives the bidder.
  Bidder(MemberNumber self, const Craft& craft) : self_(self), craft_(&craft) {}

  ToAuctioneer handle(const ToMember& message) const;
  Offer price(const Call& call) const;
  Answer take(const Award& award) const;

 private:
  ItemPrice price_item(const Call& call, const Task& task) const;
  std::string refusal_of(const Task& task) const;
  std::vector<Leg> legs_of(const std::vector<TaskNumber>& route) const;
  MemberNumber self_;
  const Craft* craft_;
};

}  // namespace skein::auction
