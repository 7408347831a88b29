// SPDX-License-Identifier: Apache-2.0
// Decision nodes that merge their ways, with vehicles that fly straight at their points, and a
// radio between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/merging/witness.hpp"
#include "testing/flown_node.hpp"

namespace skein::decision_node::testing {

using world::Vector3;

inline world::VehicleModel quick_helicopter() {
  world::VehicleModel model;
  model.hovers = true;
  model.cruise_speed = model.max_speed = 10;
  model.climb_rate = model.descent_rate = 5;
  model.acceleration = 5;
  model.ceiling = 200;
  model.yaw_rate = 1;
  model.energy.capacity = 1e6;
  model.body_radius = 1;
  model.position_precision = 0.3;
  return model;
}

/// It cannot hover.
inline world::VehicleModel quick_blimp() {
  world::VehicleModel model = quick_helicopter();
  model.hovers = false;
  model.orbit_radius = 15;
  model.min_turn_radius = 10;
  return model;
}

inline world::VehicleModel model_of(const std::string& uav) {
  return uav.starts_with("blimp") ? quick_blimp() : quick_helicopter();
}

inline executive::Start goto_of(std::uint64_t id, std::vector<double> waypoints) {
  executive::Start start = start_of(id, "goto");
  start.task.parameters = {{"waypoints", "", std::move(waypoints)}};
  return start;
}

inline executive::Start takeoff_of(std::uint64_t id, double altitude) {
  executive::Start start = start_of(id, "takeoff");
  start.task.parameters = {{"altitude", "", {altitude}}};
  return start;
}

/// What a UAV at degree 4 has to know, without anything that it could plan but a visit.
inline std::shared_ptr<const supervisor::Knowledge> knowledge_of(const std::string& uav) {
  auto knowledge = std::make_shared<supervisor::Knowledge>();
  knowledge->uav = uav;
  knowledge->vehicle = model_of(uav);
  knowledge->vocabulary.tasks["visit"] = {"visit", {}, {}};
  return knowledge;
}

class MergedTeam {
 public:
  /// In that order in the roster, each at its place: on the ground where z is 0. Who is called
  /// blimp cannot hover.
  /// With a contact-loss policy the ground station is the third of each pair; carried out after 5
  /// s.
  explicit MergedTeam(const std::vector<std::pair<std::string, Vector3>>& places, int degree = 3,
                      ContactPolicy policy = ContactPolicy::kContinue,
                      const std::vector<world::Volume>& closed = {}) {
    for (const auto& [name, place] : places) names_.push_back(name);
    for (const auto& [name, place] : places) {
      Config config;
      config.uav = name;
      config.merging = {names_, model_of(name), {}, level_ground(), {}};
      config.degree = degree;
      if (name == names_.back()) config.contact_policy = policy;
      config.contact_after = Duration::seconds(5);
      if (policy != ContactPolicy::kContinue) config.merging->witness = kGround;
      if (degree >= 4) {
        config.knowledge = knowledge_of(name);
        const world::AirspaceGrid air{{-400, -400, 0}, 20, {40, 40, 12}};
        config.world = std::make_shared<world::World>(
            world::World{{}, *level_ground(), {}, air, closed, {}, {}, {}, {}});
      }
      Uav& uav = uavs_[name];
      uav.node = std::make_unique<DecisionNode>(config);
      uav.state.position = place;
      uav.state.airborne = place.z() > 0;
      give(name, Started{true});
    }
    witness_ = merging::Witness(names_);
    witness_.begin(true, now_);
    for (const std::string& one : names_) {
      for (const std::string& other : names_)
        if (one != other) give(one, Contact{other, false, true});
      give(one, Contact{kGround, true, true});
    }
    run(1.5);
  }

  static std::shared_ptr<const world::Terrain> level_ground() {
    world::TerrainSpec spec;
    spec.west = spec.south = -1000;
    spec.east = spec.north = 1000;
    return std::make_shared<world::Terrain>(spec);
  }

  void command(const std::string& uav, mission::Request request) {
    give(uav, Command{{1, ++commands_}, std::move(request)});
  }

  /// Of the ground station, in the place of the UAV's executive: at degree 1.
  void dispatch(const std::string& uav, std::uint64_t id, const std::string& type,
                functional::Parameters parameters) {
    const functional::TaskId task{id};
    give(uav, ElementaryRequest{{functional::Verb::kDispatch, task, type, std::move(parameters)}});
  }

  /// Its plan is this flight, for a goal that it is given.
  void plan(const std::string& uav, const executive::Start& flight) {
    mission::ElementaryTask task;
    task.id = flight.task.id;
    task.type = flight.task.type;
    task.parameters = flight.task.parameters;
    task.duration = {Duration::seconds(1), Duration::seconds(300)};
    plan(uav, std::vector{std::move(task)});
  }

  /// The same of these tasks.
  void plan(const std::string& uav, std::vector<mission::ElementaryTask> tasks) {
    for (mission::ElementaryTask& one : tasks) one.origin = mission::GoalId(701);
    uavs_[uav].planned = std::move(tasks);
    mission::UnitMission mission;
    mission.id = mission::MissionId(1);
    mission.tasks.push_back({mission::GoalId(701), "visit", {}, {}});
    command(uav, mission);
  }

  /// In tenths of seconds.
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 10 + 0.5); ++i) {
      now_ = now_ + Duration::milliseconds(100);
      const auto messages = std::exchange(radio_, {});
      for (const auto& [to, told] : messages)
        if (!cut_.contains({told.from, to}) && !cut_.contains({to, told.from})) hear(to, told);
      if (!searches_withheld_) search();
      plan();
      for (const std::string& name : names_) fly(name);
      for (const std::string& name : names_) wake(name);
    }
  }

  /// How often vehicles say where they are [0.1 s].
  void tell_every(int tenths) { telemetry_tenths_ = tenths; }
  /// Searches for ways that are asked for do not end from now on, or do, with their results.
  void withhold_searches(bool withhold) { searches_withheld_ = withhold; }
  int searches_asked_by(const std::string& uav) {
    return static_cast<int>(uavs_[uav].searches.size());
  }
  /// It is on the ground from now on, and aborts whatever it is given.
  void put_down(const std::string& uav) { uavs_[uav].is_put_down = true; }
  /// It aborts whatever it is given from now on, or does not any more.
  void refuse(const std::string& uav, bool refuses) { uavs_[uav].refuses = refuses; }
  int given(const std::string& uav) { return uavs_[uav].given; }
  /// Waits and looks last until they are interrupted from now on; else they end at once.
  void let_waits_last() { waits_last_ = true; }
  /// Whenever it has nothing to fly it flies circles of 15 m at 10 m/s from now on.
  void circle(const std::string& uav) { uavs_[uav].circles = true; }
  /// So much of its energy is left from now on.
  void drain(const std::string& uav, double left) { uavs_[uav].state.energy = left; }
  /// Who asked to be woken at one instant again and again.
  const std::set<std::string>& restless() const { return restless_; }

  void cut(const std::string& one, const std::string& other) {
    cut_.insert({one, other});
    give(one, Contact{other, false, false});
    give(other, Contact{one, false, false});
  }

  void cut_from_all(const std::string& uav) {
    for (const std::string& other : names_)
      if (other != uav) cut(uav, other);
    cut_from_ground(uav);
  }

  void cut_from_ground(const std::string& uav) {
    cut_.insert({uav, kGround});
    give(uav, Contact{kGround, true, false});
  }

  void heal_with_ground(const std::string& uav) {
    cut_.erase({uav, kGround});
    give(uav, Contact{kGround, true, true});
  }

  /// Of the UAV's tasks, in the order in which they began to be flown.
  std::vector<std::uint64_t> begun(const std::string& uav) { return uavs_[uav].begun; }
  bool is_over(const std::string& uav, std::uint64_t task) {
    return uavs_[uav].over.contains(task);
  }
  std::vector<AirNoted> notes(const std::string& uav) { return uavs_[uav].notes; }
  std::vector<std::string> notices(const std::string& uav) { return uavs_[uav].notices; }
  /// What the ground station was told of its tasks.
  std::vector<functional::Status> passed_on(const std::string& uav) { return uavs_[uav].passed; }
  std::vector<executive::TaskEvent> events(const std::string& uav) { return uavs_[uav].events; }
  const world::VehicleState& state(const std::string& uav) { return uavs_[uav].state; }
  double highest(const std::string& uav) { return uavs_[uav].highest; }
  MissionTime now() const { return now_; }

 private:
  struct Uav {
    std::unique_ptr<DecisionNode> node;
    world::VehicleState state;
    std::optional<functional::Request> task;
    std::vector<Vector3> way;
    std::vector<std::uint64_t> begun;
    std::set<std::uint64_t> over;
    std::vector<AirNoted> notes;
    std::vector<std::string> notices;
    std::vector<executive::TaskEvent> events;
    std::vector<functional::Status> passed;
    double highest = 0;
    bool stopped = false;  ///< in what it flies
    bool is_put_down = false, refuses = false, circles = false;
    double turned = 0;  ///< on its circles [rad]
    int given = 0;      ///< requests
    std::set<functional::TaskId> lasting;
    std::vector<functional::Status> to_tell;
    std::vector<StartWaySearch> searches;
    std::vector<mission::ElementaryTask> planned;
    std::vector<std::uint64_t> jobs;  ///< of planning
    int flown = 0;                    ///< [0.1 s]
  };

  void plan() {
    for (const std::string& name : names_) {
      for (const std::uint64_t job : std::exchange(uavs_[name].jobs, {})) {
        supervisor::InsertionOutcome outcome;
        outcome.plan.emplace().tasks = uavs_[name].planned;
        outcome.order = {{uavs_[name].planned.front().origin, "visit", {}, {}}};
        outcome.chosen = mission::Placement::kLast;
        give(name, supervisor::JobFinished{job, outcome});
      }
    }
  }

  void search() {
    for (const std::string& name : names_)
      for (const StartWaySearch& one : std::exchange(uavs_[name].searches, {}))
        give(name, WaySearched{one.job, search_way(one.search)});
  }

  void wake(const std::string& name) {
    constexpr int kMost = 20;
    for (int times = 0; times < kMost; ++times) {
      const auto wakeup = uavs_[name].node->next_wakeup();
      if (!wakeup || *wakeup > now_) return;
      give(name, Tick{});
    }
    restless_.insert(name);
  }

  void hear(const std::string& to, const MergeTold& told) {
    if (to != kGround) return give(to, told);
    for (const auto& answer : witness_.hear(told.from, told.message, now_))
      radio_.emplace_back(answer.to, MergeTold{kGround, answer.message});
  }

  void give(const std::string& name, const Input& input) {
    Uav& uav = uavs_[name];
    for (const Effect& effect : uav.node->handle(input, now_)) {
      if (const auto* send = std::get_if<SendMerge>(&effect))
        radio_.emplace_back(send->to, MergeTold{name, send->message});
      if (const auto* to = std::get_if<ToVehicle>(&effect)) take(uav, to->request);
      if (const auto* job = std::get_if<StartWaySearch>(&effect)) uav.searches.push_back(*job);
      if (const auto* job = std::get_if<supervisor::StartDeliberation>(&effect))
        uav.jobs.push_back(job->job);
      if (const auto* note = std::get_if<AirNoted>(&effect)) uav.notes.push_back(*note);
      if (const auto* notice = std::get_if<Notice>(&effect)) uav.notices.push_back(notice->text);
      if (const auto* status = std::get_if<StatusPassedOn>(&effect))
        uav.passed.push_back(status->status);
      if (const auto* task = std::get_if<TaskChanged>(&effect)) {
        uav.events.push_back(task->event);
        if (is_terminal(task->event.state)) uav.over.insert(task->event.id.value());
      }
    }
  }

  void take(Uav& uav, const functional::Request& request) {
    ++uav.given;
    if (uav.lasting.erase(request.id) > 0)
      return uav.to_tell.push_back({request.id, functional::TaskState::kAborted, "interrupted"});
    if (request.verb == functional::Verb::kInterrupt) {
      if (uav.task && uav.task->id == request.id) {
        uav.way.clear();
        uav.stopped = true;
      }
      return;
    }
    uav.begun.push_back(request.id.value());
    if (!uav.refuses) uav.to_tell.push_back({request.id, functional::TaskState::kRunning, ""});
    if (request.type == "wait" || request.type == "takeshot") {
      if (waits_last_)
        uav.lasting.insert(request.id);
      else
        uav.to_tell.push_back({request.id, functional::TaskState::kEnded, ""});
      return;
    }
    uav.task = request;
    uav.stopped = false;
    const Vector3& at = uav.state.position;
    if (request.type == "takeoff")
      uav.way = {{at.x(), at.y(), request.parameters.find("altitude")->numbers.front()}};
    if (request.type == "land") uav.way = {{at.x(), at.y(), 0}};
    const auto* points = request.parameters.find("waypoints");
    if (points == nullptr) return;
    uav.way.clear();
    for (std::size_t i = 0; i + 2 < points->numbers.size(); i += 3)
      uav.way.emplace_back(points->numbers[i], points->numbers[i + 1], points->numbers[i + 2]);
  }

  // A metre in a tenth of a second; what it does runs from there on, and is over when there is no
  // further point.
  void fly(const std::string& name) {
    Uav& uav = uavs_[name];
    for (const functional::Status& status : std::exchange(uav.to_tell, {}))
      give(name, StatusTold{status});
    Vector3& at = uav.state.position;
    const Vector3 before = at;
    if (uav.is_put_down) {
      at.z() = 0;
      uav.way.clear();
      uav.stopped = true;
    }
    if (uav.refuses && uav.task) {
      uav.way.clear();
      return give(name, StatusTold{{std::exchange(uav.task, std::nullopt)->id,
                                    functional::TaskState::kAborted, "refused"}});
    }
    if (!uav.way.empty()) {
      const Vector3 to = uav.way.front() - at;
      at = to.norm() <= 1 ? uav.way.front() : Vector3(at + to.normalized());
      if (to.norm() <= 1) uav.way.erase(uav.way.begin());
    }
    if (uav.way.empty() && uav.circles && at.z() > 0) {
      uav.turned += 1 / kCircle;
      at += Vector3(std::cos(uav.turned), std::sin(uav.turned), 0);
    }
    uav.state.velocity = 10 * (at - before);
    uav.state.airborne = at.z() > 0.1;
    uav.highest = std::max(uav.highest, at.z());
    if (++uav.flown % telemetry_tenths_ == 0)
      give(name, world::Telemetry{name, uav.state, now_, {}});
    if (!uav.task || !uav.way.empty()) return;
    const functional::TaskId id = std::exchange(uav.task, std::nullopt)->id;
    const auto over = std::exchange(uav.stopped, false) ? functional::TaskState::kAborted
                                                        : functional::TaskState::kEnded;
    give(name, StatusTold{{id, over, ""}});
  }

  static constexpr const char* kGround = "ground";
  static constexpr double kCircle = 15;  // [m]
  std::vector<std::string> names_;
  merging::Witness witness_{{}};
  std::set<std::string> restless_;
  bool searches_withheld_ = false;
  bool waits_last_ = false;
  int telemetry_tenths_ = 1;
  std::map<std::string, Uav> uavs_;
  std::vector<std::pair<std::string, MergeTold>> radio_;
  std::set<std::pair<std::string, std::string>> cut_;
  MissionTime now_;
  std::uint64_t commands_ = 0;
};

/// The note of the air that it was granted last for a motion.
inline const AirNoted& last_had(const std::vector<AirNoted>& notes) {
  return *std::find_if(notes.rbegin(), notes.rend(),
                       [](const AirNoted& one) { return one.state == "had"; });
}

/// A goto along which something is looked at.
inline void give_sweep(MergedTeam& team, const std::string& uav, executive::Start motion) {
  executive::Start look = start_of(motion.task.id.value() + 1, "takeshot");
  look.task.preconditions = {
      {{executive::TaskInState{motion.task.id, executive::TaskState::kRunning}}}};
  motion.task.preconditions = {{{executive::MessageReceived{"go"}}}};
  team.command(uav, motion);
  team.command(uav, look);
  team.command(uav, executive::ProcessMessage{"go"});
}

/// At every height that heliv could fly past, and out of its reach, so that nobody makes room.
inline MergedTeam before_a_wall() {
  std::vector<std::pair<std::string, world::Vector3>> places{{"heliv", {100, 0, 40}}};
  for (int i = 0; i <= 5; ++i)
    places.push_back({"wall" + std::to_string(i), {0, 0, 40.0 + 12 * i}});
  MergedTeam team(places, 4);
  for (int i = 0; i <= 5; ++i) team.cut("heliv", "wall" + std::to_string(i));
  return team;
}

}  // namespace skein::decision_node::testing
