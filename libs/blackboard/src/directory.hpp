// SPDX-License-Identifier: Apache-2.0
// The peers of a node.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "agenda.hpp"
#include "peer.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// The peers, found in the channels of the configuration: by number, by the channel that they speak
/// over, and by when they are due. Those that it names no channels of are added when they are met
/// (Config::channels_with). A peer stays where it is. Thread rule: one thread.
class Directory {
 public:
  /// Both outlive it. Channels of those that are met are added to the configuration.
  Directory(Config& config, Transport& transport);
  /// The failure says which channels make no sense.
  Result<void, Failure> open();

  /// The peer with this number, which is added if it was not met yet; null: it is no peer.
  Peer* meet(NodeNumber number, Now now);
  /// Null: it was not met.
  Peer* find(NodeNumber number);
  const Peer* find(NodeNumber number) const;
  /// Precondition: it was met.
  Peer& at(NodeNumber number) { return peers_.at(number); }
  const Peers& all() const { return peers_; }
  /// Who speaks over that channel; null: no peer.
  Peer* over(std::size_t channel) const { return senders_[channel]; }
  /// The peer that is the origin of a sample that came over that channel, which may be another
  /// than who speaks over it; null: the origin is none.
  Peer* origin(std::size_t channel, const wire::SampleHeader& header);
  std::optional<std::size_t> world() const { return world_; }

  /// To be called after each change of a peer.
  void plan(const Peer& peer);
  const Agenda& agenda() const { return agenda_; }

 private:
  Result<void, Failure> add_channel(std::size_t index);

  Config& config_;
  Transport& transport_;
  Session no_session_;  ///< with whom nothing has passed yet
  Peers peers_;
  std::vector<Peer*> senders_;  ///< by channel; null where there is no peer
  Agenda agenda_;
  std::optional<std::size_t> world_;
};

}  // namespace skein::blackboard
