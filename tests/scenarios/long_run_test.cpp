// SPDX-License-Identifier: Apache-2.0
// Hours of patrol, with cuts and thousands of commands: what is held stops growing. The long form
// of the checks flies 24 hours, the short one twelve.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <map>

#include "skein/assembly/assembly.hpp"
#include "skein/laws/protocol.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "test_cases.hpp"
#include "testing/patrol.hpp"

namespace skein::testing {
namespace {

/// Bytes in use, of all nodes together.
double in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

struct Flown {
  std::vector<double> held;                           ///< [bytes] at each half hour
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

// In four hours what is kept of what is over is full. From then on what is held goes up and down by
// the planner's terms, a megabyte, and by ten kilobytes an hour for the numbers of what is over.
TEST(LongRun, WhatIsHeldStopsGrowingAfterFourHours) {
  const int hours = cases(12, 24);
  constexpr double kTerms = 1'100'000, kNumbers = 10'000;
  const scenario::Scenario scenario = patrol_of(hours);

  const Flown flown = fly(scenario, assembly::virtual_config(scenario));

  for (const double bytes : flown.held) std::printf("%.0f kB ", bytes / 1000);
  std::printf("\ncommands: %s\ngoals: %s\ntasks: %s\n", counted(flown.commands).c_str(),
              counted(flown.goals).c_str(), counted(flown.tasks).c_str());
  ASSERT_GE(flown.held.size(), 20U);
  EXPECT_GT(flown.goals.at("achieved"), 25 * hours);
  EXPECT_GT(flown.commands.at("acknowledged"), 190 * hours);
  const double after_four_hours = flown.held.at(7);
  for (std::size_t half_hours = 8; half_hours < flown.held.size(); ++half_hours)
    EXPECT_LT(flown.held[half_hours] - after_four_hours,
              kTerms + kNumbers * (0.5 * static_cast<double>(half_hours) - 3.5));
}

}  // namespace
}  // namespace skein::testing
