// SPDX-License-Identifier: Apache-2.0
// The nodes that are heard over the world channel only.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sessions/lives.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Steady time between two heartbeats that a node publishes, whatever its heartbeat period: readers
/// of the world channel do not know that. A little less than a second, as in Peer.
inline constexpr Duration kPublishedHeartbeat = Duration::milliseconds(950);

/// Which process is the node, of nodes that are no peers, by the heartbeats that they publish (see
/// Rival); and what of their samples is new. Of a node that publishes no heartbeats the sample of
/// the greatest incarnation counts, for each slot and instance.
///
/// | sample of                          | state                             | stream  | event     |
/// |------------------------------------|-----------------------------------|---------|-----------|
/// | the node, or a later life of it    | delivered                         | same    | same      |
/// | the former life, not yet silent    | kept until it is the node again   | dropped | delivered |
/// | a second process, which is refused | kept until it is the node         | refused | refused   |
///
/// Thread rule: one thread. Cost of a sample: logarithmic in the states of its node.
class Publishers {
 public:
  explicit Publishers(const Config& config);

  /// A heartbeat that was published. Returns why it is refused. Samples that are to be delivered
  /// because another process is the node from now on are added to `out`.
  std::optional<wire::Violation> hear(const wire::Heartbeat& heartbeat, Duration now,
                                      std::vector<Incoming>& out);
  /// Any other sample; it is added to `out` if it is new. Returns why it is refused.
  std::optional<wire::Violation> take(wire::Sample sample, Duration now,
                                      std::vector<Incoming>& out);

 private:
  /// Slot, instance.
  using Key = std::pair<wire::Slot, std::uint32_t>;
  /// The newest sample of one life.
  struct Word {
    std::uint64_t incarnation = 0;
    std::uint64_t sequence = 0;
    std::optional<wire::Sample> state;
  };
  struct Publisher {
    explicit Publisher(const Config& config) : lives(config) {}
    Lives lives;
    bool has_heartbeats = false;
    int older_words = 0;  ///< heartbeats of a life before the former one
    std::map<Key, std::vector<Word>> words;
  };

  Publisher& of(const wire::SampleHeader& header);
  /// The word of that life, which is new if its sequence number is 0; null if the life is over.
  static Word* word_of(Publisher& publisher, const Key& key, std::uint64_t incarnation);
  static bool is_heard(const Publisher& publisher, Duration now);
  static void follow(Publisher& publisher, std::uint64_t incarnation, Duration now,
                     std::vector<Incoming>& out);
  /// All states that the present life has said.
  static void tell_states(const Publisher& publisher, std::vector<Incoming>& out);

  Config config_;  ///< without channels
  std::unordered_map<NodeNumber, Publisher> publishers_;
};

}  // namespace skein::blackboard
