// SPDX-License-Identifier: Apache-2.0
// An STNU under change: named nodes and links are added and removed, and its controllability is
// kept up to date.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/temporal/incremental_controllability.hpp"

namespace skein::temporal {

/// Global name of a node; stable under changes of the network.
struct NodeName {
  std::uint32_t agent = 0;  ///< owner
  std::uint64_t key = 0;    ///< chosen by the owner
  auto operator<=>(const NodeName&) const = default;
};

/// Name of a link: the task it belongs to, which of its bounds, and the other end.
struct LinkName {
  std::uint32_t agent = 0;
  std::uint64_t key = 0;
  std::uint32_t kind = 0;
  std::uint64_t other = 0;
  auto operator<=>(const LinkName&) const = default;
};

/// min <= to - from <= max; contingent: nature's choice, then 0 < min <= max < ∞.
struct LiveLink {
  NodeName from, to;
  Ticks min = kMinusInfinite;
  Ticks max = kInfinite;
  bool contingent = false;
  bool operator==(const LiveLink&) const = default;
};

/// One bound of one link, by name.
struct NamedTerm {
  LinkName link;
  LinkBound bound = LinkBound::kMin;
  bool operator==(const NamedTerm&) const = default;
};

struct LiveVerdict {
  bool consistent = true;
  bool controllable = true;
  std::vector<NamedTerm> conflict;  ///< as DcResult has it
  std::optional<StnuFault> fault;   ///< no verdict is possible
};

/// `node` waits for the end of contingent link `link`: it comes no earlier than `delay` after the
/// link's activation, unless (delay > the link's min) the end has come before.
struct NamedWait {
  NodeIndex node = 0;
  LinkName link;
  Ticks delay = 0;
};

/// Nodes and links are changed in place, and `settle` decides all changes together: incrementally
/// if they are few and the network was controllable, else from scratch. A node that is added again
/// under its name has a new epoch, so that messages about the old one are not applied to it; links
/// to nodes of other agents are links like any other. Memory: that of IncrementalDc.
/// Thread rule: not safe to share. Movable. Source: spec 5.2; T IV.4.1.
class LiveNetwork {
 public:
  /// The origin's name. It is always there, and its index is 0.
  static constexpr NodeName kOrigin{0xFFFFFFFF, 0};

  LiveNetwork();

  /// Adds a node and returns its index, which is valid until its removal and reused afterwards.
  /// Precondition: the network has no node of that name.
  NodeIndex add_node(const NodeName& name);
  /// Removes a node and its links. Precondition: the node exists and is not the origin.
  void remove_node(const NodeName& name);
  std::optional<NodeIndex> index(const NodeName& name) const;
  /// Epoch of a node, greater than that of any node added before it; absent: no such node.
  std::optional<std::uint32_t> epoch(const NodeName& name) const;

  /// Adds or changes a link; returns its number, valid until its removal. Preconditions: its nodes
  /// exist and differ; its bounds satisfy LiveLink.
  std::uint32_t set_link(const LinkName& name, const LiveLink& link);
  void remove_link(const LinkName& name);

  /// Decides controllability after the changes.
  const LiveVerdict& settle();
  const LiveVerdict& verdict() const { return verdict_; }
  /// All waits of a controllable network after settle(), in the order of links.
  std::vector<NamedWait> waits() const;
  /// Bounds that follow from contingent links for any durations, in the order of links.
  /// Precondition: settle() has found the network controllable.
  std::vector<DistanceEdge> implied() const;

  /// As a plain value; places of removed nodes are nodes without links.
  Stnu network() const;
  const LiveLink& link(const LinkName& name) const;
  std::size_t link_count() const { return by_name_.size(); }
  /// Settlings by parts, and from scratch, since construction.
  std::uint64_t settled_locally() const { return local_; }
  std::uint64_t settled_from_scratch() const { return scratch_; }

 private:
  struct Node {
    NodeIndex index = 0;
    std::uint32_t epoch = 0;
  };
  struct Slot {
    LinkName name;
    LiveLink link;
    bool there = false;
    /// As the check has it.
    std::optional<LiveLink> applied;
    NodeIndex from = 0, to = 0;
    std::uint32_t position = 0;
  };
  static bool is_arc(const LiveLink& link) { return !link.contingent || link.min == link.max; }

  bool settle_locally();
  bool take_out(Slot& slot);
  bool put_in(Slot& slot, std::uint32_t number);
  static bool accept(const Result<DcResult, StnuError>& result);
  void settle_from_scratch();
  void free_slots();

  std::map<NodeName, Node> nodes_;
  std::uint32_t last_epoch_ = 0;
  std::vector<NodeIndex> free_nodes_;
  std::vector<std::set<std::uint32_t>> links_at_;  ///< of each node
  std::map<LinkName, std::uint32_t> by_name_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_slots_;
  std::set<std::uint32_t> touched_;
  std::optional<IncrementalDc> check_;
  std::vector<std::uint32_t> arcs_, contingent_;  ///< slots, by position in the check's network
  LiveVerdict verdict_;
  std::uint64_t local_ = 0, scratch_ = 0;
};

}  // namespace skein::temporal
