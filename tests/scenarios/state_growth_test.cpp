// SPDX-License-Identifier: Apache-2.0
// Hours of patrol with a state file for each node: what an hour more of them takes on disk. The
// long form of the checks flies 24 hours, the short one three.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "skein/assembly/assembly.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "skein/store/sqlite_input_log.hpp"
#include "skein/store/state_file.hpp"
#include "temporary_folder.hpp"
#include "test_cases.hpp"
#include "testing/patrol.hpp"

namespace skein::testing {
namespace {

namespace fs = std::filesystem;

/// Bytes of each node's state file, by its name, once all are closed.
std::map<std::string, double> flown_for(int hours, const fs::path& folder) {
  const scenario::Scenario scenario = patrol_of(hours);
  std::map<std::string, std::unique_ptr<store::SqliteInputLog>> logs;
  node::VirtualConfig config = assembly::virtual_config(scenario);
  config.memory_of = [&](const std::string& name) -> node::InputLog* {
    auto& log = logs[name];
    if (log == nullptr) log = std::move(store::SqliteInputLog::open(folder, {name, "patrol"})->log);
    return log.get();
  };
  node::run_virtual(
      scenario_setup::roster_of(scenario),
      [&](const std::string& name) { return assembly::make_node(scenario, name); }, config,
      [](const journal::Record&) {});
  std::map<std::string, double> bytes;
  for (auto& [name, log] : logs) {
    log.reset();
    bytes[name] = static_cast<double>(fs::file_size(folder / (name + ".state")));
  }
  return bytes;
}

// What grows is the noise of telemetry, 63 bytes a sample: a UAV has its own each second, the
// ground station those of both; the simulator, which is sent none, almost nothing.
TEST(StateFiles, GrowByLittleMoreThanTelemetryIsWorth) {
  constexpr double kTelemetry = 3600 * 63;
  const std::map<std::string, double> most = {{"ground", 1.6 * 2 * kTelemetry},
                                              {"marvin", 1.6 * kTelemetry},
                                              {"heliv", 1.6 * kTelemetry},
                                              {"sim", 0.3 * kTelemetry}};
  const int hours = cases(3, 24);
  const TemporaryFolder first, all;

  const std::map<std::string, double> of_first = flown_for(1, first.path());
  const std::map<std::string, double> of_all = flown_for(hours, all.path());

  for (const auto& [name, bytes] : of_all) {
    const double per_hour = (bytes - of_first.at(name)) / (hours - 1);
    std::printf("%s: %.0f kB, %.0f kB an hour\n", name.c_str(), bytes / 1000, per_hour / 1000);
    EXPECT_LT(per_hour, most.at(name)) << name;
  }
}

// What is folded is what was there: the node that is given it has done what it did.
TEST(StateFiles, ExplainWhatTheirNodesDid) {
  const TemporaryFolder folder;
  const std::map<std::string, double> flown = flown_for(2, folder.path());
  const scenario::Scenario scenario = patrol_of(2);

  for (const auto& [name, bytes] : flown) {
    const auto opened = store::SqliteInputLog::open(folder.path(), {name, "patrol"});
    EXPECT_EQ(opened->set_aside, "");
    const auto right = node::explains(*opened->log, *assembly::make_node(scenario, name));
    EXPECT_TRUE(right.has_value()) << name << ": " << right.error().why;
  }
}

}  // namespace
}  // namespace skein::testing
