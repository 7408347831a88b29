// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/catalogue.hpp"

#include <algorithm>
#include <bit>

#include "skein/foundation/contract.hpp"

namespace skein::auction {

Catalogue::Catalogue(Lot lot)
    : lot_(std::move(lot)), before_(lot_.tasks.size()), after_(lot_.tasks.size()) {
  for (std::size_t i = 0; i < lot_.tasks.size(); ++i) {
    const Task& task = lot_.tasks[i];
    index_.emplace(task.number, static_cast<std::uint32_t>(i));
    coupled_ = coupled_ || task.least_members > 1 || std::popcount(task.needs) > 1;
  }
  for (const auto& [first, then, delay] : lot_.precedences) {
    if (!has(first) || !has(then)) continue;
    coupled_ = true;
    after_[index(first)].push_back(index(then));
    before_[index(then)].push_back(index(first));
    if (!delay.bounds()) continue;
    Delay& both = delays_[{index(first), index(then)}];
    both = {std::max(both.least, delay.least), std::min(both.most, delay.most)};
  }
}

Delay Catalogue::delay(std::uint32_t first, std::uint32_t then) const {
  const auto found = delays_.find({first, then});
  return found == delays_.end() ? Delay() : found->second;
}

std::uint32_t Catalogue::index(TaskNumber number) const {
  const auto found = index_.find(number);
  SKEIN_EXPECTS(found != index_.end());
  return found->second;
}

}  // namespace skein::auction
