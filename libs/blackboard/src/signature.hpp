// SPDX-License-Identifier: Apache-2.0
// The headers of what a node says.
#pragma once

#include <cstdint>

#include "peer.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Gives samples their headers: this node as their origin, in the incarnation that it has towards
/// who is to have them, and numbers that rise over all states, streams and world events. To
/// everybody it has the greatest incarnation that it has towards anybody.
class Signature {
 public:
  /// The configuration outlives it.
  explicit Signature(const Config& config);

  /// A state or a stream. Returns its number.
  std::uint64_t sign(wire::SampleHeader& header, const Peer& to, Now now);
  /// Events are numbered by their session. `expires`: see SendOptions.
  void sign_event(wire::Sample& event, const Peer& to, MissionTime expires, Now now) const;
  /// A sample to everybody. Returns its number.
  std::uint64_t sign_published(wire::SampleHeader& header, Now now);
  /// The heartbeats to everybody are numbered apart.
  void sign_published(wire::SampleHeader& header, std::uint64_t number, Now now) const;
  /// What was said before is said again by that incarnation.
  void renew(wire::SampleHeader& header, std::uint64_t incarnation);

  /// Towards some peer this node has that incarnation from now on. True if it is the greatest.
  bool become(std::uint64_t incarnation);
  /// Towards everybody.
  std::uint64_t incarnation() const { return incarnation_; }
  /// The number given last; at first that of the last one of earlier lives, or less.
  std::uint64_t last_number() const { return number_; }

 private:
  const Config& config_;
  std::uint64_t number_;
  std::uint64_t incarnation_;
};

}  // namespace skein::blackboard
