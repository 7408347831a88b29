// SPDX-License-Identifier: Apache-2.0
// What every agent checks and reports; validation of a network; the factory.
#include "skein/temporal/agent.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "agents.hpp"

namespace skein::temporal {

std::string to_text(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::kCip:
      return "cip";
    case Algorithm::kDipG:
      return "dip-g";
    case Algorithm::kDipL:
      return "dip-l";
    case Algorithm::kDipM:
      return "dip-m";
  }
  return "unknown";
}

std::string to_text(AgentError error) {
  switch (error) {
    case AgentError::kUnknownAgent:
      return "unknown agent";
    case AgentError::kUnknownNode:
      return "unknown node";
    case AgentError::kUnknownArc:
      return "unknown arc";
    case AgentError::kUnknownJob:
      return "unknown job";
    case AgentError::kUnknownOwner:
      return "unknown owner";
    case AgentError::kCyclicOwnership:
      return "cyclic ownership";
    case AgentError::kArcGivenTwice:
      return "arc given twice";
    case AgentError::kArcToItself:
      return "arc from a node to itself";
    case AgentError::kEmptyInterval:
      return "empty interval";
    case AgentError::kOverflow:
      return "time out of range";
    case AgentError::kExternalArc:
      return "external arc";
    case AgentError::kNotOwner:
      return "not the owner";
    case AgentError::kSeenId:
      return "id already seen";
    case AgentError::kUnexpected:
      return "unexpected content";
    case AgentError::kWrongReceiver:
      return "wrong receiver";
    case AgentError::kWeakerUpdate:
      return "weaker update";
  }
  return "unknown error";
}

Message Agent::make_message(std::optional<AgentIndex> receiver, Content content) {
  Message message;
  message.sender = self_;
  message.receiver = receiver;
  message.id = ++last_id_;
  message.content = std::move(content);
  return message;
}

Output Agent::start(MissionTime now) { return finish(do_start(now)); }

Result<Output, AgentRefusal> Agent::on_disturbance(std::span<const ArcUpdate> changes,
                                                   MissionTime now) {
  auto output = do_disturbance(changes, now);
  if (!output) return output;
  return finish(*std::move(output));
}

Result<Output, AgentRefusal> Agent::on_message(const Message& message, MissionTime now) {
  if (const auto refusal = check(message)) return tl::unexpected(*refusal);
  auto output = do_message(message, now);
  if (!output) return output;
  seen_[message.sender].insert(message.id);
  return finish(*std::move(output));
}

Result<Output, AgentRefusal> Agent::on_link(AgentIndex peer, bool up, MissionTime now) {
  if (!knows_peer(peer)) return refuse(AgentError::kUnknownAgent, peer);
  return finish(do_link(peer, up, now));
}

std::optional<AgentRefusal> Agent::check(const Message& message) const {
  if (!knows_peer(message.sender)) return AgentRefusal{AgentError::kUnknownAgent, message.sender};
  if (message.receiver && *message.receiver != self_) {
    return AgentRefusal{AgentError::kWrongReceiver, *message.receiver};
  }
  const SeenIds& seen = seen_[message.sender];
  const bool old = fifo_ ? message.id <= seen.last() : seen.contains(message.id);
  if (old || message.id == 0) return AgentRefusal{AgentError::kSeenId, message.sender};
  return std::nullopt;
}

Verdict Agent::verdict() const { return {consistent(), words()}; }

Output Agent::finish(Output output) const {
  output.consistent = consistent();
  output.blocked_since = blocked_since();
  return output;
}

AgentIndex owner_of(const Mastn& network, const Arc& arc) {
  return network.owner[arc.from == 0 ? arc.to : arc.from];
}

bool is_external(const Mastn& network, const Arc& arc) {
  return arc.from != 0 && arc.to != 0 && network.owner[arc.from] != network.owner[arc.to];
}

std::optional<AgentError> check_bounds(Ticks min, Ticks max) {
  const auto error = check_interval(min, max);
  if (!error) return std::nullopt;
  return *error == StnError::kOverflow ? AgentError::kOverflow : AgentError::kEmptyInterval;
}

namespace {

std::optional<AgentError> wrong_arc(const Mastn& network, const Arc& arc) {
  if (arc.from >= network.nodes.size() || arc.to >= network.nodes.size()) {
    return AgentError::kUnknownNode;
  }
  if (arc.from == arc.to) return AgentError::kArcToItself;
  return check_bounds(arc.min, arc.max);
}

Result<Ticks, AgentRefusal> slack_of(const Mastn& network, const Arc& arc,
                                     const AgentOptions& options) {
  Ticks slack = 0;
  for (const NodeIndex node : {arc.from, arc.to}) {
    const AgentIndex agent = network.owner[node];
    const Ticks error = options.clock_error[agent];
    if (error < 0 || error > kLargest / 2) return refuse(AgentError::kOverflow, agent);
    slack += error;
  }
  return slack;
}

Result<Mastn, AgentRefusal> widened(Mastn network, const AgentOptions& options) {
  if (options.clock_error.empty()) return network;
  if (options.clock_error.size() != network.agents.size()) {
    return refuse(AgentError::kUnknownAgent, static_cast<AgentIndex>(options.clock_error.size()));
  }
  for (std::size_t i = 0; i < network.arcs.size(); ++i) {
    Arc& arc = network.arcs[i];
    if (!is_external(network, arc)) continue;
    const auto slack = slack_of(network, arc, options);
    if (!slack) return tl::unexpected(slack.error());
    if (arc.min != kMinusInfinite) arc.min -= *slack;
    if (arc.max != kInfinite) arc.max += *slack;
    const auto error = check_bounds(arc.min, arc.max);
    if (error) return refuse(*error, static_cast<std::uint32_t>(i));
  }
  return network;
}

Result<Mastn, AgentRefusal> accepted(const Mastn& network, const AgentOptions& options) {
  if (const auto refusal = validate(network)) return tl::unexpected(*refusal);
  return widened(network, options);
}

}  // namespace

std::optional<AgentRefusal> validate(const Mastn& network) {
  if (network.nodes.empty() || network.owner.size() != network.nodes.size()) {
    return AgentRefusal{AgentError::kUnknownOwner, 0};
  }
  for (NodeIndex node = 1; node < network.nodes.size(); ++node) {
    if (network.owner[node] >= network.agents.size()) {
      return AgentRefusal{AgentError::kUnknownOwner, node};
    }
  }
  std::set<std::pair<NodeIndex, NodeIndex>> given;
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    if (const auto error = wrong_arc(network, arc)) return AgentRefusal{*error, i};
    if (!given.emplace(arc.from, arc.to).second) {
      return AgentRefusal{AgentError::kArcGivenTwice, i};
    }
  }
  return std::nullopt;
}

Result<std::unique_ptr<Agent>, AgentRefusal> make_agent_with(const Defects& defects,
                                                             Algorithm algorithm,
                                                             const Mastn& network, AgentIndex index,
                                                             const AgentOptions& options) {
  const auto ready = accepted(network, options);
  if (!ready) return tl::unexpected(ready.error());
  if (index >= network.agents.size()) return refuse(AgentError::kUnknownAgent, index);
  switch (algorithm) {
    case Algorithm::kCip:
      return make_cip_slave(*ready, index);
    case Algorithm::kDipG:
      return make_dip_g(*ready, index, defects);
    case Algorithm::kDipL:
      return make_dip_l(*ready, index, defects);
    case Algorithm::kDipM:
      return make_dip_m(*ready, index, defects);
  }
  return refuse(AgentError::kUnexpected, index);
}

Result<std::unique_ptr<Agent>, AgentRefusal> make_supervisor_with(const Defects& defects,
                                                                  const Mastn& network,
                                                                  const AgentOptions& options) {
  const auto ready = accepted(network, options);
  if (!ready) return tl::unexpected(ready.error());
  return make_cip_supervisor(*ready, defects);
}

Result<std::unique_ptr<Agent>, AgentRefusal> make_agent(Algorithm algorithm, const Mastn& network,
                                                        AgentIndex index,
                                                        const AgentOptions& options) {
  return make_agent_with({}, algorithm, network, index, options);
}

Result<std::unique_ptr<Agent>, AgentRefusal> make_supervisor(const Mastn& network,
                                                             const AgentOptions& options) {
  return make_supervisor_with({}, network, options);
}

}  // namespace skein::temporal
