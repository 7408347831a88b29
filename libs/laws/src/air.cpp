// SPDX-License-Identifier: Apache-2.0
// UAVs that wait for each other for their air (spec 6.4): a circle of waits, and how long it
// stands.
#include <algorithm>
#include <map>
#include <utility>

#include "checks.hpp"
#include "energy_left.hpp"
#include "radio_limits.hpp"
#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/deliberation.hpp"
#include "skein/laws/air_history.hpp"
#include "skein/world/segment.hpp"

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

/// Its energy does not last to get out of the way and come home then: the other moves, when third
/// ones leave it the air.
bool has_no_energy_for_it(const History& history, const std::string& name, double at) {
  constexpr double kHalfOfTheMargin = 0.01;  // that plans keep above the reserve
  const auto uav = history.uavs.find(name);
  if (uav == history.uavs.end()) return false;
  auto sample = uav->second.at(at);
  if (!sample) return false;
  sample->energy -= kHalfOfTheMargin;
  return lacks_energy_to_land(history, uav->second, *sample);
}

/// How long two may wait for each other where everybody hears everybody [s]: what they decide in,
/// and on narrow links the words for that: for whom one waits, what another asks for to get out of
/// the way, the answer.
double longest_of_two(const scenario::RadioSpec& radio) {
  constexpr double kDecides = 2;  // [s]
  return kDecides + airtime_of_words_on_air(radio);
}

}  // namespace

namespace {

std::vector<WantedPiece> pieces_of(const std::vector<double>& wants) {
  constexpr std::size_t kNumbers = 7;
  std::vector<WantedPiece> pieces;
  for (std::size_t i = 0; i + kNumbers <= wants.size(); i += kNumbers)
    pieces.push_back({{wants[i], wants[i + 1]}, {wants[i + 2], wants[i + 3]}, wants[i + 4]});
  return pieces;
}

}  // namespace

bool AirHistory::see(const journal::Record& record) {
  return journal::hand_on<journal::lines::Air>(record, *this);
}

void AirHistory::hear(const journal::lines::Air& line, const journal::Written& when) {
  AirWait wait{when.at.to_seconds(), line.uav, {}, {}, pieces_of(line.wants)};
  std::string_view rest = line.state == "waits" ? std::string_view(line.for_) : "";
  while (!rest.empty()) {
    const std::string one(rest.substr(0, rest.find(';')));
    rest.remove_prefix(std::min(rest.size(), one.size() + 2));
    const std::size_t space = one.find(' ');
    if (space == std::string::npos || !has_to_leave(one.substr(space + 1))) continue;
    wait.for_others.insert(one.substr(0, space));
    if (one.substr(space + 1).starts_with("to leave")) wait.to_leave.insert(one.substr(0, space));
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
                      is_kept_from_it(history, pair.second, from, until) ||
                      has_no_energy_for_it(history, pair.first, from) ||
                      has_no_energy_for_it(history, pair.second, from);
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

namespace {

constexpr double kStays = 120;  // [s] for which it stays somewhere, and has no use of other air
constexpr double kAround =
    200;  // [m] around the place where it was then, which it flies circles in
constexpr double kItsAir = 250;  // [m] farther than that nobody has air around where he stays
constexpr double kLooked = 30;   // [s] between two looks

/// Nobody has it fly anywhere during [from, until], and it stays where it was then.
bool stays(const Uav& uav, double from, double until) {
  const auto first = uav.at(from);
  if (!first || !first->airborne || out_of_control(uav, until)) return false;
  for (double at = from; at <= until; ++at) {
    const auto sample = uav.at(at);
    if (!sample || !sample->airborne) return false;
    if ((sample->position - first->position).head<2>().norm() > kAround) return false;
  }
  return std::none_of(uav.activities.begin(), uav.activities.end(), [&](const Activity& one) {
    return one.moves() && one.from < until && one.until > from;
  });
}

bool is_far(const Uav& uav, double at, const std::vector<WantedPiece>& wants) {
  const world::Vector2 place = uav.at(at)->position.head<2>();
  return std::all_of(wants.begin(), wants.end(), [&](const WantedPiece& piece) {
    return world::to_segment(place, piece.from, piece.to) > piece.radius + kAround + kItsAir;
  });
}

/// Until when the UAV waits like this.
double end_of(const History& history, const AirWait& wait) {
  for (const AirWait& next : history.air.waits)
    if (next.uav == wait.uav && next.at > wait.at) return next.at;
  return history.end;
}

}  // namespace

double seconds_waited_for_air(const History& history, const std::string& uav, double from,
                              double until) {
  double seconds = 0;
  for (const AirWait& wait : history.air.waits) {
    if (wait.uav != uav || wait.for_others.empty()) continue;
    seconds += std::max(0.0, std::min(until, end_of(history, wait)) - std::max(from, wait.at));
  }
  return seconds;
}

std::vector<Violation> waits_for_unused_air(const History& history) {
  std::vector<Violation> result;
  for (const AirWait& wait : history.air.waits) {
    if (wait.wants.empty()) continue;
    const double end = end_of(history, wait);
    for (const std::string& name : wait.to_leave) {
      const auto other = history.uavs.find(name);
      if (other == history.uavs.end()) continue;
      for (double at = wait.at + kStays; at <= end; at += kLooked) {
        const double from = at - kStays;
        if (!all_are_heard(history, from, at) || !stays(other->second, from, at) ||
            !is_far(other->second, from, wait.wants))
          continue;
        result.push_back({"", wait.at, wait.uav, 0,
                          "it waits for " + name + " to leave air that this has not used for " +
                              figure(at - from) + " s, far from there"});
        break;
      }
    }
  }
  return result;
}

}  // namespace skein::laws
