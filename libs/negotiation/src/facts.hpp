// SPDX-License-Identifier: Apache-2.0
// What is known of a session: who offered what, who vowed what. Grows, and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/negotiation/terms.hpp"

namespace skein::interaction {

/// Which entries have which parts: an offer, a vow, a loss of each member, one bit each. Of two who
/// know the same session it says who knows more.
using FactBits = std::uint64_t;
inline bool lacks(FactBits one, FactBits other) { return (other & ~one) != 0; }

/// The entries of a session. Merging is commutative, associative and idempotent.
class Facts {
 public:
  explicit Facts(const Terms& terms);

  /// Why these cannot be entries of this session next to those that are known; absent: they can.
  std::optional<std::string> contradiction_in(const std::vector<Entry>& others) const;
  /// Precondition: no contradiction.
  void merge(const std::vector<Entry>& others);

  const std::vector<Entry>& entries() const { return entries_; }
  Entry& operator[](std::size_t member) { return entries_[member]; }
  const Entry& operator[](std::size_t member) const { return entries_[member]; }
  std::size_t size() const { return entries_.size(); }

  FactBits bits() const { return bits_of(entries_); }
  static FactBits bits_of(const std::vector<Entry>& entries);
  bool all_offered() const;
  bool all_promised() const;
  /// Who refused.
  const Entry* refusal() const;
  /// Who was lost before it is known to have vowed.
  const Entry* loss() const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace skein::interaction
