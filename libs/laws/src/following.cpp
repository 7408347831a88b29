// SPDX-License-Identifier: Apache-2.0
#include "following.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "joint_places.hpp"

namespace skein::laws {

namespace {

constexpr double kFollowedStep = 1;  // [s] how finely truth is looked at
constexpr double kBeside = 45;       // [m] further than agreed: it flies after what has moved on
constexpr double kFollowedPart = 0.95, kFollowedSlack = 5;  // [s]

/// What of a role follows a target for a time that a parameter says.
struct Following {
  std::string role, target;
  std::string componel;  ///< from whose beginning the time counts
  double seconds = 0;    ///< asked
  double reach = 0;      ///< from the target [m]
};

/// The condition that ends a block around the task after a time that a parameter says, from when a
/// componel runs. Null: there is none.
const interaction::TimeIs* time_around(const interaction::Automaton& automaton,
                                       const interaction::Componel& task) {
  for (const interaction::Componel* one = &automaton[task.parent];; one = &automaton[one->parent]) {
    for (const interaction::Clause& clause : one->block()->exit) {
      for (const interaction::Literal& literal : clause) {
        const auto* time = std::get_if<interaction::TimeIs>(&literal.condition);
        const bool is_it = time != nullptr && !time->named.empty() &&
                           std::holds_alternative<interaction::TimeIs::Event>(time->since);
        if (is_it) return time;
      }
    }
    if (&automaton[one->parent] == one) return nullptr;
  }
}

/// How far from what is followed the places are that the role agrees on.
double distance_agreed(const interaction::Automaton& automaton) {
  double farthest = 0;
  for (const interaction::Componel& one : automaton.componels()) {
    const auto* distance = one.action() == nullptr ? nullptr : one.action()->in.find("distance");
    if (distance != nullptr) farthest = std::max(farthest, std::stod(distance->scalar));
  }
  return farthest;
}

std::vector<Following> followings_of(const History& history, const std::string& joint,
                                     const interaction::Variant& variant) {
  std::vector<Following> all;
  const auto arguments = arguments_of(joint, variant);
  for (const std::string& name : variant.roles) {
    const interaction::Role& role = history.scenario->interaction->roles.at(name);
    const auto table = variant.table.parameters.find(name);
    if (table == variant.table.parameters.end()) continue;
    const auto given = [&](const std::string& parameter) {
      const auto known = table->second.find(parameter);
      return known == table->second.end() ? std::string() : arguments.at(known->second);
    };
    for (const interaction::Componel& one : role.automaton.componels()) {
      if (one.task() == nullptr || one.task()->type != "follow") continue;
      const interaction::TimeIs* time = time_around(role.automaton, one);
      const std::string seconds = time == nullptr ? "" : given(time->named);
      if (seconds.empty()) continue;
      const auto& since = std::get<interaction::TimeIs::Event>(time->since);
      all.push_back({name, given(one.task()->parameters.find("target")->scalar),
                     role.automaton[since.componel].id, std::stod(seconds),
                     distance_agreed(role.automaton) + kBeside});
    }
  }
  return all;
}

struct FollowedSpan {
  double from = 0, until = kNever;
};

/// When its role is left without a word on its parts, as by who is taken in hand, after `from`.
double left_after(const JointTold& told, double from, double end) {
  const auto left = std::ranges::find_if(told.phases, [&](const JointTold::Phase& phase) {
    return phase.at >= from && phase.phase != "running";
  });
  return left == told.phases.end() ? end : left->at;
}

/// When it said that this part of its role runs.
std::vector<FollowedSpan> spans_of(const JointTold& told, const Following& asked, double end) {
  std::vector<FollowedSpan> all;
  bool is_open = false;
  for (const JointTold::Componel& one : told.componels) {
    if (one.role != asked.role || one.componel != asked.componel) continue;
    if (is_open) all.back().until = std::min(all.back().until, one.at);
    is_open = one.state == "running";
    if (is_open) all.push_back({one.at, left_after(told, one.at, end)});
  }
  return all;
}

/// From `span`, the part in which it was not away from the target once it had come to it.
double seconds_beside(const History& history, const std::string& uav, const Following& asked,
                      const FollowedSpan& span) {
  double beside = 0;
  bool has_come = false;
  for (double t = span.from; t < span.until; t += kFollowedStep) {
    const double step = std::min(kFollowedStep, span.until - t);
    const auto target = where(history, asked.target, uav, t);
    const auto sample = history.uavs.at(uav).at(t);
    if (!sample) continue;
    const bool is_there = !target || (sample->position - *target).head<2>().norm() <= asked.reach;
    has_come = has_come || (target && is_there);
    if (is_there || !has_come) beside += step;
  }
  return has_come || span.until - span.from <= kFollowedSlack ? beside : 0;
}

}  // namespace

std::string not_followed(const History& history, const std::string& joint,
                         const interaction::Variant& variant, double reaction) {
  for (const Following& asked : followings_of(history, joint, variant)) {
    double longest = 0;
    for (const JointTold& told : history.joint.joints) {
      if (told.joint != joint) continue;
      double seconds = 0;
      for (const FollowedSpan& span : spans_of(told, asked, history.end)) {
        if (span.until - span.from > asked.seconds + kFollowedSlack)
          return told.uav + " followed " + asked.target + " for " + figure(span.until - span.from) +
                 " s, asked for " + figure(asked.seconds);
        seconds += seconds_beside(history, told.uav, asked, span);
      }
      longest = std::max(longest, seconds);
    }
    if (longest >= kFollowedPart * asked.seconds - kFollowedSlack - reaction) continue;
    return "nobody followed " + asked.target + " for more than " + figure(longest) + " of " +
           figure(asked.seconds) + " s";
  }
  return "";
}

}  // namespace skein::laws
