// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/mle_tool/mle.hpp"
#include "skein/run_tool/run.hpp"
#include "skein/spy_tool/spy.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

// CLI11's ranges let "nan" pass and print their bounds in full.
std::string finite_problem(const std::string& text) {
  double value = 0;
  const bool number = CLI::detail::lexical_cast(text, value);
  return number && std::isfinite(value) ? "" : "'" + text + "' is not a finite number";
}

std::string positive_problem(const std::string& text) {
  const std::string problem = finite_problem(text);
  return problem.empty() && std::stod(text) <= 0 ? "'" + text + "' is not positive" : problem;
}

constexpr const char* kRunExamples = R"(
Examples:
  skein run scenarios/comets/confirmed.yaml                 over DDS, at the scenario's rate
  skein run scenarios/comets/infirmed.yaml --rate 40        twice as fast
  skein run scenarios/comets/confirmed.yaml --virtual       in virtual time, as fast as possible
  skein run scenarios/comets/confirmed.yaml --virtual --degree 2 --degree marvin=1 --seed 7
Exit codes: 0 all expectations met, 1 some not, 2 wrong input, 3 a daemon died, 4 time-out, 130 Ctrl-C.)";

void add_run(CLI::App& app, Action& action) {
  auto options = std::make_shared<run_tool::RunOptions>();
  CLI::App* run = app.add_subcommand("run", "Play a scenario, check it, write its report");
  run->add_option("scenario", options->scenario, "Scenario file (YAML)")->required();
  run->add_flag("--virtual", options->virtual_time, "In virtual time, in this process");
  run->add_option("--rate", options->overrides.rate, "Mission seconds per second");
  run->add_option("--seed", options->overrides.seed, "Seed of everything random");
  run->add_option("--degree", options->overrides.degrees,
                  "Degree of autonomy of all UAVs (2) or of one (marvin=1); may be repeated")
      ->allow_extra_args(false);
  run->add_option("--out", options->out, "Folder for the results (default: out/NAME)")
      ->take_last();  // ./demo gives one that its caller may replace
  run->add_flag("--json", options->json, "The result as JSON on standard output, no progress");
  run->add_flag("--quiet", options->quiet, "No progress");
  run->add_flag("--check", options->check_only, "Only read and check the scenario");
  run->add_option("--domain", options->domain, "DDS domain id (default: a free one)")
      ->check(CLI::Range(0, 100));
  run->add_option("--daemons", options->daemons, "Folder of the daemons (default: beside skein)");
  run->footer(kRunExamples);
  run->callback([options, &action] {
    action = [options] { return run_tool::run(*options, std::cout, std::cerr); };
  });
}

void add_report(CLI::App& app, Action& action) {
  auto folder = std::make_shared<std::string>();
  CLI::App* report = app.add_subcommand("report", "Write the report of a run's folder again");
  report->add_option("folder", *folder, "Folder with events.jsonl and run.json")->required();
  report->footer("\nExample:\n  skein report out/comets-confirmed");
  report->callback([folder, &action] {
    action = [folder] { return run_tool::report(*folder, std::cout, std::cerr); };
  });
}

constexpr const char* kSpyExamples = R"(
Examples:
  skein spy --domain 1                               nodes, slots and rates
  skein spy --domain 1 echo TaskEvent SyncMessage    samples of two slots as they come
  skein spy --domain 1 echo Telemetry --from marvin --json -n 10
  skein spy --domain 1 --partition 'radio/marvin>ground'
Exit codes: 0, 2 wrong options, 3 DDS refused, 4 nothing heard.)";

void add_spy(CLI::App& app, Action& action) {
  auto options = std::make_shared<spy_tool::SpyOptions>();
  CLI::App* spy = app.add_subcommand("spy", "List or print what is on the wire");
  spy->fallthrough();
  spy->add_option("--domain", options->domain, "DDS domain id")
      ->check(CLI::Range(0, 100))
      ->envname("SKEIN_DOMAIN");
  spy->add_option("--interface", options->interfaces, "IPv4 address to listen on")
      ->allow_extra_args(false);
  spy->add_option("--partition", options->partitions,
                  "DDS partition, with * and ? (default: world, onboard/*, radio/*)")
      ->allow_extra_args(false);
  spy->add_option("--from", options->from, "Only samples made by this node");
  spy->add_option("--duration", options->duration, "Seconds to listen")->check(positive_problem);
  spy->add_flag("--json", options->json, "JSON: one document, or one line per sample");
  spy->footer(kSpyExamples);
  CLI::App* echo = spy->add_subcommand("echo", "Print samples as they come");
  echo->add_option("slots", options->slots, "Slots to print (default: all)");
  echo->add_option("-n,--count", options->count, "Stop after so many samples");
  spy->callback([options, echo, &action] {
    action = [options, echoes = echo->parsed()] {
      return echoes ? spy_tool::echo(*options, std::cout, std::cerr)
                    : spy_tool::list(*options, std::cout, std::cerr);
    };
  });
}

constexpr const char* kMleExamples = R"(
Examples:
  skein mle trace.jsonl --uav marvin
  skein mle --until 300 < trace.jsonl | grep '"dispatch"'
Formats: cli/mle/README.md. Exit codes: 0, 1 some line was wrong, 2 wrong options or files.)";

// What the command line gives as plain values.
struct MleArguments {
  mle_tool::MleOptions options;
  std::string file;
  std::optional<double> until;
  std::optional<double> timeout;
};

int run_mle(MleArguments arguments) {
  if (arguments.until) arguments.options.until = MissionTime::seconds(*arguments.until);
  if (arguments.timeout) arguments.options.timeout = Duration::seconds(*arguments.timeout);
  if (arguments.file.empty() || arguments.file == "-") {
    return mle_tool::run_mle(arguments.options, std::cin, std::cout, std::cerr);
  }
  std::ifstream in(arguments.file);
  if (!in) {
    std::cerr << arguments.file << ": cannot be read\n";
    return kExitBadInput;
  }
  arguments.options.input_name = arguments.file;
  return mle_tool::run_mle(arguments.options, in, std::cout, std::cerr);
}

void add_mle(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<MleArguments>();
  CLI::App* mle = app.add_subcommand("mle", "Replay a trace through the multi-level executive");
  mle->add_option("trace", arguments->file, "JSON lines (default: standard input)");
  mle->add_option("--uav", arguments->options.uav, "Own name among senders and receivers");
  mle->add_option("--until", arguments->until, "Run time conditions up to this instant [s]")
      ->check(finite_problem);
  mle->add_option("--types", arguments->options.types_file, "Task types and their resources (JSON)")
      ->check(CLI::ExistingFile);
  mle->add_option("--timeout", arguments->timeout, "Of the functional layer [s] (default: off)")
      ->check(positive_problem);
  mle->add_option("--background", arguments->options.background,
                  "Task type of the background routine (default: off)");
  mle->footer(kMleExamples);
  mle->callback([arguments, &action] { action = [arguments] { return run_mle(*arguments); }; });
}

}  // namespace

int run_command_line(int argc, char** argv) try {
  CLI::App app{"Skein: decisional autonomy for teams of UAVs", "skein"};
  app.set_version_flag("--version", std::string("skein ") + SKEIN_VERSION);
  app.require_subcommand(1);
  Action action;
  add_run(app, action);
  add_report(app, action);
  add_spy(app, action);
  add_mle(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitBadInput;
  }
  return action();
} catch (const std::exception& error) {
  std::cerr << "skein: " << error.what() << '\n';
  return kExitInternal;
}

}  // namespace skein::cli
