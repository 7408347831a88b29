// SPDX-License-Identifier: Apache-2.0
// A domain that is told, without DDS.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "listener.hpp"
#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/observer.hpp"
#include "skein/blackboard/program_description.hpp"

namespace skein::spy_tool::testing {

inline std::vector<std::uint8_t> bytes_of(const wire::Sample& sample) {
  std::vector<std::uint8_t> bytes(blackboard::encoded_size(sample));
  blackboard::encode(sample, bytes);
  return bytes;
}

/// Shows what it was given, at once; samples only of topics that somebody reads.
class FakeObserver final : public blackboard::Observer {
 public:
  Result<void, Failure> open() override {
    return refuses ? failure(*refuses) : Result<void, Failure>();
  }
  Result<void, Failure> read(const blackboard::Subscription& subscription) override {
    subscriptions.push_back(subscription);
    return {};
  }
  std::vector<blackboard::Sighting> take() override {
    std::vector<blackboard::Sighting> some;
    std::vector<blackboard::Sighting> later;
    for (auto& one : std::exchange(sightings, {})) {
      const auto* sample = std::get_if<blackboard::SampleSeen>(&one);
      (sample == nullptr || reads(sample->topic) ? some : later).push_back(std::move(one));
    }
    sightings = std::move(later);
    return some;
  }
  void on_sighting(std::function<void()> /*notify*/) override {}

  bool reads(const std::string& topic) const {
    for (const auto& one : subscriptions)
      if (one.topic == topic) return true;
    return false;
  }

  std::vector<blackboard::Sighting> sightings;
  std::vector<blackboard::Subscription> subscriptions;
  std::optional<std::string> refuses;
};

/// Says what happens in a domain; guids are the names.
class Story {
 public:
  explicit Story(FakeObserver& observer) : observer_(observer) {}

  Story& joins(const std::string& name,
               std::string description = to_text(blackboard::program_description())) {
    blackboard::Participant participant;
    participant.guid = participant.name = name;
    participant.vendor = "fastdds";
    participant.addresses = {"127.0.0.1:7411"};
    participant.description = std::move(description);
    return see(blackboard::ParticipantSeen{participant, false});
  }
  Story& leaves(const std::string& name, bool silent = false) {
    return see(blackboard::ParticipantGone{name, silent});
  }
  /// `name` writes the slot; the guid of its writer is "NAME.SLOT".
  Story& writes(const std::string& name, wire::Slot slot, std::string partition = "world") {
    blackboard::Endpoint endpoint = reader_of(slot, {std::move(partition)});
    endpoint.writer = true;
    return has(name, endpoint);
  }
  Story& reads(const std::string& name, wire::Slot slot, std::string partition = "world") {
    blackboard::Endpoint endpoint = reader_of(slot, {std::move(partition)});
    return has(name, endpoint, ".reader");
  }
  Story& has(const std::string& name, blackboard::Endpoint endpoint, const std::string& mark = "") {
    endpoint.participant = name;
    endpoint.guid = name + "." + endpoint.topic + mark;
    return see(blackboard::EndpointSeen{endpoint, false});
  }
  /// At `at` seconds, `delay` seconds after it was sent.
  Story& says(const std::string& name, const wire::Sample& sample, double at = 10,
              double delay = 0.001) {
    const std::string topic(wire::slot_name(wire::slot_of(sample)));
    return says_bytes(name, topic, bytes_of(sample), at, delay);
  }
  Story& says_bytes(const std::string& name, const std::string& topic,
                    std::vector<std::uint8_t> bytes, double at = 10, double delay = 0.001) {
    blackboard::SampleSeen seen;
    seen.topic = topic;
    seen.writer = name + "." + topic;
    seen.partition = "world";
    seen.at = Duration::seconds(at) + node::Waker::steady_now();
    seen.heard = 1'800'000'000'000'000'000 + Duration::seconds(at).count();
    seen.sent = seen.heard - Duration::seconds(delay).count();
    seen.bytes = std::move(bytes);
    return see(seen);
  }
  /// A node with its directory entry.
  Story& node(const std::string& name, std::uint32_t number, wire::Role role = wire::Role::kDdn,
              bool ready = true) {
    joins(name).writes(name, wire::Slot::kDirectoryEntry);
    wire::DirectoryEntry entry;
    entry.header.origin = number;
    entry.name = name;
    entry.role = role;
    entry.ready = ready;
    entry.vendor = "fastdds";
    entry.process = 1000 + number;
    return says(name, entry);
  }
  Story& see(blackboard::Sighting sighting) {
    observer_.sightings.push_back(std::move(sighting));
    return *this;
  }

 private:
  FakeObserver& observer_;
};

}  // namespace skein::spy_tool::testing
