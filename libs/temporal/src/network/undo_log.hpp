// SPDX-License-Identifier: Apache-2.0
// The writes to a network under propagation, so that they can be undone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "arc_table.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

/// What a write replaced.
struct Undo {
  enum class Write : std::uint8_t {
    kState,
    kStale,
    kWeight,
    kPendingAdded,
    kPendingRemoved,
    kNodeAdded,
    kArcAdded,
    kArcRemoved,
  };
  Write write = Write::kState;
  Bound bound = Bound::kLower;
  bool stale = false;
  std::uint32_t id = 0;
  Ticks value = 0;
  std::uint32_t cause = kNone;
  std::uint32_t root = kNone;
};

/// While at least one mark is open every write is kept, and nothing while writes are undone.
class UndoLog {
 public:
  void add(const Undo& undo) {
    if (!marks_.empty()) writes_.push_back(undo);
  }
  void mark() { marks_.push_back(writes_.size()); }
  /// Precondition: a mark is open.
  void drop_mark() {
    SKEIN_EXPECTS(!marks_.empty());
    marks_.pop_back();
    if (marks_.empty()) writes_.clear();
  }
  /// Calls `undo` with each write since the last mark, which stays: the last one first.
  /// Precondition: a mark is open.
  template <class UndoOne>
  void undo_to_mark(const UndoOne& undo) {
    SKEIN_EXPECTS(!marks_.empty());
    const std::size_t length = marks_.back();
    auto marks = std::exchange(marks_, {});  // nothing is logged meanwhile
    while (writes_.size() > length) {
      const Undo last = writes_.back();
      writes_.pop_back();
      undo(last);
    }
    marks_ = std::move(marks);
  }
  std::size_t memory_bytes() const { return writes_.capacity() * sizeof(Undo); }

 private:
  std::vector<Undo> writes_;
  std::vector<std::size_t> marks_;  ///< numbers of writes before each
};

}  // namespace skein::temporal
