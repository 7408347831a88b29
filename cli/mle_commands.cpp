// SPDX-License-Identifier: Apache-2.0
#include "mle_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "argument_checks.hpp"
#include "skein/mle_tool/mle.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

constexpr const char* kMleExamples = R"(
Examples:
  skein mle tests/golden/mle/example-2-9/in.jsonl --uav marvin
  skein mle --until 300 < tests/golden/mle/example-2-9/in.jsonl | grep '"dispatch"'
Formats: cli/mle/README.md. Exit codes: 0, 1 some line was wrong, 2 wrong options or files.)";

}  // namespace

void add_mle(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<mle_tool::MleOptions>();
  CLI::App* mle = app.add_subcommand("mle", "Replay a trace through the multi-level executive");
  mle->add_option("trace", options->input_name, "JSON lines (default: standard input)");
  mle->add_option("--uav", options->uav, "Own name among senders and receivers");
  add_seconds(*mle, "--until", options->until, "Run time conditions up to this instant [s]")
      ->check(finite_problem);
  mle->add_option("--types", options->types_file, "Task types and their resources (JSON)")
      ->check(CLI::ExistingFile);
  add_seconds(*mle, "--timeout", options->timeout, "Of the functional layer [s] (default: off)")
      ->check(positive_problem);
  add_seconds(*mle, "--sync-validity", options->sync_validity,
              "How long a synchronisation message counts [s] (default: for ever)")
      ->check(positive_problem);
  mle->add_option("--background", options->background,
                  "Task type of the background routine (default: off)");
  mle->footer(kMleExamples);
  when_chosen(mle, options, action, actions);
}

}  // namespace skein::cli
