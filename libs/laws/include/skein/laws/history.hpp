// SPDX-License-Identifier: Apache-2.0
// The history of a run by UAV, from the event log: the simulator's truth, executions of tasks,
// states of goals, and reports.
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

/// True state of a vehicle at an instant.
struct Sample {
  double at = 0;  ///< [s]
  world::Vector3 position = world::Vector3::Zero();
  world::Vector3 velocity = world::Vector3::Zero();
  double heading = 0;
  double energy = 1;
  bool airborne = false;
};

/// A task that the vehicle truly carried out, or refused (then `from` equals `until`). A task that
/// the functional layer lost and began anew gives two activities.
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

/// The execution of a task by an executive, on board or at the ground.
struct Execution {
  std::int64_t task = 0;
  std::string type;
  double started = kNever, over = kNever;
  std::string state, reason;
  std::string node;         ///< node of the last executive: the UAV's, or the ground's at degree 1
  double taken = kNever;    ///< when that executive started it
  double running = kNever;  ///< when an executive first had it running

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
  /// When it last entered `state`; absent: never.
  std::optional<double> when(std::string_view state) const;
  double received() const { return changes.front().at; }
};

/// The outcome of a mission that was requested, or only evaluated (then with its estimate).
struct Answer {
  double at = 0;
  std::int64_t mission = 0;
  bool planned = false, evaluated = false;
  double energy = 0;  ///< fraction of the full capacity
  double earliest_end = kNever, latest_end = kNever;
};

/// A closed volume of air, and when one UAV knows of it.
struct Closing {
  world::Volume volume;
  double known = 0;  ///< from when on the UAV knows it [s]
  double opened = kNever;
};

/// Something said: a notice, why a joint task is left, or the cause and outcome of a decision.
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

/// A UAV's report on what it knows of the partners of a meeting.
struct Foretold {
  double at = 0;
  std::int64_t id = 0;
  bool known = false;
  std::string last;  ///< the partner that comes last; empty: it waits for nobody
  double soonest = kNever;
};

/// A UAV sends `other` its plan's network, or receives that of `other`.
struct PlanWord {
  double at = 0;
  std::string other;
  bool sent = false;
  std::uint64_t arcs = 0;  ///< of the network that was told
};

/// True state of an object at an instant.
struct ObjectState {
  double at = 0;
  std::string kind;
  world::Vector2 position = world::Vector2::Zero();
  double radius = 0;
  bool active = false;
  std::optional<world::FireFront> front = {};  ///< of a fire that spreads

  /// Distance of a point from the area that the object covers [m].
  double distance_to(const world::Vector2& point) const;
};

/// The ground station's report of an object's position.
struct ObjectTold {
  double told = 0, seen = 0;  ///< when reported, and when sighted [s]
  std::string name;
  world::Vector3 position = world::Vector3::Zero();
  double spread = 0;  ///< [m]
};

/// A place that the ground station told a UAV of, as it lies from then on.
struct PlaceKnown {
  double at = 0;  ///< when the UAV heard of it [s]
  std::string name;
  world::Vector3 position = world::Vector3::Zero();
};

struct Uav {
  const scenario::UavSpec* spec = nullptr;
  std::vector<Sample> samples;  ///< once a second
  std::vector<Activity> activities;
  std::map<std::int64_t, Execution> executions;
  std::map<std::int64_t, Goal> goals;
  std::map<std::int64_t, std::int64_t> goal_of;  ///< goal by task, from its plans
  /// By goal: the latest end that its first plan, of that revision, allowed [s].
  std::map<std::int64_t, std::pair<std::uint64_t, double>> promised;
  std::vector<std::pair<double, int>> degrees;  ///< (from when on, degree)
  std::vector<Closing> closings;
  std::vector<PlaceKnown> places_known;
  std::vector<Word> words;
  std::vector<std::pair<double, std::string>> faults;
  std::vector<SyncHeard> syncs_heard;
  std::vector<Foretold> foretold;
  std::vector<PlanWord> plan_words;
  std::vector<Answer> answers;
  std::map<std::string, std::vector<double>> events_to;  ///< by receiver, when each was sent

  const std::string& name() const { return spec->name; }
  int degree(double at) const;
  /// At degree 4 or 5 during all of it.
  bool deliberates(double from, double until) const;
  /// Interpolated; nothing before the first and after the last sample.
  std::optional<Sample> at(double instant) const;
  /// Whether the vehicle is in the air, or, for a ground vehicle, under way.
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
  std::set<std::string> resumed;  ///< those of `dead` that always restarted with their memory
  /// Reported positions of "alarm:1" etc. by instant. A ground station without its memory begins to
  /// number alarms anew.
  std::map<std::string, std::map<double, world::Vector3>> alarms;
  std::map<std::string, std::vector<ObjectState>> objects;  ///< in truth, by name
  std::vector<ObjectTold> objects_told;
  double end = 0;
  bool finished = false;  ///< by the ground's script
  JointHistory joint = {};
  TeamHistory team = {};
  AirHistory air = {};
  std::vector<Word> unread = {};  ///< malformed lines, of kinds that laws read
  /// Down times of nodes that died, (from, until); until kNever: they did not restart.
  std::map<std::string, std::vector<std::pair<double, double>>> away = {};
  /// When an operator had declared UAVs lost, (from, until); until kNever: it was not taken back.
  std::map<std::string, std::vector<std::pair<double, double>>> lost = {};
  /// [s] by which clocks of nodes may differ and what passes between them may be late, beside what
  /// the scenario's radio says: 0 in virtual time.
  double late = 0;

  /// The position that an argument names: a place of the scenario, an alarm or a tracked object as
  /// known at `at`, or the point itself; absent: the argument is no place.
  std::optional<world::Vector3> place(const mission::Argument& argument, double at = kNever) const;
  /// Where the place that an argument names lay in [from, until], as far as the UAV had been told;
  /// several if it was told meanwhile that it lies elsewhere; none: the argument is no place.
  std::vector<world::Vector3> places(const Uav& uav, const mission::Argument& argument, double from,
                                     double until) const;
  /// Whether the UAV was told of the place that the argument names.
  bool was_told_of(const Uav& uav, const mission::Argument& argument) const;
  /// Whether the place is in the air and flown to (else it is on the ground and looked at).
  bool in_the_air(const world::Vector3& place) const;
  const world::Zone* zone(const mission::Argument& argument) const;
  /// Whether the node died, and did not restart with its memory: laws excuse only such nodes.
  bool was_killed(const std::string& node) const;
  bool is_alarm(const mission::Argument& argument) const;
  /// Whether the argument names an object whose position the ground station reports repeatedly.
  bool is_followed(const mission::Argument& argument) const;
  /// Whether the node was down at some time in [from, until].
  bool was_away(const std::string& node, double from, double until) const;
  /// Since when the UAV is declared lost at that instant.
  std::optional<double> lost_since(const std::string& uav, double at) const;
};

/// Reads a log in the order of time.
History history_of(const scenario::Scenario& scenario, const std::vector<journal::Record>& records);

/// "perceive P1 120 [end-before 300]", as goals are stated in the log.
mission::HighLevelTask task_from(std::string_view statement);

}  // namespace skein::laws
