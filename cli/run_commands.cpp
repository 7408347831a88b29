// SPDX-License-Identifier: Apache-2.0
#include "run_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "argument_checks.hpp"
#include "skein/run_tool/run.hpp"
#include "when_chosen.hpp"

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

void add_dds(CLI::App* run, run_tool::RunOptions& options, CLI::Option* in_virtual_time) {
  run->add_option(
         "--dds", options.overrides.dds,
         "Whose DDS all nodes use (fastdds, cyclonedds) or one (marvin=cyclonedds); may be "
         "repeated")
      ->allow_extra_args(false);
  run->add_flag("--types", options.types,
                "Nodes on Cyclone DDS announce the types of what they write, so that DDS tools "
                "without our IDL can read it")
      ->excludes(in_virtual_time);
}

void add_run(CLI::App& app, Action& action, const Actions& actions) {
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
  add_dds(run, *options, in_virtual_time);
  run->add_option("--out", options->out, "Folder for the results (default: out/NAME)")
      ->take_last();  // ./demo gives one that its caller may replace
  run->add_option("--explain", options->explain,
                  "After the run: why a UAV (karma) or one of its tasks (karma:104) was planned so")
      ->allow_extra_args(false);
  run->add_flag("--json", options->json, "The result as JSON on standard output, no progress");
  run->add_flag("--quiet", options->quiet, "No progress");
  run->add_option("--allow-late", options->allow_late,
                  "Over DDS: seconds of the clock on the wall by which this machine may be late: "
                  "the windows of what is expected end so much later, times the rate")
      ->check(CLI::Range(0.0, 60.0))
      ->excludes(in_virtual_time);
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
  run->add_option("--console", options->console,
                  "Over DDS: serve the operators' page meanwhile: ADDRESS:PORT, or PORT of this "
                  "machine alone")
      ->check(port_problem)
      ->excludes(in_virtual_time);
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
  when_chosen(run, options, action, actions);
}

void add_report(CLI::App& app, Action& action, const Actions& actions) {
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
  when_chosen(report, options, action, actions);
}

}  // namespace

void add_runs(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  add_run(app, action, actions);
  add_report(app, action, actions);
}

}  // namespace skein::cli
