// SPDX-License-Identifier: Apache-2.0
#include "skein/daemon_main/daemon_main.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>

#include "companions.hpp"
#include "log_file.hpp"
#include "log_line.hpp"
#include "memory.hpp"
#include "options.hpp"
#include "rights.hpp"
#include "service_manager.hpp"
#include "skein/assembly/assembly.hpp"
#include "skein/assembly/overrides.hpp"
#include "skein/assembly/page_world.hpp"
#include "skein/console/console.hpp"
#include "skein/designer/workbench.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/manual/pages.hpp"
#include "skein/mavlink_out/mavlink_out.hpp"
#include "skein/node/waker.hpp"
#include "skein/ros2_out/ros2_out.hpp"

namespace skein::daemon_main {

namespace {

spdlog::level::level_enum level_of(const journal::Record& record) {
  const std::string& kind = record.kind();
  if (kind == "dropped" || kind == "unsent" || kind == "lost" || kind == "transport")
    return spdlog::level::warn;
  if (kind == "telemetry" || kind == "message" || kind == "perception") return spdlog::level::debug;
  return spdlog::level::info;
}

// The parent may be gone before the kernel was asked to tell. Whose child this was then cannot be
// seen from here: process 1 adopts orphans, and in a container is who runs missions.
void follow(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) raise(SIGTERM);
}

/// Its own folder in that of make-keys, or the folder itself on a machine that has only its own.
std::string keys_of(const std::string& folder, const std::string& node) {
  const std::filesystem::path own = std::filesystem::path(folder) / node;
  return !folder.empty() && std::filesystem::is_directory(own) ? own.string() : folder;
}

node::DaemonConfig daemon_config(const Options& options, const scenario::Scenario& scenario,
                                 const node::Member& self, const node::Roster& roster) {
  node::DaemonConfig config;
  config.domain = options.domain;
  config.network = options.network;
  config.network.keys = keys_of(options.network.keys, self.name);
  config.rate = scenario.rate;
  config.heartbeat = scenario.radio.heartbeat;
  if (scenario.radio.silent) config.told = node::ToldOfLinks::kNothing;
  config.capacity = assembly::capacity_of(scenario);
  config.seed = scenario.seed;
  config.world = options.world;
  config.leads_clock = self.role == (options.world ? wire::Role::kSim : wire::Role::kGround);
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

/// Records go to the file too; what is wrong with that is told beside it.
void log_to(LogFile& file, node::DaemonConfig& config) {
  config.on_record = [&file, tell = config.on_record](const journal::Record& record) {
    tell(record);
    const std::string news = file.append(journal::to_json(record));
    if (!news.empty())
      tell(journal::Record(record.at(), record.node(), "notice").with("text", news));
  };
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

Result<std::unique_ptr<console::Console>, Failure> open_console(
    const Options& options, const scenario::Scenario& scenario) {
  console::ConsoleConfig config;
  config.names = options.console_names;
  config.world = assembly::page_world(scenario);
  const auto models = designer::models_of(options.scenario);
  if (!models.empty()) config.annex = std::make_shared<designer::Workbench>(models);
  if (auto read = console::read_address(options.console, config); !read) {
    return tl::unexpected(read.error());
  }
  return console::Console::open(std::move(config));
}

struct OpenCompanions {
  Companions all;
  std::vector<std::string> notices;
};

/// The page, the station of others and ROS 2, as far as they are asked for.
Result<OpenCompanions, Failure> open_companions(const Options& options,
                                                const scenario::Scenario& scenario) {
  OpenCompanions opened;
  if (!options.console.empty()) {
    auto console = open_console(options, scenario);
    if (!console) return failure("--console: " + console.error().why);
    opened.notices.push_back("console at " + (*console)->url());
    opened.all.add(std::move(*console));
  }
  if (!options.mavlink_out.empty()) {
    auto config = mavlink_out::announcer_config_of(scenario, options.geoid);
    if (!config) return failure("--mavlink-out: " + config.error().why);
    auto out = mavlink_out::MavlinkOut::open(options.mavlink_out, std::move(*config));
    if (!out) return failure("--mavlink-out: " + out.error().why);
    opened.notices.push_back("telemetry by MAVLink to " + options.mavlink_out);
    opened.all.add(std::move(*out));
  }
  if (!options.ros2) return opened;
  auto out = ros2_out::Ros2Out::open(
      {*options.ros2, options.network, ros2_out::narrator_config_of(scenario)});
  if (!out) return failure("--ros2: " + out.error().why);
  opened.notices.push_back("topics of ROS 2 in its domain " + std::to_string(*options.ros2));
  opened.all.add(std::move(*out));
  return opened;
}

/// Who this daemon is; null, and said why, when the scenario has no place for it. A program that
/// makes its node itself does so here.
const node::Member* find_self(const DaemonProgram& program, const Options& options,
                              const scenario::Scenario& scenario, const node::Roster& roster,
                              Crew& crew) {
  const std::string name = options.node.empty() ? program.node : options.node;
  const node::Member* self = roster.find(name);
  if (self == nullptr || !can_be(program, self->role)) {
    const char* what = program.plays_vehicles ? "functional layer" : "UAV";
    const std::string nearest = nearest_name(name, candidates(program, scenario));
    std::cerr << options.scenario << ": no " << what << " '" << name << "' in this scenario"
              << (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") << '\n';
    return nullptr;
  }
  if (!program.crew) return self;
  auto made = program.crew(scenario, name);
  if (!made) {
    std::cerr << options.scenario << ": " << made.error().why << '\n';
    return nullptr;
  }
  crew = std::move(*made);
  return roster.find(crew.name);
}

int run(const DaemonProgram& program, const Options& options) {
  const auto scenario = assembly::load_scenario(options.scenario, options.overrides);
  if (!scenario) {
    std::cerr << to_text(scenario.error());
    return kExitBadInput;
  }
  const node::Roster roster = assembly::roster_of(*scenario);
  if (options.show_rights) {
    std::cout << rights_of(roster);
    return kExitOk;
  }
  Crew crew;
  const node::Member* self = find_self(program, options, *scenario, roster, crew);
  if (self == nullptr) return kExitBadInput;
  const std::string& name = self->name;
  if (!options.world && self->role == wire::Role::kSim) {
    std::cerr << "--world off: the simulator is the world; in flight there is none\n";
    return kExitBadInput;
  }
  const std::string stamp = "%Y-%m-%dT%H:%M:%S.%eZ %^%-5l%$ " + name + " ";
  spdlog::set_pattern(options.log_json ? "%v" : stamp + "%v", spdlog::pattern_time_type::utc);
  ServiceManager manager;
  const auto make_node = [&] { return assembly::make_node(*scenario, name); };
  Memory memory;
  if (!options.state.empty()) {
    const store::Identity identity{name, identity_of_mission(options.scenario, options.overrides)};
    memory = open_memory(options.state, identity, make_node);
  }
  node::DaemonConfig config = daemon_config(options, *scenario, *self, roster);
  config.on_turn = [&manager](wire::ClockPhase phase) {
    manager.turn(phase, node::Waker::steady_now());
  };
  std::optional<LogFile> log;
  if (!options.log_to.empty()) {
    auto file = LogFile::open(options.log_to);
    if (!file) {
      std::cerr << "--log-to: " << file.error().why << '\n';
      return kExitBadInput;
    }
    log_to(log.emplace(std::move(*file)), config);
  }
  for (const std::string& notice : memory.notices)
    config.on_record(journal::Record({}, name, "notice").with("text", notice));
  config.memory = memory.log.get();
  config.incarnation = memory.incarnation;
  auto companions = open_companions(options, *scenario);
  if (!companions) {
    std::cerr << companions.error().why << '\n';
    return kExitBadInput;
  }
  for (const std::string& notice : companions->notices)
    config.on_record(journal::Record({}, name, "notice").with("text", notice));
  companions->all.add(std::move(crew.companion));
  if (!companions->all.empty()) config.companion = &companions->all;
  config.forgets = options.forgets;
  auto node = crew.node ? std::move(crew.node) : make_node();
  const auto end = node::run_daemon(roster, *self, std::move(node), config);
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
  if (!options.manual.empty()) {
    const manual::Command command = manual::command_of(app);
    std::cout << (options.manual == "man"
                      ? manual::man_pages(command, "skein " SKEIN_VERSION, 8).front().text
                      : manual::completion(command, options.manual));
    return kExitOk;
  }
  std::string shown;
  const Diagnostics problems = complete(app, options, program, shown);
  if (options.show_config) std::cout << shown;
  if (!problems.empty()) {
    std::cerr << to_text(problems);
    return kExitBadInput;
  }
  if (options.show_config) return kExitOk;
  spdlog::set_default_logger(spdlog::stderr_color_mt("skein"));
  spdlog::set_level(spdlog::level::from_str(options.log_level));
  if (options.parent != 0) follow(options.parent);
  return run(program, options);
} catch (const std::exception& error) {
  std::cerr << program.name << ": " << error.what() << '\n';
  return kExitInternal;
}

}  // namespace skein::daemon_main
