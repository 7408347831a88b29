// SPDX-License-Identifier: Apache-2.0
// Filter that rejects outdated states and streams.
#pragma once

#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "novelty.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// For each (origin, slot, instance) the newest sample seen, by incarnation then sequence.
class Freshness {
 public:
  /// A sample that is newer than all admitted before it is recorded. One that is older than another
  /// of the same incarnation is replayed; unless values have come in parts, past the transport, which
  /// gives the last one that it knows of again.
  Novelty admit(wire::Slot slot, const wire::SampleHeader& header) {
    const Version version{header.incarnation, header.sequence_number};
    const Key key{header.origin, slot, header.instance};
    const auto [entry, inserted] = newest_.try_emplace(key, version);
    if (inserted) return Novelty::kNew;
    Version& newest = entry->second;
    if (version <= newest) {
      const bool is_older = version.first == newest.first && version < newest;
      return is_older && !in_parts_.contains(key) ? Novelty::kReplayed : Novelty::kKnown;
    }
    if (version.first != newest.first) former_.insert_or_assign(key, newest);
    newest = version;
    return Novelty::kNew;
  }

  /// A value has come in parts.
  void note_parts(wire::Slot slot, const wire::SampleHeader& header) {
    in_parts_.insert({header.origin, slot, header.instance});
  }

  /// The origin is the life with this incarnation again, and what a later one said does not count:
  /// the last sample of each kind is admitted once more, since that of the later life took its
  /// place. Cost: all samples recorded.
  void return_to(std::uint32_t origin, std::uint64_t incarnation) {
    for (auto one = newest_.begin(); one != newest_.end();) {
      const bool is_later = one->first.origin == origin && one->second.first > incarnation;
      const auto former = is_later ? former_.find(one->first) : former_.end();
      const bool is_known = former != former_.end() && former->second.first <= incarnation;
      if (is_known) one->second = {former->second.first, former->second.second - 1};
      one = is_later && !is_known ? newest_.erase(one) : std::next(one);
    }
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
  std::unordered_map<Key, Version, Hash> former_;  ///< the newest of the incarnation before
  std::unordered_set<Key, Hash> in_parts_;         ///< values of which have come in parts
};

}  // namespace skein::blackboard
