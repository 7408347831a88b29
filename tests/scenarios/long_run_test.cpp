// SPDX-License-Identifier: Apache-2.0
// Hours of patrol, with cuts, restarts and thousands of commands: how much more is held each hour.
// The long form of the checks flies 24 hours, the short one two.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <map>
#include <sstream>

#include "skein/assembly/assembly.hpp"
#include "skein/laws/protocol.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "test_cases.hpp"

namespace skein::testing {
namespace {

/// Marvin is sent along ways by the ground station (three commands a minute), Heliv plans
/// missions on board (one in two minutes).
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

scenario::Scenario read(int hours) {
  auto scenario =
      scenario::read_scenario_text(patrol(hours), SKEIN_SOURCE_DIR "/scenarios/comets/patrol.yaml");
  EXPECT_TRUE(scenario.has_value()) << to_text(scenario.error());
  if (!scenario) return {};
  for (scenario::UavSpec& uav : scenario->uavs) uav.model.energy.capacity *= 1000;
  (void)scenario_setup::apply({}, *scenario);
  return std::move(*scenario);
}

/// Bytes in use, of all nodes together.
double in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

struct Flown {
  std::vector<double> held;                           ///< [bytes] at each full hour
  std::map<std::string, int> commands, goals, tasks;  ///< how often each state
  int resumed = 0;
};

Flown fly(const scenario::Scenario& scenario, const node::VirtualConfig& config) {
  Flown flown;
  double next = 1800;
  node::run_virtual(
      scenario_setup::roster_of(scenario),
      [&](const std::string& name) { return assembly::make_node(scenario, name); }, config,
      [&](const journal::Record& record) {
        if (record.kind() == "command") ++flown.commands[std::string(record.text("state"))];
        if (record.kind() == "goal") ++flown.goals[std::string(record.text("state"))];
        if (record.kind() == "task") ++flown.tasks[std::string(record.text("state"))];
        if (record.kind() == "resumed") ++flown.resumed;
      },
      [&](MissionTime now) {
        if (now.to_seconds() < next) return true;
        next += 1800;
        flown.held.push_back(in_use());
        return true;
      });
  return flown;
}

std::string counted(const std::map<std::string, int>& all) {
  std::string text;
  for (const auto& [state, times] : all) text += state + " " + std::to_string(times) + ", ";
  return text;
}

// Measured in the short form: 0.8 MB, of all nodes together.
TEST(LongRun, WhatIsHeldGrowsByNoMoreThanAMegabyteAnHour) {
  const int hours = cases(2, 24);
  const scenario::Scenario scenario = read(hours);

  const Flown flown = fly(scenario, assembly::virtual_config(scenario));

  for (const double bytes : flown.held) std::printf("%.0f kB ", bytes / 1000);
  std::printf("\ncommands: %s\ngoals: %s\ntasks: %s\n", counted(flown.commands).c_str(),
              counted(flown.goals).c_str(), counted(flown.tasks).c_str());
  ASSERT_GE(flown.held.size(), 3U);
  EXPECT_GT(flown.goals.at("achieved"), 25 * hours);
  EXPECT_GT(flown.commands.at("acknowledged"), 190 * hours);
  const double per_hour =
      (flown.held.back() - flown.held.front()) / (0.5 * static_cast<double>(flown.held.size() - 1));
  std::printf("%.1f kB an hour\n", per_hour / 1000);
  EXPECT_LT(per_hour, 1'000'000);
}

}  // namespace
}  // namespace skein::testing
