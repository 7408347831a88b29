// SPDX-License-Identifier: Apache-2.0
#include "live_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "argument_checks.hpp"
#include "network_options.hpp"
#include "operate_commands.hpp"
#include "skein/functional_tool/functional.hpp"
#include "skein/replay_tool/replay.hpp"
#include "skein/run_tool/run.hpp"
#include "skein/state_tool/state.hpp"
#include "skein/storm_tool/storm.hpp"
#include "spy_commands.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

constexpr const char* kRunExamples = R"(
Examples:
  skein run scenarios/comets/confirmed.yaml                 over DDS, at the scenario's rate
  skein run scenarios/comets/infirmed.yaml --rate 40        twice as fast
  skein run scenarios/comets/confirmed.yaml --virtual       in virtual time, as fast as possible
  skein run scenarios/karma/detection.yaml --virtual --explain karma:104   why, whence and when
  skein run scenarios/comets/confirmed.yaml --virtual --degree 2 --degree marvin=1 --seed 7
Exit codes: 0 all expectations met, 1 some not, 2 wrong input, 3 a daemon died, 4 time-out, 130 Ctrl-C.)";

void add_run(CLI::App& app, Action& action, const LiveActions& live) {
  auto options = std::make_shared<run_tool::RunOptions>();
  CLI::App* run = app.add_subcommand("run", "Play a scenario, check it, write its report");
  run->add_option("scenario", options->scenario, "Scenario file (YAML)")->required();
  CLI::Option* in_virtual_time =
      run->add_flag("--virtual", options->virtual_time, "In virtual time, in this process");
  run->add_option("--rate", options->overrides.rate, "Mission seconds per second");
  run->add_option("--seed", options->overrides.seed, "Seed of everything random");
  run->add_option("--degree", options->overrides.degrees,
                  "Degree of autonomy of all UAVs (2) or of one (marvin=1); may be repeated")
      ->allow_extra_args(false);
  run->add_option(
         "--dds", options->overrides.dds,
         "Whose DDS all nodes use (fastdds, cyclonedds) or one (marvin=cyclonedds); may be "
         "repeated")
      ->allow_extra_args(false);
  run->add_option("--out", options->out, "Folder for the results (default: out/NAME)")
      ->take_last();  // ./demo gives one that its caller may replace
  run->add_option("--explain", options->explain,
                  "After the run: why a UAV (karma) or one of its tasks (karma:104) was planned so")
      ->allow_extra_args(false);
  run->add_flag("--json", options->json, "The result as JSON on standard output, no progress");
  run->add_flag("--quiet", options->quiet, "No progress");
  run->add_flag("--check", options->check_only, "Only read and check the scenario");
  run->add_option("--domain", options->domain, "DDS domain id (default: a free one)")
      ->check(CLI::Range(0, 100));
  run->add_option("--daemons", options->daemons, "Folder of the daemons (default: beside skein)");
  run->add_option("--without", options->without,
                  "A node that somebody else starts, a bridge to an autopilot for instance; may be "
                  "repeated")
      ->allow_extra_args(false);
  run->add_option("--interface", options->interfaces,
                  "IPv4 address where this command listens to daemons of other machines (see "
                  "--without, --daemons); not handed to them")
      ->delimiter(',')
      ->allow_extra_args(false);
  run->add_option("--security", options->security,
                  "Folder made by make-keys: every node proves who it is");
  run->add_option(
      "--console", options->console,
      "Serve the operators' page meanwhile: ADDRESS:PORT, or PORT of this machine alone");
  run->add_option("--mavlink-out", options->mavlink_out,
                  "Over DDS: tell a MAVLink ground station where everybody is, "
                  "udp:127.0.0.1:14550 for instance")
      ->excludes(in_virtual_time);
  run->add_option("--ros2", options->ros2,
                  "Over DDS: tell programs of ROS 2 in this domain of the team, and take missions "
                  "from them")
      ->check(CLI::Range(0, 100))
      ->excludes(in_virtual_time);
  run->add_option("--mcap", options->mcap,
                  "Also write the run as an MCAP file, for Foxglove or PlotJuggler");
  run->footer(kRunExamples);
  run->callback(
      [options, &action, &live] { action = [options, &live] { return live.run(*options); }; });
}

void add_report(CLI::App& app, Action& action, const LiveActions& live) {
  auto options = std::make_shared<run_tool::ReportOptions>();
  CLI::App* report = app.add_subcommand("report", "Write the report of a run's folder again");
  report->add_option("folder", options->folder, "Folder with events.jsonl and run.json")
      ->required();
  report
      ->add_option("--explain", options->explain,
                   "Instead: why a UAV (karma) or one of its tasks (karma:104) was planned so")
      ->allow_extra_args(false);
  report->footer(
      "\nExamples:\n  skein report out/comets-confirmed\n"
      "  skein report out/karma-detection --explain karma:104");
  report->callback(
      [options, &action, &live] { action = [options, &live] { return live.report(*options); }; });
}

constexpr const char* kFunctionalExamples = R"(
Examples:
  skein functional scenarios/comets/confirmed.yaml --uav marvin --virtual    the simulator's marvin
  skein-sim --scenario S --node autopilot --domain 5 &                       any functional layer
  skein functional S --uav heliv --domain 5                                  checked over DDS
Exit codes: 0 every point of the contract is kept, 1 some are not, 2 wrong input, 3 DDS refused.)";

void add_functional(CLI::App& app, Action& action, const LiveActions& live) {
  auto options = std::make_shared<functional_tool::FunctionalOptions>();
  CLI::App* functional =
      app.add_subcommand("functional", "Check a functional layer against its contract");
  functional->add_option("scenario", options->scenario, "Scenario file (YAML)")->required();
  functional->add_option("--uav", options->uav, "The UAV whose decision node is played");
  functional->add_flag("--virtual", options->virtual_time, "The simulator's, in virtual time");
  functional->add_option("--domain", options->domain, "DDS domain id")
      ->check(CLI::Range(0, 100))
      ->envname("SKEIN_DOMAIN");
  add_network(functional, options->network);
  functional->add_option("--rate", options->rate, "Mission seconds per second, over DDS")
      ->check(positive_problem);
  functional->add_option("--height", options->height, "Of the flight over the ground [m]")
      ->check(positive_problem);
  functional->add_option("--reach", options->reach, "Of the flight from the start [m]")
      ->check(positive_problem);
  functional->add_option("--near", options->near, "Of a way-point that counts as reached [m]")
      ->check(positive_problem);
  functional->add_flag(
      "--restarts", options->restarts,
      "Over DDS: also what holds after a restart; it says when to restart the layer");
  functional->add_flag("--json", options->json, "One JSON document");
  functional->footer(kFunctionalExamples);
  functional->callback([options, &action, &live] {
    action = [options, &live] { return live.functional(*options); };
  });
}

constexpr const char* kStateExamples = R"(
Examples:
  skein state show out/confirmed/state/marvin.state            whose it is, what is in it
  skein state check /var/lib/skein/marvin.state                would a daemon go on from it?
  skein state export out/confirmed/state/ground.state | head   every input, as JSON lines
Exit codes: 0, 1 a daemon would not go on from it, 2 it cannot be read.)";

void add_state(CLI::App& app, Action& action, const LiveActions& live) {
  using What = state_tool::StateOptions::What;
  CLI::App* state = app.add_subcommand("state", "What a daemon keeps for its next life");
  state->require_subcommand(1);
  state->footer(kStateExamples);
  const auto add = [&](const char* name, const char* description, What what) {
    auto options = std::make_shared<state_tool::StateOptions>();
    options->what = what;
    CLI::App* one = state->add_subcommand(name, description);
    one->add_option("file", options->file, "NODE.state in the folder of --state")->required();
    if (what == What::kShow) one->add_flag("--json", options->json, "One JSON document");
    one->footer(kStateExamples);
    one->callback(
        [options, &action, &live] { action = [options, &live] { return live.state(*options); }; });
  };
  add("show", "Whose it is and what is in it", What::kShow);
  add("check", "Whether a daemon would go on from it", What::kCheck);
  add("export", "Every input, one JSON object a line", What::kExport);
}

constexpr const char* kReplayExamples = R"(
Examples:
  skein replay out/comets-confirmed                          its address is printed; Ctrl-C ends it
  skein replay out/comets-confirmed --speed 20 --console 8080
Exit codes: 0 it was ended, 2 the folder cannot be read, or the address cannot be listened at.)";

void add_replay(CLI::App& app, Action& action, const LiveActions& live) {
  auto options = std::make_shared<replay_tool::ReplayOptions>();
  CLI::App* replay = app.add_subcommand("replay", "A recorded run on the operators' page");
  replay->add_option("folder", options->folder, "Folder of a run (out/NAME)")->required();
  replay->add_option("--console", options->console,
                     "ADDRESS:PORT of the page (default: a free port)");
  replay->add_option("--speed", options->speed, "Mission seconds per second, at the start")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  replay->footer(kReplayExamples);
  replay->callback(
      [options, &action, &live] { action = [options, &live] { return live.replay(*options); }; });
}

constexpr const char* kStormExamples = R"(
Examples:
  skein storm scenarios/comets/confirmed.yaml --seeds 1..100 --jobs 2    troubles in a mission of yours
  skein storm --seeds 1..300                                             missions drawn at random
  skein storm my.yaml --seeds 17 --save out/17 --log out/17              one run, and its event log
  skein storm my.yaml other.yaml --seeds 1..1000 --law energy --law crash --json
  skein run out/storm/energy-my-17.yaml --virtual                        a scenario that was kept, small
Exit codes: 0 no law was broken, 1 some, 2 wrong input.)";

void add_storm(CLI::App& app, Action& action, const LiveActions& live) {
  auto options = std::make_shared<storm_tool::StormOptions>();
  CLI::App* storm = app.add_subcommand(
      "storm", "Missions in which things go wrong, by seed, judged by laws that know no plan");
  storm->add_option("scenarios", options->scenarios,
                    "Scenario files (YAML); without any, missions are drawn at random");
  storm->add_option("--seeds", options->seeds, "A..B: so many runs of each scenario")
      ->capture_default_str();
  storm->add_option("--jobs", options->judge.jobs, "How many at once")->check(CLI::Range(1, 256));
  storm->add_option("--law", options->judge.only, "Only this law; may be repeated")
      ->allow_extra_args(false);
  storm->add_flag("--laws", options->list_laws, "List the laws");
  storm->add_option("--save", options->save, "Folder for scenarios that break a law; '' keeps none")
      ->capture_default_str();
  storm->add_flag("!--no-shrink", options->shrink, "Keep them as they are, not made small");
  storm->add_option("--log", options->judge.log, "Folder for the event log of each run");
  storm->add_flag("--twice", options->judge.twice,
                  "Each run twice: the event logs must be the same");
  storm->add_option("--patience", options->judge.patience, "Seconds of processor time for one run")
      ->check(CLI::Range(1, 3600))
      ->capture_default_str();
  storm->add_option("--models", options->models,
                    "Folder scenarios/ of Skein, for missions drawn (default: found)");
  storm->add_flag("--json", options->json, "One JSON document, no progress");
  storm->add_flag("--quiet", options->quiet, "No progress");
  storm->footer(kStormExamples);
  storm->callback(
      [options, &action, &live] { action = [options, &live] { return live.storm(*options); }; });
}

}  // namespace

void add_live(CLI::App& app, std::function<int()>& action, const LiveActions& live) {
  add_run(app, action, live);
  add_report(app, action, live);
  add_replay(app, action, live);
  add_operate(app, action, live.operate);
  add_status(app, action, live.status);
  add_spy(app, action, live);
  add_functional(app, action, live);
  add_state(app, action, live);
  add_storm(app, action, live);
}

}  // namespace skein::cli
