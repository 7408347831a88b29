// SPDX-License-Identifier: Apache-2.0
// Plans that are hard for a queue: one long chain and many long arcs beside it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal::testing {

/// A chain of [1, 10] with five arcs for each node that say half, and twice, of what the chain
/// says: each node is first reached over few long arcs and then again and again over more short
/// ones. `shuffled`: nodes and arcs come in any order. `broken`: one arc leaves a third of the
/// chain too little time.
struct WideNetworkOptions {
  std::uint32_t nodes = 1000;
  bool shuffled = false;
  bool broken = false;
};

template <class Value>
void shuffle(std::vector<Value>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

inline Stn wide_network(const WideNetworkOptions& options, Random& random) {
  const std::uint32_t n = options.nodes;
  Stn network;
  std::vector<NodeIndex> place;
  for (NodeIndex i = 0; i < n; ++i) {
    network.nodes.push_back("n" + std::to_string(i));
    place.push_back(i);
  }
  if (options.shuffled) shuffle(place, random);
  network.origin = place[0];
  const auto join = [&](std::uint64_t from, std::uint64_t to, Ticks min, Ticks max) {
    network.arcs.push_back({place[from], place[to], min, max});
  };
  for (NodeIndex i = 0; i + 1 < n; ++i) join(i, i + 1, 1, 10);
  for (std::uint32_t i = 0; i < 5 * n; ++i) {
    std::uint64_t from = random.below(n);
    std::uint64_t to = random.below(n);
    if (from == to) continue;
    if (from > to) std::swap(from, to);
    const auto steps = static_cast<Ticks>(to - from);
    join(from, to, steps / 2, 20 * steps);
  }
  if (options.broken) {
    const NodeIndex third = n / 3;
    join(third, 2 * third, kMinusInfinite, static_cast<Ticks>(third) - 1);
  }
  if (options.shuffled) shuffle(network.arcs, random);
  return network;
}

}  // namespace skein::temporal::testing
