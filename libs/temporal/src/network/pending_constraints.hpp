// SPDX-License-Identifier: Apache-2.0
// The constraints that ask for what is impossible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "undo_log.hpp"

namespace skein::temporal {

/// Each constraint at most once for each kind of bounds, in no order that means anything. Cost of
/// each call: O(1).
class PendingConstraints {
 public:
  struct Pending {
    Constraint constraint;
    Bound bound;
  };

  /// There are so many constraints.
  void resize(std::size_t constraints) { places_.resize(2 * constraints, kNone); }
  void add(Constraint k, Bound bound, UndoLog& log) {
    std::uint32_t& place = places_[2 * k + side(bound)];
    if (place != kNone) return;
    log.add({.write = Undo::Write::kPendingAdded, .bound = bound, .id = k});
    place = static_cast<std::uint32_t>(pending_.size());
    pending_.push_back({k, bound});
  }
  void remove(Constraint k, Bound bound, UndoLog& log) {
    const std::uint32_t place = places_[2 * k + side(bound)];
    if (place == kNone) return;
    log.add({.write = Undo::Write::kPendingRemoved, .bound = bound, .id = k});
    const Pending last = pending_.back();
    pending_[place] = last;
    places_[2 * last.constraint + side(last.bound)] = place;
    places_[2 * k + side(bound)] = kNone;
    pending_.pop_back();
  }
  const std::vector<Pending>& all() const { return pending_; }

  std::size_t memory_bytes() const {
    return places_.capacity() * sizeof(places_[0]) + pending_.capacity() * sizeof(Pending);
  }
  void shrink() {
    places_.shrink_to_fit();
    pending_.shrink_to_fit();
  }

 private:
  std::vector<std::uint32_t> places_;  ///< of (constraint, bound), its place among the pending
  std::vector<Pending> pending_;
};

}  // namespace skein::temporal
