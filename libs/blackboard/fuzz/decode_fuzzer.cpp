// SPDX-License-Identifier: Apache-2.0
// Bytes from anywhere -> decode -> check -> print -> encode. The first byte chooses the slot.
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "skein/blackboard/cdr.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace blackboard = skein::blackboard;
  namespace wire = skein::wire;
  if (size == 0) return 0;
  const auto slot = static_cast<wire::Slot>(data[0] % wire::kSlotCount);
  const auto decoded = blackboard::decode(slot, {data + 1, size - 1});
  const auto* sample = std::get_if<wire::Sample>(&decoded);
  if (sample == nullptr) return 0;
  if (wire::to_json(*sample).empty() || wire::to_text(*sample).empty()) std::abort();
  if (wire::find_violation(*sample)) return 0;
  std::vector<std::uint8_t> bytes(blackboard::encoded_size(*sample));
  if (blackboard::encode(*sample, bytes) != bytes.size()) std::abort();
  const auto again = blackboard::decode(slot, bytes);
  const auto* same = std::get_if<wire::Sample>(&again);
  if (same == nullptr || *same != *sample) std::abort();
  return 0;
}
