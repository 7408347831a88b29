// SPDX-License-Identifier: Apache-2.0
#include "sessions/session.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace skein::blackboard {
namespace {

bool is_long(std::uint64_t number) { return number >= kFirstLongEvent; }

}  // namespace

Session::Session(const Config& config)
    : outgoing(config.held_events, config.retransmission), lives(config) {}

bool Session::full(bool long_event) const {
  return long_event ? parts_out.full() : outgoing.full();
}

std::uint64_t Session::next_number(bool long_event) const {
  return long_event ? parts_out.next_number() : outgoing.next_sequence();
}

void Session::hold(wire::Sample event, std::uint64_t receipt) {
  if (is_long(wire::header_of(event).sequence_number)) return parts_out.hold(event, receipt);
  outgoing.hold(std::move(event), receipt);
}

void Session::resend() {
  outgoing.resend();
  parts_out.resend();
  long_states.resend();
}

void Session::set_contact(bool contact) {
  outgoing.set_contact(contact);
  parts_out.set_contact(contact);
}

void Session::become(NodeNumber self, std::uint64_t incarnation) {
  outgoing.become(incarnation);
  parts_out.become(incarnation);
  long_states.drop_from(self.value());
  lives.become(incarnation);
}

std::vector<EventExpired> Session::expire(MissionTime now) {
  std::vector<EventExpired> expired = outgoing.expire(now);
  std::ranges::move(parts_out.expire(now), std::back_inserter(expired));
  return expired;
}

std::optional<MissionTime> Session::first_expiry() const {
  return earliest(outgoing.first_expiry(), parts_out.first_expiry());
}

void Session::recall_sent(wire::Sample event, std::uint64_t receipt) {
  if (is_long(wire::header_of(event).sequence_number)) return parts_out.hold(event, receipt);
  outgoing.recall(std::move(event), receipt);
}

void Session::recall_acknowledged(std::uint64_t number) {
  if (is_long(number)) return parts_out.recall_acknowledged(number);
  outgoing.acknowledge(number);
}

void Session::recall_given_up(std::uint64_t number) {
  is_long(number) ? parts_out.give_up(number) : outgoing.give_up(number);
}

void Session::recall_received(const wire::SampleHeader& header) {
  Life& life = lives.present();
  life.incarnation = std::max(life.incarnation, header.incarnation);
  if (is_long(header.sequence_number))
    return life.parts.recall(header.incarnation, header.sequence_number);
  life.incoming.recall(header);
}

}  // namespace skein::blackboard
