// SPDX-License-Identifier: Apache-2.0
#include "mastn_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "choice_option.hpp"
#include "skein/temporal_tool/mastn.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

constexpr const char* kGenerateExamples = R"(
Examples:
  skein mastn generate --agents 3 --nodes 8 --seed 7 > network.json
  skein mastn generate --mode free --relaxations 0.4 --out network.json
The same options give the same file on every machine. Exit codes: 0, 2 wrong options, 3 not written.)";

void add_mastn_generate(CLI::App& mastn, Action& action, const Actions& actions) {
  auto options = std::make_shared<temporal_tool::MastnGenerateOptions>();
  CLI::App* generate = mastn.add_subcommand("generate", "Write a random network and scenario");
  temporal::MastnShape& shape = options->shape;
  generate->add_option("--agents", shape.agents, "Agents (N)")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  generate->add_option("--nodes", shape.nodes, "Nodes of each agent (V)")
      ->check(CLI::Range(1, 2'000))
      ->capture_default_str();
  generate->add_option("--local", shape.local, "Arcs of each agent besides its chain (L)")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  generate->add_option("--external", shape.external, "Arcs of each agent to others (E)")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  add_choice(*generate, "--mode", options->scenario.mode,
             {{"kept", temporal::ScenarioMode::kKept}, {"free", temporal::ScenarioMode::kFree}},
             "Relaxations stay inside what the others allow when they can (kept, the default), or "
             "not (free)");
  generate->add_option("--relaxations", options->scenario.relaxations, "Their share of the steps")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  generate->add_option("--seed", options->seed, "Of everything random")->capture_default_str();
  generate->add_option("--out", options->out, "File (default: standard output)");
  generate->footer(kGenerateExamples);
  when_chosen(generate, options, action, actions);
}

constexpr const char* kMastnRunExamples = R"(
Examples:
  skein mastn generate --agents 3 --nodes 8 --seed 7 > network.json
  skein mastn run network.json --algorithm dip-l
  skein mastn run network.json --algorithm dip-m --delays --cuts --seed 3
  skein mastn generate | skein mastn run - --algorithm cip
Prints one JSON object: {"consistent":…, "bounds":{"a1":[min,max],…}, "messages":{…}, "checks":{…}}; bounds
in seconds, null when infinite, none while inconsistent; counts include the agents' first exchange.
Exit codes: 0 played, consistent or not; 2 wrong input.)";

void add_mastn_run(CLI::App& mastn, Action& action, const Actions& actions) {
  auto options = std::make_shared<temporal_tool::MastnRunOptions>();
  CLI::App* run = mastn.add_subcommand("run", "Play a file's steps through the agents");
  run->add_option("file", options->file, "Network and steps (JSON); -: standard input")->required();
  run->add_option("--algorithm", options->algorithm, "cip, dip-g, dip-l or dip-m")
      ->required()
      ->check(CLI::IsMember({"cip", "dip-g", "dip-l", "dip-m"}));
  run->add_flag("--delays", options->delays, "Messages take random times");
  run->add_flag("--cuts", options->cuts, "Links are cut and heal at random; all heal at the end");
  run->add_option("--seed", options->seed, "Of delays and cuts")->capture_default_str();
  run->footer(kMastnRunExamples);
  when_chosen(run, options, action, actions);
}

constexpr const char* kBenchExamples = R"(
Examples:
  skein mastn bench                     480 networks, half in mode K and half in mode F
  skein mastn bench --quick --out /tmp/mastn
  skein mastn bench --agents 4,8 --external 0,2,6 --nodes 40 --relaxations 0.3 --networks 5
Claims about means gate only with the usual V, L and share of relaxations.
Writes mastn.csv, results.md and the plots (SVG). Exit codes: 0, 1 a claim does not hold, 3 not written.)";

void add_mastn_bench(CLI::App& mastn, Action& action, const Actions& actions) {
  auto options = std::make_shared<temporal_tool::MastnBenchOptions>();
  CLI::App* bench = mastn.add_subcommand("bench", "The experiment: figures, plots and claims");
  bench->add_option("--out", options->out, "Folder for the results")->capture_default_str();
  bench->add_flag("--quick", options->quick, "Three networks per parameter set, at most 8 agents");
  bench->add_option("--seed", options->seed, "Of the first network")->capture_default_str();
  const auto list = [bench](const char* name, auto& values, const char* help, int most) {
    bench->add_option(name, values, help)
        ->delimiter(',')
        ->check(CLI::Range(0, most))
        ->type_name("N,…");
  };
  list("--agents", options->agents, "Numbers of agents N (default 2,4,8,16)", 64);
  list("--external", options->external,
       "Arcs of each agent to others E (default 0,1,2,4,8,12; 0.7 of the nodes have one at 12)",
       1000);
  bench->add_option("--nodes", options->nodes, "Nodes of each agent V (default 20)")
      ->check(CLI::Range(1, 1000));
  bench->add_option("--local", options->local, "Local arcs L besides the chain (default 10)")
      ->check(CLI::Range(0, 10'000));
  bench->add_option("--relaxations", options->relaxations, "Share of the steps (default 0.1)")
      ->check(CLI::Range(0.0, 1.0));
  bench->add_option("--networks", options->networks, "Of each parameter set (default 10)")
      ->check(CLI::Range(1, 1000));
  bench->footer(kBenchExamples);
  when_chosen(bench, options, action, actions);
}

}  // namespace

void add_mastn(CLI::App& app, Action& action, const Actions& actions) {
  CLI::App* mastn = app.add_subcommand("mastn", "Temporal networks shared by several agents");
  mastn->require_subcommand(1);
  add_mastn_generate(*mastn, action, actions);
  add_mastn_run(*mastn, action, actions);
  add_mastn_bench(*mastn, action, actions);
}

}  // namespace skein::cli
