// SPDX-License-Identifier: Apache-2.0
// A sale in virtual time: an auctioneer and its bidders, with messages under way.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <queue>
#include <vector>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/bidder.hpp"
#include "skein/foundation/random.hpp"

namespace skein::auction {

struct SaleTransport {
  Duration least = Duration::milliseconds(5);
  Duration longest = Duration::milliseconds(50);  ///< a message takes a uniform time in between
  double loss = 0;                                ///< of each message
  std::uint64_t seed = 1;
};

/// What a sale came to.
struct SaleOutcome {
  std::vector<Auctioneer::Route> routes;
  Value value;
  std::vector<SaleEffect> told;  ///< everything but messages
  std::uint64_t messages = 0;
  std::uint32_t rounds = 0;
  MissionTime ended;
};

/// Whether a member hears and answers at an instant; for members that vanish.
using Presence = std::function<bool(MemberNumber, MissionTime)>;

/// Plays a whole sale; crafts by the order of the holdings, alive during the call.
SaleOutcome play_sale(SaleSetup setup, const std::vector<const Craft*>& crafts,
                      const SaleTransport& transport, const Presence& present = {});

}  // namespace skein::auction
