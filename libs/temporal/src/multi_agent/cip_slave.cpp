// SPDX-License-Identifier: Apache-2.0
// CIP, a slave: it sends its perturbations to the supervisor and is told its bounds. Source: M 3.4,
// algorithm 3.
#include <algorithm>
#include <utility>

#include "agents.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {
namespace {

/// Blocked from a perturbation until the supervisor answers it, and from a cut of the link to the
/// supervisor until the return. On the return it sends every own arc ever changed again.
class CipSlave final : public Agent {
 public:
  CipSlave(const Mastn& network, AgentIndex self)
      : Agent(self, static_cast<AgentIndex>(network.agents.size()), true),
        own_(network.nodes.size()),
        rights_(network) {
    dates_.resize(2);  // v0
    for (NodeIndex node = 1; node < network.nodes.size(); ++node) {
      if (network.owner[node] != self) continue;
      own_.add(node, static_cast<NodeIndex>(dates_.size() / 2));
      dates_.insert(dates_.end(), {kMinusInfinite, kInfinite});
    }
  }

  Ticks earliest(NodeIndex node) const override { return date(node, Bound::kLower); }
  Ticks latest(NodeIndex node) const override { return date(node, Bound::kUpper); }
  std::uint64_t checks() const override { return 0; }
  std::optional<MissionTime> blocked_since() const override {
    return skein::earliest(cut_since_, unanswered_since_);
  }

 private:
  AgentIndex supervisor() const { return agents(); }
  bool knows_peer(AgentIndex peer) const override { return peer == supervisor(); }

  Output do_start(MissionTime /*now*/) override { return {}; }

  Result<Output, AgentRefusal> do_disturbance(std::span<const ArcUpdate> changes,
                                              MissionTime now) override {
    if (const auto refusal = rights_.check(changes, index())) return tl::unexpected(*refusal);
    changed_.note(changes);
    Output output;
    if (!changes.empty()) send({changes.begin(), changes.end()}, now, output);
    return output;
  }

  void send(std::vector<ArcUpdate> arcs, MissionTime now, Output& output) {
    output.messages.push_back(make_message(supervisor(), ArcUpdates{std::move(arcs)}));
    last_id_sent_ = output.messages.back().id;
    consistent_.reset();
    if (!unanswered_since_) unanswered_since_ = now;
  }

  Result<Output, AgentRefusal> do_message(const Message& message, MissionTime now) override {
    if (const auto* updates = std::get_if<NodeUpdates>(&message.content)) return set(*updates, now);
    const auto* word = std::get_if<Consistency>(&message.content);
    if (word == nullptr) return refuse(AgentError::kUnexpected, message.sender);
    heard_ = now;
    if (word->last_id == last_id_sent_) {
      consistent_ = word->consistent;
      unanswered_since_.reset();
    }
    return Output{};
  }

  Result<Output, AgentRefusal> set(const NodeUpdates& updates, MissionTime now) {
    for (const BoundChange& bound : updates.bounds) {
      if (bound.node >= own_.outer_count()) return refuse(AgentError::kUnknownNode, bound.node);
      if (bound.node == 0 || !own_.has(bound.node)) {
        return refuse(AgentError::kNotOwner, bound.node);
      }
      const Ticks open = bound.bound == Bound::kLower ? kMinusInfinite : kInfinite;
      if (bound.value != open && (bound.value < -kLargest || bound.value > kLargest)) {
        return refuse(AgentError::kOverflow, bound.node);
      }
    }
    heard_ = now;
    Output output;
    for (const BoundChange& bound : updates.bounds) {
      Ticks& date = dates_[2 * own_.inner(bound.node) + side(bound.bound)];
      if (date != bound.value) output.changed.push_back(bound);
      date = bound.value;
    }
    return output;
  }

  Output do_link(AgentIndex /*peer*/, bool up, MissionTime now) override {
    Output output;
    if (!up) {
      if (!cut_since_) cut_since_ = now;
      return output;
    }
    cut_since_.reset();
    if (!changed_.samples().empty()) send(changed_.samples(), now, output);
    return output;
  }

  std::optional<bool> consistent() const override { return consistent_; }

  /// The word of each agent is the supervisor's, the only one a slave hears.
  std::vector<LastWord> words() const override {
    std::vector<LastWord> words(agents());
    words[index()] = {consistent_, heard_};
    return words;
  }

  Ticks date(NodeIndex node, Bound bound) const {
    SKEIN_EXPECTS(own_.has(node));
    return dates_[2 * own_.inner(node) + side(bound)];
  }

  NodeMap own_;
  ArcRights rights_;
  std::vector<Ticks> dates_;
  ChangedArcs changed_;
  std::uint64_t last_id_sent_ = 0;
  std::optional<bool> consistent_;
  std::optional<MissionTime> heard_;
  std::optional<MissionTime> unanswered_since_;
  std::optional<MissionTime> cut_since_;
};

}  // namespace

std::unique_ptr<Agent> make_cip_slave(const Mastn& network, AgentIndex self) {
  return std::make_unique<CipSlave>(network, self);
}

}  // namespace skein::temporal
