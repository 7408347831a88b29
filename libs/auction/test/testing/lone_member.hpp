// SPDX-License-Identifier: Apache-2.0
// One member of a team of three, and what it says.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "skein/auction/team_member.hpp"

namespace skein::auction::testing {

struct LoneMember : ::testing::Test {
  TeamMember member(Disk disk = {}) {
    return TeamMember({MemberNumber(0),
                       {MemberNumber(0), MemberNumber(1), MemberNumber(2)},
                       {},
                       {},
                       1,
                       std::move(disk)});
  }
  template <class Message>
  static std::vector<Message> said(const TeamEffects& effects) {
    std::vector<Message> found;
    for (const TeamEffect& effect : effects) {
      const auto* tell = std::get_if<Tell>(&effect);
      const auto* message = tell != nullptr ? std::get_if<Message>(&tell->message) : nullptr;
      if (message != nullptr) found.push_back(*message);
    }
    return found;
  }
  template <class Effect>
  static std::size_t count(const TeamEffects& effects) {
    return static_cast<std::size_t>(
        std::count_if(effects.begin(), effects.end(),
                      [](const auto& effect) { return std::holds_alternative<Effect>(effect); }));
  }
  static TeamInput from(std::uint32_t who, TeamMessage message) {
    return Heard{MemberNumber(who), std::move(message)};
  }
  // A ledger where member 0 has task 5, granted at revision 4.
  static std::shared_ptr<Ledger> granted() {
    auto ledger = std::make_shared<Ledger>();
    ledger->term = 3;
    ledger->revision = 4;
    LedgerEntry& entry = ledger->entries[TaskNumber(5)];
    entry.task.number = TaskNumber(5);
    entry.stage = Stage::kGranted;
    entry.owners = {MemberNumber(0)};
    entry.sale = 9;
    entry.revision = 4;
    ledger->routes[MemberNumber(0)] = {TaskNumber(5)};
    return ledger;
  }
};

}  // namespace skein::auction::testing
