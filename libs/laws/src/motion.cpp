// SPDX-License-Identifier: Apache-2.0
// One motion at a time, and none under a task of another goal that holds the vehicle.
#include <algorithm>
#include <map>
#include <set>

#include "by_hand.hpp"
#include "checks.hpp"
#include "skein/functional/task.hpp"

namespace skein::laws {

namespace {

constexpr auto kFirstAside = static_cast<std::int64_t>(functional::kFirstAsideId.value());

std::string named(const Uav& uav, std::int64_t task, const std::string& type) {
  const std::int64_t goal = uav.goal_of_task(task);
  return type + " " + std::to_string(task) +
         (goal == 0 ? " of no goal" : " of goal " + std::to_string(goal));
}

// What the vehicle refused because it does something else. Operators may ask for what cannot be,
// and send it elsewhere at any moment.
void refused_at_once(const History& history, const Uav& uav, std::vector<Violation>& result) {
  const std::set<std::int64_t> by_hand = given_by_hand(history, uav);
  for (const Activity& one : uav.activities) {
    const bool busy = one.reason.find("is still active") != std::string::npos ||
                      one.reason.find("is in use by") != std::string::npos;
    if (!busy || by_hand.contains(one.task) || does_by_hand(history, uav, one.from)) continue;
    result.push_back(
        {"", one.from, uav.name(), uav.goal_of_task(one.task),
         named(uav, one.task, one.type) + " was asked for and refused: " + one.reason});
  }
}

/// One portion of the sweep, which the vehicle flies while the sweep itself waits for its air.
bool is_portion(const Activity& one, const Execution& sweep) {
  return one.task >= kFirstAside && one.type == sweep.type && one.until > sweep.running &&
         one.from <= sweep.over;
}

// When the vehicle begins with it: what is to hold it waits, on board, until what was interrupted
// is over. Never, if it was given up before.
double begun(const Uav& uav, const Execution& motion) {
  const double started = motion.taken == kNever ? motion.started : motion.taken;
  const auto real =
      std::find_if(uav.activities.begin(), uav.activities.end(), [&](const auto& one) {
        return (one.task == motion.task || is_portion(one, motion)) && one.from < one.until;
      });
  return real == uav.activities.end() ? kNever : std::max(started, real->from);
}

// That the vehicle has ended a motion its executive learns later if it was the ground's meanwhile.
bool is_over_on_the_vehicle(const Uav& uav, const Execution& motion, double at) {
  const bool was_at_ground =
      uav.degree(motion.started) == 1 || std::ranges::any_of(uav.degrees, [&](const auto& change) {
        return change.second == 1 && motion.started < change.first && change.first <= at;
      });
  return was_at_ground && std::ranges::none_of(uav.activities, [&](const Activity& one) {
           return one.task == motion.task && one.until > at;
         });
}

// In the executive on board: the ground's, at degree 1, may not know yet what a UAV out of contact
// does by itself, and the vehicle refuses a second motion anyway.
void overlapping(const Uav& uav, std::vector<Violation>& result) {
  constexpr double kMoment = 0.5;  // [s] executives of ground and UAV at a hand-over
  const Execution* last = nullptr;
  const auto on_board = [&](const Execution* one) { return one->node == uav.name(); };
  std::multimap<double, const Execution*> motions;  // in the order in which the vehicle begins
  for (const auto& [task, execution] : uav.executions) {
    // What the vehicle refused in the same instant never moved it.
    const bool flew = execution.taken != kNever && execution.over > execution.taken;
    const double from = execution.is_motion() && flew ? begun(uav, execution) : kNever;
    if (from != kNever) motions.emplace(from, &execution);
  }
  for (const auto& [from, one] : motions) {
    if (last != nullptr && on_board(one) && on_board(last) && from + kMoment < last->over &&
        !is_over_on_the_vehicle(uav, *last, from)) {
      result.push_back({"", from, uav.name(), uav.goal_of_task(one->task),
                        named(uav, one->task, one->type) + " begins while " +
                            named(uav, last->task, last->type) + " is under way"});
    }
    if (last == nullptr || one->over > last->over) last = one;
  }
}

}  // namespace

std::vector<Violation> motions_at_once(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    refused_at_once(history, uav, result);
    // Of a functional layer that is dead for a while nobody knows what it ended.
    if (!history.dead.contains("sim")) overlapping(uav, result);
  }
  return result;
}

namespace {

// What is cut off from the ground for long does not move any more until it is told to.
bool somebody_holds(const History& history) {
  return std::any_of(history.uavs.begin(), history.uavs.end(), [](const auto& one) {
    const auto& words = one.second.words;
    return std::any_of(words.begin(), words.end(),
                       [](const Word& word) { return word.text == "contact: hold"; });
  });
}

// For how much of that time the one who waits could hear of the other [s]: from itself, or from the
// ground station, which passes its words on. Others do not.
double heard_of_for(const History& history, const std::string& other, const std::string& waiting,
                    double since, double until) {
  return std::max(history.joint.up_for(other, "ground", since, until),
                  history.joint.up_for(other, waiting, since, until));
}

// For how much of that time it decided for itself where to be [s]: below degree 4 it stays where
// its operator has put it.
double at_will_for(const Uav& uav, double since, double until) {
  double seconds = 0, from = since;
  for (const auto& [change, degree] : uav.degrees) {
    if (change <= since || change >= until) continue;
    if (uav.degree(from) >= 4) seconds += change - from;
    from = change;
  }
  return uav.degree(from) >= 4 ? seconds + until - from : seconds;
}

// For how much of that time it reached the ground station, and nobody for whom it waited was out of
// its and the ground's reach (that one may still be there, for all that it knows) or an operator's
// [s].
double might_begin_for(const History& history, const std::string& name, double since,
                       double until) {
  double seconds = history.joint.up_for(name, "ground", since, until);
  for (const AirWait& wait : history.air.waits) {
    if (wait.uav != name || wait.at < since || wait.at > until) continue;
    for (const std::string& other : wait.for_others) {
      seconds = std::min(seconds, heard_of_for(history, other, name, since, until));
      const auto known = history.uavs.find(other);
      if (known != history.uavs.end())
        seconds = std::min(seconds, at_will_for(known->second, since, until));
    }
  }
  return seconds;
}

// The longest that one flight of somebody for whom it waited took of that time [s].
double longest_flight_of_others(const History& history, const std::string& name, double since,
                                double until) {
  double longest = 0;
  for (const AirWait& wait : history.air.waits) {
    if (wait.uav != name || wait.at < since || wait.at > until) continue;
    for (const std::string& other : wait.for_others) {
      const auto known = history.uavs.find(other);
      if (known == history.uavs.end()) continue;
      for (const auto& [task, motion] : known->second.executions) {
        if (motion.type != "goto") continue;
        const double from = std::max(since, begun(known->second, motion));
        longest = std::max(longest, std::min(until, motion.over) - from);
      }
    }
  }
  return longest;
}

// Given up one after the other: who does not wait for ever with one motion may do so with many.
void given_up_in_vain(const History& history, const Uav& uav, std::vector<Violation>& result) {
  constexpr double kLongest = 1500;  // [s] of a goal, in all: three tries, and flights aside
  std::map<std::int64_t, double> waited;
  for (const auto& [task, motion] : uav.executions) {
    const bool may_be_given_up = motion.type == "goto" || motion.type == "takeoff";
    if (motion.started == kNever || !may_be_given_up || begun(uav, motion) != kNever) continue;
    if (const std::int64_t goal = uav.goal_of_task(task); goal != 0)
      waited[goal] +=
          might_begin_for(history, uav.name(), motion.started, std::min(motion.over, history.end));
  }
  for (const auto& [goal, seconds] : waited) {
    if (seconds <= kLongest) continue;
    result.push_back({"", history.end, uav.name(), goal,
                      "its motions are given to the vehicle one after another, and none begins, "
                      "for " +
                          figure(seconds) + " s"});
  }
}

}  // namespace

std::vector<Violation> motions_never_begun(const History& history) {
  constexpr const char* kNotBegun = " is given to the vehicle and does not begin for ";
  constexpr double kLongest = 900;  // [s] of waiting for the air of a way, beside blimps and the
                                    // longest sweep of another, while the ground is in reach
  std::vector<Violation> result;
  if (!history.dead.empty() || somebody_holds(history)) return result;
  for (const auto& [name, uav] : history.uavs) {
    given_up_in_vain(history, uav, result);
    for (const auto& [task, motion] : uav.executions) {
      if (motion.started == kNever || !motion.is_motion() || motion.type == "wait") continue;
      const double until = std::min({begun(uav, motion), motion.over, history.end});
      const double beside = longest_flight_of_others(history, name, motion.started, until);
      if (might_begin_for(history, name, motion.started, until) - beside <= kLongest) continue;
      result.push_back(
          {"", motion.started, name, uav.goal_of_task(task),
           named(uav, task, motion.type) + kNotBegun + figure(until - motion.started) + " s"});
    }
  }
  return result;
}

namespace {

// The vehicle refuses a task while it is told to stop it, and says so of both.
bool refused_and_stopped(const Uav& uav, const Word& word) {
  return std::any_of(uav.activities.begin(), uav.activities.end(), [&](const Activity& one) {
    const std::string both =
        "status 'aborted' of task " + std::to_string(one.task) + ", which is aborted";
    return one.end == "aborted" && one.until <= one.from && word.text.rfind(both, 0) == 0;
  });
}

// Said before the vehicle, or the air that it waited for, knew of the abort; the executive has to
// note it (spec 2.1).
bool crossed_the_abort(const Word& word) {
  const bool goes_on = word.text.rfind("status 'running' of task ", 0) == 0 ||
                       word.text.rfind("status 'started' of task ", 0) == 0;
  return goes_on && word.text.find(", which is aborting,") != std::string::npos;
}

}  // namespace

// Who comes back from the dead asks the vehicle again, and hears what it knew.
std::vector<Violation> statuses_unfit(const History& history) {
  std::vector<Violation> result;
  if (!history.dead.empty()) return result;
  for (const auto& [name, uav] : history.uavs) {
    for (const Word& word : uav.words) {
      const bool of_a_task = word.text.rfind("status '", 0) == 0;
      if (of_a_task && word.text.find(", does not fit") != std::string::npos &&
          !refused_and_stopped(uav, word) && !crossed_the_abort(word))
        result.push_back({"", word.at, name, 0, word.text});
    }
  }
  return result;
}

namespace {

// Who is in the air with nothing to do asks for a wait where it is. Of what its executive starts in
// that instant it cannot know.
bool crossed_the_start(std::int64_t goal, const Execution& motion, const Execution& held) {
  constexpr double kInstant = 0.1;  // [s]
  const bool is_safe_wait = goal == 0 && motion.type == "wait";
  return is_safe_wait && motion.started - held.started <= kInstant;
}

}  // namespace

std::vector<Violation> motions_under_tasks(const History& history) {
  constexpr double kMoment = 2;  // [s] in which what is given up may stop
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    for (const auto& [task, motion] : uav.executions) {
      if (!motion.is_motion() || motion.started == kNever || motion.over - motion.started < kMoment)
        continue;
      if (!uav.deliberates(motion.started, motion.started + kMoment)) continue;
      const std::int64_t goal = uav.goal_of_task(task);
      for (const auto& [other, held] : uav.executions) {
        const std::int64_t other_goal = uav.goal_of_task(other);
        const bool holds = !held.is_motion() && other_goal != 0 && other_goal != goal;
        if (!holds || !held.under_way(motion.started) || !held.under_way(motion.started + kMoment))
          continue;
        if (crossed_the_start(goal, motion, held)) continue;
        result.push_back({"", motion.started, name, other_goal,
                          named(uav, task, motion.type) + " begins while " +
                              named(uav, other, held.type) + " is under way"});
      }
    }
  }
  return result;
}

}  // namespace skein::laws
