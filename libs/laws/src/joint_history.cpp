// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/joint_history.hpp"

#include <sstream>

namespace skein::laws {

namespace {

std::string text(const journal::Record& record, const char* key) {
  return std::string(record.text(key));
}

}  // namespace

// The last of this UAV's: a role's lines do not say which task they are of.
JointTold* JointHistory::of(const journal::Record& record) {
  for (auto one = joints.rbegin(); one != joints.rend(); ++one) {
    if (one->uav == record.text("uav") && one->joint == record.text("joint")) return &*one;
  }
  return nullptr;
}

std::optional<bool> JointHistory::steady(const std::string& from, const std::string& to,
                                         double since, double until) const {
  bool up = true;
  for (const LinkTold& one : links) {
    if (one.at > until) break;
    if (one.from != from || one.to != to) continue;
    if (one.at > since && up != one.up) return std::nullopt;
    up = one.up;
  }
  return up;
}

bool JointHistory::cut_off(const std::string& a, const std::string& b, double from,
                           double until) const {
  return steady(a, b, from, until) == false || steady(b, a, from, until) == false;
}

double JointHistory::last_up(const std::string& from, const std::string& to, double at) const {
  double last = at;
  for (const LinkTold& one : links) {
    if (one.at > at) break;
    if (one.from == from && one.to == to) last = one.up ? at : std::min(last, one.at);
  }
  return last;
}

bool JointHistory::up(const std::string& from, const std::string& to, double since,
                      double until) const {
  return steady(from, to, since, until) == true;
}

void JointHistory::see(const journal::Record& record) {
  const double at = record.at().to_seconds();
  const std::string& kind = record.kind();
  if (kind == "link") {
    links.push_back({at, text(record, "from"), text(record, "to"), record.truth("up")});
  } else if (kind == "joint") {
    const auto task = static_cast<std::int64_t>(record.number("task"));
    JointTold* told = of(record);
    // One that is not over goes on, with another number if its plan was made anew.
    if (told == nullptr || (told->task != task && told->phases.back().over())) {
      joints.push_back(
          {text(record, "uav"), text(record, "joint"), task, text(record, "variant"), {}, {}});
      told = &joints.back();
    }
    told->task = task;
    told->phases.push_back({at, text(record, "phase"), text(record, "role"), text(record, "why")});
  } else if (kind == "role") {
    if (JointTold* told = of(record)) {
      told->componels.push_back(
          {at, text(record, "role"), text(record, "componel"), text(record, "state")});
    }
  } else if (kind == "role-task") {
    tasks.push_back({text(record, "uav"), text(record, "joint"), text(record, "role"),
                     text(record, "componel"), static_cast<std::int64_t>(record.number("task"))});
  } else if (kind == "negotiation") {
    const std::string state = text(record, "state");
    const bool agreed = state.ends_with("agreed"), failed = state.ends_with("failed");
    if (!agreed && !failed) return;
    sessions.push_back({at, text(record, "uav"), text(record, "joint"), text(record, "opener"),
                        text(record, "rows"), record.number("opened"), agreed});
  } else if (kind == "place") {
    const std::vector<double> position = record.numbers("position");
    if (position.size() < 3) return;
    PlaceTold told{at,
                   text(record, "uav"),
                   text(record, "joint"),
                   text(record, "role"),
                   {},
                   {position[0], position[1], position[2]}};
    std::istringstream words(text(record, "scms"));
    for (std::string word; words >> word;) told.scms.push_back(word);
    places.push_back(std::move(told));
  }
}

}  // namespace skein::laws
