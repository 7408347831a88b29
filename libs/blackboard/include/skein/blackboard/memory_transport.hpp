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

/// The shared medium of the transports of one system: it connects writers and readers by partition,
/// immediately and in a fixed order (that of `open`). Like DDS, it gives a reader that connects the
/// last states and the recent events of the writer again.
/// Thread rule: one thread for the hub and all its transports. Must outlive them.
/// A LinkState on the world channel reaches only the two nodes of the link, and readers by pattern:
/// there are as many as pairs of nodes, and other nodes would discard them.
/// Cost of a sample: the readers of its partition, on the world channel those of its slot.
class MemoryHub {
 public:
  /// Delivers `content`, as if from the wire, to every node whose channel on this partition is up.
  /// For tests of malformed content.
  void inject(const std::string& partition, const std::variant<wire::Sample, Malformed>& content);
  /// Switches the radio direction `from` to `to`; initially on. Neither node is told, as in flight,
  /// where the radio itself cuts. Samples written while it is off are lost, except that the last
  /// states are delivered when it is on again (DDS would also deliver recent events).
  void carry(NodeNumber from, NodeNumber to, bool carried);
  /// Switches all directions that no call of carry() was about, before any is.
  void carry_others(bool carried) { others_are_carried_ = carried; }

 private:
  friend class MemoryTransport;
  /// One node's side of a channel.
  struct End {
    MemoryTransport* node = nullptr;
    std::size_t channel = 0;
    bool operator==(const End&) const = default;
  };
  /// The readers of the world channel, which each sample finds without asking all of them.
  struct WorldReaders {
    std::map<NodeNumber, std::vector<End>> of_nodes;  ///< the readers by name
    std::map<wire::Slot, std::vector<End>> of_slots;
    std::vector<End> listeners;  ///< the readers by pattern
  };
  /// The writers of a partition and its readers, by name or by pattern; in the order of `open`.
  /// There are as many as pairs of nodes.
  struct Partition {
    std::vector<End> writers, readers;
    std::unique_ptr<WorldReaders> world;  ///< null on other channels

    void read(const End& reader, bool by_pattern);
  };

  Partition& partition(const std::string& name);
  void join(const End& end, const std::string& partition, bool writes, bool reads);
  void leave(const MemoryTransport& node);
  std::vector<End> writers_for(const End& reader) const;

  bool carries(const MemoryTransport& from, const MemoryTransport& to) const;

  std::uint64_t opened_ = 0;
  std::map<std::string, Partition> partitions_;                ///< written, or read by name
  std::vector<std::pair<std::string, End>> pattern_readers_;   ///< pattern and reader
  std::map<std::pair<NodeNumber, NodeNumber>, bool> carried_;  ///< from, to
  bool others_are_carried_ = true;
};

/// One node's side of a MemoryHub. Its destruction models the death of the node: samples that it
/// wrote and nobody has received are lost.
class MemoryTransport final : public Transport {
 public:
  explicit MemoryTransport(MemoryHub& hub);
  ~MemoryTransport() override;

  Result<void, Failure> open(const TransportPlan& plan) override;
  Result<std::size_t, Failure> add(const ChannelConfig& channel) override;
  bool write(std::size_t channel, const wire::Sample& sample) override;
  Result<void, Failure> set_up(std::size_t channel, bool up) override;
  std::vector<Arrival> take() override;
  void on_arrival(std::function<void()> notify) override { notify_ = std::move(notify); }

 private:
  friend class MemoryHub;
  /// Slot, origin, destination, instance.
  using StateKey = std::tuple<wire::Slot, std::uint32_t, std::uint32_t, std::uint32_t>;
  /// A sample without the room that others would take.
  class Boxed;
  using KeptLinks = std::map<StateKey, wire::LinkState>;
  /// The link states of the world channel, and an index by either node of the link.
  struct Links {
    KeptLinks all;
    std::map<NodeNumber, std::vector<const KeptLinks::value_type*>> of_nodes;
  };
  /// The samples that a writer keeps for readers that connect later.
  struct Kept {
    std::map<StateKey, std::unique_ptr<Boxed>> states;
    std::list<wire::Sample> events;
    std::unique_ptr<Links> links;  ///< null until there are any
  };
  struct Channel {
    bool up = true;  // the members that each sample reads stand together (cache)
    bool writes = false;
    bool reads = false;
    std::bitset<wire::kSlotCount> read_slots;
    bool by_pattern = false;
    ChannelKind kind = ChannelKind::kRadio;
    MemoryHub::Partition* partition = nullptr;
    std::unique_ptr<Kept> kept;  ///< null until needed: most channels never keep a sample
  };
  using KeptState = std::pair<StateKey, wire::Sample>;

  static void remember(Channel& channel, const wire::Sample& sample);
  static void remember_state(Channel& channel, const wire::Sample& sample);
  void put(std::size_t channel, std::variant<wire::Sample, Malformed> content);
  void put_to(const std::vector<MemoryHub::End>& readers, std::size_t channel,
              const wire::Sample& sample);
  /// A channel of this node, connected or not; the hub does not know it yet.
  Channel channel_of(const ChannelConfig& config, const std::vector<wire::Slot>& reads) const;
  void join(std::size_t channel, const std::string& partition);
  void take_what_is_kept();
  /// The writers of other nodes that this channel reads.
  std::vector<MemoryHub::End> writers_for(std::size_t channel);
  static void replay(const MemoryHub::End& writer, const MemoryHub::End& reader);
  static void replay_states(const MemoryHub::End& writer, const MemoryHub::End& reader);
  /// The kept states that the reader is to get, in the order of their keys.
  static std::vector<KeptState> states_for(const Channel& writer, const MemoryHub::End& reader);
  static bool wants(const MemoryHub::End& reader, wire::Slot slot);
  bool is_radio(std::size_t channel) const;
  bool reaches(std::size_t channel, const MemoryHub::End& reader) const;
  static Channel& at(const MemoryHub::End& end) { return end.node->channels_[end.channel]; }

  MemoryHub& hub_;
  NodeNumber self_;
  std::uint64_t order_ = 0;  ///< rank among the transports of the hub, by open()
  std::vector<Channel> channels_;
  std::vector<Arrival> mailbox_;
  std::size_t last_taken_ = 0;  ///< size of the last batch that take() returned
  std::function<void()> notify_;
};

}  // namespace skein::blackboard
