// SPDX-License-Identifier: Apache-2.0
// The spy's ears: readers in any partitions, no writers.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "graph.hpp"
#include "skein/blackboard/observer.hpp"
#include "skein/blackboard/transport.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/node/waker.hpp"
#include "skein/spy_tool/spy.hpp"

namespace skein::spy_tool {

using Content = std::variant<wire::Sample, blackboard::Malformed>;

/// A sample that was asked for.
class Heard {
 public:
  /// `slot`: nothing if its type is none of ours. All references outlive it.
  Heard(const blackboard::SampleSeen& raw, const blackboard::Endpoint* writer,
        std::optional<wire::Slot> slot)
      : raw_(raw), writer_(writer), slot_(slot) {}

  const blackboard::SampleSeen& raw() const { return raw_; }
  /// Null if it has left meanwhile.
  const blackboard::Endpoint* writer() const { return writer_; }
  std::optional<wire::Slot> slot() const { return slot_; }
  /// An instance came to its end; there is no content.
  bool gone() const { return raw_.bytes.empty(); }
  /// Decoded when it is asked for. Precondition: slot(), not gone().
  const Content& content() const;
  const wire::Sample* sample() const;
  /// All zero where there is none.
  wire::SampleHeader header() const;

 private:
  const blackboard::SampleSeen& raw_;
  const blackboard::Endpoint* writer_;
  std::optional<wire::Slot> slot_;
  mutable std::optional<Content> content_;
};

/// Opens a reader as soon as a writer of what is wanted is found, with the QoS that nodes ask for,
/// or, of types that are none of ours, with what that writer offers.
class Listener {
 public:
  using Use = std::function<bool(const Heard&)>;

  /// The options outlive it.
  Listener(const SpyOptions& options, std::unique_ptr<blackboard::Observer> observer);

  /// Slots that are no slots, with the nearest that are.
  Diagnostics check() const;
  Result<void, Failure> open();
  /// Told of each sighting, before its sample is used; may end listen() as `use` does.
  void on_sighting(std::function<bool(const blackboard::Sighting&)> told) {
    told_ = std::move(told);
  }
  /// Of this slot reads only what is written from now on.
  void without_history_of(wire::Slot slot) { without_history_.insert(slot); }
  /// Reads these slots, whatever else the options say.
  void read_only(std::set<wire::Slot> slots) { only_ = std::move(slots); }
  /// Before open(): looks when listen() begins and ends, not at each sample; for who writes down
  /// much and has no haste. Samples know when they were heard.
  void look_in_turns() { in_turns_ = true; }
  /// Hands over everything heard until `until` (none: for ever), Ctrl-C, or `use` says false; then
  /// gives false, and what comes after waits for the next call.
  bool listen(std::optional<Duration> until, const Use& use);

  const Graph& graph() const { return graph_; }
  bool wanted(wire::Slot slot) const;
  bool interrupted() const { return waker_.stop_requested(); }
  /// What DDS refused: to take part, or to read a topic.
  const std::vector<std::string>& refused() const { return refused_; }
  /// Samples that were passed over because of `from`.
  std::uint64_t of_others() const { return of_others_; }

 private:
  bool take(const blackboard::Sighting& sighting, const Use& use);
  bool hear(const blackboard::SampleSeen& sample, const Use& use);
  void attend(const blackboard::Endpoint& writer);
  std::optional<blackboard::Subscription> subscription_to(const blackboard::Endpoint& writer) const;
  bool wants_topic(const std::string& topic) const;

  const SpyOptions& options_;
  bool in_turns_ = false;
  node::Waker waker_;  // before the observer's threads: it blocks signals for them too
  std::unique_ptr<blackboard::Observer> observer_;
  std::deque<blackboard::Sighting> waiting_;  ///< when `use` wanted no more
  Graph graph_;
  std::function<bool(const blackboard::Sighting&)> told_;
  std::vector<blackboard::Subscription> subscriptions_;
  std::vector<std::string> refused_;
  std::optional<std::set<wire::Slot>> only_;
  std::set<wire::Slot> without_history_;
  std::uint64_t of_others_ = 0;
};

/// Nothing where the topic or the type is none of ours.
std::optional<wire::Slot> slot_of(const blackboard::Endpoint& endpoint);
/// What nodes ask for of a slot.
blackboard::EndpointQos qos_of(wire::Slot slot);
/// The reader that a node would have of the slot.
blackboard::Endpoint reader_of(wire::Slot slot, std::vector<std::string> partitions);

}  // namespace skein::spy_tool
