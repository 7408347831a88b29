// SPDX-License-Identifier: Apache-2.0
// The experiment of spec 5.4: what the four algorithms send and compute on random networks.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "skein/temporal/agent.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"
#include "skein/temporal_lab/mastn_simulation.hpp"

namespace skein::temporal {

inline constexpr std::array<Algorithm, 4> kAllAlgorithms = {Algorithm::kCip, Algorithm::kDipG,
                                                            Algorithm::kDipL, Algorithm::kDipM};

/// What a perturbation does to the network.
enum class Turn : std::uint8_t {
  kContraction,  ///< between consistent states, to a value inside the arc's interval
  kRelaxation,   ///< between consistent states, to one outside of it
  kBreak,        ///< from a consistent state to an inconsistent one
  kBroken        ///< from an inconsistent state
};
inline constexpr std::size_t kTurns = 4;

/// One algorithm through one scenario, after the propagation of the initial network.
struct AlgorithmFigures {
  Traffic traffic;
  std::uint64_t checks = 0;        ///< of all agents
  std::uint64_t eliminations = 0;  ///< of those, in eliminations
  std::uint64_t most_data = 0;     ///< data messages of the perturbation that made most
  std::uint64_t wrong = 0;         ///< quiescent points with a date or verdict that is not right
  std::uint64_t excess = 0;        ///< perturbations over the bound that the algorithm guarantees
  std::uint64_t calm_data = 0;     ///< data messages of the perturbations that `calm` counts
  std::array<Traffic, kTurns>
      most{};  ///< by `Turn`, of the perturbation that made most data messages
};

/// One network and its scenario, each step injected when all is quiet, delivery at once.
struct ExperimentRow {
  ScenarioMode mode = ScenarioMode::kKept;
  MastnShape shape;
  std::uint64_t seed = 0;
  double frontier = 0;  ///< ρ = V_F / V
  std::uint64_t perturbations = 0;
  std::uint64_t inconsistent = 0;  ///< of these, how many left the network inconsistent
  std::uint64_t calm = 0;          ///< of these, how many led from a consistent network to one
  std::array<std::uint64_t, kTurns> turns{};   ///< of these, how many were of each `Turn`
  std::uint64_t single_checks = 0;             ///< of one agent that has the whole network
  std::uint64_t full_checks = 0;               ///< of one that starts afresh at each perturbation
  std::uint64_t greatest_boundary = 0;         ///< w: most boundary nodes of a component
  std::array<AlgorithmFigures, 4> algorithms;  ///< in the order of `Algorithm`

  const AlgorithmFigures& of(Algorithm algorithm) const {
    return algorithms[static_cast<std::size_t>(algorithm)];
  }
};

/// Plays one network. Cost: seconds for 16 agents of 20 nodes.
/// `relaxations`: their share of the steps.
ExperimentRow measure(const MastnShape& shape, ScenarioMode mode, std::uint64_t seed,
                      double relaxations = 0.1);

struct ExperimentPlan {
  std::vector<std::uint32_t> agents = {2, 4, 8, 16};
  std::vector<std::uint32_t> external = {0, 1, 2, 4, 8, 12};
  std::vector<ScenarioMode> modes = {ScenarioMode::kKept, ScenarioMode::kFree};
  std::uint32_t nodes = 20;
  std::uint32_t local = 10;
  double relaxations = 0.1;     ///< share of the steps
  std::uint32_t networks = 10;  ///< of each parameter set
  std::uint64_t seed = 1;       ///< of the first network; the others follow
};

/// All rows, by mode, agents, external arcs, seed. `progress` is called after each with how many
/// are done and how many there are.
std::vector<ExperimentRow> run_experiment(
    const ExperimentPlan& plan, const std::function<void(std::size_t, std::size_t)>& progress);

/// "K" or "F".
std::string to_text(ScenarioMode mode);
/// One line for each row and algorithm, with a heading line.
std::string to_csv(const std::vector<ExperimentRow>& rows);

}  // namespace skein::temporal
