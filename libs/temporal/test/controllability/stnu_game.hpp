// SPDX-License-Identifier: Apache-2.0
// Dynamic controllability by its definition: a game in whole time units, searched to the end.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal::testing {

/// At each instant nature first says which running tasks end, then the controller executes any set
/// of nodes, at once; tasks begun then end later, since durations are at least one unit. The
/// controller wins iff it can keep every requirement whatever nature says. For tiny networks with
/// whole bounds in which every node has a finite date after the origin: exponential.
class StnuGame {
 public:
  explicit StnuGame(const Stnu& network);
  bool controller_wins();

 private:
  using Dates = std::vector<Ticks>;  ///< kInfinite: not yet

  bool after_nature(const Dates& dates, Ticks now);
  bool before_nature(const Dates& dates, Ticks now);
  bool nature_branches(const Dates& dates, Ticks now, std::size_t link);
  bool controller_branches(const Dates& dates, Ticks now, NodeIndex node);
  bool acceptable(const Dates& dates, Ticks now) const;

  const Stnu& network_;
  std::vector<bool> controlled_;
  std::vector<ContingentLink> links_;
  std::vector<Arc> arcs_;
  std::map<std::pair<Ticks, Dates>, bool> known_;
};

}  // namespace skein::temporal::testing
