// SPDX-License-Identifier: Apache-2.0
// A joint task of which "marvin" plays a role, with tasks and negotiations of every kind that the
// parts of a role know. Its course is told, not carried out.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "interaction/interaction.hpp"
#include "interaction/role_course.hpp"
#include "skein/config/parse.hpp"
#include "skein/interaction/read_library.hpp"
#include "testing/flown_node.hpp"
#include "testing/joint_host.hpp"
#include "testing/mapping_vehicle.hpp"

namespace skein::decision_node::testing {

inline constexpr const char* kScouting = R"yaml(
tasks:
  follow: {target: Obj, "beside?": Point}
  map-area: {area: Text}
functions:
  valid-position: {takes: [], gives: Point}
scms:
  separation:
    parameters: {from: Place, least: Number}
    constraints: [{distance-to: from, is: ">", than: least}]
roles:
  scout:
    needs: [hovering]
    parameters: {vehicle: Obj, area: Text}
    automaton:
      block: s10
      local: {side: valid-position()}
      content:
        - {task: pursue, type: follow, params: {target: vehicle}}
        - {task: flank, type: follow, params: {target: vehicle, beside: side}}
        - {task: sweep, type: map-area, params: {area: area}}
        - {action: divide, modality: area-sharing, in: {area: area}}
        - {action: divide-the-whole-field, modality: area-sharing, in: {area: area}}
        - {action: keep, modality: area-sharing, in: {area: area}}
        - {action: swap, modality: role-allocation}
        - {action: haggle, modality: task-auction}
        - block: s11
          pre: [[{message: area-sharing invitation}]]
          content: [{action: divide-again, modality: area-sharing, in: {area: area}}]
  spare:
    needs: [hovering]
    parameters: {vehicle: Obj}
    automaton:
      block: p10
      content:
        - {task: p1, type: follow, params: {target: vehicle}}
        - {action: keep, modality: area-sharing}
        - {action: swap, modality: role-allocation}
        - {action: haggle, modality: task-auction}
  post:
    needs: [hovering, {camera: thermal}]
    parameters: {vehicle: Obj}
    automaton:
      block: o10
      local: {side: valid-position()}
      content:
        - {action: spread, modality: perception-positions, in: {around: vehicle, distance: 40, altitude: 40, directions: 4}, out: {place: side}}
        - block: o11
          pre: [[{message: perception-positions invitation}]]
          content: [{action: spread-again, modality: perception-positions, in: {around: vehicle, distance: 40, altitude: 40, directions: 4}, out: {place: side}}]
models:
  scouting:
    variants:
      pair:
        parameters: {vehicle: Obj, area: Text, uavs: UAVlist}
        roles: [scout, spare, post]
        coordination:
          arity: {scout: {at-least: 1}, spare: {at-least: 0}, post: {at-least: 0}}
          actions:
            - {role: scout, action: divide, with: scout, target: divide, who: everyone}
            - {role: scout, action: divide-the-whole-field, with: scout, target: divide-the-whole-field, who: everyone}
            - {role: scout, action: divide-again, with: scout, target: divide-again, who: everyone}
            - {role: scout, action: swap, with: scout, target: swap, who: everyone}
            - {role: scout, action: keep, with: spare, target: keep, who: everyone}
            - {role: spare, action: keep, with: scout, target: keep, who: everyone}
            - {role: scout, action: swap, with: spare, target: swap, who: everyone}
            - {role: spare, action: swap, with: scout, target: swap, who: everyone}
            - {role: scout, action: haggle, with: spare, target: haggle, who: everyone}
            - {role: spare, action: haggle, with: scout, target: haggle, who: everyone}
            - {role: post, action: spread, with: post, target: spread, who: everyone}
            - {role: post, action: spread-again, with: post, target: spread-again, who: everyone}
          scms:
            apart: {scm: separation, from: R*, least: 20}
          blocks:
            apart: {scout: [s10], spare: [p10], post: [o10]}
          parameters:
            scout: {vehicle: vehicle, area: area}
            spare: {vehicle: vehicle}
            post: {vehicle: vehicle}
)yaml";

/// The world has an area "field" of 200 m by 200 m; a vehicle with a camera that looks down.
inline Config scouting_config() {
  Config config = stood_in_config("");
  auto knowledge = std::make_shared<supervisor::Knowledge>(*config.knowledge);
  knowledge->altitude = 60;
  make_map(knowledge->vehicle);
  config.knowledge = knowledge;
  world::WorldFile file = level_ground();
  file.airspace.ceiling = 150;
  file.zones.push_back({"field", {{0, 0}, {200, 0}, {200, 200}, {0, 200}}});
  config.world = std::make_shared<world::World>(world::build_world(std::move(file)).value());
  const auto text = config::parse_yaml(kScouting, "scouting.yaml");
  config.interaction = std::make_shared<const interaction::Library>(
      interaction::read_library({{"scouting.yaml", text.value()}}).value());
  return config;
}

inline Joint scouting_joint(const Config& config) {
  mission::ElementaryTask task;
  task.id = executive::TaskId(7);
  task.type = "joint:scouting";
  task.parameters.add("vehicle", std::string("car"));
  task.parameters.add("area", std::string("field"));
  task.parameters.add("uavs", std::string("marvin heliv"));
  return joint_of(task, config.interaction, "marvin", {"heliv"}).value();
}

/// Marvin and heliv both scout. What the role is told, and its tasks, are kept as they come.
class ScoutingCourse final : public RoleCourse {
 public:
  ScoutingCourse() {
    my.phase = interaction::JointPhase::kRunning;
    interaction.start();
    stands_at({0, 0, 60});
  }

  RolePlay& play() override { return play_; }
  Outlook outlook() const override {
    const Config& config = host.config();
    return {*config.knowledge, *config.world,
            sightings.observer(my.joint.arguments, *config.world, now_), now_};
  }
  void tell(const interaction::Input& input) override {
    constexpr const char* kWords[] = {"runs", "ended", "aborted"};
    if (const auto* message = std::get_if<interaction::Message>(&input))
      told.push_back(message->text);
    const auto* status = std::get_if<interaction::Status>(&input);
    if (status == nullptr) return;
    told.push_back(status->componel + " " + kWords[static_cast<int>(status->word)]);
  }
  executive::TaskId give(const std::string& componel, executive::Task task,
                         std::optional<executive::TaskId> along) override {
    task.id = executive::TaskId(100 + given.size());
    given.push_back({componel, std::move(task), along});
    return given.back().task.id;
  }
  void fail(const std::string& componel, const std::string& why) override {
    failed.push_back(componel + ": " + why);
  }

  void at(double seconds) {
    now_ = MissionTime::seconds(seconds);
    host.bus().begin(now_);
  }
  void stands_at(const world::Vector3& place) {
    world::Telemetry telemetry = flying(true);
    telemetry.state.position = place;
    telemetry.state.energy = 1;
    sightings.see(telemetry);
  }
  PlaySurroundings surroundings() { return {host, interaction, sightings, joint_task, my}; }

  struct Given {
    std::string componel;
    executive::Task task;
    std::optional<executive::TaskId> along;
  };
  /// The way-points of a flight that was given.
  static std::vector<world::Vector3> way_of(const Given& flight) {
    const std::vector<double>& flat = flight.task.parameters.find("waypoints")->numbers;
    std::vector<world::Vector3> way;
    for (std::size_t i = 0; i + 2 < flat.size(); i += 3)
      way.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
    return way;
  }
  std::vector<Given> given;
  std::vector<std::string> told;    ///< "keep ended"
  std::vector<std::string> failed;  ///< "sweep: the area is not shared"

  LoneJointHost host{scouting_config()};
  Interaction interaction{host};
  Sightings sightings{"marvin"};
  Membership my{.joint = scouting_joint(host.config()),
                .holders = {{"heliv", "scout"}, {"marvin", "scout"}}};
  JointTask joint_task{
      host, interaction, my.joint, {{Duration(), Duration::seconds(1000)}}, sightings};

 private:
  MissionTime now_;
  RolePlay play_{my.joint, "scout", my.holders, "marvin"};
};

}  // namespace skein::decision_node::testing
