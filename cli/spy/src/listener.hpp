// SPDX-License-Identifier: Apache-2.0
// DDS readers of the spy in any partitions, without writers.
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

/// A received sample that matches the options.
class Heard {
 public:
  /// `slot`: nothing for foreign types. All references must outlive this object.
  Heard(const blackboard::SampleSeen& raw, const blackboard::Endpoint* writer,
        std::optional<wire::Slot> slot)
      : raw_(raw), writer_(writer), slot_(slot) {}

  const blackboard::SampleSeen& raw() const { return raw_; }
  /// The writer; null if it has left meanwhile.
  const blackboard::Endpoint* writer() const { return writer_; }
  std::optional<wire::Slot> slot() const { return slot_; }
  /// Whether the sample only reports the end of an instance, without content.
  bool gone() const { return raw_.bytes.empty(); }
  /// The content, decoded on first use. Precondition: slot(), not gone().
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

/// Opens a reader as soon as a writer of a wanted topic is discovered, with the QoS that nodes
/// request, or, for foreign types, with the QoS that the writer offers.
class Listener {
 public:
  using Use = std::function<bool(const Heard&)>;

  /// The options outlive it.
  Listener(const SpyOptions& options, std::unique_ptr<blackboard::Observer> observer);

  /// Slots that are no slots, with the nearest that are.
  Diagnostics check() const;
  Result<void, Failure> open();
  /// Sets a callback for each sighting, called before `use`; like `use` it may end listen().
  void on_sighting(std::function<bool(const blackboard::Sighting&)> told) {
    told_ = std::move(told);
  }
  /// Of this slot reads only what is written from now on.
  void without_history_of(wire::Slot slot) { without_history_.insert(slot); }
  /// Reads these slots, whatever else the options say.
  void read_only(std::set<wire::Slot> slots) { only_ = std::move(slots); }
  /// Takes samples only when listen() begins and ends, instead of at each arrival, for recording at
  /// high rates; samples keep their arrival times. Precondition: before open().
  void look_in_turns() { in_turns_ = true; }
  /// Hands over everything heard until `until` (none: for ever), Ctrl-C, or `use` says false; then
  /// gives false, and what comes after waits for the next call.
  bool listen(std::optional<Duration> until, const Use& use);

  const Graph& graph() const { return graph_; }
  bool wanted(wire::Slot slot) const;
  bool interrupted() const { return waker_.stop_requested(); }
  /// Operations refused by DDS: joining the domain, or reading a topic.
  const std::vector<std::string>& refused() const { return refused_; }
  /// Number of samples skipped because of the option `from`.
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
/// The QoS that nodes request for a slot.
blackboard::EndpointQos qos_of(wire::Slot slot);
/// The reader that a node would have of the slot.
blackboard::Endpoint reader_of(wire::Slot slot, std::vector<std::string> partitions);

}  // namespace skein::spy_tool
