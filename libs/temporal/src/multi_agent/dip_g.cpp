// SPDX-License-Identifier: Apache-2.0
// DIP-G: every agent knows every arc; each perturbation is sent to all. Source: M 3.5, algorithm 4.
#include <utility>

#include "agents.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {
namespace {

/// Key: an arc, written by its owner only; the message with the greatest id wins, so the transport
/// need not keep the order. On the return of a link: one sample of each own arc ever changed.
class DipG final : public Agent {
 public:
  DipG(const Mastn& network, AgentIndex self, const Defects& defects)
      : Agent(self, static_cast<AgentIndex>(network.agents.size()), false),
        owner_(network.owner),
        rights_(network),
        core_(propagation_of(network, defects)),
        last_id_of_arc_(network.arcs.size(), 0),
        heard_(network.agents.size()) {}

  Ticks earliest(NodeIndex node) const override { return core_.date(node, Bound::kLower); }
  Ticks latest(NodeIndex node) const override { return core_.date(node, Bound::kUpper); }
  std::optional<MissionTime> blocked_since() const override { return std::nullopt; }
  std::uint64_t checks() const override { return core_.checks(); }

 private:
  Output do_start(MissionTime /*now*/) override { return propagate(); }

  Result<Output, AgentRefusal> do_disturbance(std::span<const ArcUpdate> changes,
                                              MissionTime /*now*/) override {
    if (const auto refusal = rights_.check(changes, index())) return tl::unexpected(*refusal);
    changed_.note(changes);
    for (const ArcUpdate& change : changes) apply(change);
    Output output = propagate();
    if (agents() > 1 && !changes.empty()) {
      output.messages.push_back(
          make_message(std::nullopt, ArcUpdates{{changes.begin(), changes.end()}}));
    }
    return output;
  }

  Result<Output, AgentRefusal> do_message(const Message& message, MissionTime now) override {
    const auto* updates = std::get_if<ArcUpdates>(&message.content);
    if (updates == nullptr) return refuse(AgentError::kUnexpected, message.sender);
    if (const auto refusal = rights_.check(updates->arcs, message.sender)) {
      return tl::unexpected(*refusal);
    }
    heard_[message.sender] = now;
    for (const ArcUpdate& update : updates->arcs) {
      if (message.id < last_id_of_arc_[update.arc]) continue;
      last_id_of_arc_[update.arc] = message.id;
      apply(update);
    }
    return propagate();
  }

  Output do_link(AgentIndex peer, bool up, MissionTime /*now*/) override {
    Output output;
    if (up && !changed_.samples().empty()) {
      output.messages.push_back(make_message(peer, ArcUpdates{changed_.samples()}));
    }
    return output;
  }

  std::optional<bool> consistent() const override { return core_.consistent(); }

  std::vector<LastWord> words() const override {
    std::vector<LastWord> words;
    for (const auto& heard : heard_) words.push_back({std::nullopt, heard});
    words[index()].consistent = core_.consistent();
    return words;
  }

  void apply(const ArcUpdate& update) { core_.set_bounds({update.arc, update.min, update.max}); }

  Output propagate() {
    core_.relax();
    core_.forget_resets();
    core_.propagate();
    Output output;
    core_.take_changes(output.changed);
    std::erase_if(output.changed,
                  [this](const BoundChange& change) { return owner_[change.node] != index(); });
    return output;
  }

  std::vector<AgentIndex> owner_;
  ArcRights rights_;
  Propagation core_;
  std::vector<std::uint64_t> last_id_of_arc_;
  std::vector<std::optional<MissionTime>> heard_;
  ChangedArcs changed_;
};

}  // namespace

std::unique_ptr<Agent> make_dip_g(const Mastn& network, AgentIndex self, const Defects& defects) {
  return std::make_unique<DipG>(network, self, defects);
}

}  // namespace skein::temporal
