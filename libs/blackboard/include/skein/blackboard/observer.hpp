// SPDX-License-Identifier: Apache-2.0
// The port through which a DDS domain is watched: who takes part, which endpoints there are, and
// the bytes of any topic.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// In the order of DDS: each gives what those before it give.
enum class Durability : std::uint8_t { kVolatile, kTransientLocal, kTransient, kPersistent };

/// Of QoS, what decides whether a writer and a reader may be matched, and a writer's lifespan.
struct EndpointQos {
  bool reliable = false;
  Durability durability = Durability::kVolatile;
  bool exclusive = false;  ///< ownership
  /// Between two samples of an instance; none: max().
  Duration deadline = Duration::max();
  Duration lifespan = Duration::max();
  bool operator==(const EndpointQos&) const = default;
};

/// A process, or a part of one, that takes part in the domain.
struct Participant {
  std::string guid;  ///< 24 hexadecimal digits
  std::string name;  ///< as it calls itself; may be empty
  std::string vendor;
  std::vector<std::string> addresses;  ///< "10.0.0.1:7411", of its data
  std::string description;             ///< see program_description.hpp; empty: it says nothing
  bool operator==(const Participant&) const = default;
};

struct Endpoint {
  std::string guid;         ///< its participant's, a dot, and 8 digits
  std::string participant;  ///< guid
  bool writer = false;
  bool keyed = false;
  std::string topic, type;
  std::vector<std::string> partitions;  ///< none: the default one
  EndpointQos qos;
  bool operator==(const Endpoint&) const = default;
};

/// A participant was found, or says something else of itself.
struct ParticipantSeen {
  Participant participant;
  bool changed = false;
};
struct ParticipantGone {
  std::string guid;
  bool silent = false;  ///< it did not say goodbye: its lease ran out
};
/// An endpoint was found, or its QoS (that is, mostly, its partition) is another.
struct EndpointSeen {
  Endpoint endpoint;
  bool changed = false;
};
struct EndpointGone {
  std::string guid;
};
/// A sample as it came, or that an instance was disposed of or left by its writers.
struct SampleSeen {
  std::string topic;
  std::string writer;               ///< guid
  std::string partition;            ///< of its writer, the first; empty: the default one
  std::int64_t sent = 0;            ///< by the writer's clock [ns since 1970]; 0: it does not say
  std::int64_t heard = 0;           ///< by this machine's [ns since 1970]
  Duration at;                      ///< likewise, steady
  std::vector<std::uint8_t> bytes;  ///< CDR behind its 4-byte header; none: the instance is gone
};

using Sighting =
    std::variant<ParticipantSeen, ParticipantGone, EndpointSeen, EndpointGone, SampleSeen>;

/// What an observer reads.
struct Subscription {
  std::string topic, type;
  bool keyed = true;
  std::vector<std::string> partitions;  ///< with * and ? as DDS has them
  EndpointQos qos;                      ///< asked for
  bool operator==(const Subscription&) const = default;
};

/// Watches without a writer of its own. Discovery is told from open() on, samples only of what
/// read() asks for. Thread rule: all calls from one thread; the callback comes from any.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  /// Once, before everything else.
  virtual Result<void, Failure> open() = 0;
  /// From now on. Fails where the topic is read already with another type, for one.
  virtual Result<void, Failure> read(const Subscription& subscription) = 0;
  /// What was seen since the last call, in order.
  virtual std::vector<Sighting> take() = 0;
  /// Called soon after something was seen; it must not call back and not block.
  virtual void on_sighting(std::function<void()> notify) = 0;
};

/// Why DDS keeps a writer and a reader of the same topic apart, apart from partitions: a sentence
/// for each cause. Empty: it does not. Source: DDS 1.4, 2.2.3.
std::vector<std::string> refusals(const Endpoint& writer, const Endpoint& reader);

/// Whether a writer and a reader in these partitions meet. Source: DDS 1.4, 2.2.3.13: patterns as
/// of fnmatch, of which at most one side's counts.
bool partitions_meet(const std::vector<std::string>& a, const std::vector<std::string>& b);

}  // namespace skein::blackboard
