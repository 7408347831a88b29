// SPDX-License-Identifier: Apache-2.0
// The lines that a host writes to the event log.
#include <utility>

#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/node/host.hpp"

namespace skein::node {

namespace lines = journal::lines;

using blackboard::Now;

void Host::log_route(const blackboard::RouteChanged& route, Now now) {
  lines::Route line{.peer = roster_.name_of(route.peer)};
  if (route.via) {
    line.via = roster_.name_of(*route.via);
    line.relays = route.relays;
  }
  log(std::move(line), now);
}

void Host::log_older(const blackboard::TakenForOlder& one, Now now) {
  const std::string peer = roster_.name_of(one.peer);
  log(lines::Notice{.text = one.is_next ? peer + " knows a later life of this node, which is the "
                                                 "next one to it now"
                                        : peer + " hears another node of this name, and takes "
                                                 "this one for older"},
      now);
}

void Host::log_unsent(wire::Slot slot, const std::string& to, blackboard::Refusal why, Now now) {
  log(lines::Unsent{wire::slot_name(slot), to, blackboard::name_of(why)}, now);
}

void Host::log_message(const wire::Sample& sample, const std::string& from, const std::string& to,
                       std::uint64_t sequence, const char* direction, Now now) {
  lines::Message line{.slot = wire::slot_name(wire::slot_of(sample)),
                      .from = from,
                      .to = to,
                      .sequence = sequence,
                      .direction = direction};
  if (const auto* negotiation = std::get_if<wire::NegotiationMessage>(&sample)) {
    line.subject = negotiation->subject;
    line.opener = negotiation->opener;
    line.opened = MissionTime::nanoseconds(negotiation->opened).to_seconds();
  }
  log(line, now);
}

}  // namespace skein::node
