// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_lab/mastn_simulation.hpp"

#include <algorithm>

#include "skein/foundation/overloaded.hpp"

namespace skein::temporal {

namespace {

std::uint64_t count_nodes(const NodeUpdates& updates) {
  std::set<NodeIndex> nodes;
  for (const BoundChange& change : updates.bounds) nodes.insert(change.node);
  return nodes.size();
}

std::uint64_t count_arcs(const MacroUpdates& updates) {
  std::set<std::pair<NodeIndex, NodeIndex>> arcs;
  for (const MacroConstraint& one : updates.constraints) {
    arcs.insert(std::minmax(one.from, one.to));
  }
  return arcs.size();
}

void count(Traffic& traffic, const Content& content) {
  std::visit(
      Overloaded{[&](const ArcUpdates&) { ++traffic.disturbances; },
                 [&](const NodeUpdates& updates) { traffic.node_updates += count_nodes(updates); },
                 [&](const Update&) { ++traffic.updates; },
                 [&](const Relax&) { ++traffic.relaxations; },
                 [&](const Relaxed&) { ++traffic.relaxations; },
                 [&](const Consistency&) { ++traffic.consistency; },
                 [&](const MacroUpdates& updates) {
                   ++traffic.macro_packs;
                   traffic.macro_arcs += count_arcs(updates);
                   traffic.macro_bounds += updates.constraints.size();
                 },
                 [&](const Hello&) { ++traffic.hellos; }},
      content);
}

}  // namespace

Traffic operator-(const Traffic& after, const Traffic& before) {
  Traffic between;
  between.disturbances = after.disturbances - before.disturbances;
  between.node_updates = after.node_updates - before.node_updates;
  between.updates = after.updates - before.updates;
  between.relaxations = after.relaxations - before.relaxations;
  between.macro_packs = after.macro_packs - before.macro_packs;
  between.macro_arcs = after.macro_arcs - before.macro_arcs;
  between.macro_bounds = after.macro_bounds - before.macro_bounds;
  between.consistency = after.consistency - before.consistency;
  between.hellos = after.hellos - before.hellos;
  between.lost = after.lost - before.lost;
  return between;
}

Result<std::unique_ptr<Agent>, AgentRefusal> usual_agent(Algorithm algorithm, const Mastn& network,
                                                         AgentIndex index) {
  return index == network.agents.size() && algorithm == Algorithm::kCip
             ? make_supervisor(network)
             : make_agent(algorithm, network, index);
}

MastnSimulation::MastnSimulation(Algorithm algorithm, const Mastn& network,
                                 const TransportOptions& options)
    : algorithm_(algorithm),
      node_owner_(network.owner),
      options_(options),
      random_(options.seed, "mastn/transport") {}

Result<MastnSimulation, AgentRefusal> MastnSimulation::make(Algorithm algorithm,
                                                            const Mastn& network,
                                                            const TransportOptions& options,
                                                            const AgentMaker& maker) {
  if (const std::optional<AgentRefusal> wrong = validate(network)) {
    return tl::unexpected<AgentRefusal>(*wrong);
  }
  MastnSimulation simulation(algorithm, network, options);
  for (const Arc& arc : network.arcs) simulation.arc_owner_.push_back(owner_of(network, arc));
  const std::size_t processes = network.agents.size() + (algorithm == Algorithm::kCip ? 1 : 0);
  for (AgentIndex index = 0; index < processes; ++index) {
    Result<std::unique_ptr<Agent>, AgentRefusal> agent = maker(algorithm, network, index);
    if (!agent) return tl::unexpected<AgentRefusal>(agent.error());
    simulation.agents_.push_back(std::move(*agent));
  }
  for (const std::unique_ptr<Agent>& agent : simulation.agents_) {
    simulation.take(agent->start(simulation.now_));
  }
  return simulation;
}

std::optional<AgentRefusal> MastnSimulation::disturb(std::span<const ArcUpdate> changes) {
  std::map<AgentIndex, std::vector<ArcUpdate>> by_owner;
  for (const ArcUpdate& change : changes) {
    if (change.arc >= arc_owner_.size()) return AgentRefusal{AgentError::kUnknownArc, change.arc};
    by_owner[arc_owner_[change.arc]].push_back(change);
  }
  for (const auto& [owner, own] : by_owner) {
    const Result<Output, AgentRefusal> output = agents_[owner]->on_disturbance(own, now_);
    if (!output) return output.error();
    take(*output);
  }
  return std::nullopt;
}

void MastnSimulation::take(const Output& output) {
  for (const Message& message : output.messages) send(message);
}

void MastnSimulation::send(const Message& message) {
  count(traffic_, message.content);
  const auto shared = std::make_shared<const Message>(message);
  if (message.receiver) return send_to(*message.receiver, shared);
  for (AgentIndex agent = 0; agent < agents_.size(); ++agent) {
    if (agent != message.sender) send_to(agent, shared);
  }
}

void MastnSimulation::send_to(AgentIndex receiver, const std::shared_ptr<const Message>& message) {
  if (down_.contains(std::minmax(message->sender, receiver))) {
    ++traffic_.lost;
    return;
  }
  const auto longest = static_cast<std::uint64_t>(options_.longest_delay);
  const auto delay = static_cast<Ticks>(random_.below(longest + 1));
  MissionTime arrival = now_ + Duration::nanoseconds(delay);
  if (options_.in_order) {
    MissionTime& last = last_arrival_[{message->sender, receiver}];
    arrival = last = std::max(last, arrival);
  }
  if (options_.renumbers) ids_[{message->sender, receiver}].push_back(message->id);
  under_way_.emplace(std::pair(arrival, sent_++), Copy{receiver, message});
}

Message MastnSimulation::take_message(const Copy& copy) {
  Message message = *copy.message;
  if (options_.renumbers) {
    std::deque<std::uint64_t>& ids = ids_[{message.sender, copy.receiver}];
    message.id = ids.front();
    ids.pop_front();
  }
  return message;
}

void MastnSimulation::deliver_next() {
  const auto first = under_way_.begin();
  const Copy copy = first->second;
  now_ = std::max(now_, first->first.first);
  under_way_.erase(first);
  const Result<Output, AgentRefusal> output =
      agents_[copy.receiver]->on_message(take_message(copy), now_);
  if (output) return take(*output);
  if (!refusal_) refusal_ = output.error();
}

bool MastnSimulation::run_until(MissionTime end, std::size_t most) {
  for (; !under_way_.empty() && under_way_.begin()->first.first <= end; --most) {
    if (most == 0) return false;
    deliver_next();
    if (refusal_) return false;
  }
  now_ = std::max(now_, end);
  return true;
}

bool MastnSimulation::settle(std::size_t most) {
  for (; !under_way_.empty(); --most) {
    if (most == 0) return false;
    deliver_next();
    if (refusal_) return false;
  }
  return !refusal_;
}

std::vector<std::pair<AgentIndex, AgentIndex>> MastnSimulation::links() const {
  std::vector<Link> links;
  const auto count = static_cast<AgentIndex>(agents_.size());
  const bool star = algorithm_ == Algorithm::kCip;
  for (AgentIndex one = 0; one < count; ++one) {
    for (AgentIndex other = star ? count - 1 : one + 1; other < count; ++other) {
      if (one < other) links.emplace_back(one, other);
    }
  }
  return links;
}

void MastnSimulation::cut(AgentIndex one, AgentIndex other) {
  const Link link = std::minmax(one, other);
  if (!down_.insert(link).second) return;
  traffic_.lost += std::erase_if(under_way_, [link](const auto& entry) {
    const Copy& copy = entry.second;
    return Link(std::minmax(copy.message->sender, copy.receiver)) == link;
  });
  ids_.erase({one, other});
  ids_.erase({other, one});
  tell(one, other, false);
  tell(other, one, false);
}

void MastnSimulation::heal(AgentIndex one, AgentIndex other) {
  if (down_.erase(std::minmax(one, other)) == 0) return;
  tell(one, other, true);
  tell(other, one, true);
}

void MastnSimulation::heal_all() {
  const std::set<Link> down = down_;
  for (const auto& [one, other] : down) heal(one, other);
}

void MastnSimulation::tell(AgentIndex agent, AgentIndex peer, bool up) {
  const Result<Output, AgentRefusal> output = agents_[agent]->on_link(peer, up, now_);
  if (output) return take(*output);
  if (!refusal_) refusal_ = output.error();
}

Ticks MastnSimulation::earliest(NodeIndex node) const {
  return node == 0 ? 0 : agents_[node_owner_[node]]->earliest(node);
}

Ticks MastnSimulation::latest(NodeIndex node) const {
  return node == 0 ? 0 : agents_[node_owner_[node]]->latest(node);
}

std::optional<bool> MastnSimulation::consistent() const {
  if (agents_.empty()) return true;  // v0 alone
  std::optional<bool> common;
  for (const std::unique_ptr<Agent>& agent : agents_) {
    const std::optional<bool> own = agent->verdict().consistent;
    if (!own || (common && common != own)) return std::nullopt;
    common = own;
  }
  return common;
}

std::optional<bool> MastnSimulation::consistent(AgentIndex agent) const {
  return agents_[agent]->verdict().consistent;
}

std::size_t MastnSimulation::blocked_agents() const {
  return static_cast<std::size_t>(
      std::count_if(agents_.begin(), agents_.end(),
                    [](const auto& agent) { return agent->blocked_since().has_value(); }));
}

std::uint64_t MastnSimulation::checks() const {
  std::uint64_t sum = 0;
  for (const std::unique_ptr<Agent>& agent : agents_) sum += agent->checks();
  return sum;
}

std::uint64_t MastnSimulation::elimination_checks() const {
  std::uint64_t sum = 0;
  for (const std::unique_ptr<Agent>& agent : agents_) sum += agent->elimination_checks();
  return sum;
}

}  // namespace skein::temporal
