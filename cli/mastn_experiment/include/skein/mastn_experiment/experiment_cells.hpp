// SPDX-License-Identifier: Apache-2.0
// The experiment's figures per parameter set: means over networks and how they spread.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "skein/mastn_experiment/mastn_experiment.hpp"

namespace skein::temporal {

/// Over the networks of a parameter set.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< standard deviation of the sample; 0 for one network
};
Spread spread_of(const std::vector<double>& values);

/// Per perturbation, messages as the paper counts them; computation against a single agent.
struct CellFigures {
  Spread data;          ///< M_X: data messages
  Spread calm;          ///< data messages per perturbation that leads from consistent to consistent
  Spread consistency;   ///< CONSISTENCY messages
  Spread packs;         ///< DIP-M: sends, all that a perturbation changes in one; else as `data`
  Spread macro_arcs;    ///< DIP-M: macro-arcs sent; else 0
  Spread computation;   ///< C_X = checks of all agents / checks of a single agent
  Spread eliminations;  ///< the part of C_X that eliminations make
  double most_data = 0;                ///< greatest number of data messages of one perturbation
  std::array<Traffic, kTurns> most{};  ///< of the perturbation of each `Turn` that made most
};

struct ExperimentCell {
  ScenarioMode mode = ScenarioMode::kKept;
  MastnShape shape;
  std::size_t networks = 0;
  double frontier = 0;      ///< ρ, mean
  double inconsistent = 0;  ///< share of the perturbations, mean
  Spread single_checks;     ///< per perturbation
  Spread full_checks;       ///< per perturbation
  double greatest_boundary = 0;
  std::array<std::uint64_t, kTurns> turns{};  ///< perturbations of each
  std::array<CellFigures, 4> algorithms;

  const CellFigures& of(Algorithm algorithm) const {
    return algorithms[static_cast<std::size_t>(algorithm)];
  }
  /// How many times fewer checks than starting afresh.
  double saving() const;
};

/// In the order in which their first rows come.
std::vector<ExperimentCell> cells_of(const std::vector<ExperimentRow>& rows);
/// The cell of these numbers of agents and external arcs in mode K, if there is one.
const ExperimentCell* find_cell(const std::vector<ExperimentCell>& cells, std::uint32_t agents,
                                std::uint32_t external);

}  // namespace skein::temporal
