// SPDX-License-Identifier: Apache-2.0
// Delivery between the transports of one MemoryHub.
#include "skein/blackboard/memory_transport.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <array>

#include "skein/blackboard/link_instance.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

bool is_pattern(const std::string& partition) {
  return partition.find_first_of("*?[") != std::string::npos;
}

/// Partitions match as in DDS: one of the two may be a pattern, here the reader's.
bool partitions_match(const std::string& writer, const std::string& reader) {
  return fnmatch(reader.c_str(), writer.c_str(), 0) == 0;
}

/// The nodes that a sample of the world is about, if it is about two only.
std::optional<std::array<NodeNumber, 2>> pair_of(ChannelKind kind, const wire::Sample& sample) {
  const auto* link = std::get_if<wire::LinkState>(&sample);
  if (link == nullptr || kind != ChannelKind::kWorld || !is_of_one(*link)) return std::nullopt;
  return std::array{NodeNumber(link->from), NodeNumber(link->to)};
}

}  // namespace

void MemoryHub::Partition::read(const End& reader, bool by_pattern) {
  readers.push_back(reader);
  const MemoryTransport::Channel& channel = MemoryTransport::at(reader);
  if (channel.kind != ChannelKind::kWorld) return;
  if (!world) world = std::make_unique<WorldReaders>();
  if (by_pattern) {
    world->listeners.push_back(reader);
  } else {
    world->of_nodes[reader.node->self_].push_back(reader);
  }
  for (std::size_t i = 0; i < wire::kSlotCount; ++i)
    if (channel.read_slots.test(i)) world->of_slots[static_cast<wire::Slot>(i)].push_back(reader);
}

MemoryHub::Partition& MemoryHub::partition(const std::string& name) {
  const auto [found, is_new] = partitions_.try_emplace(name);
  if (is_new) {
    for (const auto& [pattern, reader] : pattern_readers_)
      if (partitions_match(name, pattern)) found->second.read(reader, true);
  }
  return found->second;
}

void MemoryHub::join(const End& end, const std::string& name, bool writes, bool reads) {
  if (!is_pattern(name)) {
    Partition& joined = partition(name);
    if (writes) joined.writers.push_back(end);
    if (reads) joined.read(end, false);
  } else if (reads) {
    pattern_readers_.emplace_back(name, end);
    for (auto& [other, joined] : partitions_)
      if (partitions_match(other, name)) joined.read(end, true);
  }
}

void MemoryHub::leave(const MemoryTransport& node) {
  const auto is_of_node = [&](const End& end) { return end.node == &node; };
  const auto leave_it = [&](Partition& left) {
    std::erase_if(left.writers, is_of_node);
    std::erase_if(left.readers, is_of_node);
    if (!left.world) return;
    std::erase_if(left.world->listeners, is_of_node);
    for (auto& [slot, readers] : left.world->of_slots) std::erase_if(readers, is_of_node);
    const auto named = left.world->of_nodes.find(node.self_);
    if (named != left.world->of_nodes.end() && std::erase_if(named->second, is_of_node) > 0 &&
        named->second.empty())
      left.world->of_nodes.erase(named);
  };
  for (const MemoryTransport::Channel& channel : node.channels_)
    if (channel.partition != nullptr) leave_it(*channel.partition);
  const auto listens = [&](const auto& reader) { return is_of_node(reader.second); };
  if (std::erase_if(pattern_readers_, listens) == 0) return;
  for (auto& [name, left] : partitions_) leave_it(left);
}

std::vector<MemoryHub::End> MemoryHub::writers_for(const End& reader) const {
  std::vector<End> all;
  for (const auto& [name, one] : partitions_)
    if (std::ranges::find(one.readers, reader) != one.readers.end())
      all.insert(all.end(), one.writers.begin(), one.writers.end());
  return all;
}

void MemoryHub::inject(const std::string& name,
                       const std::variant<wire::Sample, Malformed>& content) {
  for (const End& reader : partition(name).readers)
    if (reader.node->channels_[reader.channel].up) reader.node->put(reader.channel, content);
}

void MemoryHub::carry(NodeNumber from, NodeNumber to, bool carried) {
  bool& carries = carried_.try_emplace({from, to}, others_are_carried_).first->second;
  if (std::exchange(carries, carried) == carried || !carried) return;
  for (const auto& [name, one] : partitions_) {
    for (const End& writer : one.writers) {
      if (writer.node->self_ != from || !writer.node->is_radio(writer.channel)) continue;
      for (const End& reader : one.readers)
        if (reader.node->self_ == to) MemoryTransport::replay_states(writer, reader);
    }
  }
}

bool MemoryHub::carries(const MemoryTransport& from, const MemoryTransport& to) const {
  const auto found = carried_.find({from.self_, to.self_});
  return found == carried_.end() ? others_are_carried_ : found->second;
}

class MemoryTransport::Boxed {
 public:
  static std::unique_ptr<Boxed> of(const wire::Sample& sample);
  virtual ~Boxed() = default;
  virtual wire::Sample sample() const = 0;
};

std::unique_ptr<MemoryTransport::Boxed> MemoryTransport::Boxed::of(const wire::Sample& sample) {
  return std::visit(
      [](const auto& content) -> std::unique_ptr<Boxed> {
        using Content = std::decay_t<decltype(content)>;
        struct Box final : Boxed {
          explicit Box(Content it) : content(std::move(it)) {}
          wire::Sample sample() const override { return content; }
          Content content;
        };
        return std::make_unique<Box>(content);
      },
      sample);
}

MemoryTransport::MemoryTransport(MemoryHub& hub) : hub_(hub) {}

MemoryTransport::~MemoryTransport() { hub_.leave(*this); }

Result<void, Failure> MemoryTransport::open(const TransportPlan& plan) {
  SKEIN_EXPECTS(channels_.empty());
  self_ = plan.self;
  channels_.reserve(plan.channels.size());
  for (const ChannelConfig& config : plan.channels) {
    const bool world = config.kind == ChannelKind::kWorld;
    channels_.push_back(channel_of(config, world ? plan.world_reads : config.slots));
  }
  order_ = hub_.opened_++;
  for (std::size_t i = 0; i < channels_.size(); ++i) join(i, plan.channels[i].partition);
  take_what_is_kept();
  return {};
}

Result<std::size_t, Failure> MemoryTransport::add(const ChannelConfig& config) {
  SKEIN_EXPECTS(config.kind != ChannelKind::kWorld);
  const std::size_t index = channels_.size();
  channels_.push_back(channel_of(config, config.slots));
  channels_.back().up = false;
  join(index, config.partition);
  return index;
}

MemoryTransport::Channel MemoryTransport::channel_of(const ChannelConfig& config,
                                                     const std::vector<wire::Slot>& reads) const {
  Channel channel;
  channel.kind = config.kind;
  channel.by_pattern = is_pattern(config.partition);
  const bool world = config.kind == ChannelKind::kWorld;
  channel.writes = world || config.from == self_;
  channel.reads = world || config.from != self_;
  for (const wire::Slot slot : reads) channel.read_slots.set(static_cast<std::size_t>(slot));
  if (!world) channel.read_slots.set(static_cast<std::size_t>(wire::Slot::kHeartbeat));
  return channel;
}

void MemoryTransport::join(std::size_t channel, const std::string& partition) {
  Channel& joins = channels_[channel];
  hub_.join({this, channel}, partition, joins.writes, joins.reads);
  joins.partition = &hub_.partition(partition);
}

/// From the writers that are there already, in their order.
void MemoryTransport::take_what_is_kept() {
  std::vector<std::pair<MemoryHub::End, MemoryHub::End>> all;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (!channels_[i].reads) continue;
    for (const MemoryHub::End& writer : writers_for(i)) all.push_back({writer, {this, i}});
  }
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) {
    return std::pair(a.first.node->order_, a.first.channel) <
           std::pair(b.first.node->order_, b.first.channel);
  });
  for (const auto& [writer, reader] : all) replay(writer, reader);
}

std::vector<MemoryHub::End> MemoryTransport::writers_for(std::size_t channel) {
  const Channel& reader = channels_[channel];
  std::vector<MemoryHub::End> all =
      reader.by_pattern ? hub_.writers_for({this, channel}) : reader.partition->writers;
  std::erase_if(all, [&](const MemoryHub::End& writer) { return writer.node == this; });
  return all;
}

bool MemoryTransport::write(std::size_t channel, const wire::Sample& sample) {
  Channel& writer = channels_.at(channel);
  SKEIN_EXPECTS(writer.writes);
  remember(writer, sample);
  if (!writer.up) return true;
  const MemoryHub::Partition& partition = *writer.partition;
  if (!partition.world) {
    put_to(partition.readers, channel, sample);
  } else if (const auto pair = pair_of(writer.kind, sample)) {
    const auto& of_nodes = partition.world->of_nodes;
    for (const NodeNumber node : *pair)
      if (const auto found = of_nodes.find(node); found != of_nodes.end())
        put_to(found->second, channel, sample);
    put_to(partition.world->listeners, channel, sample);
  } else {
    const auto readers = partition.world->of_slots.find(wire::slot_of(sample));
    if (readers != partition.world->of_slots.end()) put_to(readers->second, channel, sample);
  }
  return true;
}

void MemoryTransport::put_to(const std::vector<MemoryHub::End>& readers, std::size_t channel,
                             const wire::Sample& sample) {
  const auto slot = static_cast<std::size_t>(wire::slot_of(sample));
  for (const MemoryHub::End& reader : readers) {
    const Channel& to = at(reader);
    if (reader.node != this && to.up && to.read_slots.test(slot) && reaches(channel, reader))
      reader.node->put(reader.channel, sample);
  }
}

void MemoryTransport::remember(Channel& channel, const wire::Sample& sample) {
  const wire::SlotClass kind = wire::slot_class(wire::slot_of(sample));
  if (kind == wire::SlotClass::kStream) return;
  if (!channel.kept) channel.kept = std::make_unique<Kept>();
  if (kind == wire::SlotClass::kState) return remember_state(channel, sample);
  const bool world = channel.kind == ChannelKind::kWorld;
  std::list<wire::Sample>& events = channel.kept->events;
  events.push_back(sample);
  if (events.size() > (world ? kWorldEventDepth : kEventDepth)) events.pop_front();
}

void MemoryTransport::remember_state(Channel& channel, const wire::Sample& sample) {
  Kept& keeps = *channel.kept;
  const wire::SampleHeader& header = wire::header_of(sample);
  const StateKey key{wire::slot_of(sample), header.origin, header.destination, header.instance};
  const auto pair = pair_of(channel.kind, sample);
  if (!pair) return void(keeps.states.insert_or_assign(key, Boxed::of(sample)));
  if (!keeps.links) keeps.links = std::make_unique<Links>();
  const auto [kept, is_new] =
      keeps.links->all.insert_or_assign(key, std::get<wire::LinkState>(sample));
  if (!is_new) return;
  for (const NodeNumber node : *pair) keeps.links->of_nodes[node].push_back(&*kept);
}

void MemoryTransport::put(std::size_t channel, std::variant<wire::Sample, Malformed> content) {
  if (mailbox_.empty()) mailbox_.reserve(last_taken_);
  mailbox_.push_back({channel, std::move(content)});
  if (notify_) notify_();
}

bool MemoryTransport::is_radio(std::size_t channel) const {
  return channels_[channel].kind == ChannelKind::kRadio;
}

bool MemoryTransport::reaches(std::size_t channel, const MemoryHub::End& reader) const {
  return !is_radio(channel) || hub_.carries(*this, *reader.node);
}

bool MemoryTransport::wants(const MemoryHub::End& reader, wire::Slot slot) {
  return at(reader).read_slots.test(static_cast<std::size_t>(slot));
}

void MemoryTransport::replay_states(const MemoryHub::End& writer, const MemoryHub::End& reader) {
  if (!at(writer).up || !at(reader).up) return;
  if (!writer.node->reaches(writer.channel, reader)) return;
  for (auto& [key, state] : states_for(at(writer), reader))
    reader.node->put(reader.channel, std::move(state));
}

std::vector<MemoryTransport::KeptState> MemoryTransport::states_for(const Channel& writer,
                                                                    const MemoryHub::End& reader) {
  std::vector<KeptState> kept;
  if (!writer.kept) return kept;
  for (const auto& [key, state] : writer.kept->states)
    if (wants(reader, std::get<0>(key))) kept.emplace_back(key, state->sample());
  const Links* links = writer.kept->links.get();
  if (links == nullptr || !wants(reader, wire::Slot::kLinkState)) return kept;
  if (at(reader).by_pattern) {
    for (const auto& [key, link] : links->all) kept.emplace_back(key, link);
  } else if (const auto about = links->of_nodes.find(reader.node->self_);
             about != links->of_nodes.end()) {
    for (const auto* link : about->second) kept.emplace_back(link->first, link->second);
  }
  std::ranges::sort(kept, {}, &KeptState::first);
  return kept;
}

void MemoryTransport::replay(const MemoryHub::End& writer, const MemoryHub::End& reader) {
  replay_states(writer, reader);
  if (!at(writer).up || !at(reader).up) return;
  if (!writer.node->reaches(writer.channel, reader)) return;
  if (!at(writer).kept) return;
  for (const wire::Sample& event : at(writer).kept->events)
    if (wants(reader, wire::slot_of(event))) reader.node->put(reader.channel, event);
}

Result<void, Failure> MemoryTransport::set_up(std::size_t channel, bool up) {
  Channel& mine = channels_.at(channel);
  if (mine.up == up) return {};
  mine.up = up;
  if (!up) return {};
  if (mine.writes) {
    for (const MemoryHub::End& reader : mine.partition->readers)
      if (reader.node != this) replay({this, channel}, reader);
  }
  if (!mine.reads) return {};
  for (const MemoryHub::End& writer : writers_for(channel)) replay(writer, {this, channel});
  return {};
}

std::vector<Arrival> MemoryTransport::take() {
  last_taken_ = mailbox_.size();
  return std::exchange(mailbox_, {});
}

}  // namespace skein::blackboard
