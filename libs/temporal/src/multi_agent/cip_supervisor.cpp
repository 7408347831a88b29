// SPDX-License-Identifier: Apache-2.0
// CIP, the supervisor: it knows and propagates everything. Source: M 3.4, algorithm 2; notes 5.1.
#include <algorithm>
#include <utility>

#include "agents.hpp"

namespace skein::temporal {
namespace {

/// A bound is sent exactly when it differs from the last one sent (erratum 4); the bounds of one
/// slave that one perturbation changed go in one message. On the return of a link: all its bounds.
class CipSupervisor final : public Agent {
 public:
  CipSupervisor(const Mastn& network, const Defects& defects)
      : Agent(static_cast<AgentIndex>(network.agents.size()),
              static_cast<AgentIndex>(network.agents.size()), true),
        literal_bound_updates_(defects.literal_bound_updates),
        owner_(network.owner),
        rights_(network),
        core_(propagation_of(network, defects)),
        slaves_(network.agents.size()) {
    for (NodeIndex node = 0; node < network.nodes.size(); ++node) {
      sent_.insert(sent_.end(), {kMinusInfinite, kInfinite});
    }
  }

  Ticks earliest(NodeIndex node) const override { return core_.date(node, Bound::kLower); }
  Ticks latest(NodeIndex node) const override { return core_.date(node, Bound::kUpper); }
  std::optional<MissionTime> blocked_since() const override { return std::nullopt; }
  std::uint64_t checks() const override { return core_.checks(); }

 private:
  struct Slave {
    std::uint64_t last_id_received = 0;
    std::optional<Consistency> last_word_sent;
    std::optional<MissionTime> heard;
  };

  Output do_start(MissionTime /*now*/) override { return propagate(); }

  Result<Output, AgentRefusal> do_disturbance(std::span<const ArcUpdate> changes,
                                              MissionTime /*now*/) override {
    if (changes.empty()) return Output{};
    return refuse(AgentError::kNotOwner, changes.front().arc);
  }

  Result<Output, AgentRefusal> do_message(const Message& message, MissionTime now) override {
    const auto* updates = std::get_if<ArcUpdates>(&message.content);
    if (updates == nullptr) return refuse(AgentError::kUnexpected, message.sender);
    if (const auto refusal = rights_.check(updates->arcs, message.sender)) {
      return tl::unexpected(*refusal);
    }
    Slave& slave = slaves_[message.sender];
    slave.last_id_received = message.id;
    slave.heard = now;
    for (const ArcUpdate& update : updates->arcs) {
      core_.set_bounds({update.arc, update.min, update.max});
    }
    return propagate();
  }

  Output do_link(AgentIndex peer, bool up, MissionTime /*now*/) override {
    Output output;
    if (!up) return output;
    NodeUpdates all;
    for (NodeIndex node = 1; node < owner_.size(); ++node) {
      if (owner_[node] != peer) continue;
      for (const Bound bound : kBounds) all.bounds.push_back({node, bound, sent(node, bound)});
    }
    if (!all.bounds.empty()) output.messages.push_back(make_message(peer, std::move(all)));
    slaves_[peer].last_word_sent.reset();
    send_words(output);
    return output;
  }

  Output propagate() {
    core_.relax();
    core_.forget_resets();
    core_.propagate();
    Output output;
    core_.take_changes(output.changed);
    send_bounds(output);
    send_words(output);
    return output;
  }

  void send_bounds(Output& output) {
    std::vector<NodeUpdates> updates(slaves_.size());
    for (const BoundChange& change : output.changed) {
      if (change.value == sent(change.node, change.bound)) continue;
      if (literal_bound_updates_ && weaker_than_sent(change)) continue;
      sent(change.node, change.bound) = change.value;
      updates[owner_[change.node]].bounds.push_back(change);
    }
    for (AgentIndex slave = 0; slave < updates.size(); ++slave) {
      if (updates[slave].bounds.empty()) continue;
      output.messages.push_back(make_message(slave, std::move(updates[slave])));
    }
  }

  void send_words(Output& output) {
    for (AgentIndex i = 0; i < slaves_.size(); ++i) {
      const Consistency word{core_.consistent(), slaves_[i].last_id_received};
      if (slaves_[i].last_word_sent == word) continue;
      slaves_[i].last_word_sent = word;
      output.messages.push_back(make_message(i, word));
    }
  }

  bool weaker_than_sent(const BoundChange& change) {
    const Ticks last = sent(change.node, change.bound);
    return change.bound == Bound::kLower ? change.value < last : change.value > last;
  }

  Ticks& sent(NodeIndex node, Bound bound) { return sent_[2 * node + side(bound)]; }

  std::optional<bool> consistent() const override { return core_.consistent(); }

  std::vector<LastWord> words() const override {
    std::vector<LastWord> words;
    for (const Slave& slave : slaves_) words.push_back({std::nullopt, slave.heard});
    return words;
  }

  bool literal_bound_updates_;
  std::vector<AgentIndex> owner_;
  ArcRights rights_;
  Propagation core_;
  std::vector<Slave> slaves_;
  std::vector<Ticks> sent_;
};

}  // namespace

std::unique_ptr<Agent> make_cip_supervisor(const Mastn& network, const Defects& defects) {
  return std::make_unique<CipSupervisor>(network, defects);
}

}  // namespace skein::temporal
