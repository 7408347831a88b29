// SPDX-License-Identifier: Apache-2.0
// The check of a mission against the words of a domain.
#include "skein/mission/vocabulary.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/foundation/shortest_text.hpp"
#include "skein/mission/duration_range.hpp"
#include "words.hpp"

namespace skein::mission {

namespace {

constexpr Words<ParameterKind, 10> kKinds{{{ParameterKind::kPlace, "place"},
                                           {ParameterKind::kZone, "zone"},
                                           {ParameterKind::kPlaces, "places"},
                                           {ParameterKind::kDuration, "duration"},
                                           {ParameterKind::kNumber, "number"},
                                           {ParameterKind::kUavs, "uavs"},
                                           {ParameterKind::kUav, "uav"},
                                           {ParameterKind::kDevice, "device"},
                                           {ParameterKind::kSyncId, "sync-id"},
                                           {ParameterKind::kWord, "word"}}};
static_assert(kKinds.size() == static_cast<std::size_t>(ParameterKind::kCount));

/// Numbers beyond are not exact as JSON numbers.
constexpr double kLargestWhole = 9007199254740992.0;

std::string_view description(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kPlace:
      return "a place or a location";
    case ParameterKind::kZone:
      return "a zone";
    case ParameterKind::kPlaces:
      return "a list of places";
    case ParameterKind::kDuration:
      return "a duration above 0 s, or two of them as in 60..120";
    case ParameterKind::kNumber:
      return "a finite number";
    case ParameterKind::kUavs:
      return "a list of UAVs";
    case ParameterKind::kUav:
      return "a UAV";
    case ParameterKind::kDevice:
      return "a device";
    case ParameterKind::kSyncId:
      return "a whole number above 0";
    case ParameterKind::kWord:
    case ParameterKind::kCount:
      break;
  }
  return "a word";
}

/// Texts come from outside and may be of any length.
constexpr std::size_t kLongestShown = 60;

std::string quoted(const std::string& text) {
  if (text.size() <= kLongestShown) return "'" + text + "'";
  return "'" + text.substr(0, kLongestShown) + "…'";
}

std::string unknown(std::string_view what, const std::string& name,
                    const std::vector<std::string>& known) {
  const std::string text = "unknown " + std::string(what) + " " + quoted(name);
  return name.size() > kLongestShown ? text : text + did_you_mean(nearest_name(name, known));
}

class Check {
 public:
  Check(const Vocabulary& vocabulary, const Surroundings& around, MissionTime now)
      : vocabulary_(vocabulary), around_(around), now_(now) {
    for (const auto& [name, signature] : vocabulary_.tasks) task_names_.push_back(name);
    if (around_.vehicle == nullptr) return;
    for (const world::SensorModel& sensor : around_.vehicle->sensors) {
      devices_.push_back(sensor.device);
    }
  }

  void mission(const UnitMission& mission) {
    if (mission.id == MissionId()) problems_.push_back("the mission needs a number above 0");
    if (mission.tasks.empty()) problems_.push_back("the mission has no tasks");
    std::set<GoalId> seen, told;
    for (const HighLevelTask& one : mission.tasks) {
      if (one.id == GoalId()) problems_.push_back("a task needs a number above 0");
      if (!seen.insert(one.id).second && told.insert(one.id).second) {
        problems_.push_back("task " + to_text(one.id) + " is given twice");
      }
      task(one);
    }
  }

  std::vector<std::string> take() { return std::move(problems_); }

 private:
  void say(const std::string& what) { problems_.push_back(where_ + ": " + what); }

  void task(const HighLevelTask& task) {
    where_ = "task " + to_text(task.id);
    times(task.time);
    for (const GoalBound& bound : task.after) after(task, bound);
    const auto found = vocabulary_.tasks.find(task.name);
    if (found == vocabulary_.tasks.end()) {
      say(unknown("task", task.name, task_names_));
      return;
    }
    where_ += " (" + task.name + ")";
    arguments(task, found->second);
    for (const std::string& use : found->second.uses) served(use);
  }

  void arguments(const HighLevelTask& task, const TaskSignature& signature) {
    const std::size_t wanted = signature.parameters.size();
    if (task.arguments.size() != wanted) {
      std::vector<std::string> kinds;
      for (const ParameterKind kind : signature.parameters) kinds.emplace_back(to_text(kind));
      say("takes " + std::to_string(wanted) + (wanted == 1 ? " argument" : " arguments") +
          (wanted == 0 ? "" : " (" + joined(kinds, ", ") + ")") + ", not " +
          std::to_string(task.arguments.size()));
    }
    for (std::size_t i = 0; i < std::min(wanted, task.arguments.size()); ++i) {
      position_ = i + 1;
      argument(task.arguments[i], signature.parameters[i]);
    }
  }

  void argument(const Argument& argument, ParameterKind kind) {
    if (const auto* name = std::get_if<std::string>(&argument)) {
      one_name(*name, kind);
    } else if (const auto* number = std::get_if<double>(&argument)) {
      one_number(*number, kind);
    } else if (const auto* point = std::get_if<world::Vector3>(&argument)) {
      if (kind != ParameterKind::kPlace) return wrong(kind);
      if (!point->allFinite()) say(nth() + " is a location with a figure that is not finite");
    } else {
      several(std::get<std::vector<std::string>>(argument), kind);
    }
  }

  void one_name(const std::string& name, ParameterKind kind) {
    switch (kind) {
      case ParameterKind::kPlace:
        return known("place", name, around_.places);
      case ParameterKind::kZone:
        return known("zone", name, around_.zones);
      case ParameterKind::kUav:
        return known("UAV", name, around_.uavs);
      case ParameterKind::kDevice:
        if (around_.vehicle == nullptr) return not_empty(name, kind);
        return known("device", name, devices_);
      case ParameterKind::kDuration:
        return range(name);
      case ParameterKind::kWord:
        return not_empty(name, kind);
      default:
        return wrong(kind);
    }
  }

  void range(const std::string& text) {
    const auto found = duration_range_from(text);
    if (!found) return wrong(ParameterKind::kDuration);
    one_number(found->least, ParameterKind::kDuration);
    one_number(found->most, ParameterKind::kDuration);
    if (found->least > found->most)
      say(nth() + " must be the least duration and then the most, not " + text);
  }

  void one_number(double number, ParameterKind kind) {
    const bool positive = std::isfinite(number) && number > 0;
    switch (kind) {
      case ParameterKind::kDuration:
        // Below a nanosecond nothing is left of it as a duration.
        if (!positive || Duration::seconds(number) <= Duration()) wrong(kind, number);
        return;
      case ParameterKind::kNumber:
        if (!std::isfinite(number)) wrong(kind, number);
        return;
      case ParameterKind::kSyncId:
        if (!positive || number != std::floor(number) || number > kLargestWhole)
          wrong(kind, number);
        return;
      default:
        wrong(kind);
    }
  }

  void several(const std::vector<std::string>& names, ParameterKind kind) {
    const bool places = kind == ParameterKind::kPlaces;
    if (!places && kind != ParameterKind::kUavs) return wrong(kind);
    if (names.empty()) say(nth() + " names nothing; expected " + std::string(description(kind)));
    std::set<std::string> seen;
    for (const std::string& name : names) {
      if (!seen.insert(name).second) {
        if (!places) say(nth() + " names " + quoted(name) + " twice");
        continue;
      }
      known(places ? "place" : "UAV", name, places ? around_.places : around_.uavs);
    }
  }

  void known(std::string_view what, const std::string& name,
             const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      say(nth() + ": " + unknown(what, name, names));
  }

  void not_empty(const std::string& name, ParameterKind kind) {
    if (name.empty()) wrong(kind);
  }

  void wrong(ParameterKind kind) { say(nth() + " must be " + std::string(description(kind))); }
  void wrong(ParameterKind kind, double number) {
    say(nth() + " must be " + std::string(description(kind)) + ", not " + shortest_text(number));
  }
  std::string nth() const { return "argument " + std::to_string(position_); }

  void served(const std::string& use) {
    if (around_.vehicle == nullptr) return;
    std::vector<std::string> serving;
    for (const auto& [device, what] : vocabulary_.serves) {
      if (what != use) continue;
      if (std::find(devices_.begin(), devices_.end(), device) != devices_.end()) return;
      if (std::find(serving.begin(), serving.end(), device) == serving.end())
        serving.push_back(device);
    }
    say("no device on board serves " + quoted(use) +
        (serving.empty() ? "" : "; one of these would: " + joined(serving, ", ")));
  }

  void times(const TimeConstraints& time) {
    later(time.start_after, "start after", time.start_before, "start before");
    later(time.end_after, "end after", time.end_before, "end before");
    later(time.start_after, "start after", time.end_before, "end before");
    passed(time.start_before, "start before");
    passed(time.end_before, "end before");
  }

  void after(const HighLevelTask& task, const GoalBound& bound) {
    const std::string what =
        std::string(bound.on_end ? "end" : "start") + " after goal " + to_text(bound.goal);
    if (bound.goal == GoalId()) say("a bound after a goal needs its number");
    if (bound.goal == task.id) say("cannot " + what + ": that is itself");
    if (bound.least < Duration()) say("cannot " + what + " by less than 0 s");
    if (bound.least > bound.most) {
      say("cannot " + what + " by " + to_text(bound.least) + " s at least and " +
          to_text(bound.most) + " s at most");
    }
  }

  void later(const std::optional<MissionTime>& least, std::string_view least_name,
             const std::optional<MissionTime>& most, std::string_view most_name) {
    if (!least || !most || *least <= *most) return;
    say("cannot " + std::string(least_name) + " " + to_text(*least) + " s and " +
        std::string(most_name) + " " + to_text(*most) + " s");
  }

  void passed(const std::optional<MissionTime>& bound, std::string_view name) {
    if (bound && *bound < now_) {
      say("cannot " + std::string(name) + " " + to_text(*bound) + " s: it is " + to_text(now_) +
          " s already");
    }
  }

  const Vocabulary& vocabulary_;
  const Surroundings& around_;
  MissionTime now_;
  std::vector<std::string> task_names_, devices_;
  std::vector<std::string> problems_;
  std::string where_;
  std::size_t position_ = 0;
};

}  // namespace

std::string_view to_text(ParameterKind kind) { return word_of(kKinds, kind); }
std::optional<ParameterKind> parameter_kind_from(std::string_view text) {
  return value_of(kKinds, text);
}

std::vector<std::string> problems_of(const UnitMission& mission, const Vocabulary& vocabulary,
                                     const Surroundings& surroundings, MissionTime now) {
  Check check(vocabulary, surroundings, now);
  check.mission(mission);
  return check.take();
}

}  // namespace skein::mission
