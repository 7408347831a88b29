// SPDX-License-Identifier: Apache-2.0
// Consistency, in the words of this tool.
#include "skein/temporal/stn_solution.hpp"
#include "skein/temporal_files/network_text.hpp"
#include "stn_analysis.hpp"

namespace skein::temporal_tool {

Result<Consistency, Failure> analyse_consistency(const temporal::Stnu& network) {
  auto solution = temporal::solve_stn(temporal::without_uncertainty(network));
  if (!solution) return failure(temporal::to_text(solution.error().error));
  Consistency answer{solution->consistent, {}, std::move(solution->windows)};
  const std::size_t arcs = network.arcs.size();
  for (const temporal::ConflictArc& one : solution->conflict) {
    const bool contingent = one.arc >= arcs;
    const auto index = static_cast<std::uint32_t>(contingent ? one.arc - arcs : one.arc);
    const bool min = one.bound == decltype(one.bound)::kLower;
    answer.conflict.push_back(
        {{contingent ? temporal::LinkKind::kContingent : temporal::LinkKind::kRequirement, index},
         min ? LinkBound::kMin : LinkBound::kMax});
  }
  return answer;
}

}  // namespace skein::temporal_tool
