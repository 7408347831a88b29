// SPDX-License-Identifier: Apache-2.0
// Random multi-agent networks and scenarios of the experiment.
#pragma once

#include <cstdint>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Size of a random network: gen(N, V, L, E).
struct MastnShape {
  std::uint32_t agents = 2;    ///< N >= 1
  std::uint32_t nodes = 20;    ///< V >= 1, of each agent
  std::uint32_t local = 10;    ///< L: arcs of each agent besides its chain
  std::uint32_t external = 4;  ///< E: arcs of each agent towards others; counted once, at `from`
  bool operator==(const MastnShape&) const = default;
};

/// A consistent network around a hidden solution; all values are whole seconds. The first
/// agents × nodes arcs are the chains (v0 -> first node -> second node …), agent by agent; then
/// come the other local arcs, then the external ones. No two arcs join the same two nodes: of a
/// shape that asks for more arcs than there are pairs, the arcs in excess are left out. The same
/// shape and seed give the same network on every machine. Source: spec 5.4, M 5.1 as completed by
/// section 3 of the notes.
Mastn generate_mastn(const MastnShape& shape, std::uint64_t seed);

/// Positions of the chain arcs of a generated network.
std::vector<std::uint32_t> chain_arcs(const MastnShape& shape);

/// ρ: nodes with an external arc / nodes, v0 left out; 0 without nodes.
double frontier_ratio(const Mastn& mastn);

enum class ScenarioMode {
  kKept,  ///< mode K: a relaxation stays inside what the other constraints allow, when possible
  kFree,  ///< mode F: no such care; the network is often inconsistent
};

struct ScenarioOptions {
  ScenarioMode mode = ScenarioMode::kKept;
  double relaxations = 0.1;  ///< share of the steps that leave the arc's interval, in [0, 1]
  Ticks interval = kTicksPerSecond;  ///< between two steps [ns]; the first is at `interval`
};

/// Fixes every arc of `arcs` once, each to one value, in a random order. A contraction draws the
/// value from what the whole network then allows (from the arc's own interval while the network is
/// inconsistent); a relaxation is 1 to 10 s outside the arc's interval. The bounds of the arcs
/// named must be finite, min <= max. Cost: O(steps × nodes × arcs) in the worst case. Source:
/// section 3 of the notes.
std::vector<Step> make_scenario(const Mastn& mastn, const std::vector<std::uint32_t>& arcs,
                                const ScenarioOptions& options, std::uint64_t seed);

}  // namespace skein::temporal
