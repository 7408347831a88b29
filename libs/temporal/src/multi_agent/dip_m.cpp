// SPDX-License-Identifier: Apache-2.0
// DIP-M: every agent knows its own network, the external arcs and the macro-STN of the others.
// Source: M 3.7, algorithm 6; notes 5.1 (13, 14), 5.2.
#include <map>
#include <utility>

#include "agents.hpp"
#include "macro_network.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {
namespace {

/// Keys: an oriented macro-constraint and the status flag, each written by one agent; the greatest
/// id wins. On the return of a link: one sample of each key ever published.
class DipM final : public Agent {
 public:
  DipM(const Mastn& network, AgentIndex self, const Defects& defects)
      : Agent(self, static_cast<AgentIndex>(network.agents.size()), false),
        owner_(network.owner),
        frontier_(frontier_of(network)),
        rights_(network),
        macro_(network, self),
        core_(defects.literal_upper_test),
        map_(network.nodes.size()),
        arc_of_(network.arcs.size(), kNone),
        others_(network.agents.size()) {
    for (NodeIndex node = 1; node < network.nodes.size(); ++node) {
      if (owner_[node] == self || frontier_[node]) map_.add(node, core_.add_node());
    }
    for (std::size_t i = 0; i < network.arcs.size(); ++i) {
      const Arc& arc = network.arcs[i];
      if (!is_external(network, arc) && owner_of(network, arc) != self) continue;
      arc_of_[i] = core_.add_arc({map_.inner(arc.from), map_.inner(arc.to), arc.min, arc.max});
    }
  }

  Ticks earliest(NodeIndex node) const override { return date(node, Bound::kLower); }
  Ticks latest(NodeIndex node) const override { return date(node, Bound::kUpper); }
  std::optional<MissionTime> blocked_since() const override { return std::nullopt; }
  std::uint64_t checks() const override { return core_.checks() + macro_.checks(); }
  std::uint64_t elimination_checks() const override { return macro_.checks(); }

 private:
  struct Other {
    bool consistent = true;
    std::uint64_t flag_id = 0;
    std::optional<MissionTime> heard;
  };
  /// An arc of the core for two frontier nodes of another agent, from the smaller to the greater.
  struct MacroArc {
    ArcId arc;
    std::uint64_t forward_id = 0;
    std::uint64_t backward_id = 0;
  };

  Output do_start(MissionTime /*now*/) override {
    Output output = propagate();
    send_macro(output);
    return output;
  }

  Result<Output, AgentRefusal> do_disturbance(std::span<const ArcUpdate> changes,
                                              MissionTime /*now*/) override {
    if (const auto refusal = rights_.check(changes, index())) return tl::unexpected(*refusal);
    for (const ArcUpdate& change : changes) {
      macro_.set_arc(change.arc, change.min, change.max);
      core_.set_bounds({arc_of_[change.arc], change.min, change.max});
    }
    Output output = propagate();
    send_macro(output);
    return output;
  }

  void send_macro(Output& output) {
    auto updates = macro_.update();
    if (updates && agents() > 1) {
      output.messages.push_back(make_message(std::nullopt, *std::move(updates)));
    }
  }

  Result<Output, AgentRefusal> do_message(const Message& message, MissionTime now) override {
    const auto* updates = std::get_if<MacroUpdates>(&message.content);
    if (updates == nullptr) return refuse(AgentError::kUnexpected, message.sender);
    for (const MacroConstraint& constraint : updates->constraints) {
      if (const auto refusal = check(constraint, message.sender)) return tl::unexpected(*refusal);
    }
    Other& other = others_[message.sender];
    other.heard = now;
    if (message.id > other.flag_id) {
      other.flag_id = message.id;
      other.consistent = updates->consistent;
    }
    for (const MacroConstraint& constraint : updates->constraints) apply(constraint, message.id);
    return propagate();
  }

  std::optional<AgentRefusal> check(const MacroConstraint& constraint, AgentIndex sender) const {
    for (const NodeIndex node : {constraint.from, constraint.to}) {
      if (node >= owner_.size()) return AgentRefusal{AgentError::kUnknownNode, node};
      if (node != 0 && (!frontier_[node] || owner_[node] != sender)) {
        return AgentRefusal{AgentError::kNotOwner, node};
      }
    }
    if (constraint.from == constraint.to) {
      return AgentRefusal{AgentError::kArcToItself, constraint.from};
    }
    if (const auto error = check_bounds(constraint.min, kInfinite)) {
      return AgentRefusal{*error, constraint.from};
    }
    return std::nullopt;
  }

  void apply(const MacroConstraint& constraint, std::uint64_t id) {
    const bool forward = constraint.from < constraint.to;
    MacroArc& macro = macro_arc(constraint);
    std::uint64_t& last_id = forward ? macro.forward_id : macro.backward_id;
    if (id < last_id) return;
    last_id = id;
    const Arc now = core_.arcs().arc(macro.arc);
    if (forward) {
      core_.set_bounds({macro.arc, constraint.min, now.max});
    } else {
      const Ticks max = constraint.min == kMinusInfinite ? kInfinite : -constraint.min;
      core_.set_bounds({macro.arc, now.min, max});
    }
  }

  MacroArc& macro_arc(const MacroConstraint& constraint) {
    const auto [first, second] = std::minmax(constraint.from, constraint.to);
    const auto found = macro_arcs_.find({first, second});
    if (found != macro_arcs_.end()) return found->second;
    const ArcId arc = core_.add_arc({map_.inner(first), map_.inner(second)});
    return macro_arcs_.emplace(std::pair{first, second}, MacroArc{arc}).first->second;
  }

  Output propagate() {
    core_.relax();
    core_.forget_resets();
    core_.propagate();
    Output output;
    core_.take_changes(output.changed);
    for (BoundChange& change : output.changed) change.node = map_.outer(change.node);
    std::erase_if(output.changed,
                  [this](const BoundChange& change) { return owner_[change.node] != index(); });
    return output;
  }

  Output do_link(AgentIndex peer, bool up, MissionTime /*now*/) override {
    Output output;
    if (up) output.messages.push_back(make_message(peer, macro_.published()));
    return output;
  }

  std::optional<bool> consistent() const override {
    bool all = core_.consistent();
    for (const Other& other : others_) all = all && other.consistent;
    return all;
  }

  std::vector<LastWord> words() const override {
    std::vector<LastWord> words;
    for (const Other& other : others_) {
      words.push_back({other.heard ? std::optional(other.consistent) : std::nullopt, other.heard});
    }
    words[index()].consistent = core_.consistent();
    return words;
  }

  Ticks date(NodeIndex node, Bound bound) const {
    SKEIN_EXPECTS(map_.has(node));
    return core_.date(map_.inner(node), bound);
  }

  std::vector<AgentIndex> owner_;
  std::vector<bool> frontier_;
  ArcRights rights_;
  MacroNetwork macro_;
  Propagation core_;
  NodeMap map_;
  std::vector<ArcId> arc_of_;  ///< in the core, of a position in Mastn::arcs
  std::map<std::pair<NodeIndex, NodeIndex>, MacroArc> macro_arcs_;
  std::vector<Other> others_;
};

}  // namespace

std::unique_ptr<Agent> make_dip_m(const Mastn& network, AgentIndex self, const Defects& defects) {
  return std::make_unique<DipM>(network, self, defects);
}

}  // namespace skein::temporal
