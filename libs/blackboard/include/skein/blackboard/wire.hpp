// SPDX-License-Identifier: Apache-2.0
// All slots of the blackboard, as one closed set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "skein/blackboard/wire_slots.hpp"

namespace skein::wire {

inline constexpr std::size_t kSlotCount = std::variant_size_v<SampleVariant>;

constexpr Slot slot_of(const Sample& sample) { return static_cast<Slot>(sample.index()); }

/// The name of the slot, which is that of its IDL type and of its DDS topic: "TaskRequest".
std::string_view slot_name(Slot slot);
std::optional<Slot> slot_from_name(std::string_view name);

/// Whether nothing follows any more.
constexpr bool is_settled(CommandState state) {
  return state != CommandState::kIssued && state != CommandState::kDelivered;
}

SampleHeader& header_of(Sample& sample);
const SampleHeader& header_of(const Sample& sample);

/// Limits on what a peer may send; anything larger is malformed.
inline constexpr std::size_t kMaximumString = 65'536;  ///< [byte]
inline constexpr std::size_t kMaximumSequence = 4096;  ///< elements

/// The first field that breaks the rules of the wire.
struct Violation {
  std::string field;  ///< path: "task.preconditions[2].literals[0].state"
  std::string why;    ///< "7 is not a value of the enumeration"
  bool operator==(const Violation&) const = default;
};

/// Checks what holds for every wire type: enumerations in range, numbers finite, strings and
/// sequences within the limits. What a value means is for whoever converts it.
std::optional<Violation> find_violation(const Sample& sample);

/// One JSON object on one line: {"slot":"Clock","header":{…},…}; fields in wire order, enumerations
/// by name, times in ns.
std::string to_json(const Sample& sample);

/// One line for people: the slot, "origin>destination #sequence", then the fields but the header.
std::string to_text(const Sample& sample);

}  // namespace skein::wire
