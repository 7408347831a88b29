// SPDX-License-Identifier: Apache-2.0
// Names of slots, samples of any slot and access to their headers.
#include "skein/blackboard/wire.hpp"

#include <algorithm>

namespace skein::wire {

static_assert(kSlotNames.size() == kSlotCount);

Sample::Sample() = default;
Sample::Sample(const Sample& other) = default;
Sample::Sample(Sample&& other) noexcept = default;
Sample& Sample::operator=(const Sample& other) = default;
Sample& Sample::operator=(Sample&& other) noexcept = default;
Sample::~Sample() = default;

std::string_view slot_name(Slot slot) { return kSlotNames[static_cast<std::size_t>(slot)]; }

std::optional<Slot> slot_from_name(std::string_view name) {
  const auto* const found = std::find(kSlotNames.begin(), kSlotNames.end(), name);
  if (found == kSlotNames.end()) return std::nullopt;
  return static_cast<Slot>(found - kSlotNames.begin());
}

SampleHeader& header_of(Sample& sample) {
  return std::visit([](auto& value) -> SampleHeader& { return value.header; }, sample);
}

const SampleHeader& header_of(const Sample& sample) {
  return std::visit([](const auto& value) -> const SampleHeader& { return value.header; }, sample);
}

}  // namespace skein::wire
