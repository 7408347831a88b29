// SPDX-License-Identifier: Apache-2.0
// Newest wins.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// For each (origin, slot, instance) the newest sample seen, by incarnation then sequence.
class Freshness {
 public:
  /// Whether the sample is newer than all before it; then it is the newest.
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
  using Key = std::tuple<std::uint32_t, wire::Slot, std::uint32_t>;
  using Version = std::pair<std::uint64_t, std::uint64_t>;
  std::map<Key, Version> newest_;
};

}  // namespace skein::blackboard
