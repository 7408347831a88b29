// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <functional>
#include <iostream>
#include <span>
#include <string_view>

#include "allocate_commands.hpp"
#include "argument_checks.hpp"
#include "import_commands.hpp"
#include "live_commands.hpp"
#include "manual_commands.hpp"
#include "mastn_commands.hpp"
#include "model_commands.hpp"
#include "plan_commands.hpp"
#include "refine_commands.hpp"
#include "series_commands.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/mle_tool/mle.hpp"
#include "stn_commands.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

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
  std::optional<double> sync_validity;
};

int run_mle(MleArguments arguments) {
  if (arguments.until) arguments.options.until = MissionTime::seconds(*arguments.until);
  if (arguments.timeout) arguments.options.timeout = Duration::seconds(*arguments.timeout);
  if (arguments.sync_validity) {
    arguments.options.sync_validity = Duration::seconds(*arguments.sync_validity);
  }
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
  mle->add_option("--sync-validity", arguments->sync_validity,
                  "How long a synchronisation message counts [s] (default: for ever)")
      ->check(positive_problem);
  mle->add_option("--background", arguments->options.background,
                  "Task type of the background routine (default: off)");
  mle->footer(kMleExamples);
  mle->callback([arguments, &action] { action = [arguments] { return run_mle(*arguments); }; });
}

// `skein plan` with what its arguments name: describing all commands and options to CLI11 costs
// more than a small plan. No action if something is wrong, or help is asked for.
Action quick_plan(int argc, char** argv) {
  Action action;
  if (argc < 3 || std::string_view(argv[1]) != "plan") return action;
  CLI::App app{"Skein", "skein"};
  add_plan(app, action, std::span(argv, static_cast<std::size_t>(argc)).subspan(2));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError&) {
    return {};
  }
  return action;
}

void add_commands(CLI::App& app, Action& action, const LiveActions& live) {
  add_allocate(app, action);
  add_live(app, action, live);
  add_import(app, action, live);
  add_series(app, action, live);
  add_mle(app, action);
  add_plan(app, action);
  add_mastn(app, action);
  add_model(app, action, live);
  add_stn(app, action);
  add_refine(app, action, live);
  add_terrain(app, action, live);
  add_manual(app, action);
}

}  // namespace

int run_command_line(int argc, char** argv, const LiveActions& live) try {
  if (const Action plan = quick_plan(argc, argv)) return plan();
  CLI::App app{"Skein: decisional autonomy for teams of UAVs", "skein"};
  app.set_version_flag("--version", std::string("skein ") + SKEIN_VERSION);
  app.require_subcommand(1);
  Action action;
  add_commands(app, action, live);
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
