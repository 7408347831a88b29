// SPDX-License-Identifier: Apache-2.0
// Messages between the agents of a multi-agent temporal network.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/temporal/network.hpp"
#include "skein/temporal/stn_engine.hpp"

namespace skein::temporal {

/// UPDATE(v, w, both bounds): new bounds of an arc, named by its position in `Mastn::arcs`.
struct ArcUpdate {
  std::uint32_t arc = 0;
  Ticks min = kMinusInfinite;
  Ticks max = kInfinite;
  bool operator==(const ArcUpdate&) const = default;
};

/// All the arcs of one perturbation. CIP: slave to supervisor. DIP-G: to all.
struct ArcUpdates {
  std::vector<ArcUpdate> arcs;
  bool operator==(const ArcUpdates&) const = default;
};

/// CIP: supervisor to slave, the bounds of its nodes that changed (UPDATE(v0, v, …) for each).
struct NodeUpdates {
  std::vector<BoundChange> bounds;
  bool operator==(const NodeUpdates&) const = default;
};

/// DIP-L: UPDATE of one bound of a frontier node of the sender.
struct Update {
  NodeIndex node = 0;
  Bound bound = Bound::kLower;
  /// The date; when not `anchored`, an offset from -∞ (kLower) or +∞ (kUpper): the node is tied to
  /// others but not to v0, and the offset serves to find a cycle.
  Ticks value = 0;
  bool anchored = true;
  /// The frontier nodes through which the value came, `node` the last; no node twice.
  std::vector<NodeIndex> trail;
  bool operator==(const Update&) const = default;
};

/// Names a relaxation of the sender of RELAX; RELAXED gives it back.
using JobId = std::uint64_t;

/// DIP-L: RELAX(v, b, job): forget this bound of my node v and all that follows from it.
struct Relax {
  NodeIndex node = 0;
  Bound bound = Bound::kLower;
  JobId job = 0;
  bool operator==(const Relax&) const = default;
};

/// DIP-L: RELAXED(v, b, job): that is done, here and beyond.
struct Relaxed {
  NodeIndex node = 0;
  Bound bound = Bound::kLower;
  JobId job = 0;
  bool operator==(const Relaxed&) const = default;
};

/// CIP, DIP-L: the sender's view of the consistency, knowing the receiver's data messages up to
/// `last_id` (0: none).
struct Consistency {
  bool consistent = true;
  std::uint64_t last_id = 0;
  bool operator==(const Consistency&) const = default;
};

/// One oriented macro-constraint: to - from >= min (kMinusInfinite: none any more).
struct MacroConstraint {
  NodeIndex from = 0;
  NodeIndex to = 0;
  Ticks min = kMinusInfinite;
  bool operator==(const MacroConstraint&) const = default;
};

/// DIP-M: the macro-constraints of the sender that one perturbation changed, and its status flag:
/// false while a component of its own has a negative cycle (its macro-constraints then stay).
struct MacroUpdates {
  std::vector<MacroConstraint> constraints;
  bool consistent = true;
  bool operator==(const MacroUpdates&) const = default;
};

/// DIP-L: nothing but the opening of a session (see `Message::sender_epoch`).
struct Hello {
  bool operator==(const Hello&) const = default;
};

using Content =
    std::variant<ArcUpdates, NodeUpdates, Update, Relax, Relaxed, Consistency, MacroUpdates, Hello>;

struct Message {
  AgentIndex sender = 0;
  std::optional<AgentIndex> receiver;  ///< absent: every other agent
  std::uint64_t id = 0;                ///< strictly increasing at the sender, from 1
  /// DIP-L: how many times the link returned, as seen by the sender and, the last it heard, by the
  /// receiver. What was sent to an earlier session is dropped. 0 in the other algorithms.
  std::uint32_t sender_epoch = 0;
  std::uint32_t receiver_epoch = 0;
  Content content;
  bool operator==(const Message&) const = default;
};

/// Whether it is data (UPDATE, RELAX, RELAXED, macro) rather than CONSISTENCY or Hello.
bool is_data(const Content& content);
/// The number of messages by the paper's count: one for each arc, bound or macro-constraint in the
/// content; 1 for a status flag alone.
std::size_t unit_count(const Content& content);
/// For people and golden files: "RELAX(7, LB, job 3)".
std::string to_text(const Content& content);

}  // namespace skein::temporal
