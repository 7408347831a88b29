// SPDX-License-Identifier: Apache-2.0
// The blackboard's transport over Fast DDS.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// A sample as it came, malformed or not.
struct RawSample {
  wire::Slot slot = wire::Slot::kHeartbeat;
  std::string partition;                ///< of its writer; empty if it is in none
  std::int64_t source_time = 0;         ///< of its writer [ns since 1970]
  std::span<const std::uint8_t> bytes;  ///< CDR behind its 4-byte header
};

struct FastDdsConfig {
  std::uint32_t domain = 0;      ///< 0 to 100, so that its ports stay below the ephemeral ones
  std::string participant_name;  ///< shown by DDS tools
  NetworkConfig network;
  /// Warnings and errors of the middleware, one line each, from any of its threads; they go nowhere
  /// else. The middleware's log is one per process: the last transport opened receives it.
  std::function<void(const std::string&)> log;
  /// With keys: who has which number. A sample that says it is of a node whose certificate its
  /// writer does not have is malformed. Empty: that is not checked (a spy).
  std::map<NodeNumber, std::string> names = {};
  /// Told of every sample that is taken from a reader, from any of the middleware's threads: for
  /// recorders.
  std::function<void(const RawSample&)> tap = {};
};

/// One participant over UDP; each channel has its own publisher and subscriber, and cutting it
/// moves both out of the partition. Topics are named after the slots, types are those of idl/.
/// Decoding happens in the middleware's threads, into a mailbox. Destruction waits, two seconds at
/// most, until all readers have got what was written to the world channel. Environment variables
/// and profile files of Fast DDS have no effect.
class FastDdsTransport final : public Transport {
 public:
  explicit FastDdsTransport(FastDdsConfig config);
  ~FastDdsTransport() override;

  Result<void, Failure> open(const TransportPlan& plan) override;
  bool write(std::size_t channel, const wire::Sample& sample) override;
  void set_up(std::size_t channel, bool up) override;
  std::vector<Arrival> take() override;
  void on_arrival(std::function<void()> notify) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
