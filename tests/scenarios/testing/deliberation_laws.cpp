// SPDX-License-Identifier: Apache-2.0
#include "testing/deliberation_laws.hpp"

#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace skein::testing {

namespace {

using journal::Record;

const std::set<std::string, std::less<>>& successors_of(std::string_view state) {
  static const std::map<std::string, std::set<std::string, std::less<>>, std::less<>> kAfter{
      {"", {"received"}},
      {"received", {"planned", "failed", "cancelled", "handed-over", "under-way"}},
      {"planned", {"received", "under-way", "achieved", "failed", "cancelled", "handed-over"}},
      {"under-way", {"received", "planned", "achieved", "failed", "cancelled", "handed-over"}},
      {"handed-over", {"received", "planned", "under-way", "achieved", "failed", "cancelled"}},
      {"achieved", {}},
      {"failed", {}},
      {"cancelled", {}}};
  static const std::set<std::string, std::less<>> kNone;
  const auto found = kAfter.find(state);
  return found == kAfter.end() ? kNone : found->second;
}

// Everything that is checked of one UAV, record by record.
class Watch {
 public:
  Watch(std::string uav, double moment, std::vector<std::string>& breaches)
      : uav_(std::move(uav)), moment_(moment), breaches_(breaches) {}

  void see(const Record& record) {
    const std::string& kind = record.kind();
    if (kind == "goal") see_goal(record);
    if (kind == "plan") see_plan(record);
    if (kind == "planned") see_planned(record);
    if (kind == "decision") see_decision(record);
    if (kind == "degree") degree_ = static_cast<int>(record.number("degree"));
    if (kind == "task") see_task(record);
    if (kind == "telemetry") see_flight(record);
    if (kind == "notice" || kind == "contact") excused_ = true;
    if (kind == "fault") excused_ = true;
  }

 private:
  using Key = std::int64_t;

  void breach(const Record& record, const std::string& what) {
    std::ostringstream text;
    text << record.at().to_seconds() << " s, " << uav_ << ": " << what;
    breaches_.push_back(text.str());
  }

  static Key key(const Record& record, const char* field) {
    return static_cast<Key>(record.number(field, -1));
  }

  void see_goal(const Record& record) {
    std::string& state = goals_[key(record, "goal")];
    const std::string next(record.text("state"));
    if (next != state && !successors_of(state).contains(next)) {
      breach(record, "goal " + std::to_string(key(record, "goal")) + " from '" + state + "' to '" +
                         next + "'");
    }
    state = next;
  }

  void see_plan(const Record& record) {
    const Key revision = key(record, "revision");
    if (revision != revision_ + 1) breach(record, "revision " + std::to_string(revision));
    revision_ = revision;
    left_ = key(record, "tasks");
  }

  void see_planned(const Record& record) {
    left_ -= 1;
    if (left_ < 0) breach(record, "more planned tasks than the revision has");
    const Key task = key(record, "task");
    if (key(record, "revision") != revision_) breach(record, "planned task of another revision");
    const auto [goal, is_new] = goal_of_.emplace(task, key(record, "goal"));
    if (!is_new && goal->second != key(record, "goal")) {
      breach(record, "task " + std::to_string(task) + " changed its goal");
    }
    if (record.number("earliest_end") + 1e-6 < record.number("earliest_start")) {
      breach(record, "task " + std::to_string(task) + " ends before it starts");
    }
  }

  void see_decision(const Record& record) {
    const Key number = key(record, "number");
    if (number != decision_ + 1) breach(record, "decision " + std::to_string(number));
    decision_ = number;
    const bool repair = record.text("operator").starts_with("6");
    if (repair && record.text("cause").empty()) breach(record, "a repair without cause");
    excused_ = true;
  }

  void see_task(const Record& record) {
    static const std::set<std::string, std::less<>> kMotion{"takeoff", "goto", "land", "wait"};
    const std::string state(record.text("state"));
    // What does not move it occupies it only while it is under way.
    if (!kMotion.contains(record.text("type")) && state == "scheduled") return;
    const bool over = state == "ended" || state == "aborted";
    if (over) {
      motion_.erase(key(record, "task"));
      excused_ = false;
    } else {
      motion_.insert(key(record, "task"));
    }
    idle_since_.reset();
  }

  void see_flight(const Record& record) {
    const bool idle = degree_ == 4 && record.truth("airborne") && motion_.empty();
    if (!idle) {
      idle_since_.reset();
      return;
    }
    const double now = record.at().to_seconds();
    if (!idle_since_) idle_since_ = now;
    if (now - *idle_since_ > moment_ && !excused_) {
      breach(record, "flies without a task and without having said so");
      excused_ = true;
    }
  }

  std::string uav_;
  double moment_;
  std::vector<std::string>& breaches_;
  std::map<Key, std::string> goals_;
  std::map<Key, Key> goal_of_;
  Key revision_ = 0;
  Key left_ = 0;
  Key decision_ = 0;
  int degree_ = 0;
  std::set<Key> motion_;
  std::optional<double> idle_since_;
  bool excused_ = false;
};

}  // namespace

std::vector<std::string> broken_deliberation_laws(const std::vector<Record>& records,
                                                  double moment) {
  std::vector<std::string> breaches;
  std::map<std::string, Watch> uavs;
  for (const Record& record : records) {
    const std::string uav(record.text("uav"));
    if (uav.empty()) continue;
    uavs.try_emplace(uav, uav, moment, breaches).first->second.see(record);
  }
  return breaches;
}

}  // namespace skein::testing
