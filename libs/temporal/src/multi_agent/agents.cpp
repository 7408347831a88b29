// SPDX-License-Identifier: Apache-2.0
// What the four algorithms share.
#include "agents.hpp"

#include <algorithm>

namespace skein::temporal {

ArcRights::ArcRights(const Mastn& network) {
  for (const Arc& arc : network.arcs) {
    rights_.push_back({owner_of(network, arc), is_external(network, arc)});
  }
}

std::optional<AgentRefusal> ArcRights::check(std::span<const ArcUpdate> changes,
                                             AgentIndex agent) const {
  for (const ArcUpdate& change : changes) {
    if (change.arc >= rights_.size()) return AgentRefusal{AgentError::kUnknownArc, change.arc};
    const Right& right = rights_[change.arc];
    if (right.owner != agent) return AgentRefusal{AgentError::kNotOwner, change.arc};
    if (right.external) return AgentRefusal{AgentError::kExternalArc, change.arc};
    if (const auto error = check_bounds(change.min, change.max)) {
      return AgentRefusal{*error, change.arc};
    }
  }
  return std::nullopt;
}

void ChangedArcs::note(std::span<const ArcUpdate> changes) {
  for (const ArcUpdate& change : changes) {
    const auto place = std::lower_bound(
        samples_.begin(), samples_.end(), change.arc,
        [](const ArcUpdate& sample, std::uint32_t arc) { return sample.arc < arc; });
    if (place != samples_.end() && place->arc == change.arc) {
      *place = change;
    } else {
      samples_.insert(place, change);
    }
  }
}

Propagation propagation_of(const Mastn& network, const Defects& defects) {
  Propagation core(defects.literal_upper_test);
  for (std::size_t node = 1; node < network.nodes.size(); ++node) core.add_node();
  for (const Arc& arc : network.arcs) core.add_arc(arc);
  return core;
}

}  // namespace skein::temporal
