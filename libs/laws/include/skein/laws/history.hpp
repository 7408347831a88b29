// SPDX-License-Identifier: Apache-2.0
// What happened in a run, by UAV, as the event log tells it: truth of the simulator, what the
// executives did, what became of goals, what was said.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/laws/air_history.hpp"
#include "skein/laws/joint_history.hpp"
#include "skein/laws/team_history.hpp"
#include "skein/mission/high_level_task.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/world/terrain.hpp"

namespace skein::laws {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A vehicle at an instant, in truth.
struct Sample {
  double at = 0;  ///< [s]
  world::Vector3 position = world::Vector3::Zero();
  world::Vector3 velocity = world::Vector3::Zero();
  double heading = 0;
  double energy = 1;
  bool airborne = false;
};

/// A task that the vehicle really carried out, or refused (then `from` is `until`). One that a
/// functional layer lost and began anew is two.
struct Activity {
  std::int64_t task = 0;
  std::string type;
  std::string device;  ///< of a perception
  std::optional<world::Vector3> target;
  double from = kNever, until = kNever;
  std::string end;  ///< "ended", "aborted"; empty while it goes on
  std::string reason;

  bool looks() const { return !device.empty(); }
  bool moves() const { return type == "takeoff" || type == "goto" || type == "land"; }
};

/// A task in an executive, whichever has it.
struct Execution {
  std::int64_t task = 0;
  std::string type;
  double started = kNever, over = kNever;
  std::string state, reason;
  std::string node;       ///< whose executive had it last: the UAV's, or the ground's at degree 1
  double taken = kNever;  ///< that one started it

  bool is_motion() const;
  bool under_way(double at) const { return started <= at && at < over; }
};

struct Change {
  double at = 0;
  std::string state, why;
};

struct Goal {
  std::int64_t id = 0;
  mission::HighLevelTask task;  ///< read from its statement
  std::vector<Change> changes;

  const std::string& state() const { return changes.back().state; }
  bool settled() const;
  /// When it was last `state`; nothing if never.
  std::optional<double> when(std::string_view state) const;
  double received() const { return changes.front().at; }
};

/// What became of a mission that was asked for, or only asked about (then with what it would take).
struct Answer {
  double at = 0;
  std::int64_t mission = 0;
  bool planned = false, evaluated = false;
  double energy = 0;  ///< share of its capacity
  double earliest_end = kNever, latest_end = kNever;
};

/// A volume of air and what one UAV knows of it.
struct Closing {
  world::Volume volume;
  double known = 0;  ///< from when on the UAV knows it [s]
  double opened = kNever;
};

/// Something said: a notice, or the cause and outcome of a decision.
struct Word {
  double at = 0;
  std::string text;
};

/// A synchronisation message: its sender is there.
struct SyncHeard {
  double at = 0;
  std::int64_t id = 0;
  std::string from;
};

/// What a UAV says that it knows of who it is to meet.
struct Foretold {
  double at = 0;
  std::int64_t id = 0;
  bool known = false;
  std::string last;  ///< who comes last; empty: it waits for nobody
  double soonest = kNever;
};

/// One tells another of its plan's network, or hears of the other's.
struct PlanWord {
  double at = 0;
  std::string other;
  bool sent = false;
};

/// An object at an instant, in truth.
struct ObjectState {
  double at = 0;
  std::string kind;
  world::Vector2 position = world::Vector2::Zero();
  double radius = 0;
  bool active = false;
  std::optional<world::FireFront> front = {};  ///< of a fire that spreads

  /// How far a point is from what it covers [m].
  double distance_to(const world::Vector2& point) const;
};

/// Where the ground station says that an object was, and when.
struct ObjectTold {
  double told = 0, seen = 0;  ///< [s]
  std::string name;
  world::Vector3 position = world::Vector3::Zero();
  double spread = 0;  ///< [m]
};

struct Uav {
  const scenario::UavSpec* spec = nullptr;
  std::vector<Sample> samples;  ///< once a second
  std::vector<Activity> activities;
  std::map<std::int64_t, Execution> executions;
  std::map<std::int64_t, Goal> goals;
  std::map<std::int64_t, std::int64_t> goal_of;  ///< by task, as its plans name it
  std::vector<std::pair<double, int>> degrees;   ///< from when on
  std::vector<Closing> closings;
  std::vector<Word> words;
  std::vector<std::pair<double, std::string>> faults;
  std::vector<SyncHeard> syncs_heard;
  std::vector<Foretold> foretold;
  std::vector<PlanWord> plan_words;
  std::vector<Answer> answers;

  const std::string& name() const { return spec->name; }
  int degree(double at) const;
  /// At degree 4 or 5 during all of it.
  bool deliberates(double from, double until) const;
  /// Interpolated; nothing before the first and after the last sample.
  std::optional<Sample> at(double instant) const;
  /// In the air, or on its way over the ground.
  bool is_out(const Sample& sample) const;
  /// 0 when no plan names the task.
  std::int64_t goal_of_task(std::int64_t task) const;
  std::vector<const Activity*> activities_of(std::int64_t goal) const;
  bool had_fault(std::string_view what, double until = kNever) const;
};

struct History {
  const scenario::Scenario* scenario = nullptr;
  world::Terrain terrain;
  std::map<std::string, Uav> uavs;
  std::set<std::string> dead;     ///< nodes that died, at any time
  std::set<std::string> resumed;  ///< of these, the ones that always came back with what they knew
  /// "alarm:1": from when on it was said to be where. A ground station that forgot counts anew.
  std::map<std::string, std::map<double, world::Vector3>> alarms;
  std::map<std::string, std::vector<ObjectState>> objects;  ///< in truth, by name
  std::vector<ObjectTold> objects_told;
  double end = 0;
  bool finished = false;  ///< by the ground's script
  JointHistory joint = {};
  TeamHistory team = {};
  AirHistory air = {};
  std::vector<Word> unread = {};  ///< lines of kinds that laws read, which lack what they must have
  /// Of nodes that died: from when to when they were, kNever if they did not come back.
  std::map<std::string, std::vector<std::pair<double, double>>> away = {};

  /// A place of the scenario, an alarm's or a followed object's as it was known then, or the point
  /// itself; nothing for what is none.
  std::optional<world::Vector3> place(const mission::Argument& argument, double at = kNever) const;
  /// Whether it is flown to (else it lies on the ground and is looked at).
  bool in_the_air(const world::Vector3& place) const;
  const world::Zone* zone(const mission::Argument& argument) const;
  /// And did not come back, or with nothing it knew: a node that remembers is excused nothing.
  bool was_killed(const std::string& node) const;
  bool is_alarm(const mission::Argument& argument) const;
  /// Its place is said by the ground station, again and again.
  bool is_followed(const mission::Argument& argument) const;
  /// At some time between the two.
  bool was_away(const std::string& node, double from, double until) const;
};

/// Reads a log in the order of time.
History history_of(const scenario::Scenario& scenario, const std::vector<journal::Record>& records);

/// "perceive P1 120 [end-before 300]", as goals are stated in the log.
mission::HighLevelTask task_from(std::string_view statement);

}  // namespace skein::laws
