// SPDX-License-Identifier: Apache-2.0
#include "skein/daemon_main/daemon_main.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>

#include "log_line.hpp"
#include "memory.hpp"
#include "skein/assembly/assembly.hpp"
#include "skein/assembly/overrides.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::daemon_main {

namespace {

struct Options {
  std::string scenario;
  std::string node;  ///< empty: that of the program
  std::uint32_t domain = 0;
  std::vector<std::string> interfaces{"127.0.0.1"};
  assembly::Overrides overrides;
  std::string log_level = "info";
  bool log_json = false;
  bool exit_with_parent = false;
  std::string state;  ///< empty: nothing outlives the process
};

void declare(CLI::App& app, Options& options, const DaemonProgram& program) {
  app.add_option("--scenario", options.scenario, "Scenario file; the same on every machine")
      ->required();
  if (program.node.empty())
    app.add_option("--uav", options.node, "Name of the UAV in the scenario")->required();
  if (program.plays_vehicles)
    app.add_option("--node", options.node,
                   "Be a functional layer that the scenario names (default: sim, which plays all "
                   "other vehicles, and leads the clock)");
  app.add_option("--domain", options.domain, "DDS domain id")
      ->check(CLI::Range(0, 100))
      ->envname("SKEIN_DOMAIN");
  app.add_option("--interface", options.interfaces,
                 "IPv4 address to talk on; repeat for several (default: this machine only)")
      ->allow_extra_args(false);
  app.add_option("--rate", options.overrides.rate,
                 "Mission seconds per second, for the scenario's");
  app.add_option("--seed", options.overrides.seed, "Seed, for the scenario's");
  app.add_option("--degree", options.overrides.degrees,
                 "Degree of autonomy of all UAVs (2) or of one (marvin=1); may be repeated")
      ->allow_extra_args(false);
  app.add_option("--state", options.state,
                 "Folder for what outlives the process: started again with it, the daemon goes on "
                 "where it was (default: nothing does)")
      ->envname("SKEIN_STATE");
  app.add_option("--log-level", options.log_level, "error, warn, info or debug");
  app.add_flag("--log-json", options.log_json, "Records as JSON, one a line, instead of sentences");
  app.add_flag("--exit-with-parent", options.exit_with_parent,
               "Stop when the process that started this one ends");
}

spdlog::level::level_enum level_of(const journal::Record& record) {
  const std::string& kind = record.kind();
  if (kind == "dropped" || kind == "unsent" || kind == "lost") return spdlog::level::warn;
  if (kind == "telemetry" || kind == "message" || kind == "perception") return spdlog::level::debug;
  return spdlog::level::info;
}

// The parent may be gone before the kernel was asked to tell.
void follow_parent() {
  const pid_t parent = getppid();
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent || parent == 1) raise(SIGTERM);
}

node::DaemonConfig daemon_config(const Options& options, const scenario::Scenario& scenario,
                                 const node::Member& self, const node::Roster& roster) {
  node::DaemonConfig config;
  config.domain = options.domain;
  config.interfaces = options.interfaces;
  config.rate = scenario.rate;
  config.seed = scenario.seed;
  config.leads_clock = self.role == wire::Role::kSim;
  config.time_limit = scenario.duration_limit;
  for (const node::Member& member : roster.members()) {
    const bool awaited = member.role == wire::Role::kGround || member.role == wire::Role::kDdn ||
                         member.role == wire::Role::kFunctional;
    if (awaited) config.awaited.push_back(member.name);
  }
  config.on_record = [json = options.log_json](const journal::Record& record) {
    spdlog::log(level_of(record), "{}", json ? journal::to_json(record) : log_line(record));
  };
  config.on_middleware_log = [json = options.log_json, name = self.name](const std::string& line) {
    const auto notice = journal::Record({}, name, "notice").with("text", "dds: " + line);
    spdlog::warn("{}", json ? journal::to_json(notice) : "dds: " + line);
  };
  return config;
}

bool can_be(const DaemonProgram& program, wire::Role role) {
  if (program.node.empty()) return role == wire::Role::kDdn;
  if (program.plays_vehicles) return role == wire::Role::kSim || role == wire::Role::kFunctional;
  return true;
}

std::vector<std::string> candidates(const DaemonProgram& program,
                                    const scenario::Scenario& scenario) {
  if (!program.plays_vehicles) return scenario.uav_names();
  std::vector<std::string> names{program.node};
  for (const auto& [uav, layer] : scenario.functional_layers()) names.push_back(layer);
  return names;
}

int run(const DaemonProgram& program, const Options& options) {
  const auto scenario = assembly::load_scenario(options.scenario, options.overrides);
  if (!scenario) {
    std::cerr << to_text(scenario.error());
    return kExitBadInput;
  }
  const node::Roster roster = assembly::roster_of(*scenario);
  const std::string name = options.node.empty() ? program.node : options.node;
  const node::Member* self = roster.find(name);
  if (self == nullptr || !can_be(program, self->role)) {
    const char* what = program.plays_vehicles ? "functional layer" : "UAV";
    const std::string nearest = nearest_name(name, candidates(program, *scenario));
    std::cerr << options.scenario << ": no " << what << " '" << name << "' in this scenario"
              << (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") << '\n';
    return kExitBadInput;
  }
  const std::string stamp = "%Y-%m-%dT%H:%M:%S.%eZ %^%-5l%$ " + name + " ";
  spdlog::set_pattern(options.log_json ? "%v" : stamp + "%v", spdlog::pattern_time_type::utc);
  const auto make_node = [&] { return assembly::make_node(*scenario, name); };
  Memory memory;
  if (!options.state.empty()) {
    const store::Identity identity{name, identity_of_mission(options.scenario, options.overrides)};
    memory = open_memory(options.state, identity, make_node);
  }
  node::DaemonConfig config = daemon_config(options, *scenario, *self, roster);
  for (const std::string& notice : memory.notices)
    config.on_record(journal::Record({}, name, "notice").with("text", notice));
  config.memory = memory.log.get();
  const auto end = node::run_daemon(roster, *self, make_node(), config);
  if (end == node::DaemonEnd::kFinished && memory.log) memory.log->conclude();
  if (!end) {
    spdlog::error("{}", end.error().why);
    return kExitSystem;
  }
  return kExitOk;
}

}  // namespace

int run_daemon_program(const DaemonProgram& program, int argc, char** argv) try {
  CLI::App app{program.description, program.name};
  Options options;
  declare(app, options, program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitBadInput;
  }
  spdlog::set_default_logger(spdlog::stderr_color_mt("skein"));
  spdlog::set_level(spdlog::level::from_str(options.log_level));
  if (options.exit_with_parent) follow_parent();
  return run(program, options);
} catch (const std::exception& error) {
  std::cerr << program.name << ": " << error.what() << '\n';
  return kExitInternal;
}

}  // namespace skein::daemon_main
