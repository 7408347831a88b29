// SPDX-License-Identifier: Apache-2.0
// UAVs that wait for each other for their air (spec 6.4): a circle of waits, and how long it
// stands.
#include <algorithm>
#include <map>
#include <utility>

#include "checks.hpp"
#include "radio_limits.hpp"
#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/deliberation.hpp"
#include "skein/laws/air_history.hpp"

namespace skein::laws {

namespace {

using Waits = std::map<std::string, std::set<std::string>>;
using Pair = std::pair<std::string, std::string>;

/// Who leaves when others are to go first leaves too; who is to answer, or to come into reach,
/// is in nobody's way.
bool has_to_leave(const std::string& why) {
  return why.starts_with("to leave") || why.starts_with("to go first");
}

std::set<std::string> reached_from(const std::string& start, const Waits& waits) {
  std::set<std::string> reached;
  std::vector<std::string> open{start};
  while (!open.empty()) {
    const auto found = waits.find(open.back());
    open.pop_back();
    if (found == waits.end()) continue;
    for (const std::string& next : found->second)
      if (reached.insert(next).second) open.push_back(next);
  }
  return reached;
}

/// Each waits for the other, be it past others.
std::set<Pair> mutual(const Waits& waits) {
  std::map<std::string, std::set<std::string>> reached;
  for (const auto& [uav, others] : waits) reached[uav] = reached_from(uav, waits);
  std::set<Pair> pairs;
  for (const auto& [a, after] : reached) {
    for (const std::string& b : after) {
      const auto back = reached.find(b);
      if (a < b && back != reached.end() && back->second.contains(a)) pairs.emplace(a, b);
    }
  }
  return pairs;
}

/// Who hears others again knows of their ways within two beats of theirs.
bool all_are_heard(const History& history, double since, double until) {
  constexpr double kSettles = 2;  // [s]
  if (!all_hear_each_other(history, since - kSettles, until)) return false;
  return std::none_of(history.uavs.begin(), history.uavs.end(), [&](const auto& one) {
    return history.was_away(one.first, since - kSettles, until);
  });
}

/// What falls gets out of nobody's way any more.
bool falls(const History& history, const std::string& name, double at) {
  const auto uav = history.uavs.find(name);
  return uav != history.uavs.end() && out_of_control(uav->second, at);
}

/// Its flight aside was aborted by a fault: it is asked again after ten seconds.
bool is_kept_from_it(const History& history, const std::string& name, double from, double until) {
  const auto uav = history.uavs.find(name);
  if (uav == history.uavs.end()) return false;
  return std::ranges::any_of(uav->second.activities, [&](const Activity& one) {
    return one.type == "goto" && one.reason == "aborted by the functional layer" &&
           from <= one.until && one.until <= until;
  });
}

/// How long two may wait for each other where everybody hears everybody [s]: what they decide in,
/// and on narrow links the words for that: for whom one waits, what another asks for to get out of
/// the way, the answer.
double longest_of_two(const scenario::RadioSpec& radio) {
  constexpr double kDecides = 2;  // [s]
  return kDecides + airtime_of_words_on_air(radio);
}

}  // namespace

bool AirHistory::see(const journal::Record& record) {
  return journal::hand_on<journal::lines::Air>(record, *this);
}

void AirHistory::hear(const journal::lines::Air& line, const journal::Written& when) {
  AirWait wait{when.at.to_seconds(), line.uav, {}};
  std::string_view rest = line.state == "waits" ? std::string_view(line.for_) : "";
  while (!rest.empty()) {
    const std::string one(rest.substr(0, rest.find(';')));
    rest.remove_prefix(std::min(rest.size(), one.size() + 2));
    const std::size_t space = one.find(' ');
    if (space != std::string::npos && has_to_leave(one.substr(space + 1)))
      wait.for_others.insert(one.substr(0, space));
  }
  waits.push_back(std::move(wait));
  if (line.raised) raised.push_back({when.at.to_seconds(), line.uav});
}

std::vector<Violation> waits_for_each_other(const History& history) {
  constexpr double kAskedAgain = 10;  // [s]
  const double longest = longest_of_two(history.scenario->radio) + history.late;
  std::vector<Violation> result;
  Waits waits;
  std::map<Pair, double> since;
  const auto over = [&](const Pair& pair, double from, double until) {
    if (until - from <= longest || !all_are_heard(history, from, until)) return;
    if (falls(history, pair.first, until) || falls(history, pair.second, until)) return;
    const bool kept = is_kept_from_it(history, pair.first, from, until) ||
                      is_kept_from_it(history, pair.second, from, until);
    if (kept && until - from <= longest + kAskedAgain) return;
    result.push_back({"", from, pair.first, 0,
                      "it and " + pair.second + " wait for each other for their air, for " +
                          figure(until - from) + " s"});
  };
  for (const AirWait& one : history.air.waits) {
    waits[one.uav] = one.for_others;
    const std::set<Pair> now = mutual(waits);
    for (const Pair& pair : now) since.emplace(pair, one.at);
    std::erase_if(since, [&](const auto& stood) {
      if (now.contains(stood.first)) return false;
      over(stood.first, stood.second, one.at);
      return true;
    });
  }
  for (const auto& [pair, from] : since) over(pair, from, history.end);
  return result;
}

}  // namespace skein::laws
