// SPDX-License-Identifier: Apache-2.0
// The known offers and vows of a session; a set that only grows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/negotiation/terms.hpp"

namespace skein::interaction {

/// Which facts are known: one bit for each of offer, vow and loss of each member. Compares the
/// knowledge of two members about the same session.
using FactBits = std::uint64_t;
inline bool lacks(FactBits one, FactBits other) { return (other & ~one) != 0; }

/// The entries of a session. Merging is commutative, associative and idempotent.
class Facts {
 public:
  explicit Facts(const Terms& terms);

  /// Why `others` contradict the known entries or the session; absent: they do not.
  std::optional<std::string> contradiction_in(const std::vector<Entry>& others) const;
  /// Precondition: no contradiction.
  void merge(const std::vector<Entry>& others);

  const std::vector<Entry>& entries() const { return entries_; }
  Entry& operator[](std::size_t member) { return entries_[member]; }
  const Entry& operator[](std::size_t member) const { return entries_[member]; }
  std::size_t size() const { return entries_.size(); }

  FactBits bits() const { return bits_of(entries_); }
  static FactBits bits_of(const std::vector<Entry>& entries);
  /// Of one who knows these facts. 1: somebody has to offer; 2: somebody has to promise; 3:
  /// decided.
  int stage_of(FactBits bits) const;
  bool all_offered() const;
  bool all_promised() const;
  /// The entry of a member that refused; null: none.
  const Entry* refusal() const;
  /// The entry of a member that was lost before a vow of it is known; null: none.
  const Entry* loss() const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace skein::interaction
