// SPDX-License-Identifier: Apache-2.0
// Nobody waits for ever for a partner that is silent, and who is given up was silent.
#include <algorithm>
#include <charconv>

#include "checks.hpp"
#include "skein/laws/healing.hpp"
#include "skein/mission/degree.hpp"
#include "statement.hpp"

namespace skein::laws {

namespace {

/// Until silence is noticed, and what is not agreed is tried again.
constexpr double kMargin = 25;  // [s]
/// Until silence is noticed, or whoever is back.
constexpr double kNoticed = 6;  // [s]

// Of a synchronisation those who send; their names come first.
std::set<std::string> partners_of(const Uav& uav, const mission::HighLevelTask& task) {
  std::set<std::string> partners;
  const bool sends = task.name.find("synchro") != std::string::npos;
  for (const mission::Argument& argument : task.arguments)
    if ((!sends || partners.empty()) && std::holds_alternative<std::vector<std::string>>(argument))
      for (const std::string& name : names_of(argument)) partners.insert(name);
  partners.erase(uav.name());
  return partners;
}

/// That instant, or when the partner died if it is dead then.
double alive_until(const History& history, const std::string& partner, double at) {
  if (const auto dead = history.away.find(partner); dead != history.away.end())
    for (const auto& [from, until] : dead->second)
      if (from <= at && at <= until) at = from;
  return at;
}

std::set<std::string> relays_of(const History& history) {
  const auto& passing = history.scenario->radio.relays;
  return {passing.begin(), passing.end()};
}

/// Since when the partner could not be heard, without a break until `at`; absent: it could be.
std::optional<double> silent_since(const History& history, const Uav& uav,
                                   const std::string& partner, double at) {
  const double since = history.joint.last_reached(partner, uav.name(), relays_of(history),
                                                  alive_until(history, partner, at));
  return since < at ? std::optional(since) : std::nullopt;
}

/// When the partner, while it lived, was last heard for long enough to be noticed, which takes its
/// time past relays.
double noticed_last(const History& history, const Uav& uav, const std::string& partner, double at) {
  const double past_relays = HealingLimits().rerouting.to_seconds();
  const auto reached = [&](double before) {
    return std::max(
        history.joint.last_reached(partner, uav.name(), {}, before, kNoticed),
        history.joint.last_reached(partner, uav.name(), relays_of(history), before, past_relays));
  };
  for (double alive = alive_until(history, partner, at);;) {
    const double heard = reached(alive), lived = alive_until(history, partner, heard);
    if (lived == heard) return heard;
    alive = lived;
  }
}

bool may_wait(const Execution& one) {
  return one.type == "synchronise" || one.type == "rendezvous" || one.type.starts_with("joint:");
}

/// When it began to wait, be it in an attempt before this one of the same goal that did not get
/// under way: a joint task that runs does not wait.
double began(const Uav& uav, const Execution& wait) {
  constexpr double kAnew = 20;  // [s] until the goal is planned again
  double since = wait.started;
  const std::int64_t goal = uav.goal_of_task(wait.task);
  for (auto one = uav.executions.rbegin(); one != uav.executions.rend(); ++one) {
    const Execution& before = one->second;
    const bool ran = before.type.starts_with("joint:") && before.running != kNever;
    const bool same = before.type == wait.type && uav.goal_of_task(one->first) == goal && !ran;
    if (same && before.started < since && before.over <= since && before.over + kAnew >= since)
      since = before.started;
  }
  return since;
}

/// From when it was to be waited for no longer.
double patience_ends(const History& history, const Uav& uav, const Execution& wait,
                     const std::string& partner, double since) {
  const auto& planning = history.scenario->planning;
  const double lease = planning ? planning->partner_lease.to_seconds() : kNever;
  double ends = std::max(began(uav, wait), since) + lease;
  const auto lost = history.lost_since(partner, std::min(wait.over, history.end));
  if (!lost) return ends;
  const double told = std::max({began(uav, wait), since, *lost});
  const bool hears = history.joint.up("ground", uav.name(), *lost, told + kMargin) &&
                     !history.was_away("ground", *lost, told + kMargin);
  return hears ? std::min(ends, told) : ends;
}

}  // namespace

namespace {

/// Of a partner that is silent since then: until when nobody else spoke for it. Below degree 3 the
/// ground station does, whose operator decides; absent: it is heard.
std::optional<double> spoken_for_until(const History& history, const Uav& uav, const Uav& partner,
                                       double since, double at) {
  if (mission::synchronises_directly(partner.degree(since), uav.degree(at))) return since;
  const auto ground = silent_since(history, uav, "ground", at);
  return ground ? std::optional(std::max(since, *ground)) : std::nullopt;
}

/// Why it is waited for no longer than until then.
struct Limit {
  double ends = kNever;
  std::string why;
};

Limit limit_of(const History& history, const Uav& uav, const Execution& wait, const Goal& goal,
               const Uav& partner) {
  const double until = std::min(wait.over, history.end);
  if (const auto since = silent_since(history, uav, partner.name(), until)) {
    const auto alone = spoken_for_until(history, uav, partner, *since, until);
    if (!alone || history.was_away("sim", *since, until)) return {};
    return {patience_ends(history, uav, wait, partner.name(), *alone),
            "is silent since " + figure(*since) + " s"};
  }
  const auto& planning = history.scenario->planning;
  const bool says_plans = planning && (planning->consistency == temporal::Algorithm::kDipM ||
                                       planning->consistency == temporal::Algorithm::kDipG);
  const auto since = stays_away_since(uav, goal, partner);
  const bool heard = since && says_plans && !history.dead.contains(partner.name()) &&
                     partner.deliberates(0, until) &&
                     history.joint.up(partner.name(), uav.name(), *since, until);
  if (!heard) return {};
  return {std::max(began(uav, wait), *since) + planning->partner_lease.to_seconds(),
          "does not plan to come since " + figure(*since) + " s"};
}

/// Whether it waits for all of that time: of a joint task that is played, whether its role does
/// nothing but meet others.
bool waits_in(const History& history, const Uav& uav, const Execution& wait, double from,
              double until) {
  constexpr double kLeaving = 10;  // [s]
  if (!wait.type.starts_with("joint:") || wait.running == kNever) return true;
  return std::ranges::any_of(history.joint.tasks, [&](const RoleTaskTold& told) {
    const auto met = uav.executions.find(told.task);
    return told.uav == uav.name() && met != uav.executions.end() &&
           met->second.type == "rendezvous" && met->second.started <= from &&
           met->second.over + kLeaving >= until;
  });
}

/// Whether it hears another partner that takes no part either, and that it may wait for.
bool may_wait_for_another(const History& history, const Uav& uav, const Execution& wait,
                          const Goal& goal, const std::string& silent) {
  const double until = std::min(wait.over, history.end);
  const auto& joints = history.joint.joints;
  const auto own = std::find_if(joints.rbegin(), joints.rend(), [&](const JointTold& one) {
    return one.uav == uav.name() && uav.goal_of_task(one.task) == goal.id;
  });
  if (own == joints.rend()) return false;
  const auto takes_part = [&](const std::string& partner) {
    return std::ranges::any_of(joints, [&](const JointTold& one) {
      return one.uav == partner && one.joint == own->joint && one.phases.front().at < until;
    });
  };
  return std::ranges::any_of(partners_of(uav, goal.task), [&](const std::string& partner) {
    return partner != silent && !silent_since(history, uav, partner, until) && !takes_part(partner);
  });
}

}  // namespace

std::vector<Violation> absent_partners_awaited(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    if (history.dead.contains(name)) continue;
    for (const auto& [task, wait] : uav.executions) {
      const double until = std::min(wait.over, history.end);
      const auto goal = uav.goals.find(uav.goal_of_task(task));
      const bool judged = may_wait(wait) && wait.started < until && wait.state != "ended";
      if (!judged || goal == uav.goals.end() || !uav.deliberates(wait.started, until)) continue;
      for (const std::string& other : partners_of(uav, goal->second.task)) {
        const auto partner = history.uavs.find(other);
        if (partner == history.uavs.end()) continue;
        const Limit limit = limit_of(history, uav, wait, goal->second, partner->second);
        if (until <= limit.ends + kMargin) continue;
        if (!waits_in(history, uav, wait, limit.ends + kMargin, until)) continue;
        if (may_wait_for_another(history, uav, wait, goal->second, other)) continue;
        result.push_back({"", until, name, goal->first,
                          mission::to_text(goal->second.task) + " has waited until " +
                              figure(until) + " s for '" + other + "', which " + limit.why +
                              ", and was to wait until " + figure(limit.ends) + " s"});
      }
    }
  }
  return result;
}

namespace {

// Whose word is passed on there: "'heliv' takes no part: …", "'heliv' left: …".
const Uav* who_is_quoted(const History& history, const std::string& why, std::size_t at) {
  const std::string before = why.substr(0, at);
  for (const auto& [name, uav] : history.uavs)
    for (const char* how : {"' takes no part: ", "' left: "})
      if (before.ends_with("'" + name + how)) return &uav;
  return nullptr;
}

bool has_said(const Uav& uav, const std::string& what, double until) {
  return std::any_of(uav.words.begin(), uav.words.end(), [&](const Word& word) {
    return word.at <= until && word.text.find(what) != std::string::npos;
  });
}

}  // namespace

// "no contact with 'heliv' since 312 s"; what a partner said of that is judged where it said it.
std::optional<std::string> untrue_silence(const History& history, const Uav& uav,
                                          const std::string& why, double at) {
  constexpr double kShortest = 60;  // [s] of who has a role
  constexpr std::string_view kBegins = "no contact with '", kGoesOn = "' since ";
  const std::size_t begin = why.find(kBegins);
  if (begin == std::string::npos) return std::nullopt;
  const std::size_t name_at = begin + kBegins.size(), end = why.find(kGoesOn, name_at);
  if (end == std::string::npos) return "it does not say since when";
  const std::string partner = why.substr(name_at, end - name_at);
  double since = kNever;
  const char* from = why.data() + end + kGoesOn.size();
  const auto figure_end = std::from_chars(from, why.data() + why.size(), since).ptr;
  if (const Uav* speaker = who_is_quoted(history, why, begin)) {
    const std::string word(why.data() + begin, figure_end);
    if (has_said(*speaker, word, at)) return std::nullopt;
    return "'" + speaker->name() + "' never said so";
  }
  const double heard = noticed_last(history, uav, partner, at);
  if (heard > since + kNoticed)
    return "'" + partner + "' could be heard " +
           (heard < at ? "until " + figure(heard) + " s" : std::string("then"));
  if (at - since < kShortest - kNoticed)
    return "'" + partner + "' was silent for " + figure(at - since) + " s only";
  return std::nullopt;
}

}  // namespace skein::laws
