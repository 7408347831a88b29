// SPDX-License-Identifier: Apache-2.0
#include "skein/daemon_main/daemon_main.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>

#include "companions.hpp"
#include "log_file.hpp"
#include "log_line.hpp"
#include "memory.hpp"
#include "options.hpp"
#include "rights.hpp"
#include "service_manager.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/manual/pages.hpp"
#include "skein/node/daemon.hpp"
#include "skein/node/waker.hpp"
#include "skein/scenario/scenario_print.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "skein/scenario_setup/setup.hpp"

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
  config.capacity = scenario_setup::capacity_of(scenario);
  config.seed = scenario.seed;
  config.scenario = scenario::print_of(scenario);
  config.world = options.world;
  config.leads_clock = self.role == (options.world ? wire::Role::kSim : wire::Role::kGround);
  config.time_limit = scenario.duration_limit;
  for (const node::Member& member : roster.members()) {
    const bool awaited = member.role == wire::Role::kGround || member.role == wire::Role::kDdn ||
                         member.role == wire::Role::kFunctional;
    if (awaited) config.awaited.push_back(member.name);
  }
  config.on_record = [json = options.log_json](const journal::Record& record, node::LineMark) {
    spdlog::log(level_of(record), "{}", json ? journal::to_json(record) : log_line(record));
  };
  config.on_middleware_log = [json = options.log_json, name = self.name](const std::string& line) {
    const auto notice =
        journal::record_of({}, name, journal::lines::Notice{.text = "dds: " + line});
    spdlog::warn("{}", json ? journal::to_json(notice) : "dds: " + line);
  };
  config.on_waiting = [json = options.log_json, name = self.name](const std::string& text) {
    const auto notice = journal::record_of({}, name, journal::lines::Notice{.text = text});
    spdlog::info("{}", json ? journal::to_json(notice) : text);
  };
  return config;
}

/// From now on records go to the file of --log-to too, if one is named; what is wrong with that
/// later is told beside them. False: it cannot be opened, and it was said why.
bool open_log(const Options& options, std::optional<LogFile>& log, node::DaemonConfig& config) {
  if (options.log_to.empty()) return true;
  auto opened = LogFile::open(options.log_to);
  if (!opened) {
    std::cerr << "--log-to: " << opened.error().why << '\n';
    return false;
  }
  LogFile& file = log.emplace(std::move(*opened));
  config.on_record = [&file, tell = config.on_record](const journal::Record& record,
                                                      node::LineMark mark) {
    tell(record, mark);
    const std::string line = journal::to_json(record);
    if (mark.again && file.had(line)) return;
    const std::string news = file.append(line);
    if (!news.empty()) {
      tell(journal::record_of(record.at(), record.node(), journal::lines::Notice{.text = news}),
           {});
    }
  };
  return true;
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

struct OpenCompanions {
  Companions all;
  std::vector<std::string> notices;
};

/// As far as they are asked for.
Result<OpenCompanions, Failure> open_companions(const DaemonProgram& program,
                                                const Options& options,
                                                const scenario::Scenario& scenario) {
  OpenCompanions opened;
  for (CompanionSource* const source : program.companions) {
    auto one = source->open({options.scenario, scenario, options.network});
    if (!one) return tl::unexpected(one.error());
    if (!one->companion) continue;
    opened.notices.push_back(std::move(one->notice));
    opened.all.add(std::move(one->companion));
  }
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
    std::cerr << options.scenario << ": no " << what << " '" << name << "' in this scenario"
              << did_you_mean(nearest_name(name, candidates(program, scenario))) << '\n';
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

/// Longer each time: where handshakes are slow and not stuck, to begin anew would make them slower.
Duration handshake_limit(int attempt) {
  constexpr int kMostAttempts = 5;
  if (attempt >= kMostAttempts) return Duration::max();
  return Duration::milliseconds(std::int64_t{8000} << attempt);
}

void log(const node::DaemonConfig& config, const std::string& name,
         const std::vector<std::string>& notices) {
  for (const std::string& notice : notices)
    config.on_record(journal::record_of({}, name, journal::lines::Notice{.text = notice}), {});
}

/// Of a daemon that is run anew, from time to time.
struct Attempt {
  int number = 0;
  bool keeps = true;  ///< a memory, if it is asked for
};

/// If one is asked for.
Memory memory_of(const Options& options, const Attempt& attempt, const std::string& name,
                 const scenario::Scenario& scenario) {
  if (options.state.empty() || !attempt.keeps) return {};
  return open_memory(options.state, {name, identity_of_mission(scenario)});
}

/// If it is to; false: it was said why it cannot.
bool can_do_without_world(const Options& options, const node::Member& self) {
  if (options.world || self.role != wire::Role::kSim) return true;
  std::cerr << "--world off: the simulator is the world; in flight there is none\n";
  return false;
}

/// Of lines on stderr: when, how bad, which node.
void set_pattern(const Options& options, const std::string& node) {
  const std::string stamp = "%Y-%m-%dT%H:%M:%S.%eZ %^%-5l%$ " + node + " ";
  spdlog::set_pattern(options.log_json ? "%v" : stamp + "%v", spdlog::pattern_time_type::utc);
}

/// The scenario of the mission that is under way is another: what was kept of it is for the next
/// start, with the right file.
int end_refused(const Memory& memory, const node::DaemonConfig& config, const std::string& name) {
  if (memory.log && memory.log->take_back())
    log(config, name, {"what was kept of " + name + " is in its place again"});
  return kExitBadInput;
}

/// The exit code; nothing when the node is to be run anew.
std::optional<int> run(const DaemonProgram& program, const Options& options, Attempt& attempt) {
  const auto scenario =
      scenario_setup::load_scenario(options.scenario, options.overrides, program.check);
  if (!scenario) {
    std::cerr << to_text(scenario.error());
    return kExitBadInput;
  }
  const node::Roster roster = scenario_setup::roster_of(*scenario);
  if (options.show_rights) {
    std::cout << rights_of(roster);
    return kExitOk;
  }
  Crew crew;
  const node::Member* self = find_self(program, options, *scenario, roster, crew);
  if (self == nullptr || !can_do_without_world(options, *self)) return kExitBadInput;
  const std::string& name = self->name;
  set_pattern(options, name);
  ServiceManager manager;
  const Memory memory = memory_of(options, attempt, name, *scenario);
  if (!memory.in_use.empty()) {
    std::cerr << memory.in_use << '\n';
    return kExitSystem;
  }
  node::DaemonConfig config = daemon_config(options, *scenario, *self, roster);
  config.on_turn = [&manager](wire::ClockPhase phase) {
    manager.turn(phase, node::Waker::steady_now());
  };
  std::optional<LogFile> log_file;
  if (!open_log(options, log_file, config)) return kExitBadInput;
  log(config, name, memory.notices);
  config.memory = memory.log.get();
  config.incarnation = memory.incarnation;
  config.first_life = memory.first_life;
  auto companions = open_companions(program, options, *scenario);
  if (!companions) {
    std::cerr << companions.error().why << '\n';
    return kExitBadInput;
  }
  log(config, name, companions->notices);
  companions->all.add(std::move(crew.companion));
  if (!companions->all.empty()) config.companion = &companions->all;
  config.forgets = options.forgets;
  config.handshake_limit = handshake_limit(attempt.number);
  auto node = crew.node ? std::move(crew.node) : program.make(*scenario, name);
  const auto end = node::run_daemon(roster, *self, std::move(node), config);
  if (end == node::DaemonEnd::kFinished && memory.log) memory.log->conclude();
  if (!end && end.error().of_memory) {
    const Refused refused = refuse(*memory.log, name, end.error().why);
    log(config, name, refused.notices);
    attempt.keeps = refused.again;
    return std::nullopt;
  }
  if (!end) {
    spdlog::error("{}", end.error().why);
    return kExitSystem;
  }
  if (end == node::DaemonEnd::kUnmet) return std::nullopt;
  if (end == node::DaemonEnd::kOtherScenario) return end_refused(memory, config, name);
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
  std::optional<int> code;
  for (Attempt attempt; !code; ++attempt.number) code = run(program, options, attempt);
  return *code;
} catch (const std::exception& error) {
  std::cerr << program.name << ": " << error.what() << '\n';
  return kExitInternal;
}

}  // namespace skein::daemon_main
