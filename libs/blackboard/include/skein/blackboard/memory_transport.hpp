// SPDX-License-Identifier: Apache-2.0
// A transport inside one process, for the virtual runtime and for tests.
#pragma once

#include <bitset>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

class MemoryTransport;

/// What the transports of one system share: it connects writers and readers by partition, at once
/// and in a fixed order (that of `open`). It behaves as DDS does where that matters: a reader that
/// connects gets the last states and the recent events of the writer again.
/// Thread rule: one thread for the hub and all its transports. Must outlive them.
/// A link state of the world reaches the two nodes it is about, and who reads by a pattern: there
/// are as many as pairs of nodes, and everybody else would throw them away.
/// Cost: a sample is looked at by those who read its partition, whoever else there is.
class MemoryHub {
 public:
  /// Gives a reader side something as if from the wire, whatever it is; to every node that has this
  /// partition up. For tests of what arrives malformed.
  void inject(const std::string& partition, const std::variant<wire::Sample, Malformed>& content);
  /// Whether what `from` writes to `to` over radio gets there; at the start it does. Neither of the
  /// two is told, as in flight, where the radio itself cuts. What is written meanwhile does not
  /// come later, but for the last states, with the restoration: less than what DDS does.
  void carry(NodeNumber from, NodeNumber to, bool carried);

 private:
  friend class MemoryTransport;
  /// A channel of a node.
  struct End {
    MemoryTransport* node = nullptr;
    std::size_t channel = 0;
    bool operator==(const End&) const = default;
  };
  /// Who writes under a name, and who reads that, by a pattern too; in the order of `open`.
  struct Partition {
    std::vector<End> writers, readers;
    /// Of the readers, by their nodes: those who read by this name, not by a pattern.
    std::map<NodeNumber, std::vector<End>> of_nodes;
    std::vector<End> listeners;  ///< of the readers: by a pattern

    void listen(const End& reader) {
      readers.push_back(reader);
      listeners.push_back(reader);
    }
  };

  Partition& partition(const std::string& name);
  void join(const End& end, const std::string& partition, bool writes, bool reads);
  void leave(const MemoryTransport& node);
  std::vector<End> writers_for(const End& reader) const;

  bool carries(const MemoryTransport& from, const MemoryTransport& to) const;

  std::uint64_t opened_ = 0;
  std::map<std::string, Partition> partitions_;               ///< that are written, or read by name
  std::vector<std::pair<std::string, End>> pattern_readers_;  ///< of any partition that matches
  std::set<std::pair<NodeNumber, NodeNumber>> silenced_;      ///< from, to
};

/// One node's side of a MemoryHub. Its destruction is the death of the node: what it wrote and
/// nobody had received is gone.
class MemoryTransport final : public Transport {
 public:
  explicit MemoryTransport(MemoryHub& hub) : hub_(hub) {}
  ~MemoryTransport() override;

  Result<void, Failure> open(const TransportPlan& plan) override;
  bool write(std::size_t channel, const wire::Sample& sample) override;
  Result<void, Failure> set_up(std::size_t channel, bool up) override;
  std::vector<Arrival> take() override;
  void on_arrival(std::function<void()> notify) override { notify_ = std::move(notify); }

 private:
  friend class MemoryHub;
  /// Slot, origin, destination, instance.
  using StateKey = std::tuple<wire::Slot, std::uint32_t, std::uint32_t, std::uint32_t>;
  /// What a writer keeps for readers that connect later.
  struct Kept {
    std::map<StateKey, wire::Sample> states;
    std::list<wire::Sample> events;
    /// Of the world, what is about two nodes only; and by either of the two.
    std::map<StateKey, wire::LinkState> links;
    std::map<NodeNumber, std::map<StateKey, const wire::LinkState*>> links_of;
  };
  struct Channel {
    bool up = true;  // what each sample asks for, together
    bool writes = false;
    bool reads = false;
    std::bitset<wire::kSlotCount> read_slots;
    bool by_pattern = false;
    ChannelKind kind = ChannelKind::kRadio;
    MemoryHub::Partition* partition = nullptr;
    std::unique_ptr<Kept> kept;  ///< most channels never have anything
  };
  using KeptState = std::pair<StateKey, wire::Sample>;

  void remember(Channel& channel, const wire::Sample& sample) const;
  void put(std::size_t channel, std::variant<wire::Sample, Malformed> content);
  void put_to(const std::vector<MemoryHub::End>& readers, std::size_t channel,
              const wire::Sample& sample);
  void take_what_is_kept();
  /// Of other nodes.
  std::vector<MemoryHub::End> writers_for(std::size_t channel);
  static void replay(const MemoryHub::End& writer, const MemoryHub::End& reader);
  static void replay_states(const MemoryHub::End& writer, const MemoryHub::End& reader);
  /// For that reader, in the order of their keys.
  static std::vector<KeptState> states_for(const Channel& writer, const MemoryHub::End& reader);
  static bool wants(const MemoryHub::End& reader, wire::Slot slot);
  bool is_radio(std::size_t channel) const;
  bool reaches(std::size_t channel, const MemoryHub::End& reader) const;
  static Channel& at(const MemoryHub::End& end) { return end.node->channels_[end.channel]; }

  MemoryHub& hub_;
  NodeNumber self_;
  std::uint64_t order_ = 0;  ///< in which it was opened
  std::vector<Channel> channels_;
  std::vector<Arrival> mailbox_;
  std::size_t last_taken_ = 0;  ///< so many at once
  std::function<void()> notify_;
};

}  // namespace skein::blackboard
