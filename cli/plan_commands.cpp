// SPDX-License-Identifier: Apache-2.0
#include "plan_commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <memory>
#include <span>
#include <string_view>

#include "actions.hpp"
#include "argument_checks.hpp"
#include "skein/plan_tool/plan.hpp"

namespace skein::cli {

namespace {

using htn::Which;

constexpr const char* kPlanExamples = R"(
Files come before options that may take words (--trace, --optimize-cost). "-" is standard input.
Examples:
  cp libs/htn/test/domains/uav.lisp .                  a domain with three problems
  skein plan uav.lisp --problem one-uav                the first plan, as SHOP2 finds it
  skein plan uav.lisp --problem two-uavs --tree        how the tasks were decomposed, and what needed what
  skein plan uav.lisp --problem one-uav --which best --time-limit 5      the cheapest, or the best found in 5 s
  skein plan uav.lisp --problem too-far --why-not      where the search came furthest and what was missing
  skein plan uav.lisp --problem two-uavs --trace fly   how each task `fly` was tried
  skein plan uav.lisp --problem two-uavs --dot plan.dot && dot -Tsvg plan.dot > plan.svg
  skein plan uav.lisp --problem two-uavs --json > plans.jsonl
  skein plan uav.lisp --validate plans.jsonl
  cd scenarios/domains && skein plan comets.lisp karma.lisp --world seeds.yaml --vehicle seeds-uav.yaml --taskreq
Guide and formats: docs/planning.md. Exit codes: 0 every problem has a plan (plans valid), 1 some has none
(not valid), 2 wrong files or options, 4 a limit came first, 130 Ctrl-C (the best plan so far is shown).)";

const std::map<std::string, Which> kWhich = {{"first", Which::kFirst},
                                             {"all", Which::kAll},
                                             {"shallowest", Which::kShallowest},
                                             {"all-shallowest", Which::kAllShallowest},
                                             {"id-first", Which::kIdFirst},
                                             {"id-all", Which::kIdAll},
                                             {"best", Which::kBest}};

// What the command line gives as plain values.
struct Arguments {
  plan_tool::PlanOptions options;
  std::optional<std::string> cost_limit;  // empty: none given
  std::optional<double> memory_mb;
};

plan_tool::PlanOptions options_of(const Arguments& arguments) {
  plan_tool::PlanOptions options = arguments.options;
  htn::Options& search = options.search;
  if (arguments.cost_limit && !arguments.cost_limit->empty()) {
    search.cost_limit = std::strtod(arguments.cost_limit->c_str(), nullptr);
  } else if (arguments.cost_limit) {
    search.optimize_cost = true;
  }
  if (arguments.memory_mb) {
    search.limits.memory_bytes = static_cast<std::uint64_t>(*arguments.memory_mb * 1e6);
  }
  return options;
}

void add_limits(CLI::App& plan, Arguments& arguments) {
  htn::Limits& limits = arguments.options.search.limits;
  constexpr const char* kGroup = "Limits (each ends the search with what was found so far)";
  const auto count = [&](const char* name, std::optional<std::uint64_t>& limit, const char* help) {
    plan.add_option(name, limit, help)->check(count_problem)->group(kGroup);
  };
  plan.add_option("--time-limit", limits.seconds, "Processor time of each problem [s]")
      ->check(positive_problem)
      ->group(kGroup);
  count("--expansions", limits.expansions, "Tasks taken");
  count("--inferences", limits.inferences, "Goals tried");
  count("--depth", limits.depth, "Decompositions and steps along one path");
  count("--plans", limits.plans, "Plans found");
  plan.add_option("--memory", arguments.memory_mb,
                  "Memory of the search [MB] (default: 3/4 of what is available)")
      ->check(megabytes_problem)
      ->group(kGroup);
}

void add_outputs(CLI::App& plan, plan_tool::PlanOptions& options) {
  constexpr const char* kGroup = "What is shown";
  plan.add_flag("--tree", options.tree, "The decomposition, with what each step was needed for")
      ->group(kGroup);
  plan.add_option("--dot", options.dot,
                  "Write the decomposition for Graphviz; - is standard output")
      ->type_name("FILE")
      ->group(kGroup);
  plan.add_flag("--json", options.json, "One JSON object a line for each problem")->group(kGroup);
  plan.add_flag("--no-internal", options.no_internal, "Leave internal steps (!!name) out")
      ->group(kGroup);
  plan.add_option_function<std::vector<std::string>>(
          "--trace",
          [&options](const std::vector<std::string>& tasks) {
            options.trace = true;
            for (const std::string& task : tasks) {
              if (!task.empty()) options.search.traced_tasks.push_back(task);
            }
          },
          "Why methods of these tasks (default: all) are tried, fail or are chosen")
      ->expected(0, CLI::detail::expected_max_vector_size)
      ->type_name("TASK")
      ->group(kGroup);
  plan.add_flag("--why-not", options.why_not,
                "Without a plan: where the search came furthest, or was cut")
      ->group(kGroup);
  plan.add_flag("--states", options.states, "What each step makes false (-) and true (+)")
      ->group(kGroup);
  plan.add_flag("--quiet", options.quiet, "No warnings, no progress")->group(kGroup);
}

// "x,y,z".
std::string home_problem(const std::string& text) {
  double x = 0, y = 0, z = 0;
  int end = -1;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &x, &y, &z, &end) == 3 &&
      end == static_cast<int>(text.size()) && std::isfinite(x + y + z))
    return {};
  return "'" + text + "' is no place; expected X,Y,Z";
}

void add_mission(CLI::App& plan, plan_tool::MissionFiles& files) {
  constexpr const char* kGroup = "Domains of missions, which ask refiners (docs/comets-domain.md)";
  CLI::Option* world = plan.add_option("--world", files.world, "Where it flies: a world file")
                           ->type_name("FILE")
                           ->group(kGroup);
  CLI::Option* vehicle = plan.add_option("--vehicle", files.vehicle, "What flies: a vehicle model")
                             ->type_name("FILE")
                             ->needs(world)
                             ->group(kGroup);
  world->needs(vehicle);
  plan.add_option("--uav", files.uav, "Its name (default: the model's)")
      ->type_name("NAME")
      ->needs(world)
      ->group(kGroup);
  plan.add_option_function<std::string>(
          "--home",
          [&files](const std::string& text) {
            std::sscanf(text.c_str(), "%lf,%lf,%lf", &files.home[0], &files.home[1],
                        &files.home[2]);
          },
          "Where it takes off and lands [m] (default: 0,0,0)")
      ->check(home_problem)
      ->type_name("X,Y,Z")
      ->needs(world)
      ->group(kGroup);
  plan.add_option("--altitude", files.altitude, "Of flights, over the ground [m] (default: 40)")
      ->check(positive_problem)
      ->needs(world)
      ->group(kGroup);
  plan.add_flag("--taskreq", files.taskreq, "Elementary tasks, in the form of the seeds")
      ->needs(world)
      ->group(kGroup);
}

void add_repair(CLI::App& plan, plan_tool::PlanOptions& options) {
  constexpr const char* kGroup = "Repair of a plan under execution";
  CLI::Option* repair =
      plan.add_option("--repair", options.repair, "Repair the plan of this file (--json --tree)")
          ->type_name("PLAN")
          ->excludes("--validate")
          ->group(kGroup);
  plan.add_option("--executed", options.executed, "How many of its steps were executed")
      ->check(whole_problem)
      ->needs(repair)
      ->group(kGroup);
  plan.add_option("--diverge", options.diverge,
                  "What changed by itself then: (:add (fact)…) (:delete (fact)…); "
                  "earlier: (:after N (:add …))")
      ->type_name("FORM")
      ->needs(repair)
      ->group(kGroup);
}

// Whether an argument names one of these options.
bool any_named(std::span<char* const> words, std::initializer_list<std::string_view> options) {
  const auto is_one = [&](std::string_view word) {
    word = word.substr(0, word.find('='));
    return std::find(options.begin(), options.end(), word) != options.end();
  };
  return words.empty() || std::any_of(words.begin(), words.end(), is_one);
}

}  // namespace

void add_plan(CLI::App& app, std::function<int()>& action, const Actions& actions,
              std::span<char* const> words) {
  auto arguments = std::make_shared<Arguments>();
  plan_tool::PlanOptions& options = arguments->options;
  CLI::App* plan = app.add_subcommand("plan", "Plan the problems of files in SHOP2's language");
  plan->add_option("files", options.files, "Domains and problems, in any order")->required();
  plan->add_option("--problem", options.problems, "Only this problem; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  plan->add_option_function<std::string>(
          "--which",
          [&options](const std::string& word) { options.search.which = kWhich.at(word); },
          "Which plans (default: first)")
      ->check(CLI::IsMember(kWhich));
  plan->add_option("--optimize-cost", arguments->cost_limit,
                   "Keep the cheapest plan; with N, take only plans up to that cost")
      ->expected(0, 1)
      ->check([](const std::string& text) { return text.empty() ? "" : finite_problem(text); })
      ->type_name("N");
  plan->add_option("--validate", options.validate, "Check the plans of this file, plan nothing")
      ->type_name("PLAN");
  if (any_named(words, {"--repair", "--executed", "--diverge"})) add_repair(*plan, options);
  if (any_named(words, {"--world", "--vehicle", "--uav", "--home", "--altitude", "--taskreq"})) {
    add_mission(*plan, options.mission);
  }
  if (any_named(words, {"--time-limit", "--expansions", "--inferences", "--depth", "--plans",
                        "--memory"})) {
    add_limits(*plan, *arguments);
  }
  add_outputs(*plan, options);
  plan->footer(kPlanExamples);
  plan->callback([arguments, &action, &actions] {
    action = [arguments, &actions] { return actions.carry_out(options_of(*arguments)); };
  });
}

}  // namespace skein::cli
