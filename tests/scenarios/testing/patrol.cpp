// SPDX-License-Identifier: Apache-2.0
#include "testing/patrol.hpp"

#include <sstream>
#include <string>

#include "skein/foundation/contract.hpp"
#include "skein/scenario_setup/overrides.hpp"

namespace skein::testing {

namespace {

std::string patrol(int hours) {
  const int seconds = hours * 3600;
  std::ostringstream out;
  out << "scenario: patrol\nepoch: 2005-05-19T09:00:00Z\nduration_limit: " << seconds + 600 << "\n"
      << "world:\n  origin: {latitude: 40, longitude: -8, altitude: 0}\n  terrain: {west: -300, "
         "south: -300, east: 900, north: 900, cell: 20}\n"
      << "  wind: {toward: 0.6, speed: 1.0, gusts: 0.2}\n"
      << "  places: {P1: [150, 60, 0], P2: [200, 240, 0]}\n"
      << "uavs:\n"
      << "  marvin: {model: models/marvin.yaml, start: [0, 0], degree: 3}\n"
      << "  heliv: {model: models/heliv.yaml, start: [-60, 40], degree: 4}\n"
      << "planning: {domain: ../domains/comets.lisp, altitude: 40, voxel: 20, risk: 0.2}\n"
      << "radio: {range: 3000, line_of_sight: true, latency: 0.02, loss: 0.01}\n"
      << "faults:\n  - random: {cuts_per_hour: 4, mean_cut: 15}\n"
      << "ground:\n  script:\n"
      << "    - {step: up, when: {time: 5}, do: [{plan: {uav: marvin, tasks: [{id: 1, type: "
         "takeoff, mode: "
         "VUT, params: {altitude: 40}}]}}, {mission: {uav: heliv, id: 1, tasks: [{id: 1, task: "
         "[general-takeoff]}]}}]}\n";
  int id = 2, mission = 2;
  for (int t = 60; t < seconds; t += 60) {
    out << "    - {step: way-" << t << ", when: {time: " << t
        << "}, do: [{plan: {uav: marvin, tasks: [";
    for (int i = 0; i < 3; ++i)
      out << (i > 0 ? ", " : "") << "{id: " << id++ << ", type: goto, mode: DEP, params: {to: ["
          << 20 + 40 * i << ", " << (t / 60 % 2) * 60 << ", 50]}}";
    out << "]}}]}\n";
    if (t % 120 != 0) continue;
    out << "    - {step: look-" << t << ", when: {time: " << t
        << "}, do: [{mission: {uav: heliv, id: " << mission
        << ", placement: last, tasks: [{id: " << mission << ", task: [perceive, P"
        << 1 + mission % 2 << ", 20]}]}}]}\n";
    ++mission;
  }
  out << "    - {step: end, when: {time: " << seconds << "}, do: [{finish: true}]}\n";
  return out.str();
}

}  // namespace

scenario::Scenario patrol_of(int hours) {
  auto scenario =
      scenario::read_scenario_text(patrol(hours), SKEIN_SOURCE_DIR "/scenarios/comets/patrol.yaml");
  SKEIN_ENSURES(scenario.has_value());
  for (scenario::UavSpec& uav : scenario->uavs) uav.model.energy.capacity *= 1000;
  (void)scenario_setup::apply({}, *scenario);
  return std::move(*scenario);
}

}  // namespace skein::testing
