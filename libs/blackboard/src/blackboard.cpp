// SPDX-License-Identifier: Apache-2.0
// The public face of the blackboard.
#include "skein/blackboard/blackboard.hpp"

#include <algorithm>
#include <iterator>

#include "blackboard_impl.hpp"

namespace skein::blackboard {

std::string_view name_of(Refusal refusal) {
  switch (refusal) {
    case Refusal::kNoChannel:
      return "no channel to there for this slot";
    case Refusal::kFull:
      return "too many unacknowledged events";
    case Refusal::kMalformed:
      return "malformed";
    case Refusal::kTooLong:
      return "too long";
  }
  return "?";
}

Result<Blackboard, Failure> Blackboard::open(Config config, Transport& transport) {
  auto impl = std::make_unique<Impl>(std::move(config), transport);
  if (auto opened = impl->open(); !opened) return tl::unexpected(opened.error());
  return Blackboard(std::move(impl));
}

Blackboard::Blackboard(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Blackboard::Blackboard(Blackboard&&) noexcept = default;
Blackboard& Blackboard::operator=(Blackboard&&) noexcept = default;
Blackboard::~Blackboard() = default;

Result<std::uint64_t, Refusal> Blackboard::send(wire::Sample sample, NodeNumber to, Now now,
                                                SendOptions options) {
  return impl_->send(std::move(sample), to, now, options);
}

Result<std::uint64_t, Refusal> Blackboard::publish(wire::Sample sample, Now now) {
  return impl_->publish(std::move(sample), now);
}

void Blackboard::set_condition(NodeNumber from, NodeNumber to, const ChannelCondition& condition,
                               Now now) {
  impl_->set_condition(from, to, condition, now);
}

std::vector<Incoming> Blackboard::step(Now now) {
  std::vector<Incoming> all = impl_->receive(now, true);
  std::ranges::move(impl_->act(now), std::back_inserter(all));
  return all;
}

std::vector<Incoming> Blackboard::receive(Now now, bool handled) {
  return impl_->receive(now, handled);
}

std::vector<Incoming> Blackboard::act(Now now) { return impl_->act(now); }

bool Blackboard::knows(NodeNumber peer) const { return impl_->directory().find(peer) != nullptr; }

std::size_t Blackboard::channels() const { return impl_->channels(); }

std::optional<Duration> Blackboard::next_wakeup() const { return impl_->next_wakeup(); }

std::optional<MissionTime> Blackboard::next_expiry() const { return impl_->next_expiry(); }

void Blackboard::recall_sent(wire::Sample sample, NodeNumber to, MissionTime at,
                             SendOptions options) {
  impl_->recall_sent(std::move(sample), to, at, options);
}

void Blackboard::recall_acknowledged(NodeNumber peer, std::uint64_t sequence) {
  impl_->change(peer, [&](Peer& one) { one.session().recall_acknowledged(sequence); });
}

void Blackboard::recall_given_up(NodeNumber to, std::uint64_t sequence) {
  impl_->change(to, [&](Peer& one) { one.session().recall_given_up(sequence); });
}

void Blackboard::recall_received(wire::Slot slot, const wire::SampleHeader& header) {
  impl_->recall_received(slot, header);
}

void Blackboard::recall_reachable(NodeNumber peer, bool reachable) {
  impl_->change(peer, [&](Peer& one) { one.recall_reachable(reachable); });
}

bool Blackboard::reachable(NodeNumber peer) const {
  const Peer* found = impl_->directory().find(peer);
  return found != nullptr && found->reachable();
}

std::size_t Blackboard::unacknowledged(NodeNumber peer) const {
  const Peer* found = impl_->directory().find(peer);
  return found == nullptr ? 0 : found->known().unacknowledged();
}

std::uint64_t Blackboard::shed(NodeNumber peer) const {
  const Peer* found = impl_->directory().find(peer);
  return found == nullptr || found->line().limited() == nullptr ? 0
                                                                : found->line().limited()->shed();
}

const std::map<NodeNumber, MissionTime>& Blackboard::latest_heard() const {
  return impl_->latest_heard();
}

std::uint64_t Blackboard::settled(NodeNumber peer) const {
  const Peer* found = impl_->directory().find(peer);
  return found == nullptr ? 0 : found->known().outgoing.oldest() - 1;
}

std::uint64_t Blackboard::settled_long(NodeNumber peer) const {
  const Peer* found = impl_->directory().find(peer);
  const std::uint64_t last = found == nullptr ? 0 : found->known().parts_out.settled();
  return last < kFirstLongEvent ? 0 : last;
}

}  // namespace skein::blackboard
