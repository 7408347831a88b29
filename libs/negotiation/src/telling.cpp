// SPDX-License-Identifier: Apache-2.0
#include "telling.hpp"

#include <utility>

namespace skein::interaction {

Telling::Telling(std::size_t members, std::size_t self, MissionTime opened)
    : self_(self), told_(members, 0), last_sent_(opened) {}

void Telling::heard(std::size_t from, FactBits theirs) {
  told_[from] |= theirs;
  if (from == 0) unheard_ = 0;
}

std::vector<std::size_t> Telling::who_lags(FactBits known) const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < told_.size(); ++i) {
    if (i != self_ && lags(i, known)) all.push_back(i);
  }
  return all;
}

void Telling::owe_all() {
  for (std::size_t i = 0; i < told_.size(); ++i) owe(i);
}

void Telling::owe_news(FactBits known, bool all) {
  for (std::size_t i = 0; i < told_.size(); ++i) {
    if ((all || i == 0) && lags(i, known)) owe(i);
  }
}

std::set<std::size_t> Telling::take_owed(MissionTime now) {
  owed_.erase(self_);
  if (!owed_.empty()) last_sent_ = now;
  return std::exchange(owed_, {});
}

std::set<std::size_t> Telling::repeat(FactBits known, bool asks, bool invites, MissionTime now) {
  std::set<std::size_t> all;
  const bool decides = self_ == 0;
  for (std::size_t i = 0; i < told_.size(); ++i) {
    if (i == self_) continue;
    const bool uninvited = invites && told_[i] == 0;
    if (asks || (lags(i, known) && (i == 0 || decides || uninvited))) all.insert(i);
  }
  if (!all.empty()) ++unheard_;
  last_sent_ = now;
  return all;
}

}  // namespace skein::interaction
