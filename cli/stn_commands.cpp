// SPDX-License-Identifier: Apache-2.0
#include "stn_commands.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "skein/temporal_tool/stn.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

constexpr const char* kStnExamples = R"(
Examples:
  skein stn check plan.json --dates             consistent? and the dates of every node
  skein stn dc network.stnu --json              dynamically controllable? if not, which links break it
  skein stn dispatch plan.json --seed 3         one execution, durations drawn inside their bounds
  skein stn draw plan.json -o plan.svg          dates, contingent links dashed, the conflict in red
  skein stn draw plan.json --dot | dot -Tpdf -o plan.pdf
  skein stn convert network.stnu --to json
Formats, told from the content: docs/temporal.md. Without a file, or with -, standard input is read.
Exit codes: 0 consistent or controllable, 1 not, 2 wrong input, 3 the output cannot be written.)";

// Colour for a terminal, unless the environment asks for none (no-color.org).
bool colour_wanted() {
  const char* refused = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) != 0 && (refused == nullptr || *refused == '\0');
}

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

// A sub-command of `stn` with what all of them take.
CLI::App* add_stn_command(CLI::App* stn, const std::string& name, const std::string& help,
                          temporal_tool::StnOptions& common) {
  CLI::App* command = stn->add_subcommand(name, help);
  command->add_option("file", common.file,
                      "Network, in any of the formats (default: standard input)");
  common.now = steady_seconds;
  return command;
}

void add_json(CLI::App* command, temporal_tool::StnOptions& common) {
  command->add_flag("--json", common.json, "One JSON object instead of text for people");
  common.colour = colour_wanted();
}

// `command` runs `function` on the options and the standard streams.
template <class Options, class Function>
void act(CLI::App* command, const std::shared_ptr<Options>& options, Function function,
         Action& action) {
  command->callback([options, function, &action] {
    action = [options, function] { return function(*options, std::cin, std::cout, std::cerr); };
  });
}

void add_stn_checks(CLI::App* stn, Action& action) {
  auto check = std::make_shared<temporal_tool::StnCheckOptions>();
  CLI::App* check_command = add_stn_command(
      stn, "check", "Is it consistent, as if durations could be chosen?", check->common);
  add_json(check_command, check->common);
  check_command->add_flag("--dates", check->dates,
                          "Also the earliest and latest date of each node");
  act(check_command, check, temporal_tool::check_stn, action);

  auto control = std::make_shared<temporal_tool::StnOptions>();
  CLI::App* control_command =
      add_stn_command(stn, "dc", "Is it dynamically controllable?", *control);
  add_json(control_command, *control);
  act(control_command, control, temporal_tool::check_stn_controllability, action);

  auto dispatch = std::make_shared<temporal_tool::StnDispatchOptions>();
  CLI::App* dispatch_command =
      add_stn_command(stn, "dispatch", "Play an execution with random durations", dispatch->common);
  add_json(dispatch_command, dispatch->common);
  dispatch_command->add_option("--seed", dispatch->seed, "Seed of the durations and starts");
  const std::map<std::string, temporal_tool::StnStarts> starts{
      {"earliest", temporal_tool::StnStarts::kEarliest},
      {"latest", temporal_tool::StnStarts::kLatest},
      {"random", temporal_tool::StnStarts::kRandom}};
  dispatch_command->add_option("--starts", dispatch->starts, "earliest, latest or random")
      ->transform(CLI::CheckedTransformer(starts));
  act(dispatch_command, dispatch, temporal_tool::dispatch_stn, action);
}

void add_stn_writers(CLI::App* stn, Action& action) {
  auto draw = std::make_shared<temporal_tool::StnDrawOptions>();
  CLI::App* draw_command = add_stn_command(stn, "draw", "Draw it", draw->common);
  CLI::Option* dot = draw_command->add_flag("--dot", draw->dot, "Text for Graphviz");
  draw_command->add_flag("--svg")->description("A picture (default)")->excludes(dot);
  draw_command->add_option("--title", draw->title, "Above the picture");
  draw_command->add_option("-o,--output", draw->output, "File (default: standard output)");
  act(draw_command, draw, temporal_tool::draw_stn, action);

  auto convert = std::make_shared<temporal_tool::StnConvertOptions>();
  CLI::App* convert_command =
      add_stn_command(stn, "convert", "Write it in another format", convert->common);
  convert_command->add_option("--to", convert->to, "json, heatlab, graphml or plain")->required();
  convert_command->add_option("-o,--output", convert->output, "File (default: standard output)");
  act(convert_command, convert, temporal_tool::convert_stn, action);
}

}  // namespace

void add_stn(CLI::App& app, std::function<int()>& action) {
  CLI::App* stn = app.add_subcommand("stn", "Check, play, draw and convert a temporal network");
  stn->require_subcommand(1);
  stn->footer(kStnExamples);
  add_stn_checks(stn, action);
  add_stn_writers(stn, action);
}

}  // namespace skein::cli
