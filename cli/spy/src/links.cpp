// SPDX-License-Identifier: Apache-2.0
#include "links.hpp"

#include <nlohmann/json.hpp>

#include "skein/blackboard/link_instance.hpp"
#include "skein/journal/lines/radio.hpp"

namespace skein::spy_tool {
namespace {

/// Of a process that was taken for a node, until another may be.
constexpr Duration kSilence = Duration::milliseconds(3'000);

}  // namespace

Links::Half& Links::half(std::uint32_t from, std::uint32_t to) {
  Half& half = halves_[{from, to}];
  half.link.from = from;
  half.link.to = to;
  return half;
}

void Links::hear(const wire::Sample& sample, Duration at) {
  if (const auto* heartbeat = std::get_if<wire::Heartbeat>(&sample)) {
    hear_heartbeat(*heartbeat, at);
  } else if (const auto* state = std::get_if<wire::LinkState>(&sample)) {
    if (blackboard::is_of_one(*state)) half(state->from, state->to).link.carried = state->up;
  } else if (const auto* entry = std::get_if<wire::DirectoryEntry>(&sample)) {
    numbers_[entry->name] = entry->header.origin;
  } else if (const auto* board = std::get_if<wire::UavBoard>(&sample)) {
    const auto uav = numbers_.find(board->uav);
    if (uav != numbers_.end())
      half(uav->second, board->header.origin).link.heard = board->reachable;
  } else if (const auto* line = std::get_if<wire::JournalEntry>(&sample)) {
    hear_record(*line);
  } else if (wire::slot_name(wire::slot_of(sample)) == "Neighbours") {
    hear_neighbours(sample);
  }
}

bool Links::is_of_second(const wire::SampleHeader& header, Duration at) {
  const auto life = lives_.find(header.origin);
  if (life == lives_.end()) return false;
  if (life->second.incarnation == header.incarnation) {
    life->second.heard = at;
    return false;
  }
  return life->second.heard && at - *life->second.heard < kSilence;
}

void Links::hear_heartbeat(const wire::Heartbeat& heartbeat, Duration at) {
  const wire::SampleHeader& header = heartbeat.header;
  if (header.destination == 0) return;  // published, so about no link
  if (is_of_second(header, at)) return;
  if (heartbeat.ack_incarnation != 0) {
    Life& life = lives_[header.destination];
    if (life.incarnation != heartbeat.ack_incarnation) life = {heartbeat.ack_incarnation, {}};
  }
  Half& there = half(header.origin, header.destination);
  if (there.link.heartbeat) there.link.period = (at - *there.link.heartbeat).to_seconds();
  there.link.heartbeat = at;
  there.incarnation = header.incarnation;
  there.sent = heartbeat.events_to;
  Half& back = half(header.destination, header.origin);
  back.acknowledged_incarnation = heartbeat.ack_incarnation;
  back.acknowledged = heartbeat.ack_sequence;
  back.link.heard = heartbeat.ack_incarnation != 0;  // who is silent is acknowledged nothing
}

void Links::hear_record(const wire::JournalEntry& entry) {
  const auto record = journal::parse_record(entry.record);
  const auto reach = record ? journal::read_as<journal::lines::Reach>(*record) : std::nullopt;
  const auto peer = reach ? numbers_.find(reach->peer) : numbers_.end();
  if (peer != numbers_.end()) {
    half(peer->second, entry.header.origin).link.heard = reach->reachable;
  }
}

void Links::hear_neighbours(const wire::Sample& sample) {
  const auto json = nlohmann::json::parse(wire::to_json(sample), nullptr, false);
  const std::uint32_t self = wire::header_of(sample).origin;
  for (auto& [pair, one] : halves_)
    if (pair.second == self) one.link.heard = false;
  for (const auto& heard : json.value("hears", nlohmann::json::array()))
    half(heard.value("node", 0U), self).link.heard = true;
}

std::vector<Link> Links::all() const {
  std::vector<Link> links;
  for (const auto& [pair, half] : halves_) {
    Link link = half.link;
    if (half.acknowledged_incarnation != 0 && half.acknowledged_incarnation == half.incarnation)
      link.waiting = half.sent - std::min(half.sent, half.acknowledged);
    if (link.heartbeat || link.heard || link.carried) links.push_back(link);
  }
  return links;
}

}  // namespace skein::spy_tool
