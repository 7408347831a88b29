// SPDX-License-Identifier: Apache-2.0
#include "testing/files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace skein::scenario::testing {

namespace {

constexpr const char* kScenario =
    R"(scenario: small
epoch: 2005-05-19T09:00:00Z
duration_limit: 600
world:
  origin: {latitude: 40.1, longitude: -8.2, altitude: 200}
  terrain: {west: -500, south: -500, east: 500, north: 500, cell: 20, base: 10}
  zones:
    Z: [[0, 0], [200, 0], [200, 100]]
  places: {base: [0, 0, 0], aside: [50, 60, 70]}
  objects:
    fire: {kind: fire, position: [100, 50], radius: 5}
uavs:
  marvin: {model: models/marvin.yaml, start: [0, 0]}
  heliv: {model: models/heliv.yaml, start: [10, 0], degree: 2}
radio:
  cuts: [{between: [heliv, ground], from: 30, until: 40}]
ground:
  script:
    - step: start
      when: {time: 5}
      do:
        - plan:
            uav: marvin
            tasks:
              - {id: 1, type: takeoff, params: {altitude: 40}}
              - {id: 2, type: goto, mode: DEP, params: {to: base, altitude: 40}}
              - {id: 3, type: takeshot, pre: [[{task: 2, state: ended}]], params: {device: visible}}
    - step: end
      when: {task: {uav: marvin, id: 3, state: ended}}
      do: [{finish: true}]
faults:
  - {at: 100, kill: heliv, restart_after: 5}
expect:
  - {name: flies, event: {kind: task, uav: marvin, task: 1, state: ended}}
)";

constexpr const char* kPlanningScenario =
    R"(scenario: planning
epoch: 2005-05-19T09:00:00Z
duration_limit: 600
world:
  origin: {latitude: 40.1, longitude: -8.2, altitude: 200}
  terrain: {west: -500, south: -500, east: 500, north: 500, cell: 20}
  zones: {Z: [[0, 0], [200, 0], [200, 100]]}
  volumes: {tower: {polygon: [[300, 300], [400, 300], [400, 400]], ceiling: 90}}
  places: {base: [0, 0, 0]}
uavs:
  karma: {model: models/karma.yaml, start: [0, 0], degree: 4}
  heliv: {model: models/heliv.yaml, start: [10, 0]}
planning: {domain: ../domains/comets.lisp, first_ids: {karma: 100}}
ground:
  script:
    - step: start
      when: {time: 5}
      do:
        - mission: {uav: karma, id: 1, tasks: [{id: 700, task: [general-takeoff]}, {id: 701, task: [perceive, base, 20]}]}
    - step: end
      when: {goal: {uav: karma, id: 701, state: achieved}}
      do: [{finish: true}]
expect:
  - {name: plans, event: {kind: answer, uav: karma, planned: true}}
)";

// Beside the COMETS scenarios, so that their models are found.
constexpr const char* kFolder = SKEIN_SOURCE_DIR "/scenarios/comets/";
const std::string kFile = std::string(kFolder) + "small.yaml";

void erase_all(std::string& text, const std::string& piece) {
  for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece)) {
    text.erase(at, piece.size());
  }
}

}  // namespace

std::string TemporaryFolder::path(const std::string& name) const {
  return (folder_.path() / name).string();
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const std::filesystem::path file = path(name);
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
  return file.string();
}

namespace {

std::string replaced(std::string text, const std::string& piece, const std::string& instead) {
  if (piece.empty()) return text;
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  if (at != std::string::npos) text.replace(at, piece.size(), instead);
  return text;
}

}  // namespace

std::string scenario_with(const std::string& piece, const std::string& instead) {
  return replaced(kScenario, piece, instead);
}

std::string planning_scenario_with(const std::string& piece, const std::string& instead) {
  return replaced(kPlanningScenario, piece, instead);
}

std::string errors_of(const std::string& text) {
  const auto scenario = read_scenario_text(text, kFile);
  if (scenario) return "";
  std::string errors = to_text(scenario.error());
  erase_all(errors, kFile + ":");
  erase_all(errors, kFolder);
  return errors;
}

Scenario read_valid(const std::string& text) {
  auto scenario = read_scenario_text(text, kFile);
  if (scenario) return std::move(*scenario);
  ADD_FAILURE() << to_text(scenario.error());
  return {};
}

}  // namespace skein::scenario::testing
