// SPDX-License-Identifier: Apache-2.0
// All nodes of a scenario in one process and in virtual time.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "skein/node/host.hpp"

namespace skein::node {

/// Makes the node with this name; called at its start and at each restart.
using NodeFactory = std::function<std::unique_ptr<Node>(const std::string& name)>;

/// A node dies at `at` and, if `restart` is given, is started again then. The death of a dead node
/// and the restart of a live one have no effect.
struct Crash {
  MissionTime at;
  std::string node;
  std::optional<MissionTime> restart;
  bool remembers = false;  ///< restart with memory; otherwise without (HostConfig::forgets)
};

/// How long a job takes once it has begun, in mission time: drawn from the seed for each, most of
/// them near the least, and no longer than the job may take. least <= most.
struct JobTimes {
  Duration least = Duration::milliseconds(50);
  Duration most = Duration::milliseconds(50);
};

struct VirtualConfig {
  std::uint64_t seed = 0;
  MissionTime time_limit = MissionTime::max();
  Duration heartbeat_period = Duration::seconds(1);
  JobTimes jobs = {};
  Duration after_finish = Duration::seconds(2);  ///< so that last messages are still handled
  std::vector<Crash> crashes;
  bool operators = false;  ///< the roster's operators take part as nodes
  /// The simulator's cuts are made by the transport and nodes are not told, as in flight, where the
  /// radio itself cuts.
  bool silent_cuts = false;
  /// See HostConfig; a simulator among the nodes says of each link when it comes up.
  bool meets_when_told = false;
  RadioCapacity capacity = {};
  /// Gives the memory of a node (null: none), which must outlive the run. If empty, nodes that a
  /// Crash restarts with memory have a MemoryInputLog.
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
