// SPDX-License-Identifier: Apache-2.0
#include "skein/mastn_experiment/experiment_report.hpp"

#include <algorithm>
#include <functional>

#include "claim_text.hpp"
#include "skein/mastn_experiment/line_plot.hpp"

namespace skein::temporal {

namespace {

/// A curve of a plot: its name and what it takes from a cell.
struct Curve {
  std::string name;
  std::function<Spread(const ExperimentCell&)> value;
};

std::function<Spread(const ExperimentCell&)> of(Algorithm algorithm, Spread CellFigures::*member) {
  return [=](const ExperimentCell& cell) { return cell.of(algorithm).*member; };
}

std::vector<Curve> message_curves() {
  return {{"CIP", of(Algorithm::kCip, &CellFigures::data)},
          {"DIP-L", of(Algorithm::kDipL, &CellFigures::data)},
          {"DIP-M, per bound", of(Algorithm::kDipM, &CellFigures::data)},
          {"DIP-M, packed", of(Algorithm::kDipM, &CellFigures::packs)},
          {"DIP-G", of(Algorithm::kDipG, &CellFigures::data)}};
}

std::vector<Curve> computation_curves() {
  return {{"CIP", of(Algorithm::kCip, &CellFigures::computation)},
          {"DIP-L", of(Algorithm::kDipL, &CellFigures::computation)},
          {"DIP-M", of(Algorithm::kDipM, &CellFigures::computation)},
          {"DIP-M, eliminations", of(Algorithm::kDipM, &CellFigures::eliminations)},
          {"DIP-G", of(Algorithm::kDipG, &CellFigures::computation)}};
}

LinePlot plot_of(const std::vector<ExperimentCell>& cells, const std::vector<Curve>& curves,
                 const std::function<double(const ExperimentCell&)>& x) {
  LinePlot plot;
  for (const Curve& curve : curves) {
    PlotSeries series{curve.name, {}};
    for (const ExperimentCell& cell : cells) {
      const Spread value = curve.value(cell);
      series.points.push_back({x(cell), value.mean, value.deviation});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

// The one asked for if it is among them, else the greatest.
std::uint32_t nearest_of(std::vector<std::uint32_t> values, std::uint32_t wanted) {
  if (std::find(values.begin(), values.end(), wanted) != values.end()) return wanted;
  return *std::max_element(values.begin(), values.end());
}

std::vector<ExperimentCell> select(const std::vector<ExperimentCell>& cells,
                                   std::uint32_t MastnShape::*member, std::uint32_t wanted) {
  std::vector<std::uint32_t> values;
  for (const ExperimentCell& cell : cells) values.push_back(cell.shape.*member);
  const std::uint32_t chosen = nearest_of(values, wanted);
  std::vector<ExperimentCell> selected;
  for (const ExperimentCell& cell : cells) {
    if (cell.shape.*member == chosen) selected.push_back(cell);
  }
  return selected;
}

std::string conditions(const ExperimentCell& cell) {
  return "V = " + std::to_string(cell.shape.nodes) + ", L = " + std::to_string(cell.shape.local) +
         ", mode " + to_text(cell.mode) + "; mean and standard deviation of " +
         std::to_string(cell.networks) + " networks";
}

LinePlot against_agents(const std::vector<ExperimentCell>& cells,
                        const std::vector<Curve>& curves) {
  const std::vector<ExperimentCell> column = select(cells, &MastnShape::external, 4);
  LinePlot plot = plot_of(column, curves, [](const ExperimentCell& cell) {
    return static_cast<double>(cell.shape.agents);
  });
  for (const ExperimentCell& cell : column) plot.x_ticks.push_back(cell.shape.agents);
  plot.x_label = "number of agents N";
  plot.subtitle = "E = " + std::to_string(column.front().shape.external) + " (ρ ≈ " +
                  rounded(column.back().frontier) + "), " + conditions(column.front());
  return plot;
}

LinePlot against_frontier(const std::vector<ExperimentCell>& cells,
                          const std::vector<Curve>& curves) {
  const std::vector<ExperimentCell> row = select(cells, &MastnShape::agents, 8);
  LinePlot plot = plot_of(row, curves, [](const ExperimentCell& cell) { return cell.frontier; });
  plot.x_label = "external interconnectivity ρ = frontier nodes / nodes";
  plot.subtitle =
      "N = " + std::to_string(row.front().shape.agents) + ", " + conditions(row.front());
  return plot;
}

std::string title_of(const std::string& against) {
  return against == "agents" ? "the number of agents" : "external interconnectivity";
}

ExperimentPlot messages(const std::string& against, LinePlot plot) {
  plot.title = "Messages against " + title_of(against);
  plot.y_label = "data messages per perturbation";
  return {"messages-" + against, to_svg(plot)};
}

ExperimentPlot computation(const std::string& against, LinePlot plot) {
  plot.title = "Computation against " + title_of(against);
  plot.y_label = "checks of all agents / checks of a single agent";
  return {"computation-" + against, to_svg(plot)};
}

std::vector<ExperimentCell> of_mode(const std::vector<ExperimentCell>& cells, ScenarioMode mode) {
  std::vector<ExperimentCell> kept;
  for (const ExperimentCell& cell : cells) {
    if (cell.mode == mode) kept.push_back(cell);
  }
  return kept;
}

struct WorstCase {
  const char* name;
  Algorithm algorithm;
  const char* messages;
  const char* computation;
};

std::string figure_4_line(const std::vector<ExperimentCell>& cells, const WorstCase& worst) {
  double most = 0;
  double least_c = cells.front().of(worst.algorithm).computation.mean;
  double greatest_c = least_c;
  double least_m = cells.front().of(worst.algorithm).data.mean;
  double greatest_m = least_m;
  for (const ExperimentCell& cell : cells) {
    const CellFigures& figures = cell.of(worst.algorithm);
    most = std::max(most, figures.most_data);
    least_c = std::min(least_c, figures.computation.mean);
    greatest_c = std::max(greatest_c, figures.computation.mean);
    least_m = std::min(least_m, figures.data.mean);
    greatest_m = std::max(greatest_m, figures.data.mean);
  }
  return std::string("| ") + worst.name + " | " + worst.messages + " | " + rounded(least_m, 1) +
         " to " + rounded(greatest_m, 1) + " | " + rounded(most, 0) + " | " + worst.computation +
         " | " + rounded(least_c) + " to " + rounded(greatest_c) + " |\n";
}

// Of an algorithm the worst of one turn, wherever it was: "1610 (736 RELAX and RELAXED)".
std::string worst_of(const std::vector<ExperimentCell>& cells, Algorithm algorithm,
                     std::size_t turn) {
  Traffic worst;
  for (const ExperimentCell& cell : cells) {
    const Traffic& most = cell.of(algorithm).most[turn];
    if (most.data() > worst.data()) worst = most;
  }
  std::string text = std::to_string(worst.data());
  if (worst.relaxations > 0) {
    text += " (" + std::to_string(worst.relaxations) + " RELAX and RELAXED)";
  }
  return text;
}

std::string result_line(const ExperimentCell& cell) {
  const CellFigures& cip = cell.of(Algorithm::kCip);
  const CellFigures& dip_l = cell.of(Algorithm::kDipL);
  const CellFigures& dip_m = cell.of(Algorithm::kDipM);
  const CellFigures& dip_g = cell.of(Algorithm::kDipG);
  std::string line = "| " + std::to_string(cell.shape.agents) + " | " +
                     std::to_string(cell.shape.external) + " | " + rounded(cell.frontier) + " | " +
                     rounded(100 * cell.inconsistent, 0) + " % | " +
                     rounded(cell.single_checks.mean, 0) + " | " +
                     rounded(cell.full_checks.mean, 0) + " | " + rounded(cell.saving(), 0) + " |";
  line += " " + rounded(cip.data.mean, 1) + " (" + rounded(cip.calm.mean, 1) + ") + " +
          rounded(cip.consistency.mean, 1) + " | " + rounded(cip.computation.mean) + " |";
  line += " " + rounded(dip_g.data.mean) + " | " + rounded(dip_g.computation.mean) + " |";
  line += " " + rounded(dip_l.data.mean, 1) + " (" + rounded(dip_l.calm.mean, 1) + ") + " +
          rounded(dip_l.consistency.mean, 1) + " | " + rounded(dip_l.computation.mean) + " |";
  line += " " + rounded(dip_m.data.mean, 1) + " / " + rounded(dip_m.macro_arcs.mean, 1) + " / " +
          rounded(dip_m.packs.mean) + " | " + rounded(dip_m.computation.mean, 1) + " (" +
          rounded(dip_m.eliminations.mean, 1) + ") |\n";
  return line;
}

}  // namespace

std::vector<ExperimentPlot> figure_5(const std::vector<ExperimentCell>& cells, ScenarioMode mode) {
  const std::vector<ExperimentCell> kept = of_mode(cells, mode);
  if (kept.empty()) return {};
  return {messages("agents", against_agents(kept, message_curves())),
          messages("frontier", against_frontier(kept, message_curves())),
          computation("agents", against_agents(kept, computation_curves())),
          computation("frontier", against_frontier(kept, computation_curves()))};
}

std::string figure_4(const std::vector<ExperimentCell>& cells) {
  const std::vector<ExperimentCell> kept = of_mode(cells, ScenarioMode::kKept);
  std::string table =
      "| algorithm | messages, worst case (M) | measured, means | most in one perturbation | "
      "computation, worst case (M) | measured, means |\n|---|---|---|---|---|---|\n";
  if (kept.empty()) return table;
  for (const WorstCase& worst :
       {WorstCase{"CIP", Algorithm::kCip, "O(V)", "1"},
        WorstCase{"DIP-G", Algorithm::kDipG, "1", "N"},
        WorstCase{"DIP-L", Algorithm::kDipL, "O(V_F · E_X^m · E_X)", "O(V_F · E_X^m · E_X)"},
        WorstCase{"DIP-M", Algorithm::kDipM, "O(w²)", "O(N)"}}) {
    table += figure_4_line(kept, worst);
  }
  double boundary = 0;
  for (const ExperimentCell& cell : kept) boundary = std::max(boundary, cell.greatest_boundary);
  return table + "\nw, the most boundary nodes of a component, is at most " + rounded(boundary, 0) +
         " in these networks.\n";
}

std::string tail_table(const std::vector<ExperimentCell>& cells, ScenarioMode mode) {
  const std::vector<ExperimentCell> kept = of_mode(cells, mode);
  std::string table = "| perturbation, mode " + to_text(mode) +
                      " | how many | CIP | DIP-G | DIP-L | DIP-M |\n|---|---|---|---|---|---|\n";
  constexpr std::array<const char*, kTurns> kNames = {
      "contraction between consistent states", "relaxation between consistent states",
      "makes the network inconsistent", "of an inconsistent network"};
  for (std::size_t turn = 0; turn < kTurns; ++turn) {
    std::uint64_t count = 0;
    for (const ExperimentCell& cell : kept) count += cell.turns[turn];
    table += std::string("| ") + kNames[turn] + " | " + std::to_string(count) + " |";
    for (const Algorithm algorithm : kAllAlgorithms) {
      table += " " + worst_of(kept, algorithm, turn) + " |";
    }
    table += "\n";
  }
  return table;
}

std::string results_table(const std::vector<ExperimentCell>& cells, ScenarioMode mode) {
  std::string table =
      "| N | E | ρ | inconsistent | checks, single | checks, afresh | ratio | CIP messages "
      "(between "
      "consistent states) | C | DIP-G messages | C | DIP-L messages (the same) | C | DIP-M per "
      "bound / per arc / packed | C "
      "(eliminations) |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ExperimentCell& cell : of_mode(cells, mode)) table += result_line(cell);
  return table;
}

std::string claims_table(const std::vector<Claim>& claims) {
  std::string table = "| kind | claim | holds | measured |\n|---|---|---|---|\n";
  for (const Claim& claim : claims) {
    table += "| " + to_text(claim.kind) + " | " + claim.statement + " | " +
             (claim.holds ? "yes" : "**no**") + " | " + claim.evidence + " |\n";
  }
  return table;
}

}  // namespace skein::temporal
