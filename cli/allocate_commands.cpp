// SPDX-License-Identifier: Apache-2.0
#include "allocate_commands.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>

#include "choice_option.hpp"
#include "skein/allocate_tool/allocate.hpp"
#include "skein/foundation/exit_code.hpp"

namespace skein::cli {

namespace {

constexpr const char* kExamples = R"(
Examples:
  skein allocate instances.jsonl
  echo '{"vehicles":[[0,0],[9,9]],"tasks":[[1,0],[8,8],[4,4]]}' | skein allocate - --aim longest
Formats: docs/allocation.md. Exit codes: 0 everything is sold, 1 something is not (its line says why), 2 wrong input.)";

int run(const allocate_tool::AllocateOptions& options) {
  if (options.file.empty() || options.file == "-") {
    return allocate_tool::allocate({"", options.longest, options.seed}, std::cin, std::cout,
                                   std::cerr);
  }
  std::ifstream in(options.file);
  if (!in) {
    std::cerr << options.file << ": cannot be read\n";
    return kExitBadInput;
  }
  return allocate_tool::allocate(options, in, std::cout, std::cerr);
}

}  // namespace

void add_allocate(CLI::App& app, std::function<int()>& action) {
  auto options = std::make_shared<allocate_tool::AllocateOptions>();
  CLI::App* command =
      app.add_subcommand("allocate", "Who does which tasks: an auction in virtual time");
  command->add_option("file", options->file,
                      "Instances, JSON lines (default, and -: standard input)");
  add_choice(*command, "--aim", options->longest, {{"sum", false}, {"longest", true}},
             "Of tours: what is made small, sum (default) or longest");
  command->add_option("--seed", options->seed, "Of delays and of what is put back on sale")
      ->capture_default_str();
  command->footer(kExamples);
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace skein::cli
