// SPDX-License-Identifier: Apache-2.0
// The history of a run, told line by line.
#include <algorithm>
#include <deque>

#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/deliberation.hpp"
#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"
#include "skein/laws/history.hpp"
#include "skein/mission/alarm_name.hpp"

namespace skein::laws {

namespace {

namespace lines = journal::lines;

using journal::Record;
using journal::Written;

std::optional<world::Vector3> point(const std::vector<double>& xs) {
  if (xs.size() != 3) return std::nullopt;
  return world::Vector3(xs[0], xs[1], xs[2]);
}

double seconds(const Written& when) { return when.at.to_seconds(); }

/// What one UAV did, was told and said.
class UavTeller {
 public:
  explicit UavTeller(Uav& uav) : uav_(uav) {}

  void hear(const lines::Telemetry& line, const Written& when) {
    const auto position = point(line.position), velocity = point(line.velocity);
    if (!position || !velocity) return;
    uav_.samples.push_back(
        {seconds(when), *position, *velocity, line.heading, line.energy, line.airborne});
  }

  void hear(const lines::Functional& line, const Written& when) {
    const auto task = static_cast<std::int64_t>(line.task);
    auto known = std::find_if(uav_.activities.rbegin(), uav_.activities.rend(),
                              [&](const Activity& one) { return one.task == task; });
    const bool anew =
        line.state == "running" && known != uav_.activities.rend() && !known->end.empty();
    if (known == uav_.activities.rend() || anew) {
      uav_.activities.push_back(
          {task, line.type, line.device, point(line.target), seconds(when), kNever, "", ""});
      known = uav_.activities.rbegin();
    }
    if (line.state == "running") return;
    known->until = seconds(when);
    known->end = line.state;
    known->reason = line.reason;
  }

  void hear(const lines::Task& line, const Written& when) {
    const auto number = static_cast<std::int64_t>(line.task);
    Execution& task = uav_.executions[number];
    task.task = number;
    task.type = line.type;
    task.state = line.state;
    task.reason = line.reason;
    if (task.node != when.node) task.taken = kNever;
    task.node = when.node;
    if (task.state == "started") {
      task.started = std::min(task.started, seconds(when));
      task.taken = std::min(task.taken, seconds(when));
    }
    if (task.state == "running") task.running = std::min(task.running, seconds(when));
    if (task.state == "ended" || task.state == "aborted") task.over = seconds(when);
  }

  void hear(const lines::Goal& line, const Written& when) {
    const auto number = static_cast<std::int64_t>(line.goal);
    Goal& goal = uav_.goals[number];
    goal.id = number;
    if (goal.changes.empty()) goal.task = task_from(line.statement);
    goal.changes.push_back({seconds(when), line.state, line.why});
  }

  void hear(const lines::Planned& line, const Written&) {
    uav_.goal_of.emplace(static_cast<std::int64_t>(line.task),
                         static_cast<std::int64_t>(line.goal));
    const auto [promise, is_new] =
        uav_.promised.try_emplace(static_cast<std::int64_t>(line.goal), line.revision, 0.0);
    if (promise->second.first != line.revision) return;
    double& latest = promise->second.second;
    latest = std::max(latest, line.latest_end.value_or(kNever));
  }
  // A role's task serves the goal of its joint task.
  void hear(const lines::RoleTask& line, const Written&) {
    uav_.goal_of.emplace(static_cast<std::int64_t>(line.task),
                         uav_.goal_of_task(static_cast<std::int64_t>(line.of)));
  }

  void hear(const lines::Degree& line, const Written& when) {
    uav_.degrees.emplace_back(seconds(when), static_cast<int>(line.degree));
  }
  void hear(const lines::Answer& line, const Written& when) {
    uav_.answers.push_back({seconds(when), static_cast<std::int64_t>(line.mission), line.planned,
                            line.evaluated.value_or(false), line.energy.value_or(0),
                            line.earliest_end.value_or(kNever), line.latest_end.value_or(kNever)});
  }

  void hear(const lines::Meeting& line, const Written& when) {
    uav_.foretold.push_back({seconds(when), static_cast<std::int64_t>(line.id), line.known,
                             line.last, line.soonest.value_or(kNever)});
  }
  void hear(const lines::Frontier& line, const Written& when) {
    const bool sent = line.direction == "sent";
    uav_.plan_words.push_back(
        {seconds(when), sent ? line.to : line.from, sent, line.arcs.value_or(0)});
  }

  void hear(const lines::Notice& line, const Written& when) { say(when, line.text); }
  void hear(const lines::Contact& line, const Written& when) {
    say(when, "contact: " + line.policy);
    if (!line.why.empty()) say(when, line.why);
  }
  void hear(const lines::Joint& line, const Written& when) {
    if (!line.why.empty()) say(when, line.why);
  }
  void hear(const lines::Decision& line, const Written& when) {
    say(when, line.operator_ + ": " + line.cause + ": " + line.inputs + ": " + line.outcome);
  }

 private:
  void say(const Written& when, std::string text) {
    uav_.words.push_back({seconds(when), std::move(text)});
  }

  Uav& uav_;
};

/// What the ground's script and its operators told UAVs of the world, and when they heard it.
class WorldTeller {
 public:
  explicit WorldTeller(History& history) : history_(history) {
    for (const auto& step : history.scenario->ground.script.steps)
      steps_[step.name] = &step.actions;
    for (const auto& person : history.scenario->ground.script.operators)
      operators_[person.does] = &person.actions;
  }

  void hear(const lines::Step& line, const Written& when) { done(steps_, line.name, when); }
  void hear(const lines::Operator& line, const Written& when) { done(operators_, line.does, when); }

  void hear(const lines::Message& line, const Written& when) {
    if (const auto from = history_.uavs.find(line.from);
        from != history_.uavs.end() && line.direction == "sent")
      from->second.events_to[line.to].push_back(seconds(when));
    if (line.slot != "WorldChange" || line.direction != "received") return;
    const auto found = history_.uavs.find(line.to);
    std::deque<Told>& told = told_[line.to];
    while (!told.empty() && told.front().expires < seconds(when)) told.pop_front();
    if (found == history_.uavs.end() || told.empty()) return;
    Told heard = std::move(told.front());
    told.pop_front();
    if (heard.place) {
      heard.place->at = seconds(when);
      found->second.places_known.push_back(*heard.place);
    }
    if (!heard.closing) return;
    Closing& one = found->second.closings[*heard.closing];
    one.known = std::max(seconds(when), one.volume.when.from.to_seconds());
  }

 private:
  /// A change of the world on its way to a UAV: a closing, a place or something else.
  struct Told {
    double expires = kNever;             ///< nobody hears of it later
    std::optional<std::size_t> closing;  ///< index in the UAV's
    std::optional<PlaceKnown> place;
  };
  using Actions = std::map<std::string, const std::vector<ground_station::Action>*>;

  // What they close, the UAVs know when they are told.
  void done(const Actions& by, const std::string& name, const Written& when) {
    const auto found = by.find(name);
    if (found == by.end()) return;
    for (const ground_station::Action& action : *found->second) {
      if (const auto* close = std::get_if<ground_station::CloseAir>(&action)) tell(*close, when);
      if (const auto* world = std::get_if<ground_station::TellWorld>(&action)) tell(*world, when);
      if (const auto* open = std::get_if<ground_station::OpenAir>(&action)) tell(*open, when);
    }
  }

  void tell(const ground_station::CloseAir& close, const Written& when) {
    each_of(close.uavs, [&](Uav& uav) {
      told_[uav.name()].push_back({expiry(when), uav.closings.size(), {}});
      uav.closings.push_back({close.volume, kNever, kNever});
    });
  }
  void tell(const ground_station::TellWorld& world, const Written& when) {
    const auto& place = world.change.place;
    Told told{expiry(when), {}, {}};
    if (place) told.place = PlaceKnown{seconds(when), place->name, place->at};
    each_of(world.uavs, [&](Uav& uav) { told_[uav.name()].push_back(told); });
    if (place) history_.joint.points.push_back({seconds(when), place->name, place->at});
  }
  void tell(const ground_station::OpenAir& open, const Written& when) {
    each_of(open.uavs, [&](Uav& uav) {
      told_[uav.name()].push_back({expiry(when), {}, {}});
      for (Closing& one : uav.closings)
        if (one.volume.name == open.name) one.opened = std::min(one.opened, seconds(when));
    });
  }

  double expiry(const Written& when) const {
    return seconds(when) + history_.scenario->ground.script.command_lifetime.to_seconds();
  }

  template <class Do>
  void each_of(const std::vector<std::string>& names, const Do& what) {
    for (auto& [name, uav] : history_.uavs) {
      const bool meant =
          names.empty() || std::find(names.begin(), names.end(), name) != names.end();
      if (meant) what(uav);
    }
  }

  History& history_;
  std::map<std::string, std::deque<Told>> told_;  ///< on their way to each UAV, in order
  Actions steps_, operators_;
};

/// What is nobody's own: the mission, alarms, objects, deaths, and who is there at a meeting.
class RunTeller {
 public:
  explicit RunTeller(History& history) : history_(history) {}

  /// Who is dead at the end of the log has not come back.
  void end() {
    for (const std::string& node : waiting_) history_.resumed.erase(node);
  }

  void hear(const lines::Mission& line, const Written&) {
    if (line.state == "finished") history_.finished = true;
  }

  void hear(const lines::Alarm& line, const Written& when) {
    if (const auto at = point(line.position))
      history_.alarms[mission::name_of_alarm(line.alarm)][seconds(when)] = *at;
  }

  void hear(const lines::Object& line, const Written& when) {
    const auto at = point(line.position);
    if (!at) return;
    ObjectState state{seconds(when), line.type, at->head<2>(), line.radius, line.active};
    if (line.ignition.size() == 2) {
      world::FireFront front;
      front.ignition = {line.ignition[0], line.ignition[1]};
      front.length = line.radius;
      front.breadth = line.breadth.value_or(0);
      const world::Vector2 ahead = state.position - front.ignition;
      if (ahead.norm() > 0) front.ahead = ahead.normalized();
      state.front = front;
    }
    history_.objects[line.name].push_back(std::move(state));
  }

  void hear(const lines::Seen& line, const Written& when) {
    if (const auto at = point(line.position))
      history_.objects_told.push_back({seconds(when), line.when, line.name, *at, line.spread});
  }

  void hear(const lines::Fault& line, const Written& when) {
    const bool back = line.what == "resume" || line.what == "restart";
    std::vector<std::pair<double, double>>& away = history_.away[line.target];
    if (line.what == "kill") {
      if (history_.dead.insert(line.target).second) history_.resumed.insert(line.target);
      waiting_.insert(line.target);
      away.emplace_back(seconds(when), kNever);
    }
    if (line.what == "resume") waiting_.erase(line.target);
    if (line.what == "restart") history_.resumed.erase(line.target);
    if (back && !away.empty()) away.back().second = seconds(when);
    const auto found = history_.uavs.find(line.target);
    if (found != history_.uavs.end()) found->second.faults.emplace_back(seconds(when), line.what);
  }

  void hear(const lines::LostUav& line, const Written& when) {
    if (!history_.lost_since(line.uav, seconds(when)))
      history_.lost[line.uav].emplace_back(seconds(when), kNever);
  }

  void hear(const lines::FoundUav& line, const Written& when) {
    if (history_.lost_since(line.uav, seconds(when)))
      history_.lost[line.uav].back().second = seconds(when);
  }

  void hear(const lines::Sync& line, const Written& when) {
    const auto found = history_.uavs.find(line.to);
    if (line.direction != "received" || found == history_.uavs.end()) return;
    std::vector<SyncHeard>& heard = found->second.syncs_heard;
    const SyncHeard one{seconds(when), static_cast<std::int64_t>(line.id), line.from};
    if (line.word == "withdrawn") return forget_withdrawn(one, heard);
    if (line.word.empty()) heard.push_back(one);
  }

 private:
  // What comes with its withdrawal, after a cut, was said long ago.
  static void forget_withdrawn(const SyncHeard& one, std::vector<SyncHeard>& heard) {
    constexpr double kMoment = 1;  // [s]
    std::erase_if(heard, [&](const SyncHeard& said) {
      return said.id == one.id && said.from == one.from && said.at + kMoment > one.at;
    });
  }

  History& history_;
  std::set<std::string> waiting_;  ///< nodes that are dead
};

class Teller {
 public:
  explicit Teller(const scenario::Scenario& scenario)
      : history_(begun(scenario)), run_(history_), world_(history_) {}

  History tell(const std::vector<Record>& records) {
    for (const Record& record : records) {
      history_.end = std::max(history_.end, record.at().to_seconds());
      if (!see(record)) history_.unread.push_back({record.at().to_seconds(), to_json(record)});
    }
    run_.end();
    return std::move(history_);
  }

 private:
  static History begun(const scenario::Scenario& scenario) {
    History history{&scenario, world::Terrain(scenario.world.terrain), {}, {}, {}, {}, {}, {}, 0,
                    false};
    for (const scenario::UavSpec& spec : scenario.uavs) {
      Uav& uav = history.uavs[spec.name];
      uav.spec = &spec;
      for (const world::Volume& volume : scenario.world.volumes) {
        uav.closings.push_back(
            {volume, volume.when.from.to_seconds(), volume.when.until.to_seconds()});
      }
    }
    return history;
  }

  bool see(const Record& record) {
    bool read =
        journal::hand_on<lines::Mission, lines::Alarm, lines::Object, lines::Seen, lines::Fault,
                         lines::LostUav, lines::FoundUav, lines::Sync>(record, run_);
    read = journal::hand_on<lines::Step, lines::Operator, lines::Message>(record, world_) && read;
    read = see_of_uav(record) && read;
    read = history_.joint.see(record) && read;
    read = history_.team.see(record) && read;
    return history_.air.see(record) && read;
  }

  bool see_of_uav(const Record& record) {
    const auto found = history_.uavs.find(std::string(record.text("uav")));
    if (found == history_.uavs.end()) return true;
    UavTeller uav(found->second);
    return journal::hand_on<lines::Telemetry, lines::Functional, lines::Task, lines::Goal,
                            lines::Planned, lines::RoleTask, lines::Joint, lines::Degree,
                            lines::Answer, lines::Meeting, lines::Frontier, lines::Notice,
                            lines::Contact, lines::Decision>(record, uav);
  }

  History history_;
  RunTeller run_;
  WorldTeller world_;
};

}  // namespace

History history_of(const scenario::Scenario& scenario,
                   const std::vector<journal::Record>& records) {
  return Teller(scenario).tell(records);
}

}  // namespace skein::laws
