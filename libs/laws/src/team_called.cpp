// SPDX-License-Identifier: Apache-2.0
// Whom a team asks when it sells.
#include <algorithm>
#include <map>
#include <set>

#include "checks.hpp"

namespace skein::laws {

namespace {

/// For elections, and for a sale and its answers: so long somebody is there before it is expected
/// to be asked [s].
constexpr double kThere = 60;
/// For its answer [s].
constexpr double kAnswers = 10;

struct SaleTold {
  double begun = kNever;
  std::set<std::string> asked;
};

std::map<std::int64_t, SaleTold> sales_of(const TeamHistory& team) {
  std::map<std::int64_t, SaleTold> sales;
  for (const auto& [number, task] : team.tasks) {
    for (const auto& [sale, bids] : task.bids) {
      for (const auto& [uav, at] : bids) {
        sales[sale].begun = std::min(sales[sale].begun, at);
        sales[sale].asked.insert(uav);
      }
    }
  }
  return sales;
}

// Nobody of the team died, and it reached all of them.
bool reaches_all(const History& history, const std::string& uav, double from, double until) {
  std::set<std::string> others{"ground"};
  for (const auto& [name, it] : history.uavs) others.insert(name);
  others.erase(uav);
  if (history.was_away(uav, from, until) || history.was_away("sim", from, until)) return false;
  return std::ranges::all_of(others, [&](const std::string& other) {
    return history.joint.up(uav, other, from, until) && history.joint.up(other, uav, from, until) &&
           !history.was_away(other, from, until);
  });
}

// At degree 5, with its deliberation going on, and nobody has said that it is lost.
bool may_bid(const History& history, const Uav& uav, double from, double until) {
  const auto changes = [&](const auto& one) { return from < one.first && one.first <= until; };
  const auto lost = history.lost.find(uav.name());
  const bool counts =
      lost == history.lost.end() || std::ranges::none_of(lost->second, [&](const auto& while_lost) {
        return while_lost.first <= until && while_lost.second >= from;
      });
  const bool left = std::ranges::any_of(
      uav.words, [](const Word& word) { return word.text.rfind("contact: ", 0) == 0; });
  return counts && !left && uav.degree(from) >= 5 && std::ranges::none_of(uav.degrees, changes);
}

}  // namespace

// Who was there before it, and is there while it is held, said what it bids, or why nothing.
std::vector<Violation> not_asked_in_sales(const History& history) {
  std::vector<Violation> result;
  for (const auto& [number, sale] : sales_of(history.team)) {
    const double from = sale.begun - kThere, until = sale.begun + kAnswers;
    if (from < 0 || until > history.end) continue;
    for (const auto& [name, uav] : history.uavs) {
      const bool is_there =
          may_bid(history, uav, from, until) && reaches_all(history, name, from, until);
      if (!is_there || sale.asked.contains(name)) continue;
      result.push_back({"", sale.begun, name, 0,
                        "is not asked in sale " + std::to_string(number) +
                            ", though it takes part in the team and reaches all of it"});
    }
  }
  return result;
}

}  // namespace skein::laws
