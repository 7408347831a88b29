// SPDX-License-Identifier: Apache-2.0
#include "trade_picker.hpp"

#include <algorithm>
#include <cmath>

namespace skein::auction {

namespace {

constexpr double kNearness = 3;  // the larger, the nearer to each other

std::vector<TaskNumber> movable(const BookedRoute& route) {
  return {route.tasks.begin() + route.fixed, route.tasks.end()};
}

}  // namespace

TradePicker::TradePicker(const Catalogue& catalogue, Aim aim, const SaleLimits& limits,
                         std::uint64_t seed)
    : catalogue_(&catalogue), aim_(aim), limits_(limits), random_(seed, "auction/trades") {}

double TradePicker::distance(TaskNumber one, TaskNumber other) const {
  const Place a = catalogue_->task(one).at, b = catalogue_->task(other).at;
  return std::hypot(a.x - b.x, a.y - b.y);
}

// Of those left, one near to one of the chosen; it is taken out of them.
TaskNumber TradePicker::near(const std::vector<TaskNumber>& chosen, std::vector<TaskNumber>& left) {
  const TaskNumber centre = chosen[random_.below(chosen.size())];
  const double part = std::pow(random_.uniform(), kNearness);
  const auto rank =
      left.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(left.size()));
  std::nth_element(left.begin(), rank, left.end(), [&](TaskNumber a, TaskNumber b) {
    return std::pair(distance(centre, a), a) < std::pair(distance(centre, b), b);
  });
  const TaskNumber found = *rank;
  left.erase(rank);
  return found;
}

std::vector<TaskNumber> TradePicker::items(const std::vector<BookedRoute>& books,
                                           std::size_t last_to_end,
                                           const std::vector<TaskNumber>& first) {
  std::set<TaskNumber> fixed, all;
  for (const BookedRoute& route : books) {
    fixed.insert(route.tasks.begin(), route.tasks.begin() + route.fixed);
    for (const TaskNumber task : movable(route)) all.insert(task);
  }
  std::vector<TaskNumber> left;
  std::set_difference(all.begin(), all.end(), fixed.begin(), fixed.end(), std::back_inserter(left));
  std::vector<TaskNumber> chosen = first;
  if (chosen.size() > limits_.trade) chosen.resize(limits_.trade);
  if (chosen.empty() && !left.empty()) {
    std::vector<TaskNumber> critical;
    if (!books.empty() && random_.chance(aim_.equity / 2)) {
      for (const TaskNumber task : movable(books[last_to_end])) {
        if (!fixed.contains(task)) critical.push_back(task);
      }
    }
    const auto& from = critical.empty() ? left : critical;
    chosen.push_back(from[random_.below(from.size())]);
    std::erase(left, chosen.front());
  }
  const std::size_t most = std::max<std::size_t>(limits_.trade, 2);
  const std::size_t wanted = std::max(chosen.size(), 2 + random_.below(most - 1));
  while (chosen.size() < wanted && !left.empty()) chosen.push_back(near(chosen, left));
  return chosen;
}

std::set<std::size_t> TradePicker::called(const std::vector<BookedRoute>& books,
                                          const std::vector<TaskNumber>& items) {
  std::set<std::size_t> called;
  if (books.size() <= limits_.called) {
    for (std::size_t i = 0; i < books.size(); ++i) called.insert(i);
    return called;
  }
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t i = 0; i < books.size(); ++i) {
    double least = 1e300;
    for (const TaskNumber task : books[i].tasks) {
      for (const TaskNumber item : items) {
        if (task == item)
          least = -1;
        else
          least = std::min(least, distance(task, item));
      }
    }
    if (least < 0) called.insert(i);
    nearest.emplace_back(least, i);
  }
  std::sort(nearest.begin(), nearest.end());
  for (const auto& [way, i] : nearest) {
    if (called.size() + 1 >= limits_.called) break;
    called.insert(i);
  }
  called.insert(random_.below(books.size()));
  return called;
}

}  // namespace skein::auction
