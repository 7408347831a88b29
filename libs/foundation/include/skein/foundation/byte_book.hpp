// SPDX-License-Identifier: Apache-2.0
// A compact map from numbers to bytes, for states of things that are over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace skein {

/// A map from numbers to bytes; the byte of a number that was never set is 0. Made for mostly
/// consecutive numbers, like those of tasks: these take less than two bytes each; a number far from
/// all others takes a page of about 200 bytes. Cost: a search among pages of 128 numbers.
class ByteBook {
 public:
  std::uint8_t of(std::uint64_t number) const {
    const auto page = pages_.find(number / kPage);
    return page == pages_.end() ? std::uint8_t{0} : page->second[number % kPage];
  }
  bool knows(std::uint64_t number) const { return of(number) != 0; }
  void set(std::uint64_t number, std::uint8_t value) {
    pages_.try_emplace(number / kPage, Page{}).first->second[number % kPage] = value;
  }
  void clear() { pages_.clear(); }
  /// Memory in use [bytes], approximately.
  std::size_t memory() const { return pages_.size() * (sizeof(Page) + kNode); }

 private:
  static constexpr std::uint64_t kPage = 128;
  static constexpr std::size_t kNode = 64;  ///< of a map, about [bytes]
  using Page = std::array<std::uint8_t, kPage>;
  std::map<std::uint64_t, Page> pages_;
};

}  // namespace skein
