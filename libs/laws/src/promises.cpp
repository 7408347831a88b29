// SPDX-License-Identifier: Apache-2.0
// Times kept, ends told, idleness explained.
#include <algorithm>
#include <cctype>
#include <set>

#include "by_hand.hpp"
#include "checks.hpp"
#include "scripted.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::laws {

namespace {

constexpr double kMoment = 0.6;  ///< [s] a task may begin or end so much beside its bound

std::optional<std::string> broken_bound(const mission::TimeConstraints& time,
                                        const Execution& task) {
  const auto seconds = [](const std::optional<MissionTime>& at) { return at->to_seconds(); };
  const std::string name = task.type + " " + std::to_string(task.task);
  if (time.start_after && task.started < seconds(time.start_after) - kMoment) {
    return name + " began at " + figure(task.started) + " s, not after " +
           figure(seconds(time.start_after));
  }
  if (time.start_before && task.started > seconds(time.start_before) + kMoment) {
    return name + " began at " + figure(task.started) + " s, not before " +
           figure(seconds(time.start_before));
  }
  if (task.over == kNever || task.state != "ended") return std::nullopt;
  if (time.end_before && task.over > seconds(time.end_before) + kMoment) {
    return name + " ended at " + figure(task.over) + " s, not before " +
           figure(seconds(time.end_before));
  }
  if (time.end_after && task.over < seconds(time.end_after) - kMoment) {
    return name + " ended at " + figure(task.over) + " s, not after " +
           figure(seconds(time.end_after));
  }
  return std::nullopt;
}

// A bound counted from another goal holds from when that was achieved; else it is void.
std::optional<std::string> broken_bound(const mission::GoalBound& bound, const Uav& uav,
                                        const Execution& task) {
  const auto other = uav.goals.find(static_cast<std::int64_t>(bound.goal.value()));
  const auto origin = other == uav.goals.end() ? std::nullopt : other->second.when("achieved");
  const double at = bound.on_end ? task.over : task.started;
  if (!origin || at == kNever || (bound.on_end && task.state != "ended")) return std::nullopt;
  const double least = bound.least.to_seconds();
  const double most = bound.most == Duration::max() ? kNever : bound.most.to_seconds();
  const double after = at - *origin;
  if (after >= least - 2 * kMoment && after <= most + 2 * kMoment) return std::nullopt;
  return task.type + " " + std::to_string(task.task) + (bound.on_end ? " ended " : " began ") +
         figure(after) + " s after goal " + std::to_string(bound.goal.value()) + ", not " +
         figure(least) + (most == kNever ? " s or more" : " to " + figure(most) + " s");
}

std::optional<std::string> broken_bound(const Uav& uav, const Goal& goal, const Execution& task) {
  if (const auto broken = broken_bound(goal.task.time, task)) return broken;
  for (const mission::GoalBound& bound : goal.task.after) {
    if (const auto broken = broken_bound(bound, uav, task)) return broken;
  }
  return std::nullopt;
}

// Whether a text has this number in it, and not only as a part of another.
bool names(const std::string& text, const std::string& number) {
  const auto is_digit = [&](std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(number); at != std::string::npos;
       at = text.find(number, at + 1)) {
    if ((at == 0 || !is_digit(at - 1)) && !is_digit(at + number.size())) return true;
  }
  return false;
}

// Whether somebody was told that this goal is late, or early.
bool reported(const Uav& uav, const Goal& goal) {
  const std::string id = std::to_string(goal.id);
  return std::any_of(uav.words.begin(), uav.words.end(), [&](const Word& word) {
    const bool late = word.text.find("late") != std::string::npos ||
                      word.text.find("early") != std::string::npos ||
                      word.text.find("deadline") != std::string::npos ||
                      word.text.find("before") != std::string::npos;
    return late && names(word.text, id);
  });
}

}  // namespace

std::vector<Violation> times_not_kept(const History& history) {
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    const bool bounded = goal.task.time.any() || !goal.task.after.empty();
    if (!bounded || !uav.deliberates(goal.received(), at)) return;
    for (const auto& [id, task] : uav.executions) {
      if (uav.goal_of_task(id) != goal.id || task.started == kNever) continue;
      if (task.type == "takeshot") continue;  // rides along with a task whose times are judged
      const auto broken = broken_bound(uav, goal, task);
      if (!broken || reported(uav, goal)) continue;
      result.push_back(
          {"", at, uav.name(), goal.id,
           mission::to_text(goal.task) + " is achieved and nobody was told: " + *broken});
      return;
    }
  });
  return result;
}

namespace {

// A takeshot rides along with something else: by itself it is no work.
bool rides_along(const Execution& task) { return task.type == "takeshot"; }

bool works_at(const History& history, const Uav& uav, double at) {
  const std::set<std::int64_t> by_hand = given_by_hand(history, uav);
  return std::any_of(uav.executions.begin(), uav.executions.end(), [&](const auto& one) {
    const Execution& task = one.second;
    const bool meant = uav.goal_of_task(one.first) != 0 || by_hand.contains(one.first);
    return task.under_way(at) && !rides_along(task) && meant;
  });
}

/// When it last was at work for a goal or its operator, or was told something; the start of the run
/// if never.
double last_work(const History& history, const Uav& uav) {
  double last = 0;
  for (const auto& [task, one] : uav.executions) {
    if (uav.goal_of_task(task) != 0 && one.started != kNever && !rides_along(one))
      last = std::max(last, std::min(one.over, history.end));
  }
  for (const Activity* one : carried_out_by_hand(history, uav))
    last = std::max(last, std::min(one->until, history.end));
  for (const auto& [id, goal] : uav.goals) last = std::max(last, goal.received());
  for (const auto& [from, degree] : uav.degrees) last = std::max(last, from);
  return last;
}

// The first instant at which one of its goals may begin, as far as its own times say.
double not_before(const Uav& uav) {
  double first = kNever;
  for (const auto& [id, goal] : uav.goals) {
    if (goal.settled()) continue;
    double from = 0;
    if (goal.task.time.start_after) from = goal.task.time.start_after->to_seconds();
    if (goal.task.time.end_after) from = std::max(from, goal.task.time.end_after->to_seconds());
    for (const mission::GoalBound& bound : goal.task.after) {
      const auto other = uav.goals.find(static_cast<std::int64_t>(bound.goal.value()));
      if (other == uav.goals.end() || !other->second.when("achieved")) continue;
      from = std::max(from, *other->second.when("achieved") + bound.least.to_seconds());
    }
    first = std::min(first, from);
  }
  return first;
}

// Its operator set it to a degree at which it plans, and not to go on with what it handed over.
bool may_be_kept(const History& history, const std::string& uav) {
  bool kept = false;
  for_scripted<ground_station::SetDegree>(*history.scenario, [&](const auto& set) {
    kept = kept || (set.uav == uav && set.change.degree >= 4 && !set.change.resume);
  });
  return kept;
}

// What the ground was given, and has not given back, is the ground's to end.
bool is_the_grounds(const History& history, const Uav& uav, const Goal& goal) {
  if (goal.state() != "handed-over") return false;
  if (may_be_kept(history, uav.name())) return true;
  return std::none_of(uav.degrees.begin(), uav.degrees.end(), [&](const auto& change) {
    return change.first > goal.changes.back().at && change.second >= 4;
  });
}

// An instant's occupation: a task that is under way and belongs to a goal, or moves it home. A
// safe wait is none, nor is a synchronisation of its operator, which leaves the vehicle free.
bool occupied(const Uav& uav, double at) {
  return std::any_of(uav.executions.begin(), uav.executions.end(), [&](const auto& one) {
    const Execution& task = one.second;
    const bool waits = task.type == "wait" || task.type == "synchronise";
    const bool is_idle = waits && uav.goal_of_task(one.first) == 0;
    return task.under_way(at) && !is_idle && !rides_along(task);
  });
}

std::set<std::int64_t> open_goals(const Uav& uav, double at) {
  std::set<std::int64_t> open;
  for (const auto& [id, goal] : uav.goals) {
    std::string state;
    for (const Change& change : goal.changes) {
      if (change.at <= at) state = change.state;
    }
    if (state == "received" || state == "planned" || state == "under-way") open.insert(id);
  }
  return open;
}

// That something was asked for, or given to the executive, does not say why it is not done.
bool says_why(const Word& word) {
  return word.text.rfind("0 user request", 0) != 0 && word.text.rfind("5 execute", 0) != 0;
}

bool named(const Uav& uav, const std::set<std::int64_t>& goals, double from, double until) {
  return std::any_of(uav.words.begin(), uav.words.end(), [&](const Word& word) {
    if (word.at < from || word.at > until || !says_why(word)) return false;
    return std::any_of(goals.begin(), goals.end(),
                       [&](std::int64_t id) { return names(word.text, std::to_string(id)); });
  });
}

// What an operator gave it may not begin yet, and the plan waits for it.
bool waits_behind_hand(const History& history, const Uav& uav) {
  const std::set<std::int64_t> by_hand = given_by_hand(history, uav);
  return std::any_of(uav.executions.begin(), uav.executions.end(), [&](const auto& one) {
    return by_hand.contains(one.first) && one.second.state == "scheduled";
  });
}

}  // namespace

std::vector<Violation> goals_without_end(const History& history) {
  constexpr double kPatience = 90;  // [s] without any work for any goal
  constexpr double kSoon = 10;      // [s]
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    const bool judged = !history.was_killed(name) && uav.degree(history.end) >= 4;
    if (!judged || works_at(history, uav, history.end)) continue;
    const double idle_since = std::max(last_work(history, uav), not_before(uav));
    if (history.end - idle_since < kPatience) continue;
    const bool told = waits_behind_hand(history, uav) &&
                      named(uav, open_goals(uav, history.end), idle_since - kSoon, history.end);
    if (told) continue;
    for (const auto& [id, goal] : uav.goals) {
      if (goal.settled() || is_the_grounds(history, uav, goal)) continue;
      result.push_back({"", history.end, name, id,
                        mission::to_text(goal.task) + " is " + goal.state() +
                            " at the end, and nothing was done for any goal since " +
                            figure(idle_since) + " s"});
    }
  }
  return result;
}

// With goals that are not settled, a UAV in the air works for one or says, naming one, why not.
std::vector<Violation> idle_without_word(const History& history) {
  constexpr double kPause = 10;  // [s]
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    std::optional<double> since, at_work;  // and since then with its node at work
    std::set<std::int64_t> meant;  // goals that were open meanwhile: one may give way to another
    bool told = false;
    for (const Sample& sample : uav.samples) {
      const std::set<std::int64_t> open = open_goals(uav, sample.at);
      const bool idle = sample.airborne && uav.degree(sample.at) >= 4 && !open.empty() &&
                        !occupied(uav, sample.at) && !does_by_hand(history, uav, sample.at);
      if (!idle || history.was_away(name, sample.at, sample.at)) at_work.reset();
      if (!idle) {
        since.reset();
        meant.clear();
        told = false;
        continue;
      }
      if (!since) since = sample.at;
      if (!at_work) at_work = sample.at;
      meant.insert(open.begin(), open.end());
      if (told || sample.at - *at_work < kPause) continue;
      told = true;
      if (named(uav, meant, *since - kPause, sample.at)) continue;
      result.push_back({"", *since, name, *open.begin(),
                        "in the air with nothing under way for " + figure(kPause) + " s, goal " +
                            std::to_string(*open.begin()) +
                            " open, and nothing said of it by name"});
    }
  }
  return result;
}

namespace {

/// The vehicle has carried it out, or given it up, by then.
bool is_over_in_truth(const Uav& uav, std::int64_t task, double at) {
  const auto last = std::find_if(
      uav.activities.rbegin(), uav.activities.rend(),
      [&](const Activity& activity) { return activity.task == task && activity.from <= at; });
  return last != uav.activities.rend() && last->until <= at;
}

// At degree 1 the ground's executive keeps to itself what the vehicle has no part in, and may not
// have heard that a task is over. `least`: shorter tasks do not count [s].
bool does_nothing_in_a_hand(const Uav& uav, const Sample& sample, double least) {
  const int degree = uav.degree(sample.at);
  const auto& types = functional::TaskTypes::shipped();
  return sample.airborne && degree < 4 && !out_of_control(uav, sample.at) &&
         std::none_of(uav.executions.begin(), uav.executions.end(), [&](const auto& one) {
           const bool is_unknown = degree == 1 && (types.of(one.second.type).synchronises() ||
                                                   is_over_in_truth(uav, one.first, sample.at));
           return one.second.under_way(sample.at) && !is_unknown &&
                  one.second.over - one.second.started >= least;
         });
}

}  // namespace

// Nobody else tells its operator that what he asked for was refused or given up. What it has said
// before its node was away counts: it comes back with what it knew. So does what it has said before
// a task that lay between two positions which its vehicle told.
std::vector<Violation> idling_untold(const History& history) {
  constexpr double kLong = 75;      // [s]
  constexpr double kPositions = 1;  // [s] between two of them
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.was_killed(name)) continue;
    std::optional<double> idle, since;  // and since then with its node at work
    for (const Sample& sample : uav.samples) {
      const bool idles = does_nothing_in_a_hand(uav, sample, 0);
      if (!idles && !does_nothing_in_a_hand(uav, sample, kPositions)) idle.reset();
      if (!idles || history.was_away(name, sample.at, sample.at)) {
        since.reset();
        continue;
      }
      if (!idle) idle = sample.at;
      if (!since) since = sample.at;
      if (sample.at - *since < kLong || sample.at - *since >= kLong + 1) continue;
      const bool told = std::any_of(uav.words.begin(), uav.words.end(), [&](const Word& word) {
        return word.at >= *idle && word.at <= sample.at &&
               word.text.starts_with("in the air with nothing under way");
      });
      if (!told)
        result.push_back({"", *since, name, 0,
                          "in the air at degree " + std::to_string(uav.degree(sample.at)) +
                              " with nothing under way for " + figure(kLong) + " s, and unsaid"});
    }
  }
  return result;
}

}  // namespace skein::laws
