// SPDX-License-Identifier: Apache-2.0
// What a UAV says beforehand of a mission, and of the wind, against what comes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "checks.hpp"
#include "scripted.hpp"

namespace skein::laws {

namespace {

constexpr double kAtOnce = 10;       ///< [s] from the answer to the mission itself
constexpr double kMoment = 3;        ///< [s] for the plan to be made, and to begin
constexpr double kEnergyPart = 0.2;  ///< of what it takes
constexpr double kEnergySlack = 0.005;

using ground_station::SendMission;

/// A mission that was evaluated and then given, goals and all.
struct Given {
  const Answer* asked;
  const Answer* answer;  ///< to the mission itself
  std::set<std::int64_t> goals;
};

const SendMission* sent_with(const scenario::Scenario& scenario, const Uav& uav,
                             std::int64_t mission, const SendMission* not_this) {
  const SendMission* result = nullptr;
  for_scripted<SendMission>(scenario, [&](const SendMission& sent) {
    if (sent.uav != uav.name() || &sent == not_this) return;
    if (static_cast<std::int64_t>(sent.mission.id.value()) == mission) result = &sent;
  });
  return result;
}

// But for their numbers.
bool same_tasks(const mission::UnitMission& a, const mission::UnitMission& b) {
  return a.placement == b.placement && a.interrupt == b.interrupt && a.any == b.any &&
         std::equal(a.tasks.begin(), a.tasks.end(), b.tasks.begin(), b.tasks.end(),
                    [](const mission::HighLevelTask& one, const mission::HighLevelTask& other) {
                      return mission::to_text(one) == mission::to_text(other);
                    });
}

std::vector<Given> given_after_evaluation(const History& history, const Uav& uav) {
  std::vector<Given> result;
  for (const Answer& asked : uav.answers) {
    if (!asked.evaluated) continue;
    const SendMission* question = sent_with(*history.scenario, uav, asked.mission, nullptr);
    if (question == nullptr) continue;
    for (const Answer& answer : uav.answers) {
      const bool soon = answer.at >= asked.at && answer.at <= asked.at + kAtOnce;
      if (answer.evaluated || !soon) continue;
      const SendMission* sent = sent_with(*history.scenario, uav, answer.mission, question);
      if (sent == nullptr || !same_tasks(sent->mission, question->mission)) continue;
      Given given{&asked, &answer, {}};
      for (const auto& task : sent->mission.tasks)
        given.goals.insert(static_cast<std::int64_t>(task.id.value()));
      result.push_back(std::move(given));
    }
  }
  return result;
}

// How long partners let it wait nobody on board can say.
bool waits_for_partners(const Uav& uav, double from, double until) {
  return std::any_of(uav.executions.begin(), uav.executions.end(), [&](const auto& one) {
    const Execution& task = one.second;
    const bool together =
        task.type == "synchronise" || task.type == "rendezvous" || task.type == "monitor";
    return together && task.started < until && task.over > from;
  });
}

// Who is in its way then nobody on board can say beforehand.
bool flies_over_others(const History& history, const Uav& uav, double from, double until) {
  const auto& raised = history.air.raised;
  return std::any_of(raised.begin(), raised.end(), [&](const RaisedFlight& one) {
    return one.uav == uav.name() && one.at > from && one.at < until;
  });
}

// Nobody asked for anything else in between, and no plan was made anew.
bool undisturbed(const Uav& uav, const Given& given, double until) {
  for (const auto& [id, goal] : uav.goals) {
    const bool between = goal.received() > given.asked->at - kMoment && goal.received() <= until;
    if (between && given.goals.count(id) == 0) return false;
  }
  return std::none_of(uav.words.begin(), uav.words.end(), [&](const Word& word) {
    return is_repair(word) && word.at > given.asked->at - kMoment && word.at <= until;
  });
}

/// When its first task began and its last ended.
struct Span {
  double from = kNever, until = 0;
};

std::optional<Span> span_of(const Uav& uav, const Given& given) {
  Span span;
  for (const std::int64_t id : given.goals) {
    const auto goal = uav.goals.find(id);
    if (goal == uav.goals.end() || goal->second.state() != "achieved") return std::nullopt;
  }
  for (const auto& [task, one] : uav.executions) {
    if (given.goals.count(uav.goal_of_task(task)) == 0 || one.started == kNever) continue;
    span.from = std::min(span.from, one.started);
    span.until = std::max(span.until, one.over);
  }
  if (span.from == kNever || span.until == kNever) return std::nullopt;
  return span;
}

// Of a mission behind which nothing else was done: what was left at its beginning and at its end.
std::optional<double> energy_taken(const Uav& uav, const Given& given, const Span& span) {
  for (const auto& [task, one] : uav.executions) {
    const bool its = given.goals.count(uav.goal_of_task(task)) > 0;
    if (!its && one.started != kNever && one.over > span.from + kMoment &&
        one.started < span.until - kMoment)
      return std::nullopt;
    if (!its && uav.goal_of_task(task) != 0 && one.started != kNever && one.started >= span.from)
      return std::nullopt;
  }
  const auto before = uav.at(span.from), after = uav.at(span.until);
  if (!before || !after) return std::nullopt;
  return before->energy - after->energy;
}

void judge(const History& history, const Uav& uav, const Given& given,
           std::vector<Violation>& result) {
  const Answer& asked = *given.asked;
  const std::string name = "mission " + std::to_string(asked.mission);
  const auto breach = [&](double at, const std::string& sentence) {
    result.push_back({"", at, uav.name(), *given.goals.begin(), name + sentence});
  };
  if (!undisturbed(uav, given, given.answer->at)) return;
  if (asked.planned != given.answer->planned)
    return breach(given.answer->at, std::string(asked.planned ? " could" : " could not") +
                                        " be taken, it was answered, and then could" +
                                        (asked.planned ? " not" : ""));
  const auto span = span_of(uav, given);
  if (!asked.planned || !span || !undisturbed(uav, given, span->until)) return;
  if (waits_for_partners(uav, asked.at, span->until) ||
      flies_over_others(history, uav, asked.at, span->until))
    return;
  const double later = given.answer->at - asked.at + kMoment;
  if (span->until < asked.earliest_end - kMoment || span->until > asked.latest_end + later)
    breach(span->until, " was to end between " + figure(asked.earliest_end) + " and " +
                            figure(asked.latest_end) + " s, and ended at " + figure(span->until));
  const auto taken = energy_taken(uav, given, *span);
  if (!taken) return;
  if (std::abs(*taken - asked.energy) > kEnergyPart * std::max(*taken, asked.energy) + kEnergySlack)
    breach(span->until, " was to take " + figure(100 * asked.energy) +
                            " % of its energy, and took " + figure(100 * *taken) + " %");
}

}  // namespace

std::vector<Violation> evaluations_off(const History& history) {
  std::vector<Violation> result;
  if (!is_clean(*history.scenario)) return result;
  for (const auto& [name, uav] : history.uavs) {
    for (const Given& given : given_after_evaluation(history, uav))
      judge(history, uav, given, result);
  }
  return result;
}

std::vector<Violation> winds_off(const History& history) {
  constexpr double kNear = 1.5;  // [m/s] of what blows in the mean
  std::vector<Violation> result;
  const world::Vector3 truth = world::mean_velocity(history.scenario->world.wind);
  for (const auto& [name, uav] : history.uavs) {
    for (const Word& word : uav.words) {
      double speed = 0, degrees = 0;
      const char* kSaid = "the wind is felt to be %lf m/s towards %lf degrees";
      if (std::sscanf(word.text.c_str(), kSaid, &speed, &degrees) != 2) continue;
      const double toward = degrees * std::numbers::pi / 180;
      const world::Vector3 felt(speed * std::cos(toward), speed * std::sin(toward), 0);
      const double off = (felt - truth).norm();
      if (off <= kNear) continue;
      result.push_back({"", word.at, name, 0,
                        "feels a wind that is " + figure(off) + " m/s from the true one of " +
                            figure(truth.norm()) + " m/s"});
    }
  }
  return result;
}

}  // namespace skein::laws
