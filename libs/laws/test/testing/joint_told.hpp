// SPDX-License-Identifier: Apache-2.0
// A log of a joint task of two, said line by line.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/radio.hpp"

namespace skein::laws::testing {

inline constexpr const char* kJoint = "watching(P1 60) of heliv, marvin";

/// A log of Marvin and Heliv, of whom one is to watch and one to relay.
class Told {
 public:
  Told() {
    interaction::Variant variant;
    variant.name = "pair";
    variant.parameters = {{"front", interaction::ParameterType::kObj},
                          {"time", interaction::ParameterType::kTime}};
    variant.roles = {"watch", "relay"};
    variant.table.arities = {{"watch", {1, 1}}, {"relay", {1, std::nullopt}}};
    variant.table.scms = {{"far", "separation", {{"from", "front"}, {"least", 20.0}}},
                          {"apart", "separation", {{"from", "R*"}, {"least", 20.0}}}};
    variant.table.places = {{"far", "watch", {"w0"}}};
    variant.table.parameters["watch"] = {{"seconds", "time"}};
    interaction::Library library;
    library.models["watching"] = {"watching", {variant}};
    library.roles["watch"] = {"watch", {}, {}, watching()};
    library.roles["relay"] = {"relay", {}, {}, {}};
    interaction::SpatialConstraint constraint;
    constraint.of = {"from"};
    constraint.relation = interaction::Relation::kGreater;
    constraint.than = interaction::Term("least");
    library.scms["separation"] = {"separation", {{"from", true}, {"least", false}}, {constraint}};
    scenario_.interaction = std::make_shared<const interaction::Library>(library);
    scenario_.world.places["P1"] = {100, 0, 0};
    for (const char* name : {"heliv", "marvin"}) {
      scenario_.uavs.push_back({});
      scenario_.uavs.back().name = name;
      scenario_.uavs.back().model.hovers = true;
    }
  }

  Told& phase(double at, const std::string& uav, const std::string& phase, const std::string& role,
              const std::string& why = "", std::uint64_t task = 7) {
    return see(at, uav,
               journal::lines::Joint{.uav = uav,
                                     .joint = kJoint,
                                     .task = task,
                                     .variant = "pair",
                                     .phase = phase,
                                     .role = role,
                                     .why = why});
  }
  Told& link(double at, bool up, const std::string& to = "marvin",
             const std::string& from = "heliv") {
    return see(at, "sim", journal::lines::Link{.from = from, .to = to, .up = up});
  }
  Told& task(double at, const std::string& uav, const std::string& type) {
    return see(at, uav,
               journal::lines::RoleTask{
                   .uav = uav, .joint = kJoint, .role = "watch", .componel = "w2", .type = type});
  }
  Told& componel(double at, const std::string& uav, const std::string& name,
                 const std::string& state) {
    return see(at, uav,
               journal::lines::Role{
                   .uav = uav, .joint = kJoint, .role = "watch", .componel = name, .state = state});
  }
  Told& session(double at, const std::string& uav, const std::string& state,
                const std::string& rows = "") {
    return see(at, uav,
               journal::lines::Negotiation{.uav = uav,
                                           .joint = kJoint,
                                           .opener = "heliv",
                                           .opened = 3,
                                           .state = state,
                                           .rows = rows});
  }
  /// By heliv: agreed upon at both.
  Told& asked_for_roles(double opened, double agreed, const std::string& rows) {
    for (const std::string uav : {"heliv", "marvin"})
      see(agreed, uav,
          journal::lines::Negotiation{.uav = uav,
                                      .joint = std::string(kJoint) + "/role-allocation",
                                      .opener = "heliv",
                                      .opened = opened,
                                      .state = "agreed",
                                      .rows = rows});
    return *this;
  }
  Told& place(double at, const std::string& uav, const std::string& scm,
              const std::vector<double>& position) {
    return see(
        at, uav,
        journal::lines::Place{
            .uav = uav, .joint = kJoint, .role = "watch", .position = position, .scms = scm});
  }
  Told& is_at(const std::string& uav, const world::Vector3& position) {
    return is_along(uav, {{0, position}, {1000, position}});
  }
  /// Straight from each place to the next, which it is at then.
  Told& is_along(const std::string& uav, std::vector<std::pair<double, world::Vector3>> way) {
    at_[uav] = std::move(way);
    return *this;
  }
  /// Where sensors say that a thing is.
  Told& seen(double at, const std::string& name, const world::Vector3& where) {
    seen_.push_back({at, at, name, where, 2});
    return *this;
  }
  Told& told_of(double at, const std::string& name, const world::Vector3& position) {
    joint_.points.push_back({at, name, position});
    return *this;
  }

  /// By a task of the role to watch.
  Told& perceives(const std::string& uav, std::int64_t task, double from, double until) {
    activities_[uav].push_back(
        {task, "perceive", "visible", std::nullopt, from, until, "ended", ""});
    return see(from, uav,
               journal::lines::RoleTask{.uav = uav,
                                        .joint = kJoint,
                                        .role = "watch",
                                        .componel = "w1",
                                        .task = static_cast<std::uint64_t>(task)});
  }
  /// Who watches shares P1, an area, with the others; all look down.
  Told& shares(const world::Polygon& field) {
    interaction::Library library = *scenario_.interaction;
    interaction::CoordinationAction sharing{"area-sharing", {}, {}};
    sharing.in.kind = config::Value::Kind::kMap;
    config::Value area;
    area.kind = config::Value::Kind::kScalar;
    area.scalar = "field";
    sharing.in.entries.push_back({"area", area});
    library.roles["watch"].automaton.add({"a1", 0, sharing, "", 0});
    library.models["watching"].variants.front().table.parameters["watch"]["field"] = "front";
    scenario_.interaction = std::make_shared<const interaction::Library>(library);
    scenario_.world.zones.push_back({"P1", field});
    for (scenario::UavSpec& spec : scenario_.uavs) {
      world::SensorModel sensor;
      sensor.device = "visible";
      sensor.boresight_pitch = -1.5708;
      sensor.aperture = 0.9;
      sensor.range = 200;
      spec.model.sensors = {sensor};
    }
    airborne_ = true;
    return *this;
  }
  /// Who watches follows P1 by task f1, for as long as asked.
  Told& follows() {
    interaction::Library library = *scenario_.interaction;
    interaction::Task following{"follow", {}};
    following.parameters.kind = config::Value::Kind::kMap;
    config::Value target;
    target.kind = config::Value::Kind::kScalar;
    target.scalar = "what";
    following.parameters.entries.push_back({"target", target});
    const interaction::TimeIs::Event runs{1, interaction::AskedState::kRunning};
    interaction::Block until;
    until.exit = {{{interaction::TimeIs{{}, runs, true, "seconds"}}}};
    interaction::Automaton role;
    role.add({"w0", 0, until, "", 0});
    role.add({"f1", 0, following, "", 0});
    library.roles["watch"].automaton = role;
    library.models["watching"].variants.front().table.parameters["watch"]["what"] = "front";
    scenario_.interaction = std::make_shared<const interaction::Library>(library);
    return *this;
  }
  /// Who watches spreads anew when it is called to.
  Told& spreads() {
    interaction::Library library = *scenario_.interaction;
    interaction::Block again;
    again.precondition = {{{interaction::MessagePending{"perception-positions invitation"}}}};
    library.roles["watch"].automaton.add({"w2", 0, again, "", 0});
    scenario_.interaction = std::make_shared<const interaction::Library>(library);
    return *this;
  }
  /// From when on it has nothing to do but the joint task.
  Told& due(double at, const std::string& uav) {
    due_[uav] = at;
    return *this;
  }
  Told& dies(const std::string& uav, double from, double until) {
    away_[uav].emplace_back(from, until);
    return *this;
  }
  Told& goal(double at, const std::string& uav, const std::string& state) {
    Goal& one = goals_[uav];
    one.id = 70;
    one.task.name = "watching";
    one.changes.push_back({at, state, ""});
    return *this;
  }

  template <class Law>
  std::vector<std::string> broken(Law law) const {
    world::TerrainSpec ground;
    ground.west = ground.south = -500;
    ground.east = ground.north = 500;
    History history{&scenario_, world::Terrain(ground), {}, {}, {}, {}, {}, {}, 1000, false,
                    joint_};
    history.objects_told = seen_;
    history.away = away_;
    for (const scenario::UavSpec& spec : scenario_.uavs) {
      Uav& uav = history.uavs[spec.name];
      uav.spec = &spec;
      uav.goal_of[7] = 70;
      uav.degrees = {{0, 4}};
      if (due_.contains(spec.name)) {
        uav.executions[7].started = due_.at(spec.name);
        uav.executions[7].type = "joint:watching";
      }
      if (activities_.contains(spec.name)) uav.activities = activities_.at(spec.name);
      if (goals_.contains(spec.name)) uav.goals[70] = goals_.at(spec.name);
      const auto at = at_.find(spec.name);
      if (at == at_.end()) continue;
      for (const auto& [instant, position] : at->second) {
        uav.samples.push_back({instant, position});
        uav.samples.back().airborne = airborne_;
      }
    }
    std::vector<std::string> sentences;
    for (const Violation& one : law(history)) sentences.push_back(one.sentence);
    return sentences;
  }

 private:
  template <class Line>
  Told& see(double at, const std::string& node, Line line) {
    EXPECT_TRUE(joint_.see(journal::record_of(MissionTime::seconds(at), node, std::move(line))));
    return *this;
  }

  static interaction::Automaton watching() {
    interaction::Automaton automaton;
    automaton.add({"w0", 0, interaction::Block(), "", 0});
    interaction::Task task{"takeshot-while-waiting", {}};
    task.parameters.kind = config::Value::Kind::kMap;
    config::Value seconds;
    seconds.kind = config::Value::Kind::kScalar;
    seconds.scalar = "seconds";
    task.parameters.entries.push_back({"duration", seconds});
    automaton.add({"w1", 0, task, "", 0});
    return automaton;
  }

  scenario::Scenario scenario_;
  std::map<std::string, std::vector<Activity>> activities_;
  std::map<std::string, Goal> goals_;
  std::map<std::string, std::vector<std::pair<double, world::Vector3>>> at_;
  std::map<std::string, double> due_;
  bool airborne_ = false;
  std::vector<ObjectTold> seen_;
  std::map<std::string, std::vector<std::pair<double, double>>> away_;
  JointHistory joint_;
};

}  // namespace skein::laws::testing
