// SPDX-License-Identifier: Apache-2.0
// A transport inside one process, for the virtual runtime and for tests.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

class MemoryTransport;

/// What the transports of one system share: it connects writers and readers by partition, at once
/// and in a fixed order (that of `open`). It behaves as DDS does where that matters: a reader that
/// connects gets the last states and the recent events of the writer again.
/// Thread rule: one thread for the hub and all its transports. Must outlive them.
class MemoryHub {
 public:
  /// Gives a reader side something as if from the wire, whatever it is; to every node that has this
  /// partition up. For tests of what arrives malformed.
  void inject(const std::string& partition, const std::variant<wire::Sample, Malformed>& content);

 private:
  friend class MemoryTransport;
  std::vector<MemoryTransport*> nodes_;
};

/// One node's side of a MemoryHub. Its destruction is the death of the node: what it wrote and
/// nobody had received is gone.
class MemoryTransport final : public Transport {
 public:
  explicit MemoryTransport(MemoryHub& hub) : hub_(hub) {}
  ~MemoryTransport() override;

  Result<void, Failure> open(const TransportPlan& plan) override;
  bool write(std::size_t channel, const wire::Sample& sample) override;
  void set_up(std::size_t channel, bool up) override;
  std::vector<Arrival> take() override;
  void on_arrival(std::function<void()> notify) override { notify_ = std::move(notify); }

 private:
  friend class MemoryHub;
  struct Channel {
    ChannelConfig config;
    bool up = true;
    bool writes = false;
    bool reads = false;
    std::vector<wire::Slot> read_slots;
    /// What a writer keeps for readers that connect later.
    std::map<std::pair<wire::Slot, std::uint32_t>, wire::Sample> states;
    std::deque<wire::Sample> events;
  };

  void remember(Channel& channel, const wire::Sample& sample) const;
  /// Offers the sample to every reader of this node that is connected to the partition.
  void offer(const std::string& partition, const wire::Sample& sample);
  void put(std::size_t channel, std::variant<wire::Sample, Malformed> content);
  static void replay(const Channel& writer, MemoryTransport& node, std::size_t reader);

  MemoryHub& hub_;
  std::vector<Channel> channels_;
  std::vector<Arrival> mailbox_;
  std::function<void()> notify_;
};

}  // namespace skein::blackboard
