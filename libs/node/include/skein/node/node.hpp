// SPDX-License-Identifier: Apache-2.0
// The shape of every node: messages, time and job results in; messages, records and jobs out.
#pragma once

#include <any>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/foundation/time.hpp"
#include "skein/journal/record.hpp"

namespace skein::node {

using blackboard::NodeNumber;

/// First input of a node's life.
struct Started {
  std::uint64_t incarnation = 1;  ///< above 1: it was restarted in this mission
};
/// A sample, well formed, new and in order. `header_of(sample).origin` is who made it.
struct Received {
  NodeNumber from;
  wire::Sample sample;
};
/// What this node now believes of a peer. Source: spec 1.3 (reachability).
struct Reachability {
  NodeNumber peer;
  bool reachable = false;
  bool restarted = false;
};
/// An event this node sent was not acknowledged before it expired, or, if a receipt was asked for,
/// was refused at once (then `sequence` is 0).
struct Undelivered {
  NodeNumber to;
  wire::Slot slot = wire::Slot::kTaskRequest;
  std::uint64_t sequence = 0;
  std::uint64_t receipt = 0;  ///< that was asked for (Send)
  /// False: the peer was out of contact all the time. True: only its acknowledgement may be
  /// missing.
  bool may_have_arrived = true;
};
/// An event this node sent and asked a receipt for (Send) is with the peer's node.
struct Delivered {
  NodeNumber to;
  std::uint64_t receipt = 0;
};
/// What a job was told of its time: whether it had a clock at all, and how often that said that
/// there was time left before it first said, if ever, that there was none.
struct JobClock {
  bool given = false;
  bool ran_out = false;
  std::uint64_t questions = 0;  ///< answered with "not yet"
  bool operator==(const JobClock&) const = default;
};
/// The result of a job, as its work returned it.
struct JobDone {
  std::uint64_t id = 0;
  std::any result;
  JobClock clock{};
};
/// The instant given by next_wakeup() has come.
struct Wakeup {};

using Input =
    std::variant<Started, Received, Reachability, Undelivered, Delivered, JobDone, Wakeup>;

/// Sends to one peer; the header is stamped on the way. A refusal is logged.
struct Send {
  NodeNumber to;
  wire::Sample sample;
  /// Of an event; the lifespan of its slot may end before (SlotTable).
  MissionTime expires = MissionTime::max();
  std::uint64_t receipt = 0;  ///< of an event, above 0: Delivered is wanted, with this number
};
/// Sends to everybody over the world channel. A refusal is logged.
struct Publish {
  wire::Sample sample;
};
/// A line of the event log.
struct Log {
  journal::Record record;
};
/// The clock of a job: whether it has had its time. May be empty: it has all the time it needs.
using TimeIsUp = std::function<bool()>;
/// A long computation. `work` owns its inputs, touches nothing shared and may run in any thread;
/// its result comes back as JobDone. Who runs it may fill the clock: a daemon does, virtual time
/// stands still meanwhile and so never ends a job. Source: spec 1.5.
struct StartJob {
  std::uint64_t id = 0;
  std::function<std::any(const TimeIsUp&)> work;
  Duration at_most = Duration::max();  ///< from when it begins to run
};
/// Nobody wants the result of this job any more: its clock says at once that it has had its time.
/// Its result comes back all the same.
struct StopJob {
  std::uint64_t id = 0;
};
/// The mission is over; a runtime may stop everything soon after.
struct Finish {};

using Effect = std::variant<Send, Publish, Log, StartJob, StopJob, Finish>;
using Effects = std::vector<Effect>;

/// A node of the system, without input or output of its own. `now` never decreases from call to
/// call. Thread rule: one thread at a time. Source: spec 1.5.
class Node {
 public:
  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  virtual ~Node() = default;

  virtual Effects handle(const Input& input, MissionTime now) = 0;
  /// When it next wants a Wakeup, if nothing comes before; after a Wakeup, later than its instant.
  /// Only handle() changes it: it is asked once after that.
  virtual std::optional<MissionTime> next_wakeup() const = 0;

  /// From here on it is given what a former life was given, and does what that did. Of what it
  /// publishes (states of the world channel) only the last is of account: it need not make any.
  virtual void begin_recall() {}
  /// That is over. Gives what it did not publish meanwhile, as it is now.
  virtual Effects end_recall() { return {}; }
};

}  // namespace skein::node
