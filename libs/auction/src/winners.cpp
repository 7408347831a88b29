// SPDX-License-Identifier: Apache-2.0
#include "winners.hpp"

#include <algorithm>
#include <numeric>

namespace skein::auction {

namespace {

constexpr std::size_t kAllOrders = 3;  // so many items in every order
constexpr std::size_t kGroups = 4;     // of an item, tried one after the other

using Order = std::vector<std::uint32_t>;

std::optional<Decided> sell_one(Draft& draft, std::vector<Placing> placings) {
  for (std::size_t i = 0; i < placings.size(); ++i) {
    if (!draft.place(placings[i])) continue;
    Decided decided{placings[i], std::nullopt};
    if (i + 1 < placings.size()) decided.next_best = placings[i + 1];
    return decided;
  }
  return std::nullopt;
}

std::vector<Decided> in_order(Draft& draft, const Order& order) {
  std::vector<Decided> sold;
  for (const std::uint32_t item : order) {
    if (auto one = sell_one(draft, draft.placings(item, kGroups))) sold.push_back(std::move(*one));
  }
  return sold;
}

// Whether `one` would lose more than `other` by waiting: what has a single taker loses all.
bool more_urgent(const std::vector<Placing>& one, const std::vector<Placing>& other) {
  if (one.empty() || other.empty()) return other.empty() && !one.empty();
  if (one.size() == 1 || other.size() == 1) return one.size() < other.size();
  const auto loss = [](const std::vector<Placing>& of) {
    return std::pair(of[1].value.first - of[0].value.first,
                     of[1].value.second - of[0].value.second);
  };
  return loss(one) > loss(other);
}

bool cheaper(const std::vector<Placing>& one, const std::vector<Placing>& other) {
  if (one.empty() || other.empty()) return other.empty() && !one.empty();
  return better(one.front().value, other.front().value);
}

template <class Before>
std::vector<Decided> by_offers(Draft& draft, Before before) {
  Order left(draft.item_count());
  std::iota(left.begin(), left.end(), 0U);
  std::vector<Decided> sold;
  while (!left.empty()) {
    std::size_t chosen = 0;
    std::vector<Placing> best = draft.placings(left[0], kGroups);
    for (std::size_t i = 1; i < left.size(); ++i) {
      auto placings = draft.placings(left[i], kGroups);
      if (!before(placings, best)) continue;
      best = std::move(placings);
      chosen = i;
    }
    if (auto one = sell_one(draft, std::move(best))) sold.push_back(std::move(*one));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(chosen));
  }
  return sold;
}

class Best {
 public:
  explicit Best(Draft& draft) : draft_(&draft) {}

  template <class Sale>
  void consider(Sale sale) {
    if (!draft_->restore()) return;
    std::vector<Decided> sold = sale();
    const Value value = draft_->value();
    if (found_ && !better(value, value_)) return;
    found_ = true;
    value_ = value;
    sold_ = std::move(sold);
  }

  std::vector<Decided> leave_in_draft() {
    draft_->restore();
    for (const Decided& one : sold_) draft_->place(one.placing);
    return std::move(sold_);
  }

 private:
  Draft* draft_;
  bool found_ = false;
  Value value_;
  std::vector<Decided> sold_;
};

void shuffle(Order& order, Random& random) {
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
}

}  // namespace

std::vector<Decided> determine_winners(Draft& draft, Random& random, std::size_t orders) {
  Best best(draft);
  Order order(draft.item_count());
  std::iota(order.begin(), order.end(), 0U);
  if (order.size() <= kAllOrders) {
    do {
      best.consider([&] { return in_order(draft, order); });
    } while (std::next_permutation(order.begin(), order.end()));
    return best.leave_in_draft();
  }
  best.consider([&] { return by_offers(draft, more_urgent); });
  best.consider([&] { return by_offers(draft, cheaper); });
  for (std::size_t i = 0; i < orders; ++i) {
    shuffle(order, random);
    best.consider([&] { return in_order(draft, order); });
  }
  return best.leave_in_draft();
}

}  // namespace skein::auction
