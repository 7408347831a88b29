// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/history.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "skein/mission/alarm_name.hpp"
#include "skein/mission/autonomy.hpp"
#include "statement.hpp"

namespace skein::laws {

bool Execution::is_motion() const {
  return type == "takeoff" || type == "goto" || type == "land" || type == "wait";
}

bool Goal::settled() const {
  return state() == "achieved" || state() == "failed" || state() == "cancelled";
}

std::optional<double> Goal::when(std::string_view wanted) const {
  for (auto it = changes.rbegin(); it != changes.rend(); ++it) {
    if (it->state == wanted) return it->at;
  }
  return std::nullopt;
}

int Uav::degree(double instant) const {
  int degree = spec->degree;
  for (const auto& [from, value] : degrees) {
    if (from <= instant) degree = value;
  }
  return degree;
}

bool Uav::deliberates(double from, double until) const {
  if (degree(from) < 4) return false;
  return std::none_of(degrees.begin(), degrees.end(), [&](const auto& change) {
    return change.first > from && change.first <= until && change.second < 4;
  });
}

std::optional<Sample> Uav::at(double instant) const {
  const auto next = std::lower_bound(samples.begin(), samples.end(), instant,
                                     [](const Sample& sample, double t) { return sample.at < t; });
  if (next == samples.end()) return std::nullopt;
  if (next == samples.begin()) {
    if (next->at > instant) return std::nullopt;
    return *next;
  }
  const Sample& before = *std::prev(next);
  const double part = (instant - before.at) / (next->at - before.at);
  Sample result = before;
  result.at = instant;
  result.position += part * (next->position - before.position);
  result.velocity += part * (next->velocity - before.velocity);
  result.heading += part * world::wrapped(next->heading - before.heading);
  result.energy += part * (next->energy - before.energy);
  return result;
}

bool Uav::is_out(const Sample& sample) const {
  constexpr double kStands = 0.2;  // [m/s]
  return sample.airborne || (spec->model.ground && sample.velocity.head<2>().norm() > kStands);
}

std::int64_t Uav::goal_of_task(std::int64_t task) const {
  const auto found = goal_of.find(task);
  return found == goal_of.end() ? 0 : found->second;
}

std::vector<const Activity*> Uav::activities_of(std::int64_t goal) const {
  std::vector<const Activity*> result;
  for (const Activity& activity : activities) {
    if (goal_of_task(activity.task) == goal) result.push_back(&activity);
  }
  return result;
}

bool Uav::had_fault(std::string_view what, double until) const {
  return std::any_of(faults.begin(), faults.end(), [&](const auto& fault) {
    return fault.first <= until && fault.second.rfind(what, 0) == 0;
  });
}

std::optional<world::Vector3> History::place(const mission::Argument& argument, double at) const {
  if (const auto* point = std::get_if<world::Vector3>(&argument)) return *point;
  const auto* name = std::get_if<std::string>(&argument);
  if (name == nullptr) return std::nullopt;
  const auto alarm = alarms.find(*name);
  if (alarm != alarms.end()) {
    const auto after = alarm->second.upper_bound(at);
    return after == alarm->second.begin() ? after->second : std::prev(after)->second;
  }
  const auto told =
      std::find_if(objects_told.rbegin(), objects_told.rend(),
                   [&](const ObjectTold& one) { return one.name == *name && one.told <= at; });
  if (told != objects_told.rend()) return told->position;
  const auto found = scenario->world.places.find(*name);
  if (found == scenario->world.places.end()) return std::nullopt;
  return found->second;
}

bool History::is_alarm(const mission::Argument& argument) const {
  const auto* name = std::get_if<std::string>(&argument);
  return name != nullptr && alarms.count(*name) != 0;
}

bool History::is_followed(const mission::Argument& argument) const {
  const auto* name = std::get_if<std::string>(&argument);
  return name != nullptr && std::any_of(objects_told.begin(), objects_told.end(),
                                        [&](const ObjectTold& one) { return one.name == *name; });
}

bool History::in_the_air(const world::Vector3& at) const {
  constexpr double kOverGround = 5;
  return at.z() - terrain.elevation(at.x(), at.y()) >= kOverGround;
}

const world::Zone* History::zone(const mission::Argument& argument) const {
  const auto* name = std::get_if<std::string>(&argument);
  if (name == nullptr) return nullptr;
  for (const world::Zone& zone : scenario->world.zones) {
    if (zone.name == *name) return &zone;
  }
  return nullptr;
}

bool History::was_away(const std::string& node, double from, double until) const {
  const auto found = away.find(node);
  return found != away.end() && std::ranges::any_of(found->second, [&](const auto& while_away) {
           return while_away.first <= until && while_away.second >= from;
         });
}

bool History::was_killed(const std::string& node) const {
  return dead.contains(node) && !resumed.contains(node);
}

namespace {

using journal::Record;

std::int64_t whole(const Record& record, const char* key) {
  return static_cast<std::int64_t>(record.number(key, 0));
}
std::string text(const Record& record, const char* key) { return std::string(record.text(key)); }

std::optional<world::Vector3> point(const Record& record, const char* key) {
  const std::vector<double> xs = record.numbers(key);
  if (xs.size() != 3) return std::nullopt;
  return world::Vector3(xs[0], xs[1], xs[2]);
}

class Teller {
 public:
  explicit Teller(const scenario::Scenario& scenario)
      : history_{&scenario, world::Terrain(scenario.world.terrain), {}, {}, {}, {}, {}, {}, 0,
                 false} {
    for (const scenario::UavSpec& spec : scenario.uavs) {
      Uav& uav = history_.uavs[spec.name];
      uav.spec = &spec;
      for (const world::Volume& volume : scenario.world.volumes) {
        uav.closings.push_back(
            {volume, volume.when.from.to_seconds(), volume.when.until.to_seconds()});
      }
    }
    for (const auto& step : scenario.ground.script.steps) actions_[step.name] = &step.actions;
  }

  History tell(const std::vector<Record>& records) {
    for (const Record& record : records) {
      history_.end = std::max(history_.end, record.at().to_seconds());
      see(record);
      history_.joint.see(record);
      history_.team.see(record);
      history_.air.see(record);
    }
    for (const std::string& node : waiting_) history_.resumed.erase(node);
    return std::move(history_);
  }

 private:
  void see(const Record& record) {
    const std::string& kind = record.kind();
    if (kind == "mission" && record.text("state") == "finished") history_.finished = true;
    if (kind == "step") see_step(record);
    if (kind == "fault") see_fault(record);
    if (kind == "message") see_message(record);
    if (kind == "sync") see_sync(record);
    if (kind == "alarm") see_alarm(record);
    if (kind == "object") see_object(record);
    if (kind == "seen") see_object_told(record);
    const auto found = history_.uavs.find(text(record, "uav"));
    if (found != history_.uavs.end()) see(found->second, record);
  }

  void see(Uav& uav, const Record& record) {
    const std::string& kind = record.kind();
    const double at = record.at().to_seconds();
    if (kind == "telemetry") see_sample(uav, record);
    if (kind == "functional") see_activity(uav, record);
    if (kind == "task") see_task(uav, record);
    if (kind == "goal") see_goal(uav, record);
    // A role's task serves the goal of its joint task.
    if (kind == "role-task") {
      uav.goal_of.emplace(whole(record, "task"), uav.goal_of_task(whole(record, "of")));
    }
    if (kind == "planned") uav.goal_of.emplace(whole(record, "task"), whole(record, "goal"));
    if (kind == "degree") uav.degrees.emplace_back(at, static_cast<int>(record.number("degree")));
    if (kind == "meeting") see_meeting(uav, record);
    if (kind == "frontier") {
      const bool sent = record.text("direction") == "sent";
      uav.plan_words.push_back({at, text(record, sent ? "to" : "from"), sent});
    }
    if (kind == "notice") uav.words.push_back({at, text(record, "text")});
    if (kind == "answer") see_answer(uav, record);
    if (kind == "contact") uav.words.push_back({at, "contact: " + text(record, "policy")});
    if (kind == "decision") {
      uav.words.push_back({at, text(record, "operator") + ": " + text(record, "cause") + ": " +
                                   text(record, "inputs") + ": " + text(record, "outcome")});
    }
  }

  static void see_sample(Uav& uav, const Record& record) {
    const auto position = point(record, "position");
    const auto velocity = point(record, "velocity");
    if (!position || !velocity) return;
    uav.samples.push_back({record.at().to_seconds(), *position, *velocity, record.number("heading"),
                           record.number("energy"), record.truth("airborne")});
  }

  static void see_activity(Uav& uav, const Record& record) {
    const std::int64_t task = whole(record, "task");
    const double at = record.at().to_seconds();
    const std::string state = text(record, "state");
    auto known = std::find_if(uav.activities.rbegin(), uav.activities.rend(),
                              [&](const Activity& one) { return one.task == task; });
    const bool anew = state == "running" && known != uav.activities.rend() && !known->end.empty();
    if (known == uav.activities.rend() || anew) {
      uav.activities.push_back({task, text(record, "type"), text(record, "device"),
                                point(record, "target"), at, kNever, "", ""});
      known = uav.activities.rbegin();
    }
    if (state == "running") return;
    known->until = at;
    known->end = state;
    known->reason = text(record, "reason");
  }

  static void see_task(Uav& uav, const Record& record) {
    Execution& task = uav.executions[whole(record, "task")];
    task.task = whole(record, "task");
    task.type = text(record, "type");
    task.state = text(record, "state");
    task.reason = text(record, "reason");
    if (task.node != record.node()) task.taken = kNever;
    task.node = record.node();
    const double at = record.at().to_seconds();
    if (task.state == "started") {
      task.started = std::min(task.started, at);
      task.taken = std::min(task.taken, at);
    }
    if (task.state == "ended" || task.state == "aborted") task.over = at;
  }

  static void see_goal(Uav& uav, const Record& record) {
    Goal& goal = uav.goals[whole(record, "goal")];
    goal.id = whole(record, "goal");
    if (goal.changes.empty()) goal.task = task_from(record.text("statement"));
    goal.changes.push_back({record.at().to_seconds(), text(record, "state"), text(record, "why")});
  }

  static void see_answer(Uav& uav, const Record& record) {
    uav.answers.push_back({record.at().to_seconds(), whole(record, "mission"),
                           record.truth("planned"), record.truth("evaluated"),
                           record.number("energy", 0), record.number("earliest_end", kNever),
                           record.number("latest_end", kNever)});
  }

  void see_alarm(const Record& record) {
    const auto at = point(record, "position");
    const auto id = static_cast<std::uint64_t>(whole(record, "alarm"));
    if (at) history_.alarms[mission::name_of_alarm(id)][record.at().to_seconds()] = *at;
  }

  void see_object(const Record& record) {
    const auto at = point(record, "position");
    if (!at) return;
    ObjectState state{record.at().to_seconds(), text(record, "type"), at->head<2>(),
                      record.number("radius"), record.truth("active")};
    const std::vector<double> from = record.numbers("ignition");
    if (from.size() == 2) {
      world::FireFront front;
      front.ignition = {from[0], from[1]};
      front.length = state.radius;
      front.breadth = record.number("breadth");
      const world::Vector2 ahead = state.position - front.ignition;
      if (ahead.norm() > 0) front.ahead = ahead.normalized();
      state.front = front;
    }
    history_.objects[text(record, "name")].push_back(std::move(state));
  }

  void see_object_told(const Record& record) {
    const auto at = point(record, "position");
    if (!at) return;
    const double told = record.at().to_seconds();
    history_.objects_told.push_back(
        {told, record.number("when"), text(record, "name"), *at, record.number("spread")});
  }

  void see_fault(const Record& record) {
    const std::string target = text(record, "target");
    const std::string what = text(record, "what");
    if (what == "kill" && history_.dead.insert(target).second) history_.resumed.insert(target);
    if (what == "kill") waiting_.insert(target);
    if (what == "resume") waiting_.erase(target);
    if (what == "restart") history_.resumed.erase(target);
    std::vector<std::pair<double, double>>& away = history_.away[target];
    if (what == "kill") away.emplace_back(record.at().to_seconds(), kNever);
    if ((what == "resume" || what == "restart") && !away.empty())
      away.back().second = record.at().to_seconds();
    const auto found = history_.uavs.find(target);
    if (found == history_.uavs.end()) return;
    found->second.faults.emplace_back(record.at().to_seconds(), text(record, "what"));
  }

  void see_sync(const Record& record) {
    const auto found = history_.uavs.find(text(record, "to"));
    if (record.text("direction") != "received" || found == history_.uavs.end()) return;
    std::vector<SyncHeard>& heard = found->second.syncs_heard;
    const SyncHeard one{record.at().to_seconds(), whole(record, "id"), text(record, "from")};
    if (record.text("word") == "withdrawn") return forget_withdrawn(one, heard);
    if (record.find("word") == nullptr) heard.push_back(one);
  }
  // What comes with its withdrawal, after a cut, was said long ago.
  static void forget_withdrawn(const SyncHeard& one, std::vector<SyncHeard>& heard) {
    constexpr double kMoment = 1;  // [s]
    std::erase_if(heard, [&](const SyncHeard& said) {
      return said.id == one.id && said.from == one.from && said.at + kMoment > one.at;
    });
  }
  static void see_meeting(Uav& uav, const Record& record) {
    Foretold one{record.at().to_seconds(), whole(record, "id"), record.truth("known"),
                 text(record, "last"), kNever};
    if (record.find("soonest") != nullptr) one.soonest = record.number("soonest");
    uav.foretold.push_back(std::move(one));
  }

  // What the ground's script closes, its UAVs know when they are told.
  void see_step(const Record& record) {
    const auto found = actions_.find(text(record, "name"));
    if (found == actions_.end()) return;
    for (const ground_station::Action& action : *found->second) {
      if (const auto* close = std::get_if<ground_station::CloseAir>(&action)) {
        tell(close->uavs, [&](Uav& uav) {
          told_[uav.name()].push_back(uav.closings.size());
          uav.closings.push_back({close->volume, kNever, kNever});
        });
      }
      if (const auto* world = std::get_if<ground_station::TellWorld>(&action)) {
        tell(world->uavs, [&](Uav& uav) { told_[uav.name()].push_back(std::nullopt); });
        if (const auto& place = world->change.place) {
          history_.joint.points.push_back({record.at().to_seconds(), place->name, place->at});
        }
      }
      if (const auto* open = std::get_if<ground_station::OpenAir>(&action)) {
        tell(open->uavs, [&](Uav& uav) {
          told_[uav.name()].push_back(std::nullopt);
          for (Closing& one : uav.closings) {
            if (one.volume.name == open->name) one.opened = record.at().to_seconds();
          }
        });
      }
    }
  }

  template <class Do>
  void tell(const std::vector<std::string>& names, const Do& what) {
    for (auto& [name, uav] : history_.uavs) {
      const bool meant =
          names.empty() || std::find(names.begin(), names.end(), name) != names.end();
      if (meant) what(uav);
    }
  }

  void see_message(const Record& record) {
    if (record.text("slot") != "WorldChange" || record.text("direction") != "received") return;
    const auto found = history_.uavs.find(text(record, "to"));
    std::deque<std::optional<std::size_t>>& told = told_[text(record, "to")];
    if (found == history_.uavs.end() || told.empty()) return;
    const std::optional<std::size_t> closing = told.front();
    told.pop_front();
    if (!closing) return;
    Closing& one = found->second.closings[*closing];
    one.known = std::max(record.at().to_seconds(), one.volume.when.from.to_seconds());
  }

  History history_;
  std::set<std::string> waiting_;  ///< nodes that are dead
  /// Changes of the world on their way to each UAV, in order: a closing, or something else.
  std::map<std::string, std::deque<std::optional<std::size_t>>> told_;
  std::map<std::string, const std::vector<ground_station::Action>*> actions_;
};

}  // namespace

History history_of(const scenario::Scenario& scenario,
                   const std::vector<journal::Record>& records) {
  return Teller(scenario).tell(records);
}

}  // namespace skein::laws
