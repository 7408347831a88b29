// SPDX-License-Identifier: Apache-2.0
// Dynamic controllability, in the words of this tool.
#include "skein/temporal/stnu_controllability.hpp"

#include "stn_analysis.hpp"

namespace skein::temporal_tool {

Result<Controllability, Failure> analyse_controllability(const temporal::Stnu& network) {
  const auto result = temporal::check_dynamic_controllability(network);
  if (!result) return failure(temporal::to_text(result.error(), network));
  Controllability answer{result->consistent, result->controllable, {}};
  for (const temporal::ConflictTerm& term : result->conflict) {
    const bool min = term.bound == decltype(term.bound)::kMin;
    answer.conflict.push_back({term.link, min ? LinkBound::kMin : LinkBound::kMax});
  }
  return answer;
}

std::vector<temporal::LinkRef> links_of(const std::vector<ConflictPart>& conflict) {
  std::vector<temporal::LinkRef> links;
  for (const ConflictPart& part : conflict) links.push_back(part.link);
  return links;
}

}  // namespace skein::temporal_tool
