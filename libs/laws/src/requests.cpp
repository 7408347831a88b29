// SPDX-License-Identifier: Apache-2.0
// What is refused is not asked for again and again.
#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <map>

#include "checks.hpp"

namespace skein::laws {

namespace {

constexpr std::size_t kOfAGoal = 3;    ///< requests alike: the first, and twice again
constexpr double kMinute = 60;         ///< [s]
constexpr std::size_t kInAMinute = 8;  ///< requests alike, of whichever goal, safe waits among them
constexpr std::size_t kRepairs = 12;   ///< plans made anew in a minute

// Refusals in the same words but for figures are alike.
std::string without_figures(const std::string& text) {
  std::string result;
  std::copy_if(text.begin(), text.end(), std::back_inserter(result),
               [](unsigned char c) { return std::isdigit(c) == 0 && c != '.' && c != '-'; });
  return result;
}

// By the vehicle, at once. That it is busy is the law of one motion's; what was told to stop in the
// instant in which it would have begun is no refusal.
bool refused(const Activity& one) {
  const bool busy = one.reason.find("is still active") != std::string::npos ||
                    one.reason.find("is in use by") != std::string::npos;
  const bool told_to_stop = one.reason == "interrupted";
  return one.end == "aborted" && one.until <= one.from && !busy && !told_to_stop;
}

// The first instant at which more than `most` of these, in order, lie within a minute, and as many
// more as `excused` says of that minute.
std::optional<double> too_many(
    const std::vector<double>& instants, std::size_t most,
    const std::function<std::size_t(double)>& excused = [](double) { return std::size_t{0}; }) {
  for (std::size_t i = most; i < instants.size(); ++i) {
    const std::size_t allowed = most + excused(instants[i]);
    if (i >= allowed && instants[i] - instants[i - allowed] < kMinute) return instants[i];
  }
  return std::nullopt;
}

// What a role asked for is one request of its componel's: an attempt at a joint task that fails
// asks for its way in and its way out.
std::map<std::int64_t, std::string> componels_of(const History& history, const std::string& uav) {
  std::map<std::int64_t, std::string> componels;
  for (const RoleTaskTold& one : history.joint.tasks)
    if (one.uav == uav) componels.emplace(one.task, " of " + one.role + " " + one.componel);
  return componels;
}

// Whoever is in closed air tries to leave for as long as it is there.
bool leaves_closed_air(const Uav& uav, std::int64_t goal) {
  const auto found = uav.goals.find(goal);
  return found != uav.goals.end() && found->second.task.name == "leave-closed-air";
}

void judge(const History& history, const Uav& uav, std::vector<Violation>& result) {
  const std::map<std::int64_t, std::string> componels = componels_of(history, uav.name());
  std::map<std::pair<std::int64_t, std::string>, std::size_t> of_goals;
  std::map<std::string, std::vector<double>> alike;
  for (const Activity& one : uav.activities) {
    if (!refused(one) || uav.degree(one.from) < 4) continue;
    const auto componel = componels.find(one.task);
    const std::string by = componel == componels.end() ? "" : componel->second;
    const std::string what = one.type + by + ": " + without_figures(one.reason);
    const std::int64_t goal = uav.goal_of_task(one.task);
    // What comes behind it in the executive is dispatched in the same instant: nobody could know.
    const bool follows = !alike[what].empty() && alike[what].back() == one.from;
    alike[what].push_back(one.from);
    if (goal == 0 || follows || leaves_closed_air(uav, goal)) continue;
    if (++of_goals[{goal, what}] != kOfAGoal + 1) continue;
    result.push_back({"", one.from, uav.name(), goal,
                      one.type + " is asked for and refused for the " +
                          std::to_string(kOfAGoal + 1) + "th time: " + one.reason});
  }
  // An operator's order is a reason to ask once more.
  const auto ordered = [&](double at) {
    return static_cast<std::size_t>(
        std::count_if(uav.words.begin(), uav.words.end(), [&](const Word& word) {
          return word.text.rfind("0 user request: ", 0) == 0 && word.at <= at &&
                 word.at > at - kMinute;
        }));
  };
  for (const auto& [what, instants] : alike) {
    if (const auto at = too_many(instants, kInAMinute, ordered))
      result.push_back({"", *at, uav.name(), 0,
                        "more than " + std::to_string(kInAMinute) +
                            " requests in a minute are refused alike: " + what});
  }
  std::vector<double> repairs;
  for (const Word& word : uav.words) {
    if (is_repair(word)) repairs.push_back(word.at);
  }
  if (const auto at = too_many(repairs, kRepairs))
    result.push_back({"", *at, uav.name(), 0,
                      "more than " + std::to_string(kRepairs) + " plans in a minute are repaired"});
}

}  // namespace

bool is_repair(const Word& word) {
  const auto begins = [&](const char* with) { return word.text.rfind(with, 0) == 0; };
  return begins("6 repair: ") && !begins("6 repair: absorb") && !begins("6 repair: shift");
}

std::vector<Violation> asked_again_and_again(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (!history.was_killed(name)) judge(history, uav, result);
  }
  return result;
}

}  // namespace skein::laws
