// SPDX-License-Identifier: Apache-2.0
// Who says what to whom, as data.
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

/// Kinds of nodes, as far as slots are concerned, and the world channel, to which some say what
/// others read there. kFunctional: what plays a vehicle, the simulator too; kOthers: runner, spies.
enum class Party : std::uint8_t { kGround, kUav, kFunctional, kSim, kOperator, kOthers, kWorld };
inline constexpr std::size_t kParties = 7;
std::string_view name_of(Party party);

/// Which slots each kind of node produces, needs and relays, with what they get of a channel: the
/// content of scenarios/slots.yaml. Immutable; any thread. Source: spec 1.3.
class SlotTable {
 public:
  /// As it was when this was built.
  static const SlotTable& shipped();

  /// What goes from the one to the other, in the order of wire::Slot; without the heartbeat, which
  /// every channel carries. Cost: the slots.
  std::vector<wire::Slot> between(Party from, Party to) const;
  /// What goes over radio one way or another: relays pass it on.
  std::vector<wire::Slot> relayed() const;
  /// Everything on the world channel.
  std::vector<wire::Slot> of_world() const;
  const SlotShares& shares() const { return shares_; }
  const SlotLifespans& lifespans() const { return lifespans_; }

 private:
  friend class SlotTableReader;
  std::array<std::set<std::pair<Party, Party>>, wire::kSlotCount> flows_;
  std::array<bool, wire::kSlotCount> relayed_{};
  SlotShares shares_{};
  SlotLifespans lifespans_{};
};

/// Reads the format of scenarios/slots.yaml: rows given take the place of those of `base`. `file`
/// is for messages. Every error at once: unknown slots, nodes and keys, a class that is not that of
/// the IDL, fractions that are too much for a channel, lifespans of what is no event.
Result<SlotTable, Diagnostics> read_slot_table(std::string_view text, const std::string& file,
                                               const SlotTable& base);
/// Likewise of a document that was parsed: a map with the key `slots` and no other.
Result<SlotTable, Diagnostics> read_slot_table(const config::Value& document,
                                               const std::string& file, const SlotTable& base);

}  // namespace skein::blackboard
