// SPDX-License-Identifier: Apache-2.0
#include "allocate_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "choice_option.hpp"
#include "skein/allocate_tool/allocate.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

constexpr const char* kAllocateExamples = R"(
Examples:
  echo '{"vehicles":[[0,0],[9,9]],"tasks":[[1,0],[8,8],[4,4]]}' > instances.jsonl
  skein allocate instances.jsonl
  skein allocate - --aim longest < instances.jsonl
Formats: docs/allocation.md. Exit codes: 0 everything is sold, 1 something is not (its line says why), 2 wrong input.)";

}  // namespace

void add_allocate(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<allocate_tool::AllocateOptions>();
  CLI::App* command =
      app.add_subcommand("allocate", "Who does which tasks: an auction in virtual time");
  command->add_option("file", options->file,
                      "Instances, JSON lines (default, and -: standard input)");
  add_choice(*command, "--aim", options->longest, {{"sum", false}, {"longest", true}},
             "Of tours: what is made small, sum (default) or longest");
  command->add_option("--seed", options->seed, "Of delays and of what is put back on sale")
      ->capture_default_str();
  command->footer(kAllocateExamples);
  when_chosen(command, options, action, actions);
}

}  // namespace skein::cli
