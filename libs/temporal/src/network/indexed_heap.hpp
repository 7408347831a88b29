// SPDX-License-Identifier: Apache-2.0
// A priority queue of node numbers whose keys may decrease.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace skein::temporal {

/// Smallest key first; of equal keys, an order that depends on the operations only. Four children a
/// node. Keys of numbers that left the heap are kept until they come back.
template <class Key>
class IndexedHeap {
 public:
  explicit IndexedHeap(std::size_t size) : place_(size, kAbsent), key_(size) {}

  /// Makes room for one number more.
  void grow() {
    place_.push_back(kAbsent);
    key_.emplace_back();
  }

  bool empty() const { return heap_.empty(); }
  bool contains(std::uint32_t item) const { return place_[item] != kAbsent; }
  const Key& key(std::uint32_t item) const { return key_[item]; }

  /// Puts the item in, or lowers its key; a key that is not lower changes nothing. True iff
  /// changed.
  bool lower(std::uint32_t item, Key key) {
    if (place_[item] == kAbsent) {
      key_[item] = key;
      place_[item] = static_cast<std::uint32_t>(heap_.size());
      heap_.push_back(item);
    } else if (!(key < key_[item])) {
      return false;
    } else {
      key_[item] = key;
    }
    rise(place_[item]);
    return true;
  }

  /// Precondition: not empty.
  std::uint32_t pop() {
    const std::uint32_t top = heap_.front();
    place_[top] = kAbsent;
    const std::uint32_t last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
      heap_.front() = last;
      place_[last] = 0;
      sink(0);
    }
    return top;
  }

  void clear() {
    for (const std::uint32_t item : heap_) place_[item] = kAbsent;
    heap_.clear();
  }

 private:
  static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kArity = 4;

  void put(std::size_t at, std::uint32_t item) {
    heap_[at] = item;
    place_[item] = static_cast<std::uint32_t>(at);
  }

  void rise(std::size_t at) {
    const std::uint32_t item = heap_[at];
    while (at > 0) {
      const std::size_t parent = (at - 1) / kArity;
      if (!(key_[item] < key_[heap_[parent]])) break;
      put(at, heap_[parent]);
      at = parent;
    }
    put(at, item);
  }

  void sink(std::size_t at) {
    const std::uint32_t item = heap_[at];
    for (;;) {
      const std::size_t first = at * kArity + 1;
      if (first >= heap_.size()) break;
      const std::size_t end = first + kArity < heap_.size() ? first + kArity : heap_.size();
      std::size_t least = first;
      for (std::size_t child = first + 1; child < end; ++child) {
        if (key_[heap_[child]] < key_[heap_[least]]) least = child;
      }
      if (!(key_[heap_[least]] < key_[item])) break;
      put(at, heap_[least]);
      at = least;
    }
    put(at, item);
  }

  std::vector<std::uint32_t> heap_;
  std::vector<std::uint32_t> place_;
  std::vector<Key> key_;
};

}  // namespace skein::temporal
