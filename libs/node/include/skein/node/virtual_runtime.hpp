// SPDX-License-Identifier: Apache-2.0
// All nodes of a scenario in one process and in virtual time.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "skein/node/host.hpp"

namespace skein::node {

/// Makes the node of a name; called at its start and at each restart.
using NodeFactory = std::function<std::unique_ptr<Node>(const std::string& name)>;

/// A node dies at once and, if told so, is started again. Of a node that is dead already a death
/// changes nothing, of one that lives a restart.
struct Crash {
  MissionTime at;
  std::string node;
  std::optional<MissionTime> restart;
  bool remembers =
      false;  ///< it comes back with what it knew; else with nothing (but the world that it plays)
};

struct VirtualConfig {
  std::uint64_t seed = 0;
  MissionTime time_limit = MissionTime::max();
  Duration heartbeat_period = Duration::seconds(1);
  Duration job_latency = Duration::milliseconds(50);  ///< from a job's start to its result
  Duration after_finish = Duration::seconds(2);       ///< so that last messages are still handled
  std::vector<Crash> crashes;
  bool operators = false;  ///< the roster's operators play too
  /// What the simulator says of the links is done by what carries the samples, and nobody is told:
  /// as in flight, where the radio itself cuts.
  bool silent_cuts = false;
  RadioCapacity capacity = {};
  /// Where the memory of a node is kept, null for none; it outlives the run. Without: in memory, of
  /// those who will come back with it.
  std::function<InputLog*(const std::string& node)> memory_of = {};
};

struct VirtualOutcome {
  enum class End { kFinished, kTimeLimit, kNothingLeftToDo, kStopped };
  End end = End::kFinished;
  MissionTime at;           ///< the last instant that was played, or the time limit
  std::uint64_t steps = 0;  ///< host steps, a measure of work
};

/// Runs the roster's ground, sim and UAV nodes until one of them says Finish, the time limit comes,
/// nothing is left to do, or `keep_going` says no (asked once per mission second). Everything
/// happens in a fixed order that depends only on the arguments: hosts in roster order at each
/// instant, so the same arguments give the same records. Records go to `journal` in order.
/// Precondition: crashes name nodes of the roster, not the runner. Source: spec 1.5.
VirtualOutcome run_virtual(const Roster& roster, const NodeFactory& make_node,
                           const VirtualConfig& config,
                           const std::function<void(const journal::Record&)>& journal,
                           const std::function<bool(MissionTime)>& keep_going = {});

}  // namespace skein::node
