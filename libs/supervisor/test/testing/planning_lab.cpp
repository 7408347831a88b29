// SPDX-License-Identifier: Apache-2.0
#include "testing/planning_lab.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "skein/world/vehicle_model_reader.hpp"
#include "skein/world/world_builder.hpp"
#include "skein/world/world_reader.hpp"

namespace skein::supervisor::testing {

std::string file_text(const std::string& path) {
  std::ifstream file(std::string(SKEIN_SOURCE_DIR) + "/" + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

namespace {

template <class Value>
Value sound(Result<Value, Diagnostics> value) {
  if (!value) throw std::runtime_error(to_text(value.error()));
  return std::move(*value);
}

}  // namespace

world::World world_of(const std::string& path) {
  return sound(world::build_world(sound(world::read_world_file(file_text(path), path))));
}

world::VehicleModel vehicle_of(const std::string& path) {
  return sound(world::read_vehicle_model(file_text(path), path));
}

PlanningLab::PlanningLab() : world(world_of("scenarios/domains/seeds.yaml")) {
  knowledge.uav = "karma";
  knowledge.team = {"karma", "heliv", "marvin"};
  knowledge.vehicle = vehicle_of("scenarios/domains/seeds-uav.yaml");
  knowledge.vehicle.acceleration = 1e12;
  domain(file_text("scenarios/domains/comets.lisp"));
}

PlanningLab& PlanningLab::uav(const std::string& name, std::vector<std::string> team) {
  knowledge.uav = name;
  knowledge.team = std::move(team);
  return *this;
}

PlanningLab& PlanningLab::vehicle(world::VehicleModel model) {
  knowledge.vehicle = std::move(model);
  return *this;
}

PlanningLab& PlanningLab::domain(std::string text) {
  knowledge.domain = {"comets.lisp", std::move(text)};
  if (auto vocabulary = vocabulary_of(knowledge.domain)) knowledge.vocabulary = *vocabulary;
  return *this;
}

PlanningLab& PlanningLab::flying_at(const world::Vector3& position) {
  situation.position = position;
  situation.airborne = true;
  return *this;
}

PlanningLab& PlanningLab::first_id(std::uint64_t id) {
  situation.next_id = executive::TaskId(id);
  return *this;
}

PlanningLab& PlanningLab::task(std::uint64_t id, const std::string& name,
                               std::vector<mission::Argument> arguments,
                               mission::TimeConstraints time) {
  tasks.push_back({mission::GoalId(id), name, std::move(arguments), time});
  return *this;
}

PlanningRequest PlanningLab::request() const {
  return {std::make_shared<const Knowledge>(knowledge), std::make_shared<const world::World>(world),
          situation, tasks, 1};
}

std::string PlanningLab::taskreq() const {
  const auto made = plan();
  return made ? mission::to_taskreq(*made) : "no plan: " + reasons();
}

std::string PlanningLab::reasons() const {
  const auto made = plan();
  if (made) return {};
  std::string all;
  for (const std::string& one : made.error().reasons) all += one + "\n";
  return all;
}

}  // namespace skein::supervisor::testing
