// SPDX-License-Identifier: Apache-2.0
// A priority queue for whole-number priorities that never go down.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "skein/foundation/contract.hpp"

namespace skein::refiners {

/// One list per priority, in a ring; the last put in comes out first among equals. Each operation
/// is O(1), but for the search of the next bucket in use, 64 at a time.
class BucketQueue {
 public:
  /// `span`: no priority put in is above the one last taken out by more than that.
  explicit BucketQueue(std::int64_t span)
      : heads_(std::max<std::size_t>(64, std::bit_ceil(static_cast<std::size_t>(span) + 1)), kNone),
        in_use_(heads_.size() / 64, 0) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  /// Of what was taken out last, or start_at() said.
  std::int64_t priority() const { return now_; }
  /// Precondition: empty.
  void start_at(std::int64_t priority) { now_ = priority; }

  void push(std::int64_t priority, std::uint64_t value) {
    const std::size_t bucket = static_cast<std::size_t>(priority) & (heads_.size() - 1);
    const std::uint32_t place = take_place();
    entry(place) = {value, heads_[bucket]};
    heads_[bucket] = place;
    in_use_[bucket / 64] |= std::uint64_t{1} << bucket % 64;
    ++size_;
  }

  /// One of the least priority. Precondition: not empty.
  std::uint64_t pop() {
    const std::size_t bucket = next_in_use();
    const std::uint32_t place = heads_[bucket];
    const Entry taken = entry(place);
    heads_[bucket] = taken.next;
    if (taken.next == kNone) in_use_[bucket / 64] &= ~(std::uint64_t{1} << bucket % 64);
    entry(place).next = unused_;
    unused_ = place;
    --size_;
    return taken.value;
  }

 private:
  struct Entry {
    std::uint64_t value;
    std::uint32_t next;
  };
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  static constexpr unsigned kSlabBits = 12;

  Entry& entry(std::uint32_t place) {
    return slabs_[place >> kSlabBits][place & ((1U << kSlabBits) - 1)];
  }

  std::uint32_t take_place() {
    if (unused_ != kNone) {
      const std::uint32_t place = unused_;
      unused_ = entry(place).next;
      return place;
    }
    if (made_ >> kSlabBits == slabs_.size())
      slabs_.push_back(std::make_unique_for_overwrite<Entry[]>(std::size_t{1} << kSlabBits));
    return made_++;
  }

  /// Moves on to it.
  std::size_t next_in_use() {
    const std::size_t mask = heads_.size() - 1;
    const std::size_t bucket = static_cast<std::size_t>(now_) & mask;
    if (heads_[bucket] != kNone) return bucket;
    std::size_t word = bucket / 64;
    std::uint64_t bits = in_use_[word] >> bucket % 64 << bucket % 64;
    while (bits == 0) {
      word = (word + 1) & (in_use_.size() - 1);
      bits = in_use_[word];
    }
    const std::size_t found = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
    now_ += static_cast<std::int64_t>((found - bucket) & mask);
    return found;
  }

  std::vector<std::uint32_t> heads_;
  std::vector<std::uint64_t> in_use_;  // bits
  std::vector<std::unique_ptr<Entry[]>> slabs_;
  std::uint32_t unused_ = kNone, made_ = 0;
  std::size_t size_ = 0;
  std::int64_t now_ = 0;
};

}  // namespace skein::refiners
