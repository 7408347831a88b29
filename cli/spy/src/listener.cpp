// SPDX-License-Identifier: Apache-2.0
#include "listener.hpp"

#include <fnmatch.h>

#include <algorithm>

#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/dds_type.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::spy_tool {

namespace {

using blackboard::Endpoint;

std::vector<std::string> slot_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < wire::kSlotCount; ++i)
    names.emplace_back(wire::slot_name(static_cast<wire::Slot>(i)));
  return names;
}

bool fits(const std::vector<std::string>& patterns, const std::string& name) {
  return std::ranges::any_of(patterns, [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  });
}

}  // namespace

std::optional<wire::Slot> slot_of(const Endpoint& endpoint) {
  const auto slot = wire::slot_from_name(endpoint.topic);
  return slot && endpoint.type == blackboard::dds_type_of(*slot) ? slot : std::nullopt;
}

blackboard::EndpointQos qos_of(wire::Slot slot) {
  const bool stream = wire::slot_class(slot) == wire::SlotClass::kStream;
  blackboard::EndpointQos qos;
  qos.reliable = !stream;
  qos.durability =
      stream ? blackboard::Durability::kVolatile : blackboard::Durability::kTransientLocal;
  return qos;
}

Endpoint reader_of(wire::Slot slot, std::vector<std::string> partitions) {
  Endpoint reader;
  reader.keyed = true;
  reader.topic = wire::slot_name(slot);
  reader.type = blackboard::dds_type_of(slot);
  reader.partitions = std::move(partitions);
  reader.qos = qos_of(slot);
  return reader;
}

const Content& Heard::content() const {
  if (!content_) content_ = blackboard::decode(*slot_, raw_.bytes);
  return *content_;
}

const wire::Sample* Heard::sample() const {
  return slot_ && !gone() ? std::get_if<wire::Sample>(&content()) : nullptr;
}

wire::SampleHeader Heard::header() const {
  if (!slot_ || gone()) return {};
  if (const wire::Sample* const whole = sample()) return wire::header_of(*whole);
  return std::get<blackboard::Malformed>(content()).header;
}

Listener::Listener(const SpyOptions& options, std::unique_ptr<blackboard::Observer> observer)
    : options_(options), observer_(std::move(observer)) {}

Diagnostics Listener::check() const {
  Diagnostics diagnostics;
  const std::vector<std::string> known = slot_names();
  for (const std::string& slot : options_.slots) {
    if (std::ranges::any_of(known, [&](const auto& name) { return fits({slot}, name); })) continue;
    diagnostics.add({"", 0, 0, "", "no slot '" + slot + "'",
                     "one of " + joined(known, ", ") + "; topics of others: --topic",
                     nearest_name(slot, known)});
  }
  return diagnostics;
}

Result<void, Failure> Listener::open() {
  if (!in_turns_) observer_->on_sighting([this] { waker_.notify(); });
  auto opened = observer_->open();
  if (!opened) refused_.push_back(opened.error().why);
  return opened;
}

bool Listener::wanted(wire::Slot slot) const {
  if (only_) return only_->contains(slot);
  const bool any = options_.slots.empty() && options_.topics.empty();
  return any || fits(options_.slots, std::string(wire::slot_name(slot)));
}

bool Listener::wants_topic(const std::string& topic) const {
  return !only_ && fits(options_.topics, topic);
}

bool Listener::listen(std::optional<Duration> until, const Use& use) {
  while (!waker_.stop_requested()) {
    for (blackboard::Sighting& sighting : observer_->take())
      waiting_.push_back(std::move(sighting));
    while (!waiting_.empty()) {
      const blackboard::Sighting sighting = std::move(waiting_.front());
      waiting_.pop_front();
      if (!take(sighting, use)) return false;
    }
    const Duration now = node::Waker::steady_now();
    if (until && now >= *until) return true;
    waker_.wait(until ? std::optional<Duration>(*until - now) : std::nullopt);
  }
  return true;
}

bool Listener::take(const blackboard::Sighting& sighting, const Use& use) {
  const auto* const sample = std::get_if<blackboard::SampleSeen>(&sighting);
  if (sample == nullptr) graph_.see(sighting, node::Waker::steady_now());
  const auto* const found = std::get_if<blackboard::EndpointSeen>(&sighting);
  if (found != nullptr && found->endpoint.writer) attend(found->endpoint);
  if (told_ && !told_(sighting)) return false;
  return sample == nullptr || hear(*sample, use);
}

std::optional<blackboard::Subscription> Listener::subscription_to(const Endpoint& writer) const {
  blackboard::Subscription subscription{writer.topic, writer.type, writer.keyed,
                                        options_.partitions, writer.qos};
  if (const auto slot = slot_of(writer)) {
    subscription.keyed = true;
    subscription.qos = qos_of(*slot);
    // A node's name is in its directory entry.
    const bool for_names = *slot == wire::Slot::kDirectoryEntry;
    if (without_history_.contains(*slot))
      subscription.qos.durability = blackboard::Durability::kVolatile;
    return wanted(*slot) || for_names ? std::optional(subscription) : std::nullopt;
  }
  subscription.partitions = {"", "*"};
  return wants_topic(writer.topic) ? std::optional(subscription) : std::nullopt;
}

void Listener::attend(const Endpoint& writer) {
  const auto subscription = subscription_to(writer);
  if (!subscription || std::ranges::find(subscriptions_, *subscription) != subscriptions_.end())
    return;
  subscriptions_.push_back(*subscription);
  if (auto read = observer_->read(*subscription); !read) refused_.push_back(read.error().why);
}

bool Listener::hear(const blackboard::SampleSeen& raw, const Use& use) {
  const Endpoint* const writer = graph_.endpoint(raw.writer);
  // Of a writer that has left already what it wrote is of the type that is read.
  const Heard heard(raw, writer,
                    writer != nullptr ? slot_of(*writer) : wire::slot_from_name(raw.topic));
  const bool names = heard.slot() == wire::Slot::kDirectoryEntry;
  const auto* const sample = names ? heard.sample() : nullptr;
  graph_.hear(raw.writer, raw.at, heard.header().origin,
              sample == nullptr ? nullptr : std::get_if<wire::DirectoryEntry>(sample));
  if (heard.slot() ? !wanted(*heard.slot()) : !wants_topic(raw.topic)) return true;
  if (!options_.from.empty()) {
    const std::uint32_t origin = heard.header().origin;
    const std::string owner = heard.slot()
                                  ? graph_.name_of(origin)
                                  : graph_.owner_of(raw.writer.substr(0, raw.writer.find('.')));
    if (options_.from != owner && options_.from != std::to_string(origin)) {
      ++of_others_;
      return true;
    }
  }
  return use(heard);
}

}  // namespace skein::spy_tool
