// SPDX-License-Identifier: Apache-2.0
// What a team does with its tasks.
#include <algorithm>
#include <set>

#include "checks.hpp"
#include "scripted.hpp"

namespace skein::laws {

namespace {

/// For elections, a sale and its answers over a slow radio [s].
constexpr double kSold = 60;

/// By which a UAV may be behind (decision 84), and for its word until the ground has it [s].
constexpr double kBehind = 20, kHeard = 15;

std::string named(std::int64_t task) { return "task " + std::to_string(task); }

// What it was at had ended, as far as anybody can tell: a node that forgot tells nothing.
bool ended_before(const History& history, const TeamWork& work, double at) {
  return work.over <= at || history.was_killed(work.uav);
}

// When the last cut between two of the team, or the last death, was over; never, while one is not.
double healed(const History& history) {
  double at = 0;
  for (const scenario::CutSpec& cut : history.scenario->radio.cuts) {
    at = std::max(at, cut.until.to_seconds());
  }
  for (const scenario::KillSpec& kill : history.scenario->faults.kills) {
    if (!kill.restart_after) return kNever;
    at = std::max(at, (kill.at + *kill.restart_after).to_seconds());
  }
  return at;
}

// Whose contact-loss policy was carried out takes part no more until its degree is set again.
bool out_of_contact(const Uav& uav) {
  const double set = uav.degrees.empty() ? 0 : uav.degrees.back().first;
  return std::any_of(uav.words.begin(), uav.words.end(), [&](const Word& word) {
    return word.at >= set && word.text.rfind("contact: ", 0) == 0;
  });
}

// Since when nobody says that it is lost; never: somebody does.
double counted_since(const History& history, const std::string& uav) {
  const auto lost = history.lost.find(uav);
  return lost == history.lost.end() ? 0 : lost->second.back().second;
}

// Who is not in the team has no vote, and its word makes no majority.
std::set<std::string> voters(const History& history) {
  if (const auto& team = history.scenario->team)
    return {team->roster.names().begin(), team->roster.names().end()};
  std::set<std::string> all{"ground"};
  for (const auto& [name, it] : history.uavs) all.insert(name);
  return all;
}

// It has been in reach of most of those who vote for as long as a sale takes, over links of its
// own.
bool may_be_sold_to(const History& history, const std::string& uav, double from) {
  const double since = std::max(from, counted_since(history, uav));
  if (since == kNever) return false;
  const std::set<std::string> all = voters(history);
  const auto heard = std::ranges::count_if(all, [&](const std::string& other) {
    return other == uav || history.joint.up_for(uav, other, since, history.end) > kSold;
  });
  return 2 * static_cast<std::size_t>(heard) > all.size();
}

// To the end.
bool bids(const History& history, const Uav& uav, double since) {
  return uav.degree(history.end) >= 5 && !out_of_contact(uav) &&
         may_be_sold_to(history, uav.name(), since);
}

bool somebody_bids(const History& history, double since) {
  return std::any_of(history.uavs.begin(), history.uavs.end(),
                     [&](const auto& each) { return bids(history, each.second, since); });
}

// Since when who has it has left it, by its contact-loss policy, and nobody told it to go on.
std::optional<double> left_off(const History& history, const TeamStanding& standing) {
  const auto uav = history.uavs.find(standing.owners);
  const bool has_it = standing.stage == "owned" || standing.stage == "granted";
  if (!has_it || uav == history.uavs.end() || !out_of_contact(uav->second)) return std::nullopt;
  if (uav->second.degree(history.end) < 5) return std::nullopt;  // the operator decides
  double since = standing.at;
  for (const Word& word : uav->second.words)
    if (word.text.rfind("contact: ", 0) == 0) since = std::max(since, word.at);
  return since;
}

// Takes part all that time, and what it says in the last of it the ground station hears.
bool takes_part(const History& history, const Uav& uav, double from, double until) {
  if (healed(history) > from || uav.degree(from) < 5 || out_of_contact(uav)) return false;
  if (history.joint.up_for(uav.name(), "ground", until - kHeard, until) < kHeard) return false;
  return std::none_of(uav.degrees.begin(), uav.degrees.end(),
                      [&](const auto& one) { return from < one.first && one.first <= until; });
}

// Owned alone by it before it began something else, and still.
bool still_owned(const TeamTask& task, const TeamWork& work, double at) {
  const auto later = std::find_if(task.standings.begin(), task.standings.end(),
                                  [&](const TeamStanding& one) { return one.at > at; });
  if (later == task.standings.begin()) return false;
  const TeamStanding& last = *std::prev(later);
  return last.stage == "owned" && last.owners == work.uav && last.at <= work.begun;
}

/// Without work before one goes home, and for what is decided and begun meanwhile [s].
constexpr double kRest = 10, kBegun = 40;

// The last instant at which it heard so many of the others that they and it were the most. Who is
// declared lost does not count.
double last_with_most(const History& history, const std::string& uav) {
  std::set<std::string> relays{"ground"}, all = voters(history);
  for (const auto& [name, it] : history.uavs) {
    const bool is_lost = name != uav && history.lost_since(name, history.end);
    if (is_lost)
      all.erase(name);
    else
      relays.insert(name);
  }
  std::vector<double> heard;
  for (const std::string& other : all)
    if (other != uav) heard.push_back(history.joint.last_reached(other, uav, relays, history.end));
  std::sort(heard.rbegin(), heard.rend());
  return heard.empty() ? history.end : heard.at((heard.size() + 1) / 2 - 1);
}

// Since when it has had no goal that is open, been at that degree, and lived; never: it has one.
double free_since(const History& history, const Uav& uav) {
  double since = uav.degrees.empty() ? 0 : uav.degrees.back().first;
  for (const auto& [id, goal] : uav.goals)
    since = goal.settled() ? std::max(since, goal.changes.back().at) : kNever;
  const auto away = history.away.find(uav.name());
  if (away != history.away.end())
    for (const auto& [from, until] : away->second) since = std::max(since, until);
  for (const auto& [id, execution] : uav.executions)
    if (execution.is_motion()) since = std::max(since, std::min(execution.over, kNever));
  return since;
}

bool is_repeatable(const History& history, std::int64_t number) {
  bool repeatable = false;
  for_scripted<ground_station::SendGlobalMission>(*history.scenario, [&](const auto& sent) {
    for (const team::GlobalTask& one : sent.mission.tasks)
      if (static_cast<std::int64_t>(one.task.id.value()) == number) repeatable |= one.repeatable;
  });
  return repeatable;
}

// A repeatable task is sold again when who has it is silent for long, whether it is at it or not,
// and every task when the operator says that who has it is lost, be that right or wrong: two may do
// it then, but nobody does it twice.
bool may_be_at_it_both(const History& history, std::int64_t number, const TeamWork& one,
                       const TeamWork& other) {
  if (one.uav == other.uav) return false;
  const bool repeatable = is_repeatable(history, number);
  const TeamWork& first = one.sale < other.sale ? one : other;
  const auto& standings = history.team.tasks.at(number).standings;
  return std::any_of(standings.begin(), standings.end(), [&](const TeamStanding& standing) {
    return standing.sale == first.sale && standing.stage == "for-sale" &&
           (standing.why == first.uav + " was declared lost" ||
            (repeatable && standing.why == first.uav + " was silent beyond its lease"));
  });
}

bool says_to_whom_for_what(const std::string& why) {
  return why.find(" to ") != std::string::npos && why.find(" for ") != std::string::npos;
}

}  // namespace

// Under one sale its owners begin it, each once; under another, nobody before those are over, but
// what is repeatable and was sold again since one was silent.
std::vector<Violation> team_tasks_begun_twice(const History& history) {
  std::vector<Violation> result;
  for (const auto& [number, task] : history.team.tasks) {
    std::set<std::int64_t> done;
    for (std::size_t i = 0; i < task.works.size(); ++i) {
      const TeamWork& later = task.works[i];
      for (std::size_t j = 0; j < i; ++j) {
        const TeamWork& earlier = task.works[j];
        if (earlier.sale == later.sale && earlier.uav != later.uav) continue;
        if (may_be_at_it_both(history, number, earlier, later)) continue;
        const bool again = earlier.sale == later.sale && !history.was_killed(later.uav);
        if (again || !ended_before(history, earlier, later.begun)) {
          result.push_back({"", later.begun, later.uav, 0,
                            named(number) + " is begun, but " + earlier.uav + " has begun it at " +
                                figure(earlier.begun) + " s"});
        } else if (earlier.sale < later.sale && earlier.end == "done") {
          done.insert(earlier.sale);
        }
      }
      const bool all_done = std::any_of(done.begin(), done.end(), [&](std::int64_t sale) {
        return std::none_of(task.works.begin(), task.works.end(), [&](const TeamWork& work) {
          return work.sale == sale && work.end != "done";
        });
      });
      if (all_done) {
        result.push_back(
            {"", later.begun, later.uav, 0, named(number) + " is begun although it was done"});
      }
    }
  }
  return result;
}

// The ground station has been in reach of it for as long as a sale takes.
bool is_heard(const History& history, const std::string& uav, double since) {
  return history.joint.up_for(uav, "ground", since, history.end) > kSold;
}

bool could_be_given(const History& history, double since) {
  return std::any_of(history.uavs.begin(), history.uavs.end(), [&](const auto& each) {
    return each.second.degree(history.end) >= 5 && is_heard(history, each.first, since);
  });
}

// What others sell beyond its reach the ground station cannot know.
bool a_sale_is_heard(const History& history, double since) {
  return std::any_of(history.uavs.begin(), history.uavs.end(), [&](const auto& each) {
    return bids(history, each.second, since) && is_heard(history, each.first, since);
  });
}

// Once the network has healed every task finds an owner who goes on with it, or is said to be for
// nobody.
std::vector<Violation> team_tasks_without_owner(const History& history) {
  std::vector<Violation> result;
  const double whole = healed(history);
  if (whole == kNever || !somebody_bids(history, whole)) return result;
  for (const auto& [number, task] : history.team.tasks) {
    if (task.standings.empty()) continue;
    const TeamStanding& last = task.standings.back();
    const double since = std::max(last.at, whole);
    const auto left = left_off(history, last);
    const double left_since = std::min(std::max(left.value_or(kNever), whole), history.end);
    if (is_heard(history, last.owners, left_since))
      result.push_back({"", history.end, last.owners, 0,
                        named(number) + " is kept by one that left it at " + figure(*left) +
                            " s by its contact-loss policy"});
    if (last.stage != "for-sale" || history.end - since < kSold) continue;
    if (!a_sale_is_heard(history, since)) continue;
    result.push_back({"", history.end, "", 0,
                      named(number) + " has no owner for " + figure(history.end - since) +
                          " s after the network was whole: " + last.why});
  }
  const bool nothing = history.team.tasks.empty() && !history.team.given.empty() &&
                       could_be_given(history, std::max(history.team.given.front(), whole));
  if (nothing) {
    result.push_back({"", history.end, "", 0, "a global mission was given, and nobody sold it"});
  }
  return result;
}

// Whose task lasts for longer than its first plan allowed puts back what it has not begun.
std::vector<Violation> kept_while_late(const History& history) {
  std::vector<Violation> result;
  for (const auto& [number, task] : history.team.tasks) {
    for (const TeamWork& work : task.works) {
      const auto uav = history.uavs.find(work.uav);
      if (uav == history.uavs.end()) continue;
      const auto promise = uav->second.promised.find(work.goal);
      if (promise == uav->second.promised.end()) continue;
      const double promised = promise->second.second, due = promised + kBehind + kHeard;
      const bool of_former_life = promised < work.begun;  // what forgot numbers its goals anew
      if (of_former_life || std::min(work.over, history.end) <= due) continue;
      if (!takes_part(history, uav->second, work.begun, due)) continue;
      for (const auto& [other, kept] : history.team.tasks) {
        if (other == number || !still_owned(kept, work, due)) continue;
        result.push_back({"", due, work.uav, 0,
                          named(other) + " is kept by one whose " + named(number) +
                              " was to end by " + figure(promised) + " s"});
      }
    }
  }
  return result;
}

// Nothing is sold or granted to who does not reach most of the team: it does not wait there for it.
std::vector<Violation> left_aloft(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    const bool airborne = !uav.samples.empty() && uav.samples.back().airborne;
    if (!airborne || uav.degree(history.end) < 5 || out_of_contact(uav)) continue;
    const double apart = last_with_most(history, name);
    const double due = apart + uav.spec->contact_loss.after.to_seconds();
    if (std::max(due, free_since(history, uav)) + kRest + kBegun > history.end) continue;
    result.push_back({"", history.end, name, 0,
                      "stays in the air without a goal, out of reach of most of its team since " +
                          figure(apart) + " s"});
  }
  return result;
}

// Who has a grant and nothing else to do begins it. Of a joint task all others must be there.
std::vector<Violation> granted_and_not_begun(const History& history) {
  std::vector<Violation> result;
  for (const auto& [number, task] : history.team.tasks) {
    if (task.standings.empty() || task.standings.back().stage != "granted") continue;
    const TeamStanding& last = task.standings.back();
    const auto uav = history.uavs.find(last.owners);
    if (uav == history.uavs.end() || uav->second.degree(history.end) < 5) continue;
    const bool begun = std::ranges::any_of(task.works, [&](const TeamWork& work) {
      return work.sale == last.sale && work.uav == last.owners;
    });
    const double since = std::max(last.at, free_since(history, uav->second));
    if (begun || since + kBegun > history.end || out_of_contact(uav->second)) continue;
    if (!may_be_sold_to(history, last.owners, since)) continue;
    result.push_back({"", history.end, last.owners, 0,
                      "has nothing to do since " + figure(since) + " s, and does not begin " +
                          named(number) + ", which it was granted"});
  }
  return result;
}

// A sale has one number, whoever tells of it: of what is sold somebody was asked under it.
std::vector<Violation> team_sales_nobody_bid_in(const History& history) {
  std::vector<Violation> result;
  for (const auto& [number, task] : history.team.tasks) {
    const TeamStanding* before = nullptr;
    for (const TeamStanding& one : task.standings) {
      const bool sold = before != nullptr && before->stage == "for-sale" &&
                        (one.stage == "owned" || one.stage == "granted");
      before = &one;
      if (!sold || task.bids.contains(one.sale)) continue;
      result.push_back({"", one.at, one.owners, 0,
                        named(number) + " is owned under sale " + std::to_string(one.sale) +
                            ", in which nobody was asked for it"});
    }
  }
  return result;
}

// Who has a task, and why nobody has it, is said; and nobody begins what it does not own.
std::vector<Violation> team_sales_unexplained(const History& history) {
  std::vector<Violation> result;
  for (const auto& [number, task] : history.team.tasks) {
    for (const TeamStanding& one : task.standings) {
      const bool owned = one.stage == "owned" || one.stage == "granted";
      if (owned && !says_to_whom_for_what(one.why)) {
        result.push_back(
            {"", one.at, one.owners, 0, named(number) + " is sold: '" + one.why + "'"});
      } else if (one.stage == "unsold" && one.why.empty()) {
        result.push_back({"", one.at, "", 0, named(number) + " is for nobody, without a word"});
      }
    }
    for (const TeamWork& work : task.works) {
      const bool owns =
          std::any_of(task.standings.begin(), task.standings.end(), [&](const TeamStanding& one) {
            return one.sale == work.sale &&
                   (", " + one.owners + ",").find(", " + work.uav + ",") != std::string::npos;
          });
      const bool told = std::any_of(task.standings.begin(), task.standings.end(),
                                    [&](const auto& one) { return one.sale >= work.sale; });
      if (told && !owns && healed(history) == 0) {
        result.push_back({"", work.begun, work.uav, 0,
                          named(number) + " is begun by one that was never said to own it"});
      }
      if (work.end == "put-back" && work.why.empty()) {
        result.push_back(
            {"", work.over, work.uav, 0, named(number) + " is put back, without a word"});
      }
    }
  }
  return result;
}

}  // namespace skein::laws
