// SPDX-License-Identifier: Apache-2.0
// A team's ledger, entry by entry.
#pragma once

#include <memory>
#include <vector>

#include "skein/auction/team_member.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {

using Owners = std::vector<std::uint32_t>;

class LedgerBuilder {
 public:
  LedgerBuilder& has(const Task& task, Stage stage, const Owners& owners = {}) {
    LedgerEntry& entry = ledger_.entries[task.number];
    entry.task = task;
    entry.stage = stage;
    entry.owners = {owners.begin(), owners.end()};
    entry.sale = owners.empty() ? 0 : 100 + task.number.value();
    entry.revision = ++ledger_.revision;
    for (const std::uint32_t owner : owners) {
      ledger_.routes[MemberNumber(owner)].push_back(task.number);
    }
    return *this;
  }
  /// Under a sale that is later by 100, to those who have it.
  LedgerBuilder& sold_again(std::uint32_t task) {
    ledger_.entries.at(TaskNumber(task)).sale += 100;
    return *this;
  }
  LedgerBuilder& order(std::uint32_t first, std::uint32_t then) {
    return ledger_.precedences.push_back({TaskNumber(first), TaskNumber(then)}), *this;
  }
  LedgerBuilder& delay(std::uint32_t first, std::uint32_t then, Delay delay) {
    return ledger_.precedences.push_back({TaskNumber(first), TaskNumber(then), delay}), *this;
  }
  LedgerBuilder& stopped(std::uint32_t task, std::uint32_t by) {
    return ledger_.entries.at(TaskNumber(task)).stopped.insert(MemberNumber(by)), *this;
  }
  LedgerBuilder& finished(std::uint32_t task, std::uint32_t by) {
    return ledger_.entries.at(TaskNumber(task)).finished.insert(MemberNumber(by)), *this;
  }
  LedgerBuilder& term(std::uint64_t term) { return ledger_.term = term, *this; }
  operator Ledger() const { return ledger_; }  // NOLINT: builders are what they build
  std::shared_ptr<const Ledger> shared() const { return std::make_shared<const Ledger>(ledger_); }

 private:
  Ledger ledger_;
};

inline LedgerBuilder a_ledger() { return {}; }

/// The claim to a task as a LedgerBuilder numbers its sale.
inline Claim claim_to(std::uint32_t task) { return {TaskNumber(task), 100 + task}; }

}  // namespace skein::auction
