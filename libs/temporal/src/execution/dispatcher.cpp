// SPDX-License-Identifier: Apache-2.0
// The executor: dates already known narrow the windows of neighbours, and nothing else is looked
// at.
#include "skein/temporal/dispatcher.hpp"

#include <algorithm>
#include <limits>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

namespace {

constexpr std::uint32_t kNoLink = std::numeric_limits<std::uint32_t>::max();

Ticks later(Ticks at, Ticks by) { return skein::detail::saturating_add(at, by); }

/// Positions at which the items of each key begin, for items ordered by key.
template <class Items, class KeyOf>
std::vector<std::uint32_t> begins(const Items& items, std::size_t keys, KeyOf key_of) {
  std::vector<std::uint32_t> begin(keys + 1, 0);
  for (const auto& item : items) ++begin[key_of(item) + 1];
  for (std::size_t key = 0; key < keys; ++key) begin[key + 1] += begin[key];
  return begin;
}

}  // namespace

Dispatcher::Dispatcher(const DispatchableNetwork& network, MissionTime origin_at)
    : origin_at_(origin_at), nodes_(network.plan.nodes.size()), remaining_(nodes_.size()) {
  SKEIN_EXPECTS(network.plan.origin < nodes_.size());
  index_links(network);
  index_edges(network);
  index_waits(network);
  record(network.plan.origin, 0);
}

void Dispatcher::index_links(const DispatchableNetwork& network) {
  links_ = network.plan.contingent;
  overdue_.assign(links_.size(), false);
  for (NodeState& node : nodes_) node.ended_link = kNoLink;
  for (std::uint32_t link = 0; link < links_.size(); ++link) {
    if (links_[link].min < links_[link].max) nodes_[links_[link].contingent].ended_link = link;
  }
}

void Dispatcher::index_edges(const DispatchableNetwork& network) {
  const std::vector<DistanceEdge>& edges = network.edges;
  out_begin_ = begins(edges, nodes_.size(), [](const DistanceEdge& edge) { return edge.from; });
  in_begin_ = begins(edges, nodes_.size(), [](const DistanceEdge& edge) { return edge.to; });
  out_.resize(edges.size());
  in_.resize(edges.size());
  std::vector<std::uint32_t> next_out = out_begin_;
  std::vector<std::uint32_t> next_in = in_begin_;
  for (const DistanceEdge& edge : edges) {
    out_[next_out[edge.from]++] = {edge.to, edge.weight};
    in_[next_in[edge.to]++] = {edge.from, edge.weight};
    if (edge.weight < 0) ++nodes_[edge.from].blockers;
  }
}

void Dispatcher::index_waits(const DispatchableNetwork& network) {
  wait_begin_ =
      begins(network.waits, nodes_.size(), [](const WaitEdge& wait) { return wait.node; });
  waits_.resize(network.waits.size());
  waiting_for_.resize(nodes_.size());
  std::vector<std::uint32_t> next = wait_begin_;
  for (const WaitEdge& wait : network.waits) {
    waits_[next[wait.node]++] = {wait.node, wait.link, wait.delay};
    waiting_for_[links_[wait.link].activation].push_back(wait.node);
    ++nodes_[wait.node].blockers;
  }
}

std::vector<DispatchEffect> Dispatcher::handle(const DispatchInput& input, MissionTime now) {
  std::vector<DispatchEffect> out;
  const Ticks ticks = (now - origin_at_).count();
  if (ticks < now_) {
    const auto* executed = std::get_if<Executed>(&input);
    const auto* observed = std::get_if<Observed>(&input);
    const NodeIndex node = executed != nullptr   ? executed->node
                           : observed != nullptr ? observed->node
                                                 : 0;
    out.emplace_back(Refused{node, Refused::Why::kTimeWentBack});
    return out;
  }
  now_ = ticks;
  std::visit([&](const auto& event) { take(event, out); }, input);
  find_overdue(out);
  find_missed(out);
  offer(out);
  if (remaining_ == 0 && !told_complete_) {
    told_complete_ = true;
    out.emplace_back(Completed{});
  }
  return out;
}

void Dispatcher::take(const TimePassed& /*input*/, std::vector<DispatchEffect>& /*out*/) {}

void Dispatcher::take(const Executed& input, std::vector<DispatchEffect>& out) {
  find_overdue(out);
  find_missed(out);
  if (const auto why = refusal(input)) {
    out.emplace_back(Refused{input.node, *why});
    return;
  }
  record(input.node, now_);
}

void Dispatcher::take(const Observed& input, std::vector<DispatchEffect>& out) {
  if (const auto why = refusal(input)) {
    out.emplace_back(Refused{input.node, *why});
    return;
  }
  check_observed(nodes_[input.node], out);
  record(input.node, now_);
}

std::optional<Refused::Why> Dispatcher::refusal(const Executed& input) const {
  using Why = Refused::Why;
  if (input.node >= nodes_.size()) return Why::kUnknownNode;
  if (!controlled(nodes_[input.node])) return Why::kNotControlled;
  if (nodes_[input.node].done) return Why::kAlreadyDone;
  if (stopped_) return Why::kStopped;
  if (!enabled(input.node)) return Why::kNotEnabled;
  if (earliest(input.node) > now_) return Why::kTooEarly;
  return std::nullopt;
}

std::optional<Refused::Why> Dispatcher::refusal(const Observed& input) const {
  using Why = Refused::Why;
  if (input.node >= nodes_.size()) return Why::kUnknownNode;
  if (controlled(nodes_[input.node])) return Why::kNotContingent;
  if (nodes_[input.node].done) return Why::kAlreadyDone;
  return std::nullopt;
}

void Dispatcher::check_observed(const NodeState& end, std::vector<DispatchEffect>& out) {
  using Kind = Contingency::Kind;
  const ContingentLink& link = links_[end.ended_link];
  const NodeState& activation = nodes_[link.activation];
  const Ticks elapsed = activation.done ? now_ - activation.date : 0;
  if (activation.done && elapsed >= link.min && elapsed <= link.max) return;
  const Kind kind = !activation.done     ? Kind::kUnasked
                    : elapsed < link.min ? Kind::kEarly
                                         : Kind::kLate;
  stopped_ = true;
  out.emplace_back(Contingency{end.ended_link, kind, Duration::nanoseconds(elapsed)});
}

// After Y - X <= w with X at t, Y comes by t + w; with Y at t, X comes from t - w on.
void Dispatcher::record(NodeIndex node, Ticks at) {
  NodeState& state = nodes_[node];
  state.done = true;
  state.date = at;
  --remaining_;
  for (std::uint32_t i = out_begin_[node]; i < out_begin_[node + 1]; ++i) {
    NodeState& other = nodes_[out_[i].node];
    other.latest = std::min(other.latest, later(at, out_[i].weight));
  }
  for (std::uint32_t i = in_begin_[node]; i < in_begin_[node + 1]; ++i) {
    NodeState& other = nodes_[in_[i].node];
    other.earliest = std::max(other.earliest, later(at, -in_[i].weight));
    if (in_[i].weight < 0) --other.blockers;
  }
  for (const NodeIndex waiting : waiting_for_[node]) --nodes_[waiting].blockers;
}

void Dispatcher::find_overdue(std::vector<DispatchEffect>& out) {
  for (std::uint32_t i = 0; i < links_.size(); ++i) {
    const ContingentLink& link = links_[i];
    const NodeState& activation = nodes_[link.activation];
    const NodeState& end = nodes_[link.contingent];
    if (controlled(end) || end.done || !activation.done || overdue_[i]) continue;
    const Ticks elapsed = now_ - activation.date;
    if (elapsed <= link.max) continue;
    overdue_[i] = true;
    stopped_ = true;
    out.emplace_back(Contingency{i, Contingency::Kind::kOverdue, Duration::nanoseconds(elapsed)});
  }
}

void Dispatcher::find_missed(std::vector<DispatchEffect>& out) {
  if (stopped_) return;
  for (NodeIndex node = 0; node < nodes_.size(); ++node) {
    const NodeState& state = nodes_[node];
    if (state.done || !controlled(state) || state.latest >= now_) continue;
    stopped_ = true;
    out.emplace_back(Missed{node, origin_at_ + Duration::nanoseconds(state.latest)});
  }
}

void Dispatcher::offer(std::vector<DispatchEffect>& out) {
  if (stopped_) return;
  for (NodeIndex node = 0; node < nodes_.size(); ++node) {
    NodeState& state = nodes_[node];
    if (state.offered || !enabled(node) || earliest(node) > now_) continue;
    state.offered = true;
    out.emplace_back(MayStart{node, limit(state.latest)});
  }
}

bool Dispatcher::controlled(const NodeState& node) const { return node.ended_link == kNoLink; }

bool Dispatcher::enabled(NodeIndex node) const {
  const NodeState& state = nodes_[node];
  return !state.done && state.blockers == 0 && controlled(state);
}

Ticks Dispatcher::earliest(NodeIndex node) const {
  Ticks result = nodes_[node].earliest;
  for (std::uint32_t i = wait_begin_[node]; i < wait_begin_[node + 1]; ++i) {
    const ContingentLink& link = links_[waits_[i].link];
    if (nodes_[link.contingent].done) continue;
    result = std::max(result, later(nodes_[link.activation].date, waits_[i].delay));
  }
  return result;
}

std::optional<MissionTime> Dispatcher::limit(Ticks ticks) const {
  if (ticks == kInfinite) return std::nullopt;
  return origin_at_ + Duration::nanoseconds(ticks);
}

std::optional<MissionTime> Dispatcher::next_wakeup() const {
  if (stopped_ || remaining_ == 0) return std::nullopt;
  Ticks next = kInfinite;
  for (NodeIndex node = 0; node < nodes_.size(); ++node) {
    if (!enabled(node)) continue;
    if (!nodes_[node].offered) next = std::min(next, std::max(now_, earliest(node)));
    next = std::min(next, later(nodes_[node].latest, 1));
  }
  for (const ContingentLink& link : links_) {
    const NodeState& end = nodes_[link.contingent];
    if (controlled(end) || end.done || !nodes_[link.activation].done) continue;
    next = std::min(next, later(later(nodes_[link.activation].date, link.max), 1));
  }
  return limit(next);
}

std::optional<DispatchWindow> Dispatcher::window(NodeIndex node) const {
  if (node >= nodes_.size() || !enabled(node)) return std::nullopt;
  return DispatchWindow{origin_at_ + Duration::nanoseconds(earliest(node)),
                        limit(nodes_[node].latest)};
}

std::optional<MissionTime> Dispatcher::date(NodeIndex node) const {
  if (node >= nodes_.size() || !nodes_[node].done) return std::nullopt;
  return origin_at_ + Duration::nanoseconds(nodes_[node].date);
}

std::vector<NodeIndex> Dispatcher::startable() const {
  std::vector<NodeIndex> result;
  if (stopped_) return result;
  for (NodeIndex node = 0; node < nodes_.size(); ++node) {
    if (enabled(node) && earliest(node) <= now_) result.push_back(node);
  }
  return result;
}

std::optional<MissionTime> Dispatcher::must_act_by() const {
  Ticks soonest = kInfinite;
  for (NodeIndex node = 0; node < nodes_.size(); ++node) {
    if (enabled(node)) soonest = std::min(soonest, nodes_[node].latest);
  }
  return limit(soonest);
}

}  // namespace skein::temporal
