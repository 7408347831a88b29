// SPDX-License-Identifier: Apache-2.0
#include "live_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "argument_checks.hpp"
#include "network_options.hpp"
#include "operate_commands.hpp"
#include "skein/functional_tool/functional.hpp"
#include "skein/replay_tool/replay.hpp"
#include "skein/state_tool/state.hpp"
#include "spy_commands.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

constexpr const char* kFunctionalExamples = R"(
Examples:
  skein functional scenarios/comets/confirmed.yaml --uav marvin --virtual    the simulator's marvin
  sed 's/heliv: {/&functional: autopilot, /' scenarios/comets/confirmed.yaml > scenarios/comets/my.yaml
  skein-sim --scenario scenarios/comets/my.yaml --node autopilot --domain 5 &   any functional layer
  skein functional scenarios/comets/my.yaml --uav heliv --domain 5              checked over DDS
Exit codes: 0 every point of the contract is kept, 1 some are not, 2 wrong input, 3 DDS refused.)";

void add_functional(CLI::App& app, Action& action, const Actions& actions) {
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
  when_chosen(functional, options, action, actions);
}

constexpr const char* kStateExamples = R"(
Examples:
  skein run scenarios/comets/confirmed.yaml                            daemons that remember
  skein state show out/comets-confirmed/state/marvin.state             whose it is, what is in it
  skein state check out/comets-confirmed/state/marvin.state            would a daemon go on from it?
  skein state export out/comets-confirmed/state/ground.state | head    every input, as JSON lines
Exit codes: 0, 1 a daemon would not go on from it, 2 it cannot be read.)";

void add_state(CLI::App& app, Action& action, const Actions& actions) {
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
    when_chosen(one, options, action, actions);
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

void add_replay(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<replay_tool::ReplayOptions>();
  CLI::App* replay = app.add_subcommand("replay", "A recorded run on the operators' page");
  replay->add_option("folder", options->folder, "Folder of a run (out/NAME)")->required();
  replay
      ->add_option("--console", options->console, "ADDRESS:PORT of the page (default: a free port)")
      ->check(port_problem);
  replay->add_option("--speed", options->speed, "Mission seconds per second, at the start")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  replay->footer(kReplayExamples);
  when_chosen(replay, options, action, actions);
}

}  // namespace

void add_live(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  add_replay(app, action, actions);
  add_operate(app, action, actions);
  add_status(app, action, actions);
  add_spy(app, action, actions);
  add_functional(app, action, actions);
  add_state(app, action, actions);
}

}  // namespace skein::cli
