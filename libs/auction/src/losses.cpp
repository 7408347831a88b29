// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/losses.hpp"

namespace skein::auction {

bool Losses::declare(MemberNumber member, bool lost) {
  return is_lost(member) != lost && learn(member, turns_of(member) + 1);
}

bool Losses::learn(const Losses& other) {
  bool is_new = false;
  for (const auto& [member, turns] : other.turns_) is_new |= learn(member, turns);
  return is_new;
}

bool Losses::learn(MemberNumber member, std::uint32_t turns) {
  if (turns <= turns_of(member)) return false;
  turns_[member] = turns;
  return true;
}

std::uint32_t Losses::turns_of(MemberNumber member) const {
  const auto known = turns_.find(member);
  return known == turns_.end() ? 0 : known->second;
}

}  // namespace skein::auction
