// SPDX-License-Identifier: Apache-2.0
// Watches: links from a fact to the literals that name it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace skein::executive {

/// Which of the two formulas of a task.
enum class Role : std::uint8_t { kPreconditions, kExit };

/// A reference to one literal of one formula; stale once the formula has another version. 12 bytes.
struct Watch {
  std::uint32_t slot = 0;
  std::uint32_t version = 0;
  std::uint32_t literal : 31;
  std::uint32_t exit : 1;

  Role role() const { return exit != 0 ? Role::kExit : Role::kPreconditions; }
};

/// The watches of one fact, in an order that has no effect. Stale watches are dropped when visited
/// and before the list grows, so that a list never holds more than about twice its live watches.
class WatchList {
 public:
  template <class IsLive>
  void add(Watch watch, const IsLive& is_live) {
    if (all_.size() == all_.capacity() && !all_.empty()) {
      drop_stale(is_live);
      if (all_.size() > all_.capacity() / 2) all_.reserve(2 * all_.capacity());
    }
    all_.push_back(watch);
  }

  template <class IsLive>
  void drop_stale(const IsLive& is_live) {
    all_.erase(std::remove_if(all_.begin(), all_.end(),
                              [&](const Watch& watch) { return !is_live(watch); }),
               all_.end());
  }

  /// Drops stale watches from the end until a live one; true if none is left. Amortised O(1).
  template <class IsLive>
  bool trim(const IsLive& is_live) {
    while (!all_.empty() && !is_live(all_.back())) all_.pop_back();
    return all_.empty();
  }

  std::vector<Watch>& all() { return all_; }
  std::vector<Watch> take() { return std::move(all_); }
  bool empty() const { return all_.empty(); }

 private:
  std::vector<Watch> all_;
};

}  // namespace skein::executive
