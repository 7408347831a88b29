// SPDX-License-Identifier: Apache-2.0
// The memory of a node: a log of its inputs, from which its next life restores its state.
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

// ---- entries besides the inputs themselves ----

/// A job's result came (JobDone). The result itself is not kept: recall runs the work again, with
/// the same answers of the job's clock, which gives the same result.
struct JobEnded {
  std::uint64_t id = 0;
  JobClock clock;
};
/// The next life began here.
struct Resumed {};
/// The n-th Send of the node (from 0) was refused because too many events were unacknowledged.
struct Unsent {
  std::uint64_t send = 0;
};
/// A received event had expired and was not given to the node.
struct Skipped {
  wire::Slot slot = wire::Slot::kTaskRequest;
  wire::SampleHeader header;
};
/// The peer has acknowledged all events up to this sequence number. Kept now and then, only so that
/// recall need not hold events that were acknowledged.
struct Acknowledged {
  NodeNumber peer;
  std::uint64_t sequence = 0;
};

using LoggedInput = std::variant<Started, Received, Reachability, Undelivered, Delivered, Wakeup,
                                 JobEnded, Resumed, Unsent, Skipped, Acknowledged, Restarted>;

/// `at` never decreases from entry to entry; the first entry is a Started. A later Started is a new
/// incarnation without memory (HostConfig::forgets).
struct LogEntry {
  MissionTime at;
  LoggedInput input;
};

/// Whether the entry is about the node's lives and the fate of its sends, not an input. Started is
/// both.
bool is_of_lives(const LoggedInput& input);

/// The memory of one node in one mission: its inputs in their order. A node is a function of its
/// inputs, so they determine all of its state: plan, tasks and conditions, degree, commands and
/// answers, the position in a script, event sessions in both directions.
///
/// Law: an entry given to append() is available to the next life, whenever this one dies after the
/// call; and no effect of an input leaves the node before the input is appended.
/// Source: spec 1.3, 1.5. Thread rule: one thread.
class InputLog {
 public:
  using Take = std::function<Result<void, Failure>(const LogEntry&)>;

  InputLog() = default;
  InputLog(const InputLog&) = delete;
  InputLog& operator=(const InputLog&) = delete;
  virtual ~InputLog() = default;

  /// Stores the entry, in one transaction. After a failure the node may go on: the log keeps the
  /// entry in RAM and writes it with the next one; until that succeeds a restart finds no usable
  /// memory.
  virtual Result<void, Failure> append(const LogEntry& entry) = 0;
  /// A message for people about the state of the log since the last call: a sentence, or empty.
  virtual std::string take_news() { return {}; }
  /// Stores how many lines of the event log have left the node since its first life began.
  virtual void told(std::uint64_t lines) = 0;

  /// Gives `take` the entries of all former lives, in order; none in the first life. Stops at the
  /// first failure of `take` and returns it.
  virtual Result<void, Failure> recall(const Take& take) const = 0;
  /// Like recall(), but only the first entry and those that are is_of_lives(). Override it where
  /// these can be read faster.
  virtual Result<void, Failure> recall_lives(const Take& take) const;
  virtual std::uint64_t lines_told() const = 0;
};

/// Checks the memory by replaying it to a freshly made node, which must not be used afterwards. The
/// failure says where the node deviates from what is recorded: another scenario, another version of
/// the program. Cost: all computations of the node's former lives.
Result<void, Failure> explains(const InputLog& memory, Node& node);

/// An InputLog in RAM, for virtual time and tests.
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
