// SPDX-License-Identifier: Apache-2.0
// The agents that maintain a multi-agent temporal network together: CIP, DIP-G, DIP-L, DIP-M.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"
#include "skein/temporal/algorithm.hpp"
#include "skein/temporal/message.hpp"
#include "skein/temporal/network.hpp"
#include "skein/temporal/seen_ids.hpp"

namespace skein::temporal {

enum class AgentError : std::uint8_t {
  kUnknownAgent,  ///< no such agent, or the receiver itself
  kUnknownNode,
  kUnknownArc,
  kUnknownJob,       ///< RELAXED for a job that never was or is over
  kUnknownOwner,     ///< a node of an agent that does not exist
  kCyclicOwnership,  ///< a bound said to come from itself: a trail that passes a node twice
  kArcGivenTwice,
  kArcToItself,
  kEmptyInterval,  ///< min > max, min = +∞ or max = -∞
  kOverflow,       ///< beyond ±kLargest
  kExternalArc,    ///< external arcs are static in a mission. Source: M 3.1
  kNotOwner,       ///< an arc or a node of someone else
  kSeenId,         ///< a message with this id was handled already
  kUnexpected,     ///< a content this algorithm does not use, or between these two
  kWrongReceiver,
  kWeakerUpdate,  ///< DIP-L: an UPDATE weaker than the one before without a RELAX between
};
std::string to_text(AgentError error);

/// Why an input was refused; the agent is then as it was before.
struct AgentRefusal {
  AgentError error = AgentError::kUnknownAgent;
  std::uint32_t where = 0;  ///< the agent, node or arc concerned, or the position in the input
  bool operator==(const AgentRefusal&) const = default;
};

/// The last consistency status of an agent's own part.
struct LastWord {
  std::optional<bool> consistent;    ///< absent: nothing said, or overtaken by a later disturbance
  std::optional<MissionTime> heard;  ///< when; absent: never. Its age is now minus this.
  bool operator==(const LastWord&) const = default;
};

/// Provisional until the transport knows that no message is in flight (notes 5.1.9).
struct Verdict {
  std::optional<bool> consistent;  ///< of the whole network, as far as known; absent: unknown
  std::vector<LastWord> words;     ///< of each agent, itself included
  bool operator==(const Verdict&) const = default;
};

struct Output {
  std::vector<Message> messages;             ///< to send, in this order
  std::vector<BoundChange> changed;          ///< of own nodes
  std::optional<bool> consistent;            ///< as `Verdict::consistent`, after the call
  std::optional<MissionTime> blocked_since;  ///< as `Agent::blocked_since`, after the call
};

/// One agent of a MaSTN, sans-IO: takes disturbances, messages and link changes, returns messages.
///
/// Laws. Once every message is delivered, for the network as disturbed: all verdicts say whether it
/// is consistent and, if so, each agent's dates of its own nodes are the earliest and the latest.
/// A refused input changes nothing. The transport delivers in order between two agents (CIP, DIP-L)
/// or in any order (DIP-G, DIP-M); it loses messages only between `on_link(down)` and
/// `on_link(up)`, and tells both ends of a link. While a link is down DIP-G and DIP-M go on with
/// what they know; CIP slaves and DIP-L may be blocked. Thread rule: not safe to share. Source: M
/// 3; spec 5.3.
class Agent {
 public:
  virtual ~Agent() = default;
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  /// Propagates the initial network. Must be called first, once.
  Output start(MissionTime now);
  /// New bounds of own local arcs, as one perturbation.
  Result<Output, AgentRefusal> on_disturbance(std::span<const ArcUpdate> changes, MissionTime now);
  Result<Output, AgentRefusal> on_message(const Message& message, MissionTime now);
  /// The link with a peer went down or came back.
  Result<Output, AgentRefusal> on_link(AgentIndex peer, bool up, MissionTime now);

  /// Dates of a node, -∞ and +∞ if unbounded. Precondition: the agent owns `node` (for the
  /// supervisor: any).
  virtual Ticks earliest(NodeIndex node) const = 0;
  virtual Ticks latest(NodeIndex node) const = 0;
  Verdict verdict() const;
  /// Instant since which the agent is blocked waiting for others; absent: not blocked.
  virtual std::optional<MissionTime> blocked_since() const = 0;
  /// Evaluations of one difference constraint in one bound system; with DIP-M also one for each
  /// combination of an elimination. Since construction.
  virtual std::uint64_t checks() const = 0;
  /// Of those, the combinations of eliminations (DIP-M; else 0).
  virtual std::uint64_t elimination_checks() const { return 0; }
  AgentIndex index() const { return self_; }

 protected:
  /// `fifo`: an id below the last one of its sender was seen. `agents`: how many there are, the
  /// supervisor not among them.
  Agent(AgentIndex self, AgentIndex agents, bool fifo)
      : self_(self), agents_(agents), fifo_(fifo), seen_(agents + 1) {}
  AgentIndex agents() const { return agents_; }
  /// A message of this agent with the next id.
  Message make_message(std::optional<AgentIndex> receiver, Content content);

 private:
  virtual Output do_start(MissionTime now) = 0;
  virtual Result<Output, AgentRefusal> do_disturbance(std::span<const ArcUpdate> changes,
                                                      MissionTime now) = 0;
  virtual Result<Output, AgentRefusal> do_message(const Message& message, MissionTime now) = 0;
  virtual Output do_link(AgentIndex peer, bool up, MissionTime now) = 0;
  /// Whether the two may write to each other.
  virtual bool knows_peer(AgentIndex peer) const { return peer < agents_ && peer != self_; }
  virtual std::optional<bool> consistent() const = 0;
  virtual std::vector<LastWord> words() const = 0;
  std::optional<AgentRefusal> check(const Message& message) const;
  Output finish(Output output) const;

  AgentIndex self_;
  AgentIndex agents_;
  bool fifo_;
  std::vector<SeenIds> seen_;  ///< of each sender, the supervisor last
  std::uint64_t last_id_ = 0;
};

struct AgentOptions {
  /// Clock error of each agent, at most, >= 0 [ns]: an external arc is widened on both sides by the
  /// sum of its two agents'. Empty: none. To be the same for all agents. Source: spec 5.3.
  std::vector<Ticks> clock_error;
};

/// What is wrong with a network, if anything: unknown nodes or owners, arcs given twice, empty
/// intervals, overflow.
std::optional<AgentRefusal> validate(const Mastn& network);
/// The owner of an arc: see `Mastn`. Precondition: the network is valid.
AgentIndex owner_of(const Mastn& network, const Arc& arc);
bool is_external(const Mastn& network, const Arc& arc);

/// An agent; of `network` it keeps what its algorithm lets it know. `kUnknownAgent` for an index
/// that is not an agent's; else as `validate`.
Result<std::unique_ptr<Agent>, AgentRefusal> make_agent(Algorithm algorithm, const Mastn& network,
                                                        AgentIndex index,
                                                        const AgentOptions& options = {});
/// The supervisor of CIP, which is not one of the agents: its index is `network.agents.size()`.
Result<std::unique_ptr<Agent>, AgentRefusal> make_supervisor(const Mastn& network,
                                                             const AgentOptions& options = {});

}  // namespace skein::temporal
