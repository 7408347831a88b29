// SPDX-License-Identifier: Apache-2.0
// DIP-L: an agent knows its own network and the bounds of the external nodes. Source: M 3.6,
// algorithm 5; notes 5.1 (6-12, 16), 5.2, 5.4.
#include <algorithm>
#include <set>
#include <utility>

#include "agents.hpp"
#include "relax_jobs.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {
namespace {

/// Relaxations are handled at once; contraction waits until no job is open. External nodes are
/// imports, raised by their owner only. Each UPDATE carries the frontier nodes it came through: a
/// node is not raised by what came through itself, else a positive cycle across agents would turn
/// for ever. A link that returns opens a session: both ends forget the other's bounds, ask again
/// for the RELAXED still owed, and send their bounds again.
class DipL final : public Agent {
 public:
  DipL(const Mastn& network, AgentIndex self, const Defects& defects)
      : Agent(self, static_cast<AgentIndex>(network.agents.size()), true),
        no_waiting_(defects.no_waiting),
        owner_(network.owner),
        rights_(network),
        core_(defects.literal_upper_test),
        map_(network.nodes.size()),
        arc_of_(network.arcs.size(), kNone),
        peers_(network.agents.size()) {
    add_nodes(network);
    for (std::size_t i = 0; i < network.arcs.size(); ++i) {
      const Arc& arc = network.arcs[i];
      if (!map_.has(arc.from) || !map_.has(arc.to) || !touches_own(arc)) continue;
      arc_of_[i] = core_.add_arc({map_.inner(arc.from), map_.inner(arc.to), arc.min, arc.max});
    }
  }

  Ticks earliest(NodeIndex node) const override { return date(node, Bound::kLower); }
  Ticks latest(NodeIndex node) const override { return date(node, Bound::kUpper); }
  std::optional<MissionTime> blocked_since() const override { return blocked_since_; }
  std::uint64_t checks() const override { return core_.checks(); }

 private:
  /// The last UPDATE sent for a bound of a frontier node; kFloating: none holds.
  struct Export {
    Ticks value = kFloating;
    std::vector<NodeIndex> trail;
  };
  struct Frontier {
    NodeIndex node;
    std::vector<AgentIndex> sharers;
    Export exports[2];
  };
  struct Peer {
    std::uint64_t last_id_received = 0;  ///< of data, in this session
    std::uint64_t last_id_sent = 0;
    std::optional<Consistency> last_word_sent;
    std::optional<bool> consistent;
    std::optional<MissionTime> heard;
    std::uint32_t own_epoch = 0;
    std::uint32_t epoch = 0;
  };

  bool is_own(NodeIndex node) const { return node != 0 && owner_[node] == index(); }
  bool touches_own(const Arc& arc) const { return is_own(arc.from) || is_own(arc.to); }

  void add_nodes(const Mastn& network) {
    std::vector<std::set<AgentIndex>> sharers(network.nodes.size());
    std::vector<bool> imported(network.nodes.size(), false);
    for (const Arc& arc : network.arcs) {
      if (!is_external(network, arc) || !touches_own(arc)) continue;
      const NodeIndex own = is_own(arc.from) ? arc.from : arc.to;
      const NodeIndex other = is_own(arc.from) ? arc.to : arc.from;
      sharers[own].insert(owner_[other]);
      imported[other] = true;
    }
    for (NodeIndex node = 1; node < network.nodes.size(); ++node) {
      if (is_own(node) || imported[node]) map_.add(node, core_.add_node(imported[node]));
      if (sharers[node].empty()) continue;
      frontier_.push_back({node, {sharers[node].begin(), sharers[node].end()}, {}});
    }
    import_trails_.resize(2 * core_.arcs().nodes());
  }

  Output do_start(MissionTime now) override {
    Output output;
    settle(now, output);
    return output;
  }

  Result<Output, AgentRefusal> do_disturbance(std::span<const ArcUpdate> changes,
                                              MissionTime now) override {
    if (const auto refusal = rights_.check(changes, index())) return tl::unexpected(*refusal);
    for (const ArcUpdate& change : changes) {
      core_.set_bounds({arc_of_[change.arc], change.min, change.max});
    }
    Output output;
    core_.relax();
    open_job(std::nullopt, output);
    settle(now, output);
    return output;
  }

  Result<Output, AgentRefusal> do_message(const Message& message, MissionTime now) override {
    if (message.receiver_epoch > peers_[message.sender].own_epoch) {
      return refuse(AgentError::kUnexpected, message.sender);
    }
    if (const auto refusal = check_content(message)) return tl::unexpected(*refusal);
    Output output;
    Peer& peer = peers_[message.sender];
    peer.heard = now;
    if (message.sender_epoch > peer.epoch) {
      peer.epoch = message.sender_epoch;
      begin_session(message.sender, output);
    }
    if (message.sender_epoch == peer.epoch && message.receiver_epoch == peer.own_epoch) {
      if (is_data(message.content)) peer.last_id_received = message.id;
      std::visit([&](const auto& content) { handle(content, message, output); }, message.content);
    }
    settle(now, output);
    return output;
  }

  std::optional<AgentRefusal> check_content(const Message& message) const {
    const AgentIndex sender = message.sender;
    if (const auto* m = std::get_if<Update>(&message.content)) return check(*m, message);
    if (const auto* m = std::get_if<Relax>(&message.content)) return check_import(m->node, sender);
    if (const auto* m = std::get_if<Relaxed>(&message.content)) return check(*m, sender);
    const bool known = std::holds_alternative<Consistency>(message.content) ||
                       std::holds_alternative<Hello>(message.content);
    if (!known) return AgentRefusal{AgentError::kUnexpected, sender};
    return std::nullopt;
  }

  std::optional<AgentRefusal> check_import(NodeIndex node, AgentIndex sender) const {
    if (node >= owner_.size()) return AgentRefusal{AgentError::kUnknownNode, node};
    if (node == 0 || owner_[node] != sender) return AgentRefusal{AgentError::kNotOwner, node};
    if (!map_.has(node)) return AgentRefusal{AgentError::kUnknownNode, node};
    return std::nullopt;
  }

  std::optional<AgentRefusal> check(const Relaxed& relaxed, AgentIndex sender) const {
    if (relaxed.node >= owner_.size()) return AgentRefusal{AgentError::kUnknownNode, relaxed.node};
    const Frontier* frontier = frontier_at(relaxed.node);
    if (frontier == nullptr ||
        !std::binary_search(frontier->sharers.begin(), frontier->sharers.end(), sender)) {
      return AgentRefusal{AgentError::kNotOwner, relaxed.node};
    }
    if (!jobs_.ever_opened(relaxed.job)) {
      return AgentRefusal{AgentError::kUnknownJob, relaxed.node};
    }
    return std::nullopt;
  }

  std::optional<AgentRefusal> check(const Update& update, const Message& message) const {
    if (const auto refusal = check_import(update.node, message.sender)) return refusal;
    if (update.value < -kLargest || update.value > kLargest) {
      return AgentRefusal{AgentError::kOverflow, update.node};
    }
    std::set<NodeIndex> passed;
    for (const NodeIndex node : update.trail) {
      if (node >= owner_.size() || node == 0) return AgentRefusal{AgentError::kUnknownNode, node};
      if (!passed.insert(node).second) return AgentRefusal{AgentError::kCyclicOwnership, node};
    }
    if (update.trail.empty() || update.trail.back() != update.node) {
      return AgentRefusal{AgentError::kNotOwner, update.node};
    }
    const Peer& peer = peers_[message.sender];
    const bool same_session =
        message.sender_epoch == peer.epoch && message.receiver_epoch == peer.own_epoch;
    if (same_session && stored(update) < core_.value(map_.inner(update.node), update.bound)) {
      return AgentRefusal{AgentError::kWeakerUpdate, update.node};
    }
    return std::nullopt;
  }

  static Ticks stored(const Update& update) {
    const Ticks value = update.bound == Bound::kLower ? update.value : -update.value;
    return update.anchored ? value : kFloating + value;
  }

  void handle(const Update& update, const Message& /*message*/, Output& /*output*/) {
    std::vector<NodeIndex> own;
    for (const NodeIndex node : update.trail) {
      if (is_own(node)) own.push_back(map_.inner(node));
    }
    const NodeIndex import = map_.inner(update.node);
    core_.set_import(import, update.bound, stored(update), std::move(own));
    import_trails_[2 * import + side(update.bound)] = update.trail;
  }

  void handle(const Relax& relax, const Message& message, Output& output) {
    core_.drop_import(map_.inner(relax.node), relax.bound);
    core_.relax();
    open_job(RelaxJobs::Origin{message.sender, relax}, output);
  }

  void handle(const Relaxed& relaxed, const Message& message, Output& output) {
    const auto origin = jobs_.close(relaxed.job, {relaxed.node, relaxed.bound, message.sender});
    if (origin) answer(*origin, output);
  }

  void handle(const Consistency& word, const Message& message, Output& /*output*/) {
    Peer& peer = peers_[message.sender];
    if (word.last_id == peer.last_id_sent) peer.consistent = word.consistent;
  }

  void handle(const Hello& /*hello*/, const Message& /*message*/, Output& /*output*/) {}
  template <class Other>
  void handle(const Other& /*other*/, const Message& /*message*/, Output& /*output*/) {
    SKEIN_EXPECTS(false);  // check_content refused it
  }

  /// For what was just reset: the sharers of each bound they were told are to forget it too.
  void open_job(std::optional<RelaxJobs::Origin> origin, Output& output) {
    std::set<RelaxJobs::Wait> waits;
    for (const Propagation::BoundRef& reset : core_.take_resets()) {
      Frontier* frontier = frontier_at(map_.outer(reset.node));
      if (frontier == nullptr) continue;
      Export& sent = frontier->exports[side(reset.bound)];
      if (sent.value == kFloating) continue;
      sent = {};
      for (const AgentIndex sharer : frontier->sharers) {
        waits.insert({frontier->node, reset.bound, sharer});
        send(sharer, Relax{frontier->node, reset.bound, jobs_.next()}, output);
      }
    }
    if (!waits.empty()) {
      jobs_.open(std::move(origin), std::move(waits));
    } else if (origin) {
      answer(*origin, output);
    }
  }

  void answer(const RelaxJobs::Origin& origin, Output& output) {
    const Relax& request = origin.request;
    send(origin.agent, Relaxed{request.node, request.bound, request.job}, output);
  }

  void settle(MissionTime now, Output& output) {
    if (jobs_.none_open() || no_waiting_) {
      core_.propagate();
      send_updates(output);
      send_words(output);
    }
    if (jobs_.none_open()) blocked_since_.reset();
    if (!jobs_.none_open() && !blocked_since_) blocked_since_ = now;
    core_.take_changes(output.changed);
    for (BoundChange& change : output.changed) change.node = map_.outer(change.node);
    std::erase_if(output.changed, [this](const BoundChange& c) { return !is_own(c.node); });
  }

  void send_updates(Output& output) {
    for (Frontier& frontier : frontier_) {
      for (const Bound bound : kBounds) {
        const NodeIndex node = map_.inner(frontier.node);
        Export& sent = frontier.exports[side(bound)];
        if (core_.value(node, bound) == sent.value) continue;
        sent = {core_.value(node, bound), trail_of(node, bound)};
        for (const AgentIndex sharer : frontier.sharers) {
          send(sharer, update_of(frontier, bound), output);
        }
      }
    }
  }

  std::vector<NodeIndex> trail_of(NodeIndex node, Bound bound) const {
    std::vector<NodeIndex> trail;
    const NodeIndex import = core_.root(node, bound);
    if (import != kNone) trail = import_trails_[2 * import + side(bound)];
    trail.push_back(map_.outer(node));
    return trail;
  }

  static Update update_of(const Frontier& frontier, Bound bound) {
    const Export& sent = frontier.exports[side(bound)];
    const bool tied = anchored(sent.value);
    const Ticks value = tied ? sent.value : sent.value - kFloating;
    return {frontier.node, bound, bound == Bound::kLower ? value : -value, tied, sent.trail};
  }

  void send_words(Output& output) {
    for (AgentIndex agent = 0; agent < agents(); ++agent) {
      if (agent == index()) continue;
      const Consistency word{core_.consistent(), peers_[agent].last_id_received};
      if (peers_[agent].last_word_sent == word) continue;
      peers_[agent].last_word_sent = word;
      send(agent, word, output);
    }
  }

  void send(AgentIndex receiver, Content content, Output& output) {
    Peer& peer = peers_[receiver];
    Message message = make_message(receiver, std::move(content));
    message.sender_epoch = peer.own_epoch;
    message.receiver_epoch = peer.epoch;
    if (is_data(message.content)) peer.last_id_sent = message.id;
    output.messages.push_back(std::move(message));
  }

  Output do_link(AgentIndex agent, bool up, MissionTime now) override {
    Output output;
    if (!up) return output;
    ++peers_[agent].own_epoch;
    begin_session(agent, output);
    settle(now, output);
    return output;
  }

  void begin_session(AgentIndex agent, Output& output) {
    Peer& peer = peers_[agent];
    peer.last_id_received = peer.last_id_sent = 0;
    peer.last_word_sent.reset();
    peer.consistent.reset();
    send(agent, Hello{}, output);
    for (const Relax& again : jobs_.begin_session(agent)) send(agent, again, output);
    drop_imports_of(agent);
    open_job(std::nullopt, output);
    for (const Frontier& frontier : frontier_) {
      if (!std::binary_search(frontier.sharers.begin(), frontier.sharers.end(), agent)) continue;
      for (const Bound bound : kBounds) {
        if (frontier.exports[side(bound)].value == kFloating) continue;
        send(agent, update_of(frontier, bound), output);
      }
    }
  }

  void drop_imports_of(AgentIndex agent) {
    for (NodeIndex inner = 1; inner < core_.arcs().nodes(); ++inner) {
      if (owner_[map_.outer(inner)] != agent) continue;
      for (const Bound bound : kBounds) core_.drop_import(inner, bound);
    }
    core_.relax();
  }

  std::optional<bool> consistent() const override {
    bool unknown = false;
    for (const LastWord& word : words()) {
      if (word.consistent == false) return false;
      unknown = unknown || !word.consistent;
    }
    if (unknown) return std::nullopt;
    return true;
  }

  std::vector<LastWord> words() const override {
    std::vector<LastWord> words;
    for (const Peer& peer : peers_) words.push_back({peer.consistent, peer.heard});
    if (jobs_.none_open()) words[index()].consistent = core_.consistent();
    return words;
  }

  std::size_t frontier_place(NodeIndex node) const {
    const auto found = std::lower_bound(frontier_.begin(), frontier_.end(), node,
                                        [](const Frontier& f, NodeIndex n) { return f.node < n; });
    const bool is_there = found != frontier_.end() && found->node == node;
    return is_there ? static_cast<std::size_t>(found - frontier_.begin()) : frontier_.size();
  }
  Frontier* frontier_at(NodeIndex node) {
    const std::size_t place = frontier_place(node);
    return place < frontier_.size() ? &frontier_[place] : nullptr;
  }
  const Frontier* frontier_at(NodeIndex node) const {
    const std::size_t place = frontier_place(node);
    return place < frontier_.size() ? &frontier_[place] : nullptr;
  }

  Ticks date(NodeIndex node, Bound bound) const {
    SKEIN_EXPECTS(map_.has(node));
    return core_.date(map_.inner(node), bound);
  }

  bool no_waiting_;
  std::vector<AgentIndex> owner_;
  ArcRights rights_;
  Propagation core_;
  NodeMap map_;
  std::vector<ArcId> arc_of_;  ///< in the core, of a position in Mastn::arcs
  std::vector<Frontier> frontier_;
  std::vector<std::vector<NodeIndex>> import_trails_;  ///< of (import, bound)
  RelaxJobs jobs_;
  std::vector<Peer> peers_;
  std::optional<MissionTime> blocked_since_;
};

}  // namespace

std::unique_ptr<Agent> make_dip_l(const Mastn& network, AgentIndex self, const Defects& defects) {
  return std::make_unique<DipL>(network, self, defects);
}

}  // namespace skein::temporal
