// SPDX-License-Identifier: Apache-2.0
// Who takes part in a joint task holds one role, that nobody else holds, and all end alike.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "checks.hpp"
#include "joint_places.hpp"

namespace skein::laws {

namespace {

/// How many may hold a role, as the library of the scenario says; nothing: any number.
std::optional<int> most_of(const History& history, const std::string& joint,
                           const std::string& role) {
  const interaction::Model* model = model_of(history, joint);
  if (model == nullptr) return std::nullopt;
  for (const interaction::Variant& variant : model->variants) {
    const auto arity = variant.table.arities.find(role);
    if (arity != variant.table.arities.end()) return arity->second.most;
  }
  return std::nullopt;
}

bool is_over(const std::string& state) { return state == "ended" || state == "aborted"; }

/// Something happened to a UAV that its partners need not know of.
bool is_excused(const History& history, const std::string& uav) {
  const auto found = history.uavs.find(uav);
  if (found == history.uavs.end() || history.was_killed(uav)) return true;
  return !found->second.faults.empty() || found->second.degrees.size() > 1;
}

/// Who plays what, of "heliv perceive 374.708, marvin relay 10.09": without what it costs.
std::string roles_of(const std::string& rows) {
  std::string roles;
  std::istringstream all(rows);
  for (std::string row; std::getline(all, row, ',');) roles += row.substr(0, row.rfind(' ')) + ",";
  return roles;
}

}  // namespace

// Agreements are heard of one after the other, at the latest at the deadline of their session.
std::vector<Violation> roles_held_twice(const History& history) {
  constexpr double kMoment = 12;  // [s]
  std::vector<Violation> result;
  const std::vector<Held> all = roles_held(history.joint);
  for (auto a = all.begin(); a != all.end(); ++a) {
    for (auto b = std::next(a); b != all.end(); ++b) {
      if (a->joint != b->joint || a->role != b->role || a->uav == b->uav) continue;
      if (most_of(history, a->joint, a->role) != 1) continue;
      const double from = std::max(a->from, b->from), until = std::min(a->until, b->until);
      const double end = std::min(until, history.end);
      // The others go on without who is dead; back, it ends what it has begun, as they do.
      const bool is_one_dead =
          history.was_away(a->uav, from, end) || history.was_away(b->uav, from, end);
      if (end - from <= kMoment || is_one_dead) continue;
      result.push_back({"", from, a->uav, 0,
                        a->uav + " and " + b->uav + " both hold role " + a->role + " of " +
                            a->joint + " for " + figure(end - from) + " s"});
    }
  }
  return result;
}

std::vector<Violation> agreements_apart(const History& history) {
  std::vector<Violation> result;
  std::map<std::string, SessionTold> first_agreed, first_failed;
  for (const SessionTold& told : history.joint.sessions) {
    const std::string session =
        told.joint + " of " + told.opener + " at " + std::to_string(told.opened);
    (told.agreed ? first_agreed : first_failed).try_emplace(session, told);
    const auto agreed = first_agreed.find(session);
    const auto failed = first_failed.find(session);
    if (agreed != first_agreed.end() && failed != first_failed.end()) {
      result.push_back(
          {"", told.at, told.uav, 0,
           session + ": agreed at " + agreed->second.uav + ", failed at " + failed->second.uav});
    } else if (told.agreed && told.rows != agreed->second.rows) {
      result.push_back({"", told.at, told.uav, 0,
                        session + ": agreed on '" + told.rows + "' and at " + agreed->second.uav +
                            " on '" + agreed->second.rows + "'"});
    }
  }
  return result;
}

// Nobody need ask again at once for what all have just confirmed, unless something befell a member.
std::vector<Violation> restless_negotiations(const History& history) {
  constexpr double kStands = 15;  // [s]
  std::vector<Violation> result;
  std::map<std::string, SessionTold> confirmed;
  for (const SessionTold& told : history.joint.sessions) {
    if (!told.agreed || !told.joint.ends_with("/role-allocation")) continue;
    const auto before = confirmed.find(told.joint);
    const bool again = before != confirmed.end() && told.opened > before->second.opened;
    if (again && told.opened < before->second.at + kStands &&
        roles_of(told.rows) == roles_of(before->second.rows) && !is_excused(history, told.opener))
      result.push_back({"", told.opened, told.opener, 0,
                        told.joint + " is negotiated again " +
                            figure(told.opened - before->second.at) +
                            " s after all had agreed to keep their roles"});
    if (again || before == confirmed.end()) confirmed[told.joint] = told;
  }
  return result;
}

std::vector<Violation> activations_without_end(const History& history) {
  std::vector<Violation> result;
  for (const JointTold& told : history.joint.joints) {
    if (told.phases.back().phase != "ended" || is_excused(history, told.uav)) continue;
    std::map<std::string, JointTold::Componel> last;
    for (const JointTold::Componel& one : told.componels) last[one.role + " " + one.componel] = one;
    for (const auto& [name, one] : last) {
      if (is_over(one.state)) continue;
      result.push_back({"", one.at, told.uav, 0,
                        name + " of " + told.joint + " is still " + one.state +
                            " when the joint task has ended"});
    }
  }
  return result;
}

namespace {

bool is_task(const History& history, const JointTold& told, const JointTold::Componel& one) {
  return std::ranges::any_of(history.joint.tasks, [&](const RoleTaskTold& task) {
    return task.uav == told.uav && task.joint == told.joint && task.role == one.role &&
           task.componel == one.componel;
  });
}

/// Whether it begins or leaves something of its role after its componel number `i` in that time.
bool goes_on(const JointTold& told, std::size_t i, double until) {
  const double from = told.componels[i].at;
  const auto begins = [&](const auto& one) {
    return one.at <= until && (one.state == "running" || one.state == "aborting");
  };
  const auto after = told.componels.begin() + static_cast<std::ptrdiff_t>(i) + 1;
  return std::any_of(after, told.componels.end(), begins) ||
         std::any_of(told.phases.begin(), told.phases.end(), [&](const auto& one) {
           return one.at >= from && one.at <= until && one.phase != "running";
         });
}

}  // namespace

// What a role interrupts itself is aborting before it is aborted.
std::vector<Violation> roles_at_a_standstill(const History& history) {
  constexpr double kMoment = 60;  // [s]
  std::vector<Violation> result;
  for (const JointTold& told : history.joint.joints) {
    std::set<std::string> running;  // tasks
    for (std::size_t i = 0; i < told.componels.size(); ++i) {
      const JointTold::Componel& one = told.componels[i];
      const std::string name = one.role + " " + one.componel;
      if (one.state == "running" && is_task(history, told, one)) running.insert(name);
      if (one.state == "running") continue;
      const bool given_up = running.erase(name) > 0 && one.state == "aborted" && running.empty();
      const double until = one.at + kMoment;
      if (!given_up || until > history.end || goes_on(told, i, until)) continue;
      if (history.was_killed(told.uav) || history.was_away(told.uav, one.at, until)) continue;
      result.push_back({"", one.at, told.uav, 0,
                        name + " of " + told.joint +
                            " is aborted, and it neither begins anything else of its role nor "
                            "leaves it"});
    }
  }
  return result;
}

// Who is not over may be about to: the run ends, or its goal is still open.
std::vector<Violation> joint_tasks_without_end(const History& history) {
  constexpr double kMoment = 90;  // [s]
  std::vector<Violation> result;
  for (const JointTold& told : history.joint.joints) {
    const JointTold::Phase& last = told.phases.back();
    const auto uav = history.uavs.find(told.uav);
    if (uav == history.uavs.end() || history.was_killed(told.uav)) continue;
    if (last.over()) {
      if (last.phase == "ended" || !last.why.empty()) continue;
      result.push_back(
          {"", last.at, told.uav, 0, told.joint + " is " + last.phase + ": no reason"});
      continue;
    }
    const auto goal = uav->second.goals.find(uav->second.goal_of_task(told.task));
    if (goal == uav->second.goals.end() || !goal->second.settled()) continue;
    const Change& end = goal->second.changes.back();
    if (history.end - end.at <= kMoment) continue;
    result.push_back({"", end.at, told.uav, goal->first,
                      told.joint + " is still " + last.phase + " when its goal is " + end.state});
  }
  return result;
}

/// From when its role began to when it was over.
std::pair<double, double> played(const JointTold& told) {
  const auto begun = std::find_if(told.phases.begin(), told.phases.end(),
                                  [](const auto& one) { return one.phase == "running"; });
  const double end = told.phases.back().at;
  return {begun == told.phases.end() ? end : begun->at, end};
}

/// Of the same joint task, and not of an earlier or later attempt at it.
bool is_same_attempt(const JointTold& one, const JointTold& other) {
  constexpr double kTelling = 5;  // [s] by radio, that it is over and may begin again
  const auto [from, until] = played(one);
  const auto [from_other, until_other] = played(other);
  return one.joint == other.joint && from + kTelling < until_other && from_other + kTelling < until;
}

/// Whether the ground station, which plays its role, was out of its reach for long before that.
bool lost_its_player(const JointHistory& history, const std::string& uav,
                     const JointTold::Phase& left) {
  constexpr double kSilence = 55;  // [s] of the minute after which both leave
  return left.why.starts_with("no contact with the ground station") &&
         history.cut_off(uav, "ground", left.at - kSilence, left.at);
}

/// From when on it had nothing to do for the others any more: its end, or its last flight.
double done_for_others(const JointHistory& history, const JointTold& ended) {
  const auto [from, until] = played(ended);
  const RoleTaskTold* last = nullptr;
  for (const RoleTaskTold& one : history.tasks)
    if (one.uav == ended.uav && one.joint == ended.joint && from <= one.at && one.at <= until)
      last = &one;
  return last != nullptr && last->type == "goto" ? last->at : until;
}

/// When the other had already ended, it was interrupted from outside on its way out, lost the
/// ground station that played its role, or gave up hearing of that over a radio that was down all
/// the while, be it by its contact-loss policy, or while the other was on its last flight.
bool left_without_knowing(const JointHistory& history, const JointTold& aborted,
                          const JointTold& ended) {
  const auto left = std::find_if(aborted.phases.begin(), aborted.phases.end(), [](const auto& one) {
    return one.phase == "leaving" || one.phase == "aborted";
  });
  if (left == aborted.phases.end()) return false;
  const double end = ended.phases.back().at, done = done_for_others(history, ended);
  const bool for_silence =
      left->why.starts_with("no contact with '") || left->why.starts_with("contact lost: ");
  if (for_silence && left->at > done && history.cut_off(aborted.uav, ended.uav, done, left->at))
    return true;
  return left->at > end &&
         (left->why == "interrupted" || lost_its_player(history, aborted.uav, *left));
}

/// Whether it came back to it, and took part to the end.
bool came_back(const JointHistory& history, const JointTold& aborted) {
  return std::ranges::any_of(history.joints, [&](const JointTold& one) {
    return one.uav == aborted.uav && one.joint == aborted.joint &&
           one.phases.front().at > aborted.phases.front().at && one.phases.back().phase == "ended";
  });
}

std::vector<Violation> joint_tasks_apart(const History& history) {
  std::vector<Violation> result;
  const bool excused =
      std::any_of(history.joint.joints.begin(), history.joint.joints.end(),
                  [&](const JointTold& told) { return is_excused(history, told.uav); });
  if (excused) return result;
  for (const JointTold& told : history.joint.joints) {
    if (told.phases.back().phase != "aborted" || told.componels.empty()) continue;
    if (came_back(history.joint, told)) continue;
    const auto other = std::find_if(
        history.joint.joints.begin(), history.joint.joints.end(), [&](const JointTold& one) {
          return one.phases.back().phase == "ended" && one.uav != told.uav &&
                 is_same_attempt(one, told) && !left_without_knowing(history.joint, told, one);
        });
    if (other == history.joint.joints.end()) continue;
    result.push_back({"", told.phases.back().at, told.uav, 0,
                      told.joint + " is aborted here and has ended at " + other->uav});
  }
  return result;
}

}  // namespace skein::laws
