// SPDX-License-Identifier: Apache-2.0
// The experiment as documents: the plots of figure 5 of M, the table of its figure 4, the claims.
#pragma once

#include <string>
#include <vector>

#include "skein/mastn_experiment/experiment_cells.hpp"
#include "skein/mastn_experiment/mastn_claims.hpp"

namespace skein::temporal {

struct ExperimentPlot {
  std::string name;  ///< "messages-agents", "messages-frontier", "computation-agents", …
  std::string svg;
};

/// The four plots of figure 5: messages and computation, against N at E = 4 and against ρ at N = 8
/// (or, where these were not measured, at the greatest there is). Error bars are standard
/// deviations over networks. None without a cell in the mode.
std::vector<ExperimentPlot> figure_5(const std::vector<ExperimentCell>& cells, ScenarioMode mode);

/// Worst cases of figure 4 of M beside what was measured; Markdown.
std::string figure_4(const std::vector<ExperimentCell>& cells);
/// The most data messages of one perturbation, by what it does to the network; Markdown.
std::string tail_table(const std::vector<ExperimentCell>& cells, ScenarioMode mode);
/// One line for each parameter set of the mode; Markdown.
std::string results_table(const std::vector<ExperimentCell>& cells, ScenarioMode mode);
/// Markdown.
std::string claims_table(const std::vector<Claim>& claims);

}  // namespace skein::temporal
