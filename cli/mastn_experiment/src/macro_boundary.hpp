// SPDX-License-Identifier: Apache-2.0
// How many macro-constraints a change of an arc can touch, told from the graph alone.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Components of each agent's interior nodes (those without external arc), with the frontier nodes
/// and v0 around them. Source: M 3.5, notes 5.1.13.
class MacroBoundary {
 public:
  explicit MacroBoundary(const Mastn& mastn);

  /// Ordered pairs of boundary nodes of the component that the arc is in; an arc between two
  /// boundary nodes is a component of its own. Precondition: a local arc.
  std::uint64_t ordered_pairs(std::uint32_t arc) const;
  /// w: most boundary nodes of a component.
  std::uint64_t greatest() const;

 private:
  std::vector<Arc> arcs_;
  std::vector<bool> boundary_;             // of nodes: frontier or v0
  std::vector<std::uint32_t> component_;   // of interior nodes
  std::vector<std::uint64_t> neighbours_;  // of components: boundary nodes
};

}  // namespace skein::temporal
