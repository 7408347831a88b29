// SPDX-License-Identifier: Apache-2.0
#include "model_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "argument_checks.hpp"
#include "skein/designer/edit_models.hpp"
#include "skein/model_tool/model_files.hpp"
#include "skein/model_tool/run_model.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

constexpr const char* kModelExamples = R"(
Examples:
  skein model check scenarios/models/interaction/monitoring-with-relay.yaml
  skein model draw scenarios/models/interaction/vehicle-pursuit.yaml -o pursuit.svg
  skein model edit scenarios/models/interaction/monitoring-with-relay.yaml
  echo '{"at":0,"start":true}' > trace.jsonl
  skein model run scenarios/models/interaction/monitoring-with-relay.yaml --role relay --until 900 < trace.jsonl
Formats and how to write a model: docs/interaction.md. Exit codes: 0 done, 1 some line of a trace was
refused, 2 wrong files or options, 3 the picture cannot be written.)";

void add_run(CLI::App* model, Action& action, const Actions& actions) {
  auto options = std::make_shared<model_tool::RunOptions>();
  CLI::App* command =
      model->add_subcommand("run", "Play a trace through the execution automaton of a role");
  command->add_option("automaton", options->automaton, "YAML or JSON; or a library with roles")
      ->required();
  command->add_option("trace", options->input_name, "JSON lines (default: standard input)");
  command->add_option("--role", options->role, "Which role of a library")->type_name("NAME");
  const auto set = [&seconds = options->set](const std::vector<std::string>& all) {
    for (const std::string& one : all) {
      const std::size_t equals = one.find('=');
      seconds[one.substr(0, equals)] = std::stod(one.substr(equals + 1));
    }
  };
  command
      ->add_option_function<std::vector<std::string>>(
          "--set", set, "Seconds of a parameter that conditions on time name")
      ->type_name("NAME=S")
      ->check(named_number_problem);
  add_seconds(*command, "--until", options->until, "Play on up to this instant [s]")
      ->check(finite_problem);
  when_chosen(command, options, action, actions);
}

void add_check(CLI::App* model, Action& action, const Actions& actions) {
  auto options = std::make_shared<model_tool::CheckOptions>();
  CLI::App* command = model->add_subcommand(
      "check", "Are roles, SCMs, models and automata right? Every error at once");
  command->add_option("files", options->files, "Read together, with all that they use")->required();
  command->add_flag("--json", options->json, "One JSON object instead of text for people");
  when_chosen(command, options, action, actions);
}

void add_draw(CLI::App* model, Action& action, const Actions& actions) {
  auto options = std::make_shared<model_tool::DrawOptions>();
  CLI::App* command = model->add_subcommand("draw", "Draw the variants of models, or an automaton");
  command->add_option("file", options->file, "Models, roles or an automaton")->required();
  command->add_option("-o,--output", options->output, "SVG file (default: standard output)");
  when_chosen(command, options, action, actions);
}

void add_edit(CLI::App* model, Action& action, const Actions& actions) {
  auto options = std::make_shared<designer::EditOptions>();
  CLI::App* command =
      model->add_subcommand("edit", "Change models on a page of this machine, checked meanwhile");
  command->add_option("files", options->files, "Models, with all that they use")->required();
  command->add_option("--port", options->port, "Of the loopback interface (default: a free one)");
  when_chosen(command, options, action, actions);
}

}  // namespace

void add_model(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  CLI::App* model = app.add_subcommand("model", "Check, draw, change and play interaction models");
  model->require_subcommand(1);
  model->footer(kModelExamples);
  add_check(model, action, actions);
  add_draw(model, action, actions);
  add_edit(model, action, actions);
  add_run(model, action, actions);
}

}  // namespace skein::cli
