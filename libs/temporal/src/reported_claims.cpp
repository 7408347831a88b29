// SPDX-License-Identifier: Apache-2.0
// Claims of the paper that do not hold without conditions. Source: notes 4.3.
#include <functional>
#include <string>

#include "claim_kinds.hpp"
#include "claim_text.hpp"

namespace skein::temporal {

namespace {

using Figure = std::function<double(const ExperimentCell&)>;

// Whether a figure ends clearly higher than it begins for every N; the evidence says all of them.
Claim grows_with_density(std::string statement, const std::vector<ExperimentCell>& cells,
                         const Figure& figure) {
  bool holds = true;
  std::string evidence;
  for (const std::uint32_t agents : agents_among(cells)) {
    const std::vector<ExperimentCell> row = with_agents(cells, agents);
    holds = holds && figure(row.back()) > 1.1 * figure(row.front());
    evidence += (evidence.empty() ? "" : "; ") + std::string("N = ") + std::to_string(agents) + ":";
    for (const ExperimentCell& cell : row) evidence += " " + rounded(figure(cell), 1);
  }
  return {ClaimKind::kReported, std::move(statement), holds, evidence};
}

// Linear: doubling N from end to end makes C grow by at least three quarters of that.
Claim linear_when_sparse(const std::vector<ExperimentCell>& cells) {
  const std::uint32_t sparsest = cells.front().shape.external;
  const std::vector<ExperimentCell> column = with_external(cells, sparsest);
  const auto computation = [](const ExperimentCell& cell) {
    return cell.of(Algorithm::kDipM).computation.mean;
  };
  std::string evidence;
  for (const ExperimentCell& cell : column) {
    evidence += (evidence.empty() ? "C = " : ", ") + rounded(computation(cell), 1) +
                " at N = " + std::to_string(cell.shape.agents);
  }
  const double growth = computation(column.back()) / computation(column.front());
  const double agents = static_cast<double>(column.back().shape.agents) /
                        static_cast<double>(column.front().shape.agents);
  return {ClaimKind::kReported,
          "DIP-M's computation grows linearly with N also in sparse networks (ρ = " +
              rounded(column.front().frontier) + ")",
          growth >= 0.75 * agents, evidence};
}

}  // namespace

std::vector<Claim> reported_claims(const std::vector<ExperimentCell>& cells) {
  if (cells.empty()) return {};
  return {grows_with_density(
              "CIP's messages grow with ρ", cells,
              [](const ExperimentCell& cell) { return cell.of(Algorithm::kCip).data.mean; }),
          grows_with_density("DIP-M's computation worsens with density, at every N", cells,
                             [](const ExperimentCell& cell) {
                               return cell.of(Algorithm::kDipM).computation.mean;
                             }),
          grows_with_density("the same without the eliminations", cells,
                             [](const ExperimentCell& cell) {
                               const CellFigures& dip_m = cell.of(Algorithm::kDipM);
                               return dip_m.computation.mean - dip_m.eliminations.mean;
                             }),
          linear_when_sparse(cells)};
}

}  // namespace skein::temporal
