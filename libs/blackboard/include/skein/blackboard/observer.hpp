// SPDX-License-Identifier: Apache-2.0
// The port through which a DDS domain is observed: its participants, its endpoints, and the bytes
// of any topic.
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

/// In the order of DDS: each includes the guarantees of those before it.
enum class Durability : std::uint8_t { kVolatile, kTransientLocal, kTransient, kPersistent };

/// The QoS policies that decide whether a writer and a reader match, and a writer's lifespan.
struct EndpointQos {
  bool reliable = false;
  Durability durability = Durability::kVolatile;
  bool exclusive = false;  ///< ownership
  /// Longest time between two samples of an instance; max(): none.
  Duration deadline = Duration::max();
  Duration lifespan = Duration::max();
  bool operator==(const EndpointQos&) const = default;
};

/// A DDS participant of the domain.
struct Participant {
  std::string guid;  ///< 24 hexadecimal digits
  std::string name;  ///< its participant name; may be empty
  std::string vendor;
  std::vector<std::string> addresses;  ///< "10.0.0.1:7411": its locators for user data
  std::string description;             ///< its user data, see program_description.hpp; may be empty
  bool operator==(const Participant&) const = default;
};

struct Endpoint {
  std::string guid;         ///< GUID of its participant, a dot, and 8 digits
  std::string participant;  ///< GUID
  bool writer = false;
  bool keyed = false;
  std::string topic, type;
  std::vector<std::string> partitions;  ///< none: the default one
  EndpointQos qos;
  bool operator==(const Endpoint&) const = default;
};

/// A participant was discovered, or (`changed`) its data changed.
struct ParticipantSeen {
  Participant participant;
  bool changed = false;
};
struct ParticipantGone {
  std::string guid;
  bool silent = false;  ///< its lease expired without a farewell
};
/// An endpoint was discovered, or (`changed`) its QoS changed, mostly its partitions.
struct EndpointSeen {
  Endpoint endpoint;
  bool changed = false;
};
struct EndpointGone {
  std::string guid;
};
/// A sample, or the notice that an instance was disposed of or has no writer left.
struct SampleSeen {
  std::string topic;
  std::string writer;               ///< GUID
  std::string partition;            ///< first partition of the writer; empty: the default one
  std::int64_t sent = 0;            ///< by the writer's clock [ns since 1970]; 0: unknown
  std::int64_t heard = 0;           ///< arrival by this machine's clock [ns since 1970]
  Duration at;                      ///< arrival in steady time
  std::vector<std::uint8_t> bytes;  ///< CDR behind its 4-byte header; empty: the instance is gone
};

using Sighting =
    std::variant<ParticipantSeen, ParticipantGone, EndpointSeen, EndpointGone, SampleSeen>;

/// A topic that an observer reads.
struct Subscription {
  std::string topic, type;
  bool keyed = true;
  std::vector<std::string> partitions;  ///< DDS patterns, with * and ?
  EndpointQos qos;                      ///< requested by the reader
  bool operator==(const Subscription&) const = default;
};

/// Observes a domain without writing. Reports discovery from open() on, and samples of the topics
/// given to read(). Thread rule: all calls from one thread; the callback comes from any.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  /// To be called once, before everything else.
  virtual Result<void, Failure> open() = 0;
  /// Reads the topic from now on. Fails, for example, if it is read already with another type.
  virtual Result<void, Failure> read(const Subscription& subscription) = 0;
  /// The sightings since the last call, in order.
  virtual std::vector<Sighting> take() = 0;
  /// Sets the callback that is called soon after each sighting. It must neither block nor call the
  /// observer.
  virtual void on_sighting(std::function<void()> notify) = 0;
};

/// Why DDS does not match a writer and a reader of the same topic, partitions left aside: one
/// sentence for each cause. Empty: they match. Source: DDS 1.4, 2.2.3.
std::vector<std::string> refusals(const Endpoint& writer, const Endpoint& reader);

/// Whether a writer and a reader in these partitions match. Patterns are those of fnmatch; two
/// different patterns do not match. Source: DDS 1.4, 2.2.3.13.
bool partitions_meet(const std::vector<std::string>& a, const std::vector<std::string>& b);

}  // namespace skein::blackboard
