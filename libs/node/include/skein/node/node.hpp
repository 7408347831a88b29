// SPDX-License-Identifier: Apache-2.0
// The interface of every node: messages, time and job results in; messages, records and jobs out.
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
  std::uint64_t incarnation = 1;  ///< greater than those of its former lives
  /// No life of this node was before, as far as its state folder and the mission's clock know.
  /// False: it may have forgotten one.
  bool first_life = false;
};
/// First input of every further life that has the memory of the former ones: until now nothing was
/// heard, and what came meanwhile is yet to be read.
struct Restarted {};
/// A sample arrived: well formed, new and in order. `header_of(sample).origin` is its author.
struct Received {
  NodeNumber from;
  wire::Sample sample;
};
/// The reachability of a peer has changed, or the peer has restarted. Source: spec 1.3
/// (reachability).
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
  std::uint64_t receipt = 0;  ///< Send::receipt
  /// False: the peer was out of contact all the time. True: perhaps only the acknowledgement is
  /// missing.
  bool may_have_arrived = true;
};
/// An event that this node sent with a receipt number (Send) has arrived at the peer's node.
struct Delivered {
  NodeNumber to;
  std::uint64_t receipt = 0;
};
/// The answers that a job got from its clock (TimeIsUp), from which its result can be reproduced:
/// whether it had a clock, how often the answer was "not yet", and whether "time is up" followed.
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

using Input = std::variant<Started, Received, Reachability, Undelivered, Delivered, JobDone, Wakeup,
                           Restarted>;

/// Sends a sample to one peer; the blackboard fills in the header. A refusal is logged.
struct Send {
  NodeNumber to;
  wire::Sample sample;
  /// Events only; the lifespan of the slot may end earlier (SlotTable).
  MissionTime expires = MissionTime::max();
  std::uint64_t receipt = 0;  ///< events only: if above 0, Delivered comes with this number
};
/// Sends a sample to all nodes over the world channel. A refusal is logged.
struct Publish {
  wire::Sample sample;
};
/// A line of the event log.
struct Log {
  journal::Record record;
};
/// The clock of a job: true once the job's time is used up. May be empty: no limit.
using TimeIsUp = std::function<bool()>;
/// Starts a long computation. `work` owns its inputs, touches nothing shared and may run in any
/// thread; its result comes back as JobDone. A daemon passes a clock to `work`; the virtual runtime
/// passes none: there a job takes the time that is drawn for it (JobTimes). Source: spec 1.5.
struct StartJob {
  std::uint64_t id = 0;
  std::function<std::any(const TimeIsUp&)> work;
  Duration at_most = Duration::max();  ///< time limit, from the moment it begins to run
  bool aside = false;                  ///< in the second lane: no job of the first one waits for it
};
/// The result of this job is not needed any more: from now on its clock says that its time is up.
/// JobDone comes nevertheless.
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
  /// The instant of the next Wakeup if no input comes before; after a Wakeup, later than its
  /// instant. Only handle() changes it: runtimes ask once after each call of handle().
  virtual std::optional<MissionTime> next_wakeup() const = 0;

  /// The following inputs are those of a former life, whose effects are not carried out. The node
  /// need not make Publish effects (states of the world channel) meanwhile.
  virtual void begin_recall() {}
  /// The recall is over. Returns the Publish effects, with present values, for the states that were
  /// not published meanwhile.
  virtual Effects end_recall() { return {}; }
};

}  // namespace skein::node
