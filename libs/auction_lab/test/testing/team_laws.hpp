// SPDX-License-Identifier: Apache-2.0
// What must hold of every team, seen from what was done alone.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "skein/auction_lab/team_simulation.hpp"

namespace skein::auction::testing {

/// No task executed twice: what runs under one sale has ended before it begins under another, no
/// member begins twice under one, and nothing begins after a sale that was done by all its owners.
inline std::vector<std::string> executed_twice(const std::vector<Execution>& executions) {
  std::vector<std::string> wrong;
  std::map<TaskNumber, std::vector<const Execution*>> by_task;
  for (const Execution& one : executions) by_task[one.claim.task].push_back(&one);
  for (const auto& [task, all] : by_task) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Execution &later = *all[i], &earlier = *all[j];
        const std::string what = "task " + to_text(task) + " begun by " + to_text(later.member) +
                                 " at " + to_text(later.began);
        if (later.claim.sale == earlier.claim.sale) {
          if (later.member == earlier.member) wrong.push_back(what + " a second time");
          continue;
        }
        const bool runs = earlier.end == Execution::End::kRunning || earlier.ended > later.began;
        if (runs) wrong.push_back(what + " while " + to_text(earlier.member) + " was at it");
      }
      std::map<std::uint64_t, std::set<MemberNumber>> done;  // by sale
      for (const Execution* before : all) {
        if (before->claim.sale >= all[i]->claim.sale || before->end != Execution::End::kDone)
          continue;
        auto& members = done[before->claim.sale];
        if (members.insert(before->member).second && members.size() == before->owners.size()) {
          wrong.push_back("task " + to_text(task) + " begun again although it was done");
        }
      }
    }
  }
  return wrong;
}

/// When a task was done by all owners of a sale; several, if it was done again.
inline std::vector<MissionTime> ends_of(TaskNumber task, const std::vector<Execution>& executions) {
  std::map<std::uint64_t, std::pair<std::size_t, MissionTime>> done;  // by sale
  std::vector<MissionTime> ends;
  for (const Execution& one : executions) {
    if (one.claim.task != task || one.end != Execution::End::kDone) continue;
    auto& [members, last] = done[one.claim.sale];
    last = std::max(last, one.ended);
    if (++members == one.owners.size()) ends.push_back(last);
  }
  return ends;
}

/// Nobody sets off to what is to follow another task sooner than the least time after that, and
/// what is done began within the greatest.
inline std::vector<std::string> out_of_time(const std::vector<Precedence>& precedences,
                                            const std::vector<Execution>& executions) {
  constexpr double kRounding = 1e-6;  // [s]
  std::vector<std::string> wrong;
  for (const auto& [first, then, delay] : precedences) {
    const auto ends = ends_of(first, executions);
    for (const Execution& one : executions) {
      if (one.claim.task != then) continue;
      const bool is_done = one.end == Execution::End::kDone;
      const bool in_time = std::any_of(ends.begin(), ends.end(), [&, d = delay](MissionTime end) {
        const bool too_soon = (one.began - end).to_seconds() < d.least - kRounding;
        const bool too_late = (one.there - end).to_seconds() > d.most + kRounding;
        return !too_soon && !(is_done && too_late);
      });
      if (in_time) continue;
      wrong.push_back("task " + to_text(then) + " begun at " + to_text(one.began) + ", there at " +
                      to_text(one.there) + ", after " + to_text(first) + " that ended at " +
                      (ends.empty() ? "no time" : to_text(ends.front())));
    }
  }
  return wrong;
}

/// A token is taken once in its term, by one member.
inline std::vector<std::string> terms_shared(const std::vector<TokenHeld>& tokens) {
  std::vector<std::string> wrong;
  std::map<std::uint64_t, MemberNumber> holder;
  for (const TokenHeld& token : tokens) {
    const auto [first, fresh] = holder.emplace(token.term, token.member);
    if (fresh) continue;
    wrong.push_back("term " + std::to_string(token.term) + " taken by " + to_text(token.member) +
                    " at " + to_text(token.taken) + " and before by " + to_text(first->second));
  }
  return wrong;
}

/// Every sale under which something was done says who got it and for what.
inline std::vector<std::string> unexplained(const std::vector<Execution>& executions) {
  std::vector<std::string> wrong;
  for (const Execution& one : executions) {
    const bool said =
        one.why.find(" to ") != std::string::npos && one.why.find(" for ") != std::string::npos;
    if (!said)
      wrong.push_back("sale of task " + to_text(one.claim.task) + " says '" + one.why + "'");
  }
  return wrong;
}

/// Everything is done in the ledger of every member alive.
inline std::vector<std::string> unfinished(const TeamSimulation& team, std::size_t tasks) {
  std::vector<std::string> wrong;
  for (std::size_t m = 0; m < team.size(); ++m) {
    if (!team.alive(m)) continue;
    const Ledger& ledger = team.ledger(m);
    if (ledger.entries.size() != tasks)
      wrong.push_back("member " + std::to_string(m) + " lacks tasks");
    for (const auto& [task, entry] : ledger.entries) {
      if (entry.stage == Stage::kDone) continue;
      wrong.push_back("task " + to_text(task) + " is not done at member " + std::to_string(m) +
                      ": stage " + std::to_string(static_cast<int>(entry.stage)) + ", " +
                      entry.why);
    }
  }
  return wrong;
}

}  // namespace skein::auction::testing
