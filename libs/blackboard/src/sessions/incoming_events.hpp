// SPDX-License-Identifier: Apache-2.0
// The receiving half of an event session with one peer.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "novelty.hpp"
#include "skein/blackboard/blackboard.hpp"

namespace skein::blackboard {

/// Puts the events of one peer in order and delivers each once.
///
/// | from    | what comes                       | to                                              |
/// |---------|----------------------------------|-------------------------------------------------|
/// | any     | greater incarnation              | waiting, nothing buffered                       |
/// | any     | smaller incarnation              | same (ignored)                                  |
/// | waiting | event                            | waiting, event buffered                         |
/// | waiting | heartbeat that has heard of us   | open, next = its events_from                    |
/// | waiting | any other heartbeat              | waiting                                         |
/// | open    | event next                       | open, it and buffered successors are delivered  |
/// | open    | event after next                 | open, event buffered                            |
/// | open    | event before next                | open (already handled)                          |
/// | open    | heartbeat, events_from > next    | open, what lies between is lost                 |
///
/// The session waits because DDS gives old events again to readers that connect late, and only the
/// sender knows which of them an earlier incarnation of this node has handled. A heartbeat that
/// does not name this incarnation may have been sent before the sender knew of it.
class IncomingEvents {
 public:
  IncomingEvents(NodeNumber self, std::uint64_t self_incarnation)
      : self_(self), self_incarnation_(self_incarnation) {}

  /// An event; it may be empty if it was malformed: then it only fills its place in the sequence.
  Novelty on_event(const wire::SampleHeader& header, std::optional<wire::Sample> event);
  void on_heartbeat(const wire::Heartbeat& heartbeat, std::vector<Incoming>& out);
  /// Delivers the next events as far as there is no gap; expired ones are reported instead.
  void deliver(ChannelKind kind, MissionTime now, std::vector<Incoming>& out);

  /// Towards the peer this node has this incarnation from now on.
  void become(std::uint64_t self_incarnation) { self_incarnation_ = self_incarnation; }
  /// All delivered events count as handled from now on.
  void commit();
  /// The event was handled in a former life.
  void recall(const wire::SampleHeader& header);
  /// The acknowledged sequence number for the heartbeat to the peer; 0 while waiting.
  std::uint64_t ack_sequence() const { return open_ ? handled_ : 0; }
  /// Whether an acknowledgement now would spare the peer repetitions.
  bool owes_acknowledgement() const { return owes_; }
  void acknowledged() { owes_ = false; }
  /// Contact has begun: the transport may give its history again.
  void begin_contact() {
    last_again_ = 0;
    runs_again_ = 0;
  }

 private:
  bool enter(std::uint64_t incarnation);
  /// Of a tombstone: nobody waits for those that it tells of.
  void keep_places_before(const wire::SampleHeader& tombstone);
  Novelty handled_before(std::uint64_t sequence);

  NodeNumber self_;
  std::uint64_t self_incarnation_;
  std::uint64_t incarnation_ = 0;  ///< of the peer
  bool open_ = false;
  std::uint64_t next_ = 1;
  std::uint64_t handled_ = 0;
  std::uint64_t settled_ = 0;     ///< the sender holds no events before this one
  std::uint64_t last_again_ = 0;  ///< the last settled event that came again
  std::uint32_t runs_again_ = 0;  ///< how often such events began anew with an earlier one
  bool owes_ = false;
  std::map<std::uint64_t, std::optional<wire::Sample>> buffer_;
};

}  // namespace skein::blackboard
