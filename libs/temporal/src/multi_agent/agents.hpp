// SPDX-License-Identifier: Apache-2.0
// Parts shared by the four algorithms, and their factories. Precondition of all: valid networks.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "defects.hpp"
#include "network/propagation.hpp"
#include "skein/temporal/agent.hpp"

namespace skein::temporal {

std::unique_ptr<Agent> make_cip_slave(const Mastn& network, AgentIndex self);
std::unique_ptr<Agent> make_cip_supervisor(const Mastn& network, const Defects& defects);
std::unique_ptr<Agent> make_dip_g(const Mastn& network, AgentIndex self, const Defects& defects);
std::unique_ptr<Agent> make_dip_l(const Mastn& network, AgentIndex self, const Defects& defects);
std::unique_ptr<Agent> make_dip_m(const Mastn& network, AgentIndex self, const Defects& defects);

inline tl::unexpected<AgentRefusal> refuse(AgentError error, std::uint32_t where) {
  return tl::unexpected(AgentRefusal{error, where});
}
std::optional<AgentError> check_bounds(Ticks min, Ticks max);

/// The owner of each arc, by position in `Mastn::arcs`.
class ArcRights {
 public:
  explicit ArcRights(const Mastn& network);
  /// The refusal if `agent` may not change these arcs.
  std::optional<AgentRefusal> check(std::span<const ArcUpdate> changes, AgentIndex agent) const;

 private:
  struct Right {
    AgentIndex owner;
    bool external;
  };
  std::vector<Right> rights_;
};

/// The last value of every own arc that was ever changed.
class ChangedArcs {
 public:
  void note(std::span<const ArcUpdate> changes);
  const std::vector<ArcUpdate>& samples() const { return samples_; }

 private:
  std::vector<ArcUpdate> samples_;  ///< in the order of `arc`
};

/// The network of some nodes of a MaSTN under the numbers of the MaSTN. v0 is always among them.
class NodeMap {
 public:
  explicit NodeMap(std::size_t nodes) : inner_(nodes, kNone) { add(0, 0); }
  bool has(NodeIndex node) const { return node < inner_.size() && inner_[node] != kNone; }
  void add(NodeIndex node, NodeIndex inner) {
    inner_[node] = inner;
    outer_.push_back(node);
  }
  NodeIndex inner(NodeIndex node) const { return inner_[node]; }
  NodeIndex outer(NodeIndex inner) const { return outer_[inner]; }
  std::size_t outer_count() const { return inner_.size(); }

 private:
  std::vector<NodeIndex> inner_;
  std::vector<NodeIndex> outer_;
};

/// The whole MaSTN propagated, arcs under their own numbers.
Propagation propagation_of(const Mastn& network, const Defects& defects);

}  // namespace skein::temporal
