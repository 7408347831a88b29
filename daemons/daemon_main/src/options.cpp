// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <cstdlib>

#include "settings.hpp"

namespace skein::daemon_main {

namespace {

void declare_network(CLI::App& app, blackboard::NetworkConfig& network) {
  const auto list = [&](const char* name, std::vector<std::string>& values, const char* help) {
    app.add_option(name, values, help)->allow_extra_args(false)->delimiter(',');
  };
  const auto choose = [&network](const std::string& name) {
    network.dds = blackboard::dds_from_name(name).value_or(network.dds);
  };
  app.add_option_function<std::string>(
         "--dds", choose,
         "Whose DDS to use: fastdds or cyclonedds; nodes of both work "
         "together")
      ->check(CLI::IsMember(blackboard::dds_names()))
      ->default_str(std::string(blackboard::name_of(network.dds)));
  list("--interface", network.interfaces, "IPv4 address to talk on; repeat for several");
  list("--peer", network.peers,
       "Where to look for other nodes: ADDRESS or ADDRESS:PORT; may be repeated");
  app.add_option("--multicast", network.multicast, "Look for other nodes by multicast: on or off")
      ->default_str("on");
  list("--discovery-server", network.discovery_servers,
       "ADDRESS:PORT of a Fast DDS discovery server, by which alone others are found");
  app.add_option("--security", network.keys,
                 "Folder made by make-keys: talk only with nodes that prove who they are");
  app.add_flag("--types", network.types,
               "Announce the types of what it writes, so that DDS tools without our IDL can read "
               "it; with --dds cyclonedds")
      ->default_str("false");
}

void declare_run(CLI::App& app, Options& options, bool remembers) {
  app.add_option("--rate", options.overrides.rate,
                 "Mission seconds per second, for the scenario's");
  app.add_option("--seed", options.overrides.seed, "Seed, for the scenario's");
  app.add_option("--degree", options.overrides.degrees,
                 "Degree of autonomy of all UAVs (2) or of one (marvin=1); may be repeated")
      ->allow_extra_args(false)
      ->delimiter(',');
  if (remembers)
    app.add_option("--state", options.state,
                   "Folder for what outlives the process: started again with it, the daemon goes "
                   "on where it was; none: nothing does");
  app.add_option("--log-level", options.log_level, "error, warn, info or debug")
      ->check(CLI::IsMember({"error", "warn", "info", "debug"}));
  app.add_option(
      "--log-to", options.log_to,
      "File of this machine to which the records of its event log go, as JSON, one a line");
  app.add_option(
         "--world", options.world,
         "Take part in the world channel, which is for simulation: on or off. In flight off: "
         "the event log then stays on board, mission time comes from the peers")
      ->default_str("on");
  app.add_flag("--log-json", options.log_json, "Records as JSON, one a line, instead of sentences")
      ->default_str("false");
}

}  // namespace

void declare(CLI::App& app, Options& options, const DaemonProgram& program) {
  app.option_defaults()->always_capture_default();
  app.add_option("--config", options.config,
                 "YAML file with values of the options below; also as SKEIN_CONFIG");
  app.add_flag("--show-config", options.show_config,
               "Print the value of every option and where it comes from, and end");
  app.add_option("--manual", options.manual, "Print its manual page, or completion of a shell")
      ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}))
      ->group("");
  if (!program.node.empty() && !program.plays_vehicles)
    app.add_flag("--show-rights", options.show_rights,
                 "Print what each node of the scenario may write and read, and end");
  app.add_option("--scenario", options.scenario, "Scenario file; the same on every machine");
  if (program.node.empty())
    app.add_option("--uav", options.node, "Name of the UAV in the scenario");
  if (program.plays_vehicles)
    app.add_option("--node", options.node,
                   "Be a functional layer that the scenario names (default: sim, which plays all "
                   "other vehicles, and leads the clock)");
  if (program.plays_vehicles)
    app.add_flag("--forgets", options.forgets,
                 "Be one that lost its memory: of --state only vehicles and world count");
  app.add_option("--domain", options.domain, "DDS domain id")->check(CLI::Range(0, 100));
  declare_network(app, options.network);
  declare_run(app, options, !program.crew);
  for (const OwnOption& own : program.options) app.add_option(own.name, *own.value, own.help);
  for (CompanionSource* const source : program.companions) source->declare(app);
  app.add_option("--exit-with-parent", options.parent,
                 "Stop when the process of this id, which started this one, ends");
  app.footer(
      "Each option but those of this program itself may also come from the environment\n"
      "(--log-level: SKEIN_LOG_LEVEL; lists with commas) or from the file of --config\n"
      "(log-level: info). The command line wins over the environment, that over the file.");
}

Diagnostics complete(CLI::App& app, Options& options, const DaemonProgram& program,
                     std::string& shown) {
  const char* const file = std::getenv("SKEIN_CONFIG");
  if (options.config.empty() && file != nullptr) options.config = file;
  Settings settings(app, {"help", "config", "show-config", "show-rights", "manual",
                          "exit-with-parent", "forgets"});
  Diagnostics problems =
      settings.complete([](const char* name) { return std::getenv(name); }, options.config);
  const auto require = [&](const std::string& value, const char* name, const char* variable) {
    if (!value.empty()) return;
    problems.add(
        {"", 0, 0, "", std::string("--") + name + " is required",
         std::string("it here, in the environment (") + variable + ") or in the file of --config",
         ""});
  };
  require(options.scenario, "scenario", "SKEIN_SCENARIO");
  if (program.node.empty()) require(options.node, "uav", "SKEIN_UAV");
  for (std::string& problem : problems_of(options.network)) {
    problems.add({"", 0, 0, "", std::move(problem), "", ""});
  }
  shown = settings.shown();
  return problems;
}

}  // namespace skein::daemon_main
