// SPDX-License-Identifier: Apache-2.0
#include "skein/mastn_experiment/mastn_claims.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "claim_kinds.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

namespace {

template <class Keep>
std::vector<ExperimentCell> those(const std::vector<ExperimentCell>& cells, const Keep& keep) {
  std::vector<ExperimentCell> kept;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(kept), keep);
  return kept;
}

}  // namespace

std::vector<ExperimentCell> kept_cells(const std::vector<ExperimentCell>& cells) {
  return those(cells, [](const ExperimentCell& cell) { return cell.mode == ScenarioMode::kKept; });
}

std::vector<ExperimentCell> with_agents(const std::vector<ExperimentCell>& cells,
                                        std::uint32_t agents) {
  return those(cells, [=](const ExperimentCell& cell) { return cell.shape.agents == agents; });
}

std::vector<ExperimentCell> with_external(const std::vector<ExperimentCell>& cells,
                                          std::uint32_t external) {
  return those(cells, [=](const ExperimentCell& cell) { return cell.shape.external == external; });
}

std::vector<std::uint32_t> agents_among(const std::vector<ExperimentCell>& cells) {
  std::set<std::uint32_t> agents;
  for (const ExperimentCell& cell : cells) agents.insert(cell.shape.agents);
  return {agents.begin(), agents.end()};
}

std::string to_text(ClaimKind kind) {
  switch (kind) {
    case ClaimKind::kExact:
      return "exact";
    case ClaimKind::kStatistical:
      return "statistical";
    case ClaimKind::kReported:
      return "reported";
  }
  return "";
}

std::vector<Claim> check_claims(const std::vector<ExperimentRow>& rows) {
  SKEIN_EXPECTS(!rows.empty());
  const std::vector<ExperimentCell> cells = kept_cells(cells_of(rows));
  std::vector<Claim> claims = exact_claims(rows);
  for (const Claim& claim : statistical_claims(cells)) claims.push_back(claim);
  for (const Claim& claim : reported_claims(cells)) claims.push_back(claim);
  return claims;
}

bool all_gates_hold(const std::vector<Claim>& claims) {
  return std::all_of(claims.begin(), claims.end(), [](const Claim& claim) {
    return claim.holds || claim.kind == ClaimKind::kReported;
  });
}

}  // namespace skein::temporal
