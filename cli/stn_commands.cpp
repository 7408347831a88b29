// SPDX-License-Identifier: Apache-2.0
#include "stn_commands.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <memory>

#include "actions.hpp"
#include "choice_option.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

constexpr const char* kStnExamples = R"(
Examples:
  skein stn generate --nodes 200 --contingent 20 --seed 3 > plan.json
  skein stn check plan.json --dates             consistent? and the dates of every node
  skein stn convert plan.json --to plain > network.stnu
  skein stn dc network.stnu --json               dynamically controllable? if not, which links break it
  skein stn dispatch plan.json --seed 3         one execution, durations drawn inside their bounds
  skein stn draw plan.json -o plan.svg          dates, contingent links dashed, the conflict in red
  skein stn draw plan.json --dot | dot -Tpdf -o plan.pdf
  skein stn convert network.stnu --to json
  skein stn dispatchable plan.json -o form.json
  echo '[{"from":"z","to":"l0n0","min":1,"max":20}]' > changes.json
  skein stn dc plan.json --changes changes.json   one verdict for each change, by the incremental check
  mkdir networks && mv plan.json network.stnu networks
  skein stn dc --batch networks/                  every file of a folder, with statistics
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
  command->add_flag("--z-first", common.z_first,
                    "No node comes before the origin, whatever the file says: as the CSTNU Tool "
                    "takes every network");
  common.now = steady_seconds;
  return command;
}

void add_json(CLI::App* command, temporal_tool::StnOptions& common) {
  command->add_flag("--json", common.json, "One JSON object instead of text for people");
  common.colour = colour_wanted();
}

// Without a file: the question about every file of a folder.
std::shared_ptr<temporal_tool::StnBatchOptions> add_batch(CLI::App* command) {
  auto batch = std::make_shared<temporal_tool::StnBatchOptions>();
  command
      ->add_option(
          "--batch", batch->folder,
          "Every file of this folder, with statistics; exit code 0 if the answer is yes for "
          "all, 1 if not, 2 if some cannot be used")
      ->type_name("FOLDER")
      ->excludes(command->get_option("file"));
  return batch;
}

int ask_batch(temporal_tool::StnBatchOptions batch, const temporal_tool::StnOptions& common,
              temporal_tool::StnQuestion question, const Actions& actions) {
  batch.common = common;
  batch.question = question;
  return actions.carry_out(batch);
}

void add_stn_check(CLI::App* stn, Action& action, const Actions& actions) {
  auto check = std::make_shared<temporal_tool::StnCheckOptions>();
  CLI::App* command = add_stn_command(
      stn, "check", "Is it consistent, as if durations could be chosen?", check->common);
  add_json(command, check->common);
  command->add_flag("--dates", check->dates, "Also the earliest and latest date of each node");
  const auto batch = add_batch(command);
  command->callback([check, batch, &action, &actions] {
    action = [check, batch, &actions] {
      if (!batch->folder.empty()) {
        return ask_batch(*batch, check->common, temporal_tool::StnQuestion::kConsistent, actions);
      }
      return actions.carry_out(*check);
    };
  });
}

void add_stn_dc(CLI::App* stn, Action& action, const Actions& actions) {
  auto changes = std::make_shared<temporal_tool::StnChangesOptions>();
  temporal_tool::StnOptions& common = changes->common;
  CLI::App* command = add_stn_command(stn, "dc", "Is it dynamically controllable?", common);
  add_json(command, common);
  const auto batch = add_batch(command);
  CLI::Option* file =
      command
          ->add_option(
              "--changes", changes->changes,
              R"(New bounds one after the other, [{"from","to","min","max"}, …]: a verdict )"
              "after each, by the incremental check")
          ->type_name("FILE")
          ->excludes(command->get_option("--batch"));
  command->add_flag("--compare", changes->compare, "Also check from scratch after each change")
      ->needs(file);
  command->callback([changes, batch, &action, &actions] {
    action = [changes, batch, &actions] {
      if (!batch->folder.empty()) {
        return ask_batch(*batch, changes->common, temporal_tool::StnQuestion::kControllable,
                         actions);
      }
      return changes->changes.empty() ? actions.carry_out(changes->common)
                                      : actions.carry_out(*changes);
    };
  });
}

void add_stn_dispatch(CLI::App* stn, Action& action, const Actions& actions) {
  auto dispatch = std::make_shared<temporal_tool::StnDispatchOptions>();
  CLI::App* dispatch_command =
      add_stn_command(stn, "dispatch", "Play an execution with random durations", dispatch->common);
  add_json(dispatch_command, dispatch->common);
  dispatch_command->add_option("--seed", dispatch->seed, "Seed of the durations and starts")
      ->capture_default_str();
  add_choice(*dispatch_command, "--starts", dispatch->starts,
             {{"earliest", temporal_tool::StnStarts::kEarliest},
              {"latest", temporal_tool::StnStarts::kLatest},
              {"random", temporal_tool::StnStarts::kRandom}},
             "When to execute what may be executed: earliest (default), latest or random");
  when_chosen(dispatch_command, dispatch, action, actions);
}

void add_stn_generate(CLI::App* stn, Action& action, const Actions& actions) {
  auto options = std::make_shared<temporal_tool::StnGenerateOptions>();
  temporal::StnuGeneratorOptions& shape = options->shape;
  CLI::App* command = stn->add_subcommand("generate", "Write a random plan in parallel lanes");
  command->add_option("--nodes", shape.nodes, "Nodes, the origin included")
      ->check(CLI::Range(7, 100'000))
      ->capture_default_str();
  command->add_option("--contingent", shape.contingent, "Contingent links")
      ->check(CLI::Range(0, 30'000))
      ->capture_default_str();
  command->add_option("--lanes", shape.lanes, "Parallel lanes")
      ->check(CLI::Range(2, 10'000))
      ->capture_default_str();
  command->add_option("--extra", shape.extra_arcs_percent, "Arcs beside the lanes [% of the nodes]")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  command->add_flag("--broken", shape.break_it, "Not dynamically controllable (else it is)");
  command->add_option("--seed", options->seed, "Of everything random")->capture_default_str();
  command->add_option("--to", options->to, "json, heatlab, graphml or plain")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "File (default: standard output)");
  when_chosen(command, options, action, actions);
}

void add_stn_writers(CLI::App* stn, Action& action, const Actions& actions) {
  auto form = std::make_shared<temporal_tool::StnDispatchableOptions>();
  CLI::App* form_command =
      add_stn_command(stn, "dispatchable",
                      "Write its dispatchable form: edges and waits for an executor", form->common);
  form_command->add_option("--to", form->to, "json or graphml")->capture_default_str();
  form_command->add_option("-o,--output", form->output, "File (default: standard output)");
  when_chosen(form_command, form, action, actions);

  auto draw = std::make_shared<temporal_tool::StnDrawOptions>();
  CLI::App* draw_command = add_stn_command(stn, "draw", "Draw it", draw->common);
  CLI::Option* dot = draw_command->add_flag("--dot", draw->dot, "Text for Graphviz");
  draw_command->add_flag("--svg")->description("A picture (default)")->excludes(dot);
  draw_command->add_option("--title", draw->title, "Above the picture");
  draw_command->add_option("-o,--output", draw->output, "File (default: standard output)");
  when_chosen(draw_command, draw, action, actions);

  auto convert = std::make_shared<temporal_tool::StnConvertOptions>();
  CLI::App* convert_command =
      add_stn_command(stn, "convert", "Write it in another format", convert->common);
  convert_command->add_option("--to", convert->to, "json, heatlab, graphml or plain")->required();
  convert_command->add_option("-o,--output", convert->output, "File (default: standard output)");
  when_chosen(convert_command, convert, action, actions);
}

}  // namespace

void add_stn(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  CLI::App* stn =
      app.add_subcommand("stn", "Check, play, draw, convert and generate temporal networks");
  stn->require_subcommand(1);
  stn->footer(kStnExamples);
  add_stn_check(stn, action, actions);
  add_stn_dc(stn, action, actions);
  add_stn_dispatch(stn, action, actions);
  add_stn_generate(stn, action, actions);
  add_stn_writers(stn, action, actions);
}

}  // namespace skein::cli
