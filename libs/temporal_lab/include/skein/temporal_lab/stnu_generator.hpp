// SPDX-License-Identifier: Apache-2.0
// Random networks with uncertainty of the STNUBenchmark2020 kind: plans in parallel lanes.
#pragma once

#include "skein/foundation/random.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

struct StnuGeneratorOptions {
  std::uint32_t nodes = 500;      ///< the origin included; at least 1 + 3·lanes
  std::uint32_t contingent = 50;  ///< at most (nodes - 1) / 3 - lanes, so that no two touch
  std::uint32_t lanes = 5;        ///< at least 2
  std::uint32_t extra_arcs_percent =
      65;  ///< arcs beside those of the lanes, as a share of the nodes
  /// Makes the network not controllable: from a task to a node after it there is less time than the
  /// task may take.
  bool break_it = false;
};

/// A plan in lanes: each is a chain of steps, some of them contingent. Half of the extra arcs stay
/// in a lane, half join two lanes, a third of these as precedence with a least delay. There is a
/// policy that keeps every bound whatever nature does (each node as soon as its least delays
/// allow), hence the network is dynamically controllable unless `break_it`. With n/10 contingent
/// links the graph has about 3.2 n edges. Distances are whole seconds. Node 0 is the origin "z", at
/// the head of every lane. Reproducible: equal options and an equal state of `random` give equal
/// networks. Source: notes 2 (the family of STNUBenchmark2020; bounds are drawn differently).
Stnu generate_stnu(const StnuGeneratorOptions& options, Random& random);

}  // namespace skein::temporal
