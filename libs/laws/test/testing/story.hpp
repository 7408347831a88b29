// SPDX-License-Identifier: Apache-2.0
// Logs made by hand, for the tests of the laws.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/journal/line.hpp"
#include "skein/laws/laws.hpp"

namespace skein::laws::testing {

/// A task of a goal (0: of none), from begin to end.
struct Doing {
  int task;
  std::string type;
  int goal;
  double from, until;
  std::string end = "ended";
  std::string device = "";
  std::vector<double> target = {};
  std::string reason = "";
  double begins = 0;  ///< when the vehicle begins with it; 0: at once
};
/// What became of a mission; with figures, what it was said to take.
struct Answered {
  int mission;
  bool planned;
  bool evaluated = false;
  double energy = 0, earliest_end = 0, latest_end = 0;
};

/// What happened to Marvin and Heliv (and Karma), written down line by line in any order. Level
/// ground; places: P1 at (150, 60, 0), A1 at (150, 60, 50); zone Z of 100 m by 100 m about P1;
/// everyone starts at (0, 0).
class Story {
 public:
  /// `more`: lines of the scenario under `world:` (indented by two), such as volumes.
  explicit Story(const std::string& more = "", const std::string& script = "",
                 const std::string& uav_more = "");
  /// With Mana too, a robot that keeps to the ground.
  static Story with_a_robot() { return Story("", "", kRobot); }
  /// The ground rises there.
  Story& hill(const world::HillSpec& hill) {
    scenario_.world.terrain.hills.push_back(hill);
    return *this;
  }
  Story& relay(const std::string& uav) {
    scenario_.radio.relays.push_back(uav);
    return *this;
  }
  /// The script gives the team a mission.
  Story& global_mission(std::vector<team::GlobalTask> tasks) {
    ground_station::SendGlobalMission send;
    send.mission = {mission::MissionId(1), std::move(tasks), "step give"};
    scenario_.ground.script.steps.push_back({"give", "", {}, {}, {std::move(send)}});
    return *this;
  }
  /// Its model declares it.
  Story& figure(const std::string& uav, const std::string& name, double value) {
    for (scenario::UavSpec& one : scenario_.uavs)
      if (one.name == uav) one.model.abilities[name] = value;
    return *this;
  }
  /// For so long its vehicle aborts all tasks of a type [s].
  Story& refuses(double at, const std::string& uav, const std::string& type, double lasts) {
    scenario_.faults.aborts.push_back(
        {MissionTime::seconds(at), uav, type, Duration::seconds(lasts)});
    return *this;
  }
  /// So long may a job of planning take [s].
  Story& plans_in(double seconds) {
    scenario_.planning->takes_most = Duration::seconds(seconds);
    return *this;
  }
  /// Of each link [bit/s], and what it loses of what is not repeated.
  Story& capacity(double bits_per_second, double loss = 0) {
    scenario_.radio.model.capacity = bits_per_second;
    scenario_.radio.model.loss = loss;
    return *this;
  }
  world::Terrain terrain() const { return world::Terrain(scenario_.world.terrain); }

  /// Telemetry once a second: from a to b in a straight line, level with a heading along it.
  Story& flies(const std::string& uav, double from, double until, world::Vector3 a,
               world::Vector3 b, double energy = 0.9);
  Story& stands(const std::string& uav, double from, double until, world::Vector3 at = {0, 0, 0});
  /// A task of a goal, in the executive and on the vehicle.
  Story& does(const std::string& uav, const Doing& what);
  /// The ground station's executive, at degree 1, starts it, and the UAV does not hear of it; or
  /// gives it up, since it has heard no end of it.
  Story& starts_unheard(const std::string& uav, double at, int task, const std::string& type,
                        const std::string& state = "started");
  Story& goal(const std::string& uav, int id, const std::string& statement,
              const std::string& state, double at, const std::string& why = "");
  Story& says(const std::string& uav, double at, const std::string& text);
  /// A joint task, with its reason.
  Story& leaves(const std::string& uav, double at, const std::string& why);
  Story& decides(const std::string& uav, double at, const std::string& applied,
                 const std::string& cause, const std::string& outcome);
  Story& answer(const std::string& uav, double at, const Answered& what);
  Story& degree(const std::string& uav, double at, int degree);
  /// Its contact-loss policy is carried out.
  Story& contact(const std::string& uav, double at, const std::string& policy);
  /// Of the script, or a scripted operator does it: one UAV is told of it.
  Story& step(double at, const std::string& name, const std::string& told,
              bool by_operator = false);
  /// The ground station says when others come.
  Story& dates_by_ground();
  /// Where perceptions put an alarm.
  Story& alarm(double at, int id, world::Vector3 where);
  /// A fire that spreads along a ray from (x, y), half so long and half so broad, in truth.
  Story& burns(double at, world::Vector2 from, double length, double breadth);
  /// Where the ground station says that an object was seen, and when.
  Story& object_seen(double told, double seen, world::Vector3 where, double spread);
  /// Where a task of the team stands, as the ground has it.
  Story& owner(double at, int task, const std::string& stage, int sale, const std::string& owners,
               const std::string& why);
  /// What a UAV does with one.
  Story& team(const std::string& uav, double at, int task, int sale, const std::string& state,
              const std::string& why = "");
  /// It plans a goal by its first task: to end by `latest` [s].
  Story& plans(const std::string& uav, double at, int goal, double latest);
  /// What it knows of who comes to a meeting, if he comes at all.
  Story& foretold(const std::string& uav, double at, int meeting, const std::string& last,
                  std::optional<double> soonest);
  Story& hears(const std::string& uav, double at, int meeting, const std::string& from,
               const std::string& word = "");
  /// One tells another of its plan; that hears it at `heard`, if at all.
  Story& plan_word(const std::string& from, const std::string& to, double at,
                   std::optional<double> heard, std::uint64_t arcs = 0);
  /// What becomes of a motion that needs air; of one that waits, for whom and why.
  Story& air(const std::string& uav, double at, const std::string& state,
             const std::string& waits_for = "");
  Story& link(double at, const std::string& from, const std::string& to, bool up);
  Story& fault(double at, const std::string& what, const std::string& uav);

  /// Any line.
  Story& line(journal::Record record);

  /// Sentences of what one law has to say.
  std::vector<std::string> broken(const std::string& law) const;
  /// And of UAVs that were too near to each other, whether anybody asks or not.
  std::vector<std::string> too_near() const;

 private:
  static constexpr const char* kRobot =
      "}\n  mana: {model: ../action/models/mana.yaml, start: [0, 0], degree: 4";
  template <class Line>
  Story& add(double at, const std::string& node, Line what) {
    return line(journal::record_of(MissionTime::seconds(at), node, std::move(what)));
  }

  std::vector<journal::Record> ordered() const;

  scenario::Scenario scenario_;
  std::vector<journal::Record> records_;
};

}  // namespace skein::laws::testing
