// SPDX-License-Identifier: Apache-2.0
// Messages of a team that allocates its missions by auction: wire to domain and back.
#pragma once

#include "skein/auction/ledger.hpp"
#include "skein/translation/missions.hpp"

namespace skein::translation {

/// A TeamMessage or a TeamSale. In sales the work of tasks is left out: the ledger has it. Times
/// without bound, and energy without, have forms of their own on the wire.
wire::Sample to_wire(const auction::TeamMessage& message);

/// Refuses a ledger or a lot with a number given twice, orders that make no sense, and calls and
/// awards about tasks that are not in their lot. Whether an offer answers what was asked is for the
/// auctioneer.
Read<auction::TeamMessage> from_wire(const wire::TeamMessage& sample);
/// The member of an offer is its sender.
Read<auction::TeamMessage> from_wire(const wire::TeamSale& sample);

}  // namespace skein::translation
