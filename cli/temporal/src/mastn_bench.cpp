// SPDX-License-Identifier: Apache-2.0
// `skein mastn bench`: the experiment of spec 5.4.
#include <algorithm>
#include <filesystem>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/mastn_experiment/experiment_report.hpp"
#include "skein/temporal_tool/mastn.hpp"
#include "write_file.hpp"

namespace skein::temporal_tool {

namespace {

using temporal::ScenarioMode;

/// A file of the results' folder.
struct ResultFile {
  std::string name;
  std::string text;
};

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

temporal::ExperimentPlan plan_of(const MastnBenchOptions& options) {
  temporal::ExperimentPlan plan;
  plan.seed = options.seed;
  if (options.quick) {
    plan.agents = {2, 4, 8};
    plan.networks = 3;
  }
  plan.agents = sorted(options.agents.value_or(plan.agents));
  plan.external = sorted(options.external.value_or(plan.external));
  plan.nodes = options.nodes.value_or(plan.nodes);
  plan.local = options.local.value_or(plan.local);
  plan.networks = options.networks.value_or(plan.networks);
  plan.relaxations = options.relaxations.value_or(plan.relaxations);
  return plan;
}

// The margins of claims about means are measured with the paper's networks.
std::vector<temporal::Claim> claims_about(const std::vector<temporal::ExperimentRow>& rows,
                                          const temporal::ExperimentPlan& plan) {
  const temporal::ExperimentPlan usual;
  std::vector<temporal::Claim> claims = temporal::check_claims(rows);
  const bool as_usual = plan.nodes == usual.nodes && plan.local == usual.local &&
                        plan.relaxations == usual.relaxations;
  for (temporal::Claim& claim : claims) {
    if (!as_usual && claim.kind == temporal::ClaimKind::kStatistical) {
      claim.kind = temporal::ClaimKind::kReported;
    }
  }
  return claims;
}

std::string results_page(const std::vector<temporal::ExperimentCell>& cells,
                         const std::vector<temporal::Claim>& claims) {
  return "# Results of `skein mastn bench`\n\n## Worst cases (figure 4)\n\n" + figure_4(cells) +
         "\n## Most messages of one perturbation\n\n" + tail_table(cells, ScenarioMode::kKept) +
         "\n" + tail_table(cells, ScenarioMode::kFree) + "\n## Mode K\n\n" +
         results_table(cells, ScenarioMode::kKept) + "\n## Mode F\n\n" +
         results_table(cells, ScenarioMode::kFree) + "\n## Claims\n\n" + claims_table(claims);
}

std::vector<ResultFile> files_of(const std::vector<temporal::ExperimentRow>& rows,
                                 const std::vector<temporal::ExperimentCell>& cells,
                                 const std::vector<temporal::Claim>& claims) {
  std::vector<ResultFile> files = {{"mastn.csv", to_csv(rows)},
                                   {"results.md", results_page(cells, claims)}};
  for (const auto& [mode, suffix] :
       {std::pair(ScenarioMode::kKept, ""), std::pair(ScenarioMode::kFree, "-stress")}) {
    for (temporal::ExperimentPlot& plot : figure_5(cells, mode)) {
      files.push_back({"mastn-" + plot.name + suffix + ".svg", std::move(plot.svg)});
    }
  }
  return files;
}

}  // namespace

int bench_mastn(const MastnBenchOptions& options, std::ostream& out, std::ostream& err) {
  std::error_code failed;
  std::filesystem::create_directories(options.out, failed);
  if (failed) {
    err << options.out << ": " << failed.message() << '\n';
    return kExitSystem;
  }
  const temporal::ExperimentPlan plan = plan_of(options);
  const std::vector<temporal::ExperimentRow> rows =
      temporal::run_experiment(plan, [&err](std::size_t done, std::size_t total) {
        if (done * 10 / total == (done - 1) * 10 / total) return;
        err << done << " of " << total << " networks" << std::endl;
      });
  const std::vector<temporal::ExperimentCell> cells = temporal::cells_of(rows);
  const std::vector<temporal::Claim> claims = claims_about(rows, plan);
  for (const ResultFile& file : files_of(rows, cells, claims)) {
    const std::string path = (std::filesystem::path(options.out) / file.name).string();
    if (const std::optional<Failure> wrong = write_file(path, file.text)) {
      err << path << ": " << wrong->why << '\n';
      return kExitSystem;
    }
  }
  out << figure_4(cells) << '\n' << claims_table(claims);
  err << "written to " << options.out << '\n';
  return all_gates_hold(claims) ? kExitOk : kExitNegative;
}

}  // namespace skein::temporal_tool
