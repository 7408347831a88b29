// SPDX-License-Identifier: Apache-2.0
// Claims that hold in every row, whatever the mode. Source: notes 4.1.
#include <functional>

#include "claim_kinds.hpp"

namespace skein::temporal {

namespace {

using Faults = std::function<std::uint64_t(const ExperimentRow&)>;

Claim exact(std::string statement, const std::vector<ExperimentRow>& rows, const Faults& faults) {
  std::uint64_t perturbations = 0;
  std::uint64_t found = 0;
  for (const ExperimentRow& row : rows) {
    perturbations += row.perturbations;
    found += faults(row);
  }
  return {
      ClaimKind::kExact, std::move(statement), found == 0,
      std::to_string(found) + " exceptions in " + std::to_string(perturbations) + " perturbations"};
}

// 1 if the checks of an algorithm are not so many times those of a single agent.
Faults not_times_single(Algorithm algorithm, bool times_agents) {
  return [=](const ExperimentRow& row) -> std::uint64_t {
    const std::uint64_t factor = times_agents ? row.shape.agents : 1;
    return row.of(algorithm).checks == factor * row.single_checks ? 0 : 1;
  };
}

}  // namespace

std::vector<Claim> exact_claims(const std::vector<ExperimentRow>& rows) {
  const auto excess = [](Algorithm algorithm) {
    return [algorithm](const ExperimentRow& row) { return row.of(algorithm).excess; };
  };
  return {
      exact("every date and verdict is right at every quiescent point, with all four algorithms",
            rows,
            [](const ExperimentRow& row) {
              std::uint64_t wrong = 0;
              for (const AlgorithmFigures& figures : row.algorithms) wrong += figures.wrong;
              return wrong;
            }),
      exact("DIP-G sends exactly 1 message per perturbation", rows, excess(Algorithm::kDipG)),
      exact("a CIP slave sends the supervisor exactly 1 message per perturbation", rows,
            excess(Algorithm::kCip)),
      exact("DIP-M sends at most 1 packed message per perturbation, with at most one "
            "macro-constraint per ordered pair of boundary nodes of the component touched",
            rows, excess(Algorithm::kDipM)),
      exact("CIP computes exactly what a single agent computes", rows,
            not_times_single(Algorithm::kCip, false)),
      exact("DIP-G computes exactly N times what a single agent computes", rows,
            not_times_single(Algorithm::kDipG, true))};
}

}  // namespace skein::temporal
