// SPDX-License-Identifier: Apache-2.0
// Which members the operator has declared lost, and found again.
#pragma once

#include <cstdint>
#include <map>

#include "skein/auction/message.hpp"

namespace skein::auction {

/// How often each member was declared lost or found again, in turn: of two who know different
/// declarations the one that knows more is right, in whatever order they hear of each other.
class Losses {
 public:
  bool is_lost(MemberNumber member) const { return turns_of(member) % 2 == 1; }
  /// By what this and the other know together.
  bool is_lost(MemberNumber member, const Losses& other) const {
    return (turns_of(member) < other.turns_of(member) ? other : *this).is_lost(member);
  }
  /// False: it was so already.
  bool declare(MemberNumber member, bool lost);
  /// Takes what the other knows and this does not. False: nothing.
  bool learn(const Losses& other);
  bool learn(MemberNumber member, std::uint32_t turns);
  /// By member; one that was never declared lost is not in it.
  const std::map<MemberNumber, std::uint32_t>& turns() const { return turns_; }
  bool operator==(const Losses&) const = default;

 private:
  std::uint32_t turns_of(MemberNumber member) const;

  std::map<MemberNumber, std::uint32_t> turns_;
};

}  // namespace skein::auction
