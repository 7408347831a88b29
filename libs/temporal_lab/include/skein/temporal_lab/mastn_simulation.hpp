// SPDX-License-Identifier: Apache-2.0
// The agents of a network over a simulated transport: in order or not, with delays, cuts and heals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/temporal/agent.hpp"

namespace skein::temporal {

/// What was sent. One call of send counts 1, to one agent or to all. Source: section 3 of the
/// notes.
struct Traffic {
  std::uint64_t disturbances = 0;  ///< sends of ArcUpdates
  std::uint64_t node_updates = 0;  ///< CIP, to slaves: nodes with new dates
  std::uint64_t updates = 0;       ///< DIP-L: UPDATE
  std::uint64_t relaxations = 0;   ///< DIP-L: RELAX and RELAXED
  std::uint64_t macro_packs = 0;   ///< DIP-M: sends of MacroUpdates
  std::uint64_t macro_arcs = 0;    ///< DIP-M: macro-arcs in them
  std::uint64_t macro_bounds = 0;  ///< DIP-M: oriented macro-constraints in them
  std::uint64_t consistency = 0;   ///< CONSISTENCY
  std::uint64_t hellos = 0;        ///< DIP-L: openings of sessions
  std::uint64_t lost = 0;          ///< copies that a cut took away

  /// Data messages as the paper counts them: one for each arc, node or macro-bound; not
  /// CONSISTENCY.
  std::uint64_t data() const {
    return disturbances + node_updates + updates + relaxations + macro_bounds;
  }
  bool operator==(const Traffic&) const = default;
};
Traffic operator-(const Traffic& after, const Traffic& before);

struct TransportOptions {
  Ticks longest_delay = 0;  ///< a message takes a uniform time in [0, longest_delay] [ns]
  bool in_order = true;     ///< between two agents, each way
  /// Of messages out of order: gives their ids in order all the same, so that receivers do not see
  /// it from the ids.
  bool renumbers = false;
  std::uint64_t seed = 1;
};

/// Makes agent `index`; that of `agents.size()` is the supervisor of CIP.
using AgentMaker = std::function<Result<std::unique_ptr<Agent>, AgentRefusal>(
    Algorithm, const Mastn&, AgentIndex index)>;
/// make_agent and make_supervisor without options.
Result<std::unique_ptr<Agent>, AgentRefusal> usual_agent(Algorithm algorithm, const Mastn& network,
                                                         AgentIndex index);

/// All agents of one algorithm and the messages under way. Sans-IO and deterministic: one seed, one
/// run. While a link is cut, what is under way or sent on it is lost, and both ends are told at the
/// instants of the cut and of the return. Thread rule: not safe to share.
class MastnSimulation {
 public:
  /// Agents are made and started at instant 0; their first messages are under way.
  static Result<MastnSimulation, AgentRefusal> make(Algorithm algorithm, const Mastn& network,
                                                    const TransportOptions& options = {},
                                                    const AgentMaker& maker = usual_agent);

  /// New bounds of arcs, one perturbation for each owner among them, in the order of agents. What
  /// an agent refuses is returned; the agents after it are then not told.
  std::optional<AgentRefusal> disturb(std::span<const ArcUpdate> changes);

  /// Delivers what arrives until `end`, at most `most` messages, then lets time be `end`.
  /// Whether all that was due is delivered and accepted.
  bool run_until(MissionTime end, std::size_t most);
  /// Delivers until nothing is under way, at most `most` messages. Whether that was reached, no
  /// message having been refused.
  bool settle(std::size_t most);

  /// The end of a link that is not between two processes of the algorithm is no link: CIP has links
  /// between slaves and supervisor only.
  std::vector<std::pair<AgentIndex, AgentIndex>> links() const;
  void cut(AgentIndex one, AgentIndex other);
  void heal(AgentIndex one, AgentIndex other);
  void heal_all();

  MissionTime now() const { return now_; }
  bool is_quiet() const { return under_way_.empty(); }
  /// From the owner of the node.
  Ticks earliest(NodeIndex node) const;
  Ticks latest(NodeIndex node) const;
  /// What the agents say, if they all say the same; the supervisor too.
  std::optional<bool> consistent() const;
  /// What one agent says. Precondition: it exists.
  std::optional<bool> consistent(AgentIndex agent) const;
  std::size_t blocked_agents() const;
  const Traffic& traffic() const { return traffic_; }
  /// Of all agents, the supervisor included.
  std::uint64_t checks() const;
  std::uint64_t elimination_checks() const;
  /// The first message that an agent refused, if any: a defect.
  const std::optional<AgentRefusal>& refusal() const { return refusal_; }

 private:
  using Link = std::pair<AgentIndex, AgentIndex>;  // lesser first when it has no direction
  struct Copy {
    AgentIndex receiver;
    std::shared_ptr<const Message> message;  // shared by the receivers of a send to all
  };

  MastnSimulation(Algorithm algorithm, const Mastn& network, const TransportOptions& options);
  void take(const Output& output);
  void send(const Message& message);
  void send_to(AgentIndex receiver, const std::shared_ptr<const Message>& message);
  void deliver_next();
  Message take_message(const Copy& copy);
  void tell(AgentIndex agent, AgentIndex peer, bool up);

  Algorithm algorithm_;
  std::vector<AgentIndex> node_owner_;
  std::vector<AgentIndex> arc_owner_;
  TransportOptions options_;
  Random random_;
  std::vector<std::unique_ptr<Agent>> agents_;
  MissionTime now_;
  std::map<std::pair<MissionTime, std::uint64_t>, Copy> under_way_;  // by arrival, then as sent
  std::uint64_t sent_ = 0;
  std::map<Link, MissionTime> last_arrival_;       // by sender and receiver
  std::map<Link, std::deque<std::uint64_t>> ids_;  // under way, as sent; if renumbered
  std::set<Link> down_;
  Traffic traffic_;
  std::optional<AgentRefusal> refusal_;
};

}  // namespace skein::temporal
