// SPDX-License-Identifier: Apache-2.0
// The flow of slots between the kinds of nodes, as data.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/blackboard/slot_lifespan.hpp"
#include "skein/blackboard/slot_share.hpp"
#include "skein/blackboard/wire.hpp"
#include "skein/config/value.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"

namespace skein::blackboard {

/// Kinds of nodes, as far as slots are concerned, and the world channel as a sender and a receiver.
/// kFunctional: functional layers, the simulator included; kOthers: runner and spies.
enum class Party : std::uint8_t { kGround, kUav, kFunctional, kSim, kOperator, kOthers, kWorld };
inline constexpr std::size_t kParties = 7;
std::string_view name_of(Party party);

/// Which slots each kind of node produces, needs and relays, their shares of a channel and their
/// lifespans: the content of scenarios/slots.yaml. Immutable; any thread. Source: spec 1.3.
class SlotTable {
 public:
  /// The table of scenarios/slots.yaml at build time.
  static const SlotTable& shipped();

  /// The slots that `from` sends to `to`, in the order of wire::Slot; without the heartbeat, unless
  /// one is the world: every other channel carries it. Cost: the number of slots.
  std::vector<wire::Slot> between(Party from, Party to) const;
  /// The slots that relays forward.
  std::vector<wire::Slot> relayed() const;
  /// The slots of the world channel.
  std::vector<wire::Slot> of_world() const;
  const SlotShares& shares() const { return shares_; }
  const SlotLifespans& lifespans() const { return lifespans_; }
  /// Events of this slot live at least so long; without effect on one whose events live for ever.
  SlotTable with_lifespan(wire::Slot slot, Duration at_least) const;

 private:
  friend class SlotTableReader;
  std::array<std::set<std::pair<Party, Party>>, wire::kSlotCount> flows_;
  std::array<bool, wire::kSlotCount> relayed_{};
  SlotShares shares_{};
  SlotLifespans lifespans_{};
};

/// Reads the format of scenarios/slots.yaml: the rows given replace those of `base`. `file` is for
/// messages. Returns all errors: unknown slots, nodes and keys, a class other than in the IDL,
/// fractions that exceed a channel, lifespans of slots that are not events.
Result<SlotTable, Diagnostics> read_slot_table(std::string_view text, const std::string& file,
                                               const SlotTable& base);
/// The same for a parsed document: a map with the only key `slots`.
Result<SlotTable, Diagnostics> read_slot_table(const config::Value& document,
                                               const std::string& file, const SlotTable& base);

}  // namespace skein::blackboard
