// SPDX-License-Identifier: Apache-2.0
// Who synchronises is there at one time, and not at one point.
#include <algorithm>
#include <map>
#include <set>

#include "checks.hpp"
#include "radio_limits.hpp"
#include "skein/scenario/narrowest.hpp"
#include "statement.hpp"

namespace skein::laws {

namespace {

/// A rendezvous that a goal has: all of them are there at one time.
struct Meeting {
  double id = 0;
  std::set<std::string> partners;
};

std::optional<Meeting> meeting_of(const Uav& uav, const mission::HighLevelTask& task) {
  const bool plain = task.name == "synchro" || task.name == "wait-until-synchro" ||
                     task.name == "general-combined-goto-and-synchro-and-takeshot";
  const bool monitors = task.name == "monitor-until";
  if (!plain && !monitors) return std::nullopt;
  const std::size_t first = monitors ? 1 : 0;
  if (task.arguments.size() < first + 3) return std::nullopt;
  const auto id = number_of(task.arguments[first]);
  if (!id) return std::nullopt;
  Meeting meeting{*id, {uav.name()}};
  for (std::size_t i = first + 1; i < first + (monitors ? 2U : 3U); ++i) {
    for (const std::string& name : names_of(task.arguments[i])) meeting.partners.insert(name);
  }
  return meeting;
}

bool both_ways(const mission::HighLevelTask& task) {
  if (task.name == "monitor-until") return true;
  std::set<std::string> senders, receivers;
  for (const std::string& name : names_of(task.arguments[1])) senders.insert(name);
  for (const std::string& name : names_of(task.arguments[2])) receivers.insert(name);
  return senders == receivers;
}

/// When the synchronisations of goals that have the meeting were under way.
std::vector<const Execution*> synchronisations(const Uav& uav, double meeting) {
  std::vector<const Execution*> result;
  for (const auto& [task, execution] : uav.executions) {
    const bool sync = execution.type == "synchronise" || execution.type == "rendezvous";
    const auto goal = uav.goals.find(uav.goal_of_task(task));
    if (!sync || execution.started == kNever || goal == uav.goals.end()) continue;
    const auto one = meeting_of(uav, goal->second.task);
    if (one && one->id == meeting) result.push_back(&execution);
  }
  return result;
}

// At some time: one that was interrupted after the partner was there counts, and so does one whose
// mission is given again, since what the partner then says, that it has synchronised, counts for
// ever.
bool together(const Uav& uav, const Uav& other, double meeting, double until) {
  constexpr double kMoment = 2;  // [s] radio and telling
  const auto theirs = synchronisations(other, meeting);
  for (const Execution* a : synchronisations(uav, meeting)) {
    for (const Execution* b : theirs) {
      const bool meet = a->started <= b->over + kMoment && b->started <= a->over + kMoment;
      if (meet && std::max(a->started, b->started) <= until + kMoment) return true;
    }
  }
  return false;
}

bool never_come(const History& history, const Uav& uav, const Goal& goal,
                std::set<std::string>& asked_before);

// It is at a meeting to which somebody never comes.
bool waits_in_vain(const History& history, const Uav& uav, std::set<std::string>& asked_before) {
  if (!asked_before.insert(uav.name()).second) return false;
  return std::any_of(uav.goals.begin(), uav.goals.end(), [&](const auto& one) {
    return one.second.state() == "under-way" && never_come(history, uav, one.second, asked_before);
  });
}

bool never_comes(const History& history, const Uav& partner, double meeting,
                 std::set<std::string>& asked_before) {
  bool asked = false, met = false;
  for (const auto& [id, goal] : partner.goals) {
    const auto other = meeting_of(partner, goal.task);
    if (!other || other->id != meeting) continue;
    if (goal.state() == "failed") return true;
    asked = true;
    met = met || goal.state() == "achieved";
  }
  return !asked || (!met && waits_in_vain(history, partner, asked_before));
}

bool never_come(const History& history, const Uav& uav, const Goal& goal,
                std::set<std::string>& asked_before) {
  const auto meeting = meeting_of(uav, goal.task);
  if (!meeting) return false;
  return std::any_of(meeting->partners.begin(), meeting->partners.end(),
                     [&](const std::string& name) {
                       const auto partner = history.uavs.find(name);
                       return name != uav.name() && partner != history.uavs.end() &&
                              never_comes(history, partner->second, meeting->id, asked_before);
                     });
}

}  // namespace

bool partner_never_comes(const History& history, const Uav& uav, const Goal& goal) {
  std::set<std::string> asked_before{uav.name()};
  return never_come(history, uav, goal, asked_before);
}

std::optional<double> stays_away_since(const Uav& uav, const Goal& goal, const Uav& partner) {
  const auto meeting = meeting_of(uav, goal.task);
  if (!meeting) return std::nullopt;
  double since = 0;
  for (const auto& [id, other] : partner.goals) {
    const auto theirs = meeting_of(partner, other.task);
    if (!theirs || theirs->id != meeting->id) continue;
    if (!other.settled() || other.state() == "achieved") return std::nullopt;
    since = std::max(since, other.changes.back().at);
  }
  return since;
}

std::vector<Violation> synchronisations_apart(const History& history) {
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    const auto meeting = meeting_of(uav, goal.task);
    if (!meeting || !both_ways(goal.task)) return;
    for (const std::string& name : meeting->partners) {
      const auto partner = history.uavs.find(name);
      const bool judged = name != uav.name() && partner != history.uavs.end() &&
                          !history.was_killed(name) && !partner->second.goals.empty();
      if (!judged || together(uav, partner->second, meeting->id, at)) continue;
      result.push_back({"", at, uav.name(), goal.id,
                        mission::to_text(goal.task) + " is achieved: " + name +
                            " was never in this synchronisation at the same time"});
    }
  });
  return result;
}

namespace {

// From when both have reached each other for so long, since one spoke and before it speaks again.
// Of a link that is up again the simulator tells them, unless it is dead.
std::optional<double> reached(const History& history, const std::string& one,
                              const std::string& other, double from, double until, double so_long) {
  constexpr double kApproachStep = 0.1;  // [s]
  for (double at = from; at + so_long < until; at += kApproachStep) {
    const auto up = [&](const auto& a, const auto& b) {
      return history.joint.up(a, b, at, at + so_long);
    };
    if (up(one, other) && up(other, one) && !history.was_away("sim", at, at + so_long)) return at;
  }
  return std::nullopt;
}

/// [s] For a word about a plan, and as much again that is on its way before it, on the narrowest of
/// the links. Past a relay the words to all others go over one link, one after the other, beside
/// what that passes on for others.
double on_the_air(const History& history, std::uint64_t arcs) {
  constexpr double kUsual = 2'500;              // [byte] a network of some twenty tasks, told whole
  constexpr double kArc = 32, kCarrying = 1.5;  // [byte]; of what goes in parts
  const double bytes = std::max(kUsual, static_cast<double>(arcs) * kArc * kCarrying);
  const scenario::RadioSpec& radio = history.scenario->radio;
  const double uavs = static_cast<double>(history.scenario->uavs.size());
  const double words = radio.relays.empty() ? 1 : std::max(1.0, uavs);
  return 8.0 * 2 * words * bytes / scenario::narrowest(radio).value_or(kNever);
}

/// [s] On the narrowest link, for the events that go before what is said of a plan: those of so
/// long after `since`, and a few that wait then; no longer than for what is usual anyway.
double events_before(const History& history, const Uav& uav, const std::string& other, double since,
                     double within) {
  constexpr double kWaiting = 2;  // [s]
  const auto sent = uav.events_to.find(other);
  if (sent == uav.events_to.end()) return 0;
  const auto events = std::ranges::count_if(
      sent->second, [&](double at) { return at > since - kWaiting && at < since + within; });
  const Duration each = airtime_of_an_event(history.scenario->radio);
  return std::min(static_cast<double>(events) * each.to_seconds(), on_the_air(history, 0) / 2);
}

/// [s] On a narrow link that loses parts of it: until each was said again, or asked for, as often
/// as may be.
double said_again(const scenario::Scenario& scenario) {
  constexpr double kSample = 8 * 512;  // [bit]
  const auto capacity = scenario::narrowest(scenario.radio);
  const double loss = greatest_loss(scenario);
  if (!capacity || loss <= 0 || loss >= 1) return 0;
  const double one_way = greatest_latency(scenario).to_seconds() + kSample / *capacity;
  const double either = 1 - (1 - loss) * (1 - loss);
  return tries(either) * (scenario.radio.heartbeat.to_seconds() / 10 + 2 * one_way);
}

}  // namespace

// Words of those who died, or to them, may be lost with them.
std::vector<Violation> plan_words_unheard(const History& history) {
  std::vector<Violation> result;
  const double again = said_again(*history.scenario);
  for (const auto& [name, uav] : history.uavs) {
    for (auto word = uav.plan_words.begin(); word != uav.plan_words.end(); ++word) {
      const double alone = 1 + on_the_air(history, word->arcs) + again + history.late;  // [s]
      const auto hearer = history.uavs.find(word->other);
      const bool died = history.dead.contains(name) || history.dead.contains(word->other);
      if (!word->sent || died || hearer == history.uavs.end()) continue;
      const auto next = std::find_if(std::next(word), uav.plan_words.end(), [&](const auto& one) {
        return one.sent && one.other == word->other;
      });
      const double until = next == uav.plan_words.end() ? history.end : next->at;
      const auto& heard = hearer->second.plan_words;
      const auto first = std::find_if(heard.begin(), heard.end(), [&](const PlanWord& one) {
        return !one.sent && one.other == name && one.at >= word->at - history.late;
      });
      const double by = first == heard.end() ? until : std::min(first->at, until);
      auto since = reached(history, name, word->other, word->at, by, alone);
      const double within =
          alone + (since ? events_before(history, uav, word->other, *since, alone) : 0);
      if (since) since = reached(history, name, word->other, *since, by, within);
      if (since)
        result.push_back({"", *since + within, word->other, 0,
                          "what " + name + " said of its plan at " + figure(word->at) +
                              " s is not heard, though they reach each other since " +
                              figure(*since) + " s"});
    }
  }
  return result;
}

namespace {

/// Of a meeting of more than two, all others came before: what is foretold is when the last comes.
bool is_the_last(const Uav& uav, const SyncHeard& word) {
  std::set<std::string> awaited;
  for (const auto& [id, goal] : uav.goals) {
    const auto meeting = meeting_of(uav, goal.task);
    if (meeting && meeting->id == static_cast<double>(word.id))
      awaited.merge(std::set(meeting->partners));
  }
  awaited.erase(uav.name());
  for (const SyncHeard& one : uav.syncs_heard)
    if (one.id == word.id && one.at <= word.at) awaited.erase(one.from);
  return awaited.empty();
}

/// [s] A word on a plan, said before the word that its author is there, may come so much later than
/// that one, which is shorter and goes first; 0 where none was said lately, or no link is narrow.
double later_by(const History& history, const std::string& hearer, const SyncHeard& there) {
  const auto author = history.uavs.find(there.from);
  if (author == history.uavs.end()) return 0;
  double most = 0;
  for (const PlanWord& word : author->second.plan_words) {
    if (!word.sent || word.other != hearer || word.at > there.at) continue;
    const double takes = on_the_air(history, word.arcs) + said_again(*history.scenario);
    if (there.at < word.at + takes) most = std::max(most, takes);
  }
  return most;
}

/// That `heard.from` comes to the meeting, last of all, and not before `until`.
bool foretells_later(const Foretold& one, const SyncHeard& heard, double until) {
  return one.known && one.last == heard.from && one.soonest > until;
}

}  // namespace

// What is believed when the word comes that somebody is there: not that he could not be. That word
// and those of plans come over one radio; where it is narrow, not in their order, and where the
// ground station says when others come, by a hop more: a word that comes so soon after it counts,
// too.
std::vector<Violation> come_before_foretold(const History& history) {
  const double moment = 1 + history.late;  // [s]
  const auto& planning = history.scenario->planning;
  const bool by_ground = planning && planning->consistency == temporal::Algorithm::kCip;
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    for (const SyncHeard& heard : uav.syncs_heard) {
      const double on_its_way = (by_ground ? moment : 0) + later_by(history, name, heard);
      const Foretold* believed = nullptr;
      bool later = false;  // by all words that count
      for (const Foretold& one : uav.foretold) {
        if (one.id != heard.id || one.at > heard.at + on_its_way) continue;
        const bool known_then = one.at <= heard.at;
        if (known_then) believed = &one;
        later = (known_then || later) && foretells_later(one, heard, heard.at + moment);
      }
      if (believed == nullptr || !later || !is_the_last(uav, heard)) continue;
      const std::string when = believed->soonest == kNever
                                   ? "never"
                                   : "no earlier than " + figure(believed->soonest) + " s";
      result.push_back({"", heard.at, name, 0,
                        heard.from + " is there for synchronisation " + std::to_string(heard.id) +
                            ", foretold at " + figure(believed->at) + " s to come " + when});
    }
  }
  return result;
}

namespace {

struct Span {
  double from = 0, until = 0;
};

/// Where a UAV stands for all of that time and waits for others.
std::optional<Meeting> stands_in(const Uav& uav, const Span& time) {
  for (const auto& [task, one] : uav.executions) {
    const bool meets = one.type == "rendezvous" || one.type == "synchronise";
    if (!meets || one.started > time.from || one.over < time.until) continue;
    const auto goal = uav.goals.find(uav.goal_of_task(task));
    const auto meeting =
        goal == uav.goals.end() ? std::nullopt : meeting_of(uav, goal->second.task);
    if (meeting) return meeting;
  }
  return std::nullopt;
}

bool is_to_come(const Uav& uav, double id, double at) {
  return std::any_of(uav.goals.begin(), uav.goals.end(), [&](const auto& one) {
    const Goal& goal = one.second;
    const auto meeting = meeting_of(uav, goal.task);
    const bool over = goal.settled() && goal.changes.back().at <= at;
    return meeting && meeting->id == id && !over && goal.changes.front().at <= at;
  });
}

/// Who stands elsewhere for all of that time, and is to come here; nobody where another one who is
/// awaited is not to come at all.
std::vector<std::string> awaited_elsewhere(const History& history, const Uav& uav,
                                           const Span& time) {
  std::vector<std::string> result;
  const auto here = stands_in(uav, time);
  if (!here || !uav.deliberates(time.from, time.until)) return result;
  for (const std::string& name : here->partners) {
    const auto other = history.uavs.find(name);
    if (name == uav.name() || other == history.uavs.end()) continue;
    if (!is_to_come(other->second, here->id, time.until)) return {};
    const auto there = stands_in(other->second, time);
    if (there && there->id != here->id) result.push_back(name);
  }
  return result;
}

bool in_a_circle(const History& history, const std::string& name, const Span& time) {
  std::vector<std::string> way = {name};
  std::set<std::string> seen;
  while (!way.empty()) {
    const std::string one = way.back();
    way.pop_back();
    for (const std::string& next : awaited_elsewhere(history, history.uavs.at(one), time)) {
      if (seen.insert(next).second) way.push_back(next);
    }
  }
  return seen.count(name) != 0;
}

}  // namespace

bool all_hear_each_other(const History& history, double from, double until) {
  for (const auto& [a, one] : history.uavs) {
    for (const auto& [b, other] : history.uavs)
      if (a != b && !history.joint.up(a, b, from, until)) return false;
  }
  return true;
}

// Who leaves first does so when he has waited for long.
std::vector<Violation> waits_in_circles(const History& history) {
  constexpr double kPatience = 120;  // [s]
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    for (const auto& [task, one] : uav.executions) {
      const double until = std::min(one.over, history.end);
      const Span time{until - kPatience, until};
      if (one.started > time.from || !in_a_circle(history, name, time)) continue;
      const auto here = stands_in(uav, time);
      if (!here || !all_hear_each_other(history, time.from, time.until)) continue;
      result.push_back(
          {"", until, name, 0,
           "it waits in synchronisation " + std::to_string(static_cast<std::int64_t>(here->id)) +
               " for one who waits for it in another, for " + figure(kPatience) + " s and more"});
      break;
    }
  }
  return result;
}

namespace {

// Where it takes place is said by some tasks only: who waits for partners wherever it is, is sent
// nowhere.
bool has_place(const mission::HighLevelTask& task) {
  return task.name == "monitor-until" ||
         task.name == "general-combined-goto-and-synchro-and-takeshot";
}

// Goals of one synchronisation, at one place, that are under way at both; at one of them for some
// time: where both have only just set out from, other goals had brought them.
bool meet_at(const Uav& a, const Uav& b, double at) {
  constexpr double kSetsOut = 5;  // [s]
  const auto meetings = [at](const Uav& uav) {
    std::map<double, double> since;
    for (const auto& [id, goal] : uav.goals) {
      const auto meeting = meeting_of(uav, goal.task);
      if (!meeting || !has_place(goal.task)) continue;
      Change last;
      for (const Change& change : goal.changes) {
        if (change.at <= at) last = change;
      }
      if (last.state == "under-way") since[meeting->id] = last.at;
    }
    return since;
  };
  const std::map<double, double> ours = meetings(a), theirs = meetings(b);
  return std::any_of(ours.begin(), ours.end(), [&](const auto& our) {
    const auto their = theirs.find(our.first);
    return their != theirs.end() && at - std::min(our.second, their->second) >= kSetsOut;
  });
}

}  // namespace

std::vector<Violation> partners_too_near(const History& history) {
  constexpr double kLeast = 8;  // [m]
  std::vector<Violation> result;
  for (auto a = history.uavs.begin(); a != history.uavs.end(); ++a) {
    for (auto b = std::next(a); b != history.uavs.end(); ++b) {
      Sample worst;
      double least = kNever;
      for (const Sample& sample : a->second.samples) {
        const auto other = b->second.at(sample.at);
        if (!sample.airborne || !other || !other->airborne) continue;
        const double distance = (sample.position - other->position).norm();
        if (distance < least && distance < kLeast && meet_at(a->second, b->second, sample.at)) {
          least = distance;
          worst = sample;
        }
      }
      if (least == kNever) continue;
      result.push_back({"", worst.at, a->first, 0,
                        "partners of one synchronisation come within " + figure(least) +
                            " m: " + a->first + " and " + b->first});
    }
  }
  return result;
}

}  // namespace skein::laws
