// SPDX-License-Identifier: Apache-2.0
// Temporal networks as plain values: what files hold, generators make and engines are built from.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace skein::temporal {

/// An instant or a distance in time [ns]. Finite values are within ±kLargest, so that the sum of
/// any two fits; what goes beyond is the error `kOverflow`, never a wrap-around.
using Ticks = std::int64_t;
inline constexpr Ticks kLargest = Ticks{1} << 60;
inline constexpr Ticks kInfinite = std::numeric_limits<Ticks>::max();  ///< no upper bound
inline constexpr Ticks kMinusInfinite = -kInfinite;                    ///< no lower bound

inline constexpr Ticks kTicksPerSecond = 1'000'000'000;

/// Position of a node in `nodes`.
using NodeIndex = std::uint32_t;

/// min <= to - from <= max. Either bound may be infinite. Source: M 2.1.
struct Arc {
  NodeIndex from = 0;
  NodeIndex to = 0;
  Ticks min = kMinusInfinite;
  Ticks max = kInfinite;
  bool operator==(const Arc&) const = default;
};

/// A simple temporal network. `origin` is the reference v0, whose date is 0.
struct Stn {
  std::vector<std::string> nodes;  ///< names, all different
  NodeIndex origin = 0;
  std::vector<Arc> arcs;
  bool operator==(const Stn&) const = default;
};

/// A link whose duration nature chooses: contingent - activation in [min, max], 0 < min < max < ∞
/// (min = max is kept as a requirement arc). Source: T IV.4.1.
struct ContingentLink {
  NodeIndex activation = 0;
  NodeIndex contingent = 0;
  Ticks min = 0;
  Ticks max = 0;
  bool operator==(const ContingentLink&) const = default;
};

/// A simple temporal network with uncertainty. No two contingent links end in one node.
struct Stnu {
  std::vector<std::string> nodes;
  NodeIndex origin = 0;
  std::vector<Arc> arcs;  ///< requirement links
  std::vector<ContingentLink> contingent;
  bool operator==(const Stnu&) const = default;
};

/// Position of an agent in `agents`.
using AgentIndex = std::uint32_t;

/// One change of an arc's bounds in the course of a scenario: both bounds at once.
struct Step {
  Ticks at = 0;           ///< when it is injected [ns]
  std::uint32_t arc = 0;  ///< position in `Mastn::arcs`
  Ticks min = kMinusInfinite;
  Ticks max = kInfinite;
  bool operator==(const Step&) const = default;
};

/// A multi-agent simple temporal network with a scenario. Node 0 is v0, which nobody owns; an arc
/// belongs to the owner of its nodes, an external arc to the owner of `from` (of `to` when `from`
/// is v0). Source: M 2.2, spec 5.3.
struct Mastn {
  std::vector<std::string> agents;
  std::vector<std::string> nodes;  ///< nodes[0] is "v0"
  std::vector<AgentIndex> owner;   ///< of each node; owner[0] has no meaning
  std::vector<Arc> arcs;
  std::vector<Step> steps;  ///< in the order of `at`
  bool operator==(const Mastn&) const = default;
};

}  // namespace skein::temporal
