// SPDX-License-Identifier: Apache-2.0
// Filter that rejects outdated states and streams.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// For each (origin, slot, instance) the newest sample seen, by incarnation then sequence.
class Freshness {
 public:
  /// Whether the sample is newer than all admitted before it; if so, it is recorded.
  bool admit(wire::Slot slot, const wire::SampleHeader& header) {
    const Version version{header.incarnation, header.sequence_number};
    const auto [entry, inserted] =
        newest_.try_emplace(Key{header.origin, slot, header.instance}, version);
    if (inserted) return true;
    if (version <= entry->second) return false;
    entry->second = version;
    return true;
  }

 private:
  struct Key {
    std::uint32_t origin;
    wire::Slot slot;
    std::uint32_t instance;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const {
      constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15;  // 2^64 by the golden ratio
      const std::uint64_t both = std::uint64_t{key.origin} << 32 | key.instance;
      return (both ^ static_cast<std::uint64_t>(key.slot) * kSpread) * kSpread;
    }
  };
  using Version = std::pair<std::uint64_t, std::uint64_t>;
  std::unordered_map<Key, Version, Hash> newest_;
};

}  // namespace skein::blackboard
