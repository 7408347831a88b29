// SPDX-License-Identifier: Apache-2.0
#include "macro_boundary.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace skein::temporal {

namespace {

bool is_between_agents(const Mastn& mastn, const Arc& arc) {
  return arc.from != 0 && arc.to != 0 && mastn.owner[arc.from] != mastn.owner[arc.to];
}

std::uint32_t root_of(const std::vector<std::uint32_t>& parent, std::uint32_t node) {
  while (parent[node] != node) node = parent[node];
  return node;
}

}  // namespace

MacroBoundary::MacroBoundary(const Mastn& mastn)
    : arcs_(mastn.arcs),
      boundary_(mastn.nodes.size(), false),
      component_(mastn.nodes.size()),
      neighbours_(mastn.nodes.size(), 0) {
  boundary_[0] = true;
  for (const Arc& arc : arcs_) {
    if (is_between_agents(mastn, arc)) boundary_[arc.from] = boundary_[arc.to] = true;
  }
  std::iota(component_.begin(), component_.end(), 0U);
  for (const Arc& arc : arcs_) {
    if (boundary_[arc.from] || boundary_[arc.to]) continue;
    component_[root_of(component_, arc.from)] = root_of(component_, arc.to);
  }
  for (std::uint32_t& node : component_) node = root_of(component_, node);
  std::vector<std::set<NodeIndex>> around(mastn.nodes.size());
  for (const Arc& arc : arcs_) {
    if (!boundary_[arc.from] && boundary_[arc.to]) around[component_[arc.from]].insert(arc.to);
    if (!boundary_[arc.to] && boundary_[arc.from]) around[component_[arc.to]].insert(arc.from);
  }
  std::transform(around.begin(), around.end(), neighbours_.begin(),
                 [](const std::set<NodeIndex>& nodes) { return nodes.size(); });
}

std::uint64_t MacroBoundary::ordered_pairs(std::uint32_t arc) const {
  const Arc& touched = arcs_[arc];
  if (boundary_[touched.from] && boundary_[touched.to]) return 2;
  const NodeIndex interior = boundary_[touched.from] ? touched.to : touched.from;
  const std::uint64_t nodes = neighbours_[component_[interior]];
  return nodes == 0 ? 0 : nodes * (nodes - 1);
}

std::uint64_t MacroBoundary::greatest() const {
  return neighbours_.empty() ? 0 : *std::max_element(neighbours_.begin(), neighbours_.end());
}

}  // namespace skein::temporal
