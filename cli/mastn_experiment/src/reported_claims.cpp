// SPDX-License-Identifier: Apache-2.0
// Claims of the paper that do not hold without conditions. Source: notes 4.3.
#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "claim_kinds.hpp"
#include "claim_text.hpp"

namespace skein::temporal {

namespace {

using Figure = std::function<double(const ExperimentCell&)>;

// Whether a figure ends clearly higher than it begins for every N of more than `above`; the
// evidence says all of them.
std::optional<Claim> grows_with_density(std::string statement,
                                        const std::vector<ExperimentCell>& cells,
                                        const Figure& figure, std::uint32_t above = 0) {
  bool holds = true;
  std::string evidence;
  for (const std::uint32_t agents : agents_among(cells)) {
    const std::vector<ExperimentCell> row = with_agents(cells, agents);
    if (row.size() < 2) return std::nullopt;
    holds = holds && (agents <= above || figure(row.back()) > 1.1 * figure(row.front()));
    evidence += (evidence.empty() ? "" : "; ") + std::string("N = ") + std::to_string(agents) + ":";
    for (const ExperimentCell& cell : row) evidence += " " + rounded(figure(cell), 1);
  }
  return Claim{ClaimKind::kReported, std::move(statement), holds, evidence};
}

// Linear: doubling N from end to end makes C grow by at least three quarters of that.
std::optional<Claim> linear_when_sparse(const std::vector<ExperimentCell>& cells) {
  const auto sparsest = std::find_if(cells.begin(), cells.end(), [](const ExperimentCell& cell) {
    return cell.shape.external > 0;
  });
  if (sparsest == cells.end()) return std::nullopt;
  const std::vector<ExperimentCell> column = with_external(cells, sparsest->shape.external);
  if (column.size() < 2) return std::nullopt;
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
  return Claim{ClaimKind::kReported,
               "our extension: DIP-M's computation grows linearly with N also in sparse networks "
               "(ρ = " +
                   rounded(column.front().frontier) + ")",
               growth >= 0.75 * agents, evidence};
}

// CIP against DIP-L: how far a mean of the checks of all agents is from one agent's.
std::optional<Claim> checks_differ_clearly(const std::vector<ExperimentCell>& cells) {
  double least = 0;
  double greatest = 0;
  for (const ExperimentCell& cell : cells) {
    const double more =
        cell.of(Algorithm::kDipL).computation.mean - cell.of(Algorithm::kCip).computation.mean;
    least = std::min(least, more);
    greatest = std::max(greatest, more);
  }
  return Claim{
      ClaimKind::kReported,
      "CIP clearly computes less than the distributed algorithms: by more than a tenth less "
      "than DIP-L",
      least > 0.1, "C(DIP-L) - C(CIP) from " + rounded(least) + " to " + rounded(greatest)};
}

// Messages of CIP against those of DIP-G.
std::optional<Claim> messages_differ_little(const std::vector<ExperimentCell>& cells) {
  double most = 0;
  double least = cells.front().of(Algorithm::kCip).data.mean;
  for (const ExperimentCell& cell : cells) {
    const double times = cell.of(Algorithm::kCip).data.mean / cell.of(Algorithm::kDipG).data.mean;
    most = std::max(most, times);
    least = std::min(least, times);
  }
  return Claim{ClaimKind::kReported,
               "the numbers of messages differ little: CIP sends at most twice as many as DIP-G",
               most <= 2, rounded(least, 1) + " to " + rounded(most, 1) + " times as many"};
}

}  // namespace

std::vector<Claim> reported_claims(const std::vector<ExperimentCell>& cells) {
  if (cells.empty()) return {};
  const auto computation = [](const ExperimentCell& cell) {
    return cell.of(Algorithm::kDipM).computation.mean;
  };
  std::vector<Claim> claims;
  std::vector<std::optional<Claim>> found{
      grows_with_density(
          "CIP's messages grow with ρ, between consistent states, from N = 4 up", cells,
          [](const ExperimentCell& cell) { return cell.of(Algorithm::kCip).calm.mean; }, 2),
      grows_with_density(
          "the same over all perturbations, those of inconsistent networks too", cells,
          [](const ExperimentCell& cell) { return cell.of(Algorithm::kCip).data.mean; }, 2),
      grows_with_density("DIP-M's computation worsens with density, from N = 4 up", cells,
                         computation, 2),
      grows_with_density("the same at every N without the eliminations", cells,
                         [](const ExperimentCell& cell) {
                           const CellFigures& dip_m = cell.of(Algorithm::kDipM);
                           return dip_m.computation.mean - dip_m.eliminations.mean;
                         }),
      messages_differ_little(cells),
      checks_differ_clearly(cells),
      linear_when_sparse(cells)};
  for (std::optional<Claim>& claim : found) {
    if (claim) claims.push_back(std::move(*claim));
  }
  return claims;
}

}  // namespace skein::temporal
