// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/joint_history.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/radio.hpp"
#include "told_links.hpp"
#include "ways.hpp"

namespace skein::laws {

namespace {

/// Lines about every link come before those about one.
bool is_about(const LinkTold& line, const std::string& from, const std::string& to) {
  return line.from == kEveryLink || (line.from == from && line.to == to);
}

}  // namespace

// The last of this UAV's: a role's lines do not say which task they are of.
JointTold* JointHistory::of(const std::string& uav, const std::string& joint) {
  const auto found = std::find_if(joints.rbegin(), joints.rend(), [&](const JointTold& one) {
    return one.uav == uav && one.joint == joint;
  });
  return found == joints.rend() ? nullptr : &*found;
}

std::optional<bool> JointHistory::steady(const std::string& from, const std::string& to,
                                         double since, double until) const {
  bool up = true;
  for (const LinkTold& one : links) {
    if (one.at > until) break;
    if (!is_about(one, from, to)) continue;
    if (one.at > since && up != one.up) return std::nullopt;
    up = one.up;
  }
  return up;
}

bool JointHistory::cut_off(const std::string& a, const std::string& b, double from,
                           double until) const {
  return steady(a, b, from, until) == false || steady(b, a, from, until) == false;
}

double JointHistory::last_reached(const std::string& from, const std::string& to,
                                  const std::set<std::string>& relays, double at,
                                  double shortest) const {
  std::map<std::pair<std::string, std::string>, bool> told;
  bool others_are_up = true;
  const Carries carries = [&](const std::string& a, const std::string& b) {
    const auto link = told.find({a, b});
    return link == told.end() ? others_are_up : link->second;
  };
  double last = 0;
  std::optional<double> since = 0;  // when it became so that messages pass
  const auto passed_until = [&](double end) {
    if (since && end - *since >= shortest) last = end;
  };
  for (const LinkTold& one : links) {
    if (one.at > at) break;
    (one.from == kEveryLink ? others_are_up : told[{one.from, one.to}]) = one.up;
    if (!has_way(from, to, relays, relays.size() + 1, carries)) {
      passed_until(one.at);
      since.reset();
    } else if (!since) {
      since = one.at;
    }
  }
  passed_until(at);
  return last;
}

bool JointHistory::up(const std::string& from, const std::string& to, double since,
                      double until) const {
  return steady(from, to, since, until) == true;
}

double JointHistory::up_for(const std::string& from, const std::string& to, double since,
                            double until) const {
  double total = 0, last = since;
  bool up = true;
  const auto go_on = [&](double at) {
    if (up) total += std::max(0.0, at - last);
    last = std::max(last, at);
  };
  for (const LinkTold& one : links) {
    if (one.at > until) break;
    if (!is_about(one, from, to)) continue;
    go_on(one.at);
    up = one.up;
  }
  go_on(until);
  return total;
}

bool JointHistory::see(const journal::Record& record) {
  namespace lines = journal::lines;
  return journal::hand_on<lines::Link, lines::Joint, lines::Role, lines::RoleTask,
                          lines::Negotiation, lines::Place>(record, *this);
}

void JointHistory::hear(const journal::lines::Link& line, const journal::Written& when) {
  links.push_back({when.at.to_seconds(), line.from, line.to, line.up});
}

void JointHistory::hear(const journal::lines::Joint& line, const journal::Written& when) {
  const auto task = static_cast<std::int64_t>(line.task);
  JointTold* told = of(line.uav, line.joint);
  // One that is not over goes on, with another number if its plan was made anew.
  if (told == nullptr || (told->task != task && told->phases.back().over())) {
    joints.push_back({line.uav, line.joint, task, line.variant, {}, {}});
    told = &joints.back();
  }
  told->task = task;
  told->phases.push_back({when.at.to_seconds(), line.phase, line.role, line.why});
}

void JointHistory::hear(const journal::lines::Role& line, const journal::Written& when) {
  if (JointTold* told = of(line.uav, line.joint))
    told->componels.push_back({when.at.to_seconds(), line.role, line.componel, line.state});
}

void JointHistory::hear(const journal::lines::RoleTask& line, const journal::Written& when) {
  tasks.push_back({line.uav, line.joint, line.role, line.componel,
                   static_cast<std::int64_t>(line.task), when.at.to_seconds(), line.type});
}

void JointHistory::hear(const journal::lines::Negotiation& line, const journal::Written& when) {
  const bool agreed = line.state.ends_with("agreed"), failed = line.state.ends_with("failed");
  if (!agreed && !failed) return;
  sessions.push_back(
      {when.at.to_seconds(), line.uav, line.joint, line.opener, line.rows, line.opened, agreed});
}

void JointHistory::hear(const journal::lines::Place& line, const journal::Written& when) {
  if (line.position.size() < 3) return;
  PlaceTold told{when.at.to_seconds(),
                 line.uav,
                 line.joint,
                 line.role,
                 {},
                 {line.position[0], line.position[1], line.position[2]}};
  std::istringstream words(line.scms);
  for (std::string word; words >> word;) told.scms.push_back(word);
  places.push_back(std::move(told));
}

}  // namespace skein::laws
