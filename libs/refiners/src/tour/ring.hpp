// SPDX-License-Identifier: Apache-2.0
// A closed tour whose pieces can be turned round; private.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace skein::refiners {

using City = std::uint32_t;

/// Places in a ring, held in an array. It may be looked at in either sense: `mirror` changes what
/// next and previous mean, not the ring. Every turn is recorded, so that it can be taken back.
class TourRing {
 public:
  explicit TourRing(std::vector<City> order) : order_(std::move(order)), position_(order_.size()) {
    for (City i = 0; i < size(); ++i) position_[order_[i]] = i;
  }

  City size() const { return static_cast<City>(order_.size()); }
  const std::vector<City>& order() const { return order_; }
  City at(City position) const { return order_[position % size()]; }
  City position(City city) const { return position_[city]; }
  City next(City city) const { return backwards_ != mirrored_ ? before(city) : after(city); }
  City previous(City city) const { return backwards_ != mirrored_ ? after(city) : before(city); }
  /// True when next is the next in the array.
  bool reads_forwards() const { return backwards_ == mirrored_; }
  void mirror() { mirrored_ = !mirrored_; }

  /// Turns round the part from `first` on to `last`. Cost: O(size / 2) at most.
  void turn(City first, City last) {
    if (mirrored_) std::swap(first, last);
    turns_.emplace_back(first, last);
    turn_plain(first, last);
  }

  std::size_t turns() const { return turns_.size(); }
  /// Takes back all turns but the first `count` ones.
  void take_back(std::size_t count) {
    for (; turns_.size() > count; turns_.pop_back())
      turn_plain(turns_.back().second, turns_.back().first);
  }
  void forget_turns() { turns_.clear(); }

 private:
  City after(City city) const {
    const City at = position_[city] + 1;
    return order_[at == size() ? 0 : at];
  }
  City before(City city) const {
    const City at = position_[city];
    return order_[(at == 0 ? size() : at) - 1];
  }

  /// In the unmirrored sense. Turning the others round instead gives the same ring, read backwards.
  void turn_plain(City first, City last) {
    if (backwards_) std::swap(first, last);
    City from = position_[first], to = position_[last];
    City count = (to >= from ? to - from : to + size() - from) + 1;
    if (2 * count > size()) {
      std::swap(from, to);
      from = from + 1 == size() ? 0 : from + 1;
      to = to == 0 ? size() - 1 : to - 1;
      count = size() - count;
      backwards_ = !backwards_;
    }
    for (City swaps = count / 2; swaps > 0; --swaps) {
      const City a = order_[from], b = order_[to];
      order_[from] = b, position_[b] = from;
      order_[to] = a, position_[a] = to;
      if (++from == size()) from = 0;
      if (to-- == 0) to = size() - 1;
    }
  }

  std::vector<City> order_, position_;
  std::vector<std::pair<City, City>> turns_;
  bool backwards_ = false, mirrored_ = false;
};

}  // namespace skein::refiners
