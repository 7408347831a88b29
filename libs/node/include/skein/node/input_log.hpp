// SPDX-License-Identifier: Apache-2.0
// What a node was given, kept so that the next life of it knows all that this one did.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/node/node.hpp"

namespace skein::node {

// ---- what is kept, besides the inputs that are kept as they are ----

/// A job's result came. Its work is done again when it is recalled: the same question to the same
/// clock gives the same answer, and so the same result.
struct JobEnded {
  std::uint64_t id = 0;
  JobClock clock;
};
/// The next life began here.
struct Resumed {};
/// The n-th Send of the node (from 0) was refused for want of room.
struct Unsent {
  std::uint64_t send = 0;
};
/// An event of this peer came too late to be given.
struct Skipped {
  wire::Slot slot = wire::Slot::kTaskRequest;
  wire::SampleHeader header;
};
/// The peer has handled everything up to this one. Kept now and then: what it saves is memory.
struct Acknowledged {
  NodeNumber peer;
  std::uint64_t sequence = 0;
};

using LoggedInput = std::variant<Started, Received, Reachability, Undelivered, Delivered, Wakeup,
                                 JobEnded, Resumed, Unsent, Skipped, Acknowledged>;

/// `at` never decreases from entry to entry; the first one is Started. Another Started is a new
/// incarnation, that came back with nothing of it but the world it plays.
struct LogEntry {
  MissionTime at;
  LoggedInput input;
};

/// Whether it tells of the node's lives and what came of its sends, and is not given to it.
/// Started is both.
bool is_of_lives(const LoggedInput& input);

/// The memory of one node in one mission: its inputs in their order. A node is a function of them,
/// so they are all of its state: plan, tasks and conditions, degree, commands and answers, the
/// place in a script, sessions of events both ways.
///
/// Law: what append() was given is there for the next life, whenever this one dies after the call;
/// and nothing that follows from an input leaves the node before it is appended.
/// Source: spec 1.3, 1.5. Thread rule: one thread.
class InputLog {
 public:
  using Take = std::function<Result<void, Failure>(const LogEntry&)>;

  InputLog() = default;
  InputLog(const InputLog&) = delete;
  InputLog& operator=(const InputLog&) = delete;
  virtual ~InputLog() = default;

  /// One transaction. A failure is no reason to stop: the log keeps what it could not write and
  /// tries again with the next; until it succeeds there is no next life that knows.
  virtual Result<void, Failure> append(const LogEntry& entry) = 0;
  /// What else people should know of the keeping since it was last asked: a sentence, or empty.
  virtual std::string take_news() { return {}; }
  /// So many lines of the event log have left the node, from its first life on.
  virtual void told(std::uint64_t lines) = 0;

  /// What the lives before this one were given; empty for the first. Stops, with the failure of
  /// `take`, where that fails.
  virtual Result<void, Failure> recall(const Take& take) const = 0;
  /// Of that the first, and what is_of_lives(): to be overridden where that can be had for less.
  virtual Result<void, Failure> recall_lives(const Take& take) const;
  virtual std::uint64_t lines_told() const = 0;
};

/// Whether this node, as it was made, can have been given what is in the memory and have done what
/// is known that it did. The failure says why not: another scenario, another version of the
/// program. The node is of no use after. Cost: that of the node's life without waiting.
Result<void, Failure> explains(const InputLog& memory, Node& node);

/// In memory: for virtual time and tests.
class MemoryInputLog final : public InputLog {
 public:
  Result<void, Failure> append(const LogEntry& entry) override;
  void told(std::uint64_t lines) override { told_ = lines; }
  Result<void, Failure> recall(const Take& take) const override;
  std::uint64_t lines_told() const override { return told_; }
  const std::vector<LogEntry>& entries() const { return entries_; }

 private:
  std::vector<LogEntry> entries_;
  std::uint64_t told_ = 0;
};

}  // namespace skein::node
