// SPDX-License-Identifier: Apache-2.0
// Reachability of one peer and the event session with it.
#include "peer.hpp"

#include <algorithm>

namespace skein::blackboard {
namespace {

/// Long enough to acknowledge a burst at once, short against any retransmission time.
constexpr Duration kAcknowledgementDelay = Duration::milliseconds(10);

std::optional<Duration> sooner(std::optional<Duration> a, std::optional<Duration> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

}  // namespace

Peer::Peer(PeerChannels channels, const Config& config)
    : channels_(channels),
      self_incarnation_(config.incarnation),
      period_(config.heartbeat_period),
      outgoing_(config.held_events, config.retransmission),
      incoming_(config.self, config.incarnation) {}

void Peer::set_outgoing(const ChannelCondition& condition, Now now) {
  if (condition.up && !out_condition_.up) next_heartbeat_ = now.steady;
  out_condition_ = condition;
}

void Peer::on_event(const wire::SampleHeader& header, std::optional<wire::Sample> event, Now now,
                    std::vector<Incoming>& out) {
  incoming_.on_event(header, std::move(event));
  incoming_.deliver(channels_.kind, now.mission, out);
  if (incoming_.owes_acknowledgement() && !acknowledge_at_) {
    acknowledge_at_ = now.steady + kAcknowledgementDelay;
  }
}

void Peer::on_heartbeat(const wire::Heartbeat& heartbeat, Now now, std::vector<Incoming>& out) {
  const std::uint64_t incarnation = heartbeat.header.incarnation;
  if (incarnation < incarnation_) return;
  const bool restarted = incarnation_ != 0 && incarnation > incarnation_;
  if (heartbeat.ack_incarnation == self_incarnation_) {
    outgoing_.acknowledge(heartbeat.ack_sequence);
  }
  if (!reachable_ || restarted) {
    out.emplace_back(Reachability{channels_.number, true, restarted});
    outgoing_.resend();
    next_heartbeat_ = now.steady;
  }
  reachable_ = true;
  recalled_ = false;
  incarnation_ = incarnation;
  last_heard_ = now.steady;
  incoming_.on_heartbeat(heartbeat, out);
  incoming_.deliver(channels_.kind, now.mission, out);
  if (incoming_.owes_acknowledgement() && !acknowledge_at_) {
    acknowledge_at_ = now.steady + kAcknowledgementDelay;
  }
}

void Peer::recall_sent(wire::Sample event) {
  outgoing_.recall(std::move(event));
  recalled_ = true;
}

void Peer::recall_received(const wire::SampleHeader& header) {
  incarnation_ = std::max(incarnation_, header.incarnation);
  incoming_.recall(header);
}

void Peer::recall_reachable(bool reachable) {
  reachable_ = reachable;
  recalled_ = true;
}

// The silence of a peer that was in reach is counted from the first update of this life.
void Peer::update(Now now, std::vector<Incoming>& out) {
  if (recalled_ && last_heard_ == Duration{}) last_heard_ = now.steady;
  if (reachable_ && now.steady - last_heard_ >= silence_limit()) {
    reachable_ = false;
    out.emplace_back(Reachability{channels_.number, false, false});
  }
  if (recalled_) return;  // what it has acknowledged is not known before it is heard
  for (const EventExpired& expired : outgoing_.expire(now.mission)) out.emplace_back(expired);
}

std::vector<const wire::Sample*> Peer::take_due_events(Now now) {
  if (!out_condition_.up || recalled_) return {};
  return outgoing_.take_due(now, round_trip());
}

bool Peer::heartbeat_due(Duration steady) const {
  if (!out_condition_.up) return false;
  return steady >= next_heartbeat_ || (acknowledge_at_ && steady >= *acknowledge_at_);
}

wire::Heartbeat Peer::take_heartbeat(Duration steady) {
  next_heartbeat_ = steady + period_;
  acknowledge_at_.reset();
  incoming_.acknowledged();
  wire::Heartbeat heartbeat;
  heartbeat.events_from = outgoing_.oldest();
  heartbeat.events_to = outgoing_.next_sequence() - 1;
  heartbeat.ack_incarnation = incarnation_;
  heartbeat.ack_sequence = incoming_.ack_sequence();
  return heartbeat;
}

std::optional<Duration> Peer::next_wakeup() const {
  std::optional<Duration> next;
  if (reachable_) next = last_heard_ + silence_limit();
  if (!out_condition_.up) return next;
  next = sooner(next, next_heartbeat_);
  next = sooner(next, acknowledge_at_);
  return recalled_ ? next : sooner(next, outgoing_.next_due(round_trip()));
}

}  // namespace skein::blackboard
