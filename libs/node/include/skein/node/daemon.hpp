// SPDX-License-Identifier: Apache-2.0
// The DDS runtime: one node as a daemon on the wall clock.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/node/companion.hpp"
#include "skein/node/host.hpp"

namespace skein::node {

struct DaemonConfig {
  std::uint32_t domain = 0;  ///< DDS domain id, 0 to 100
  blackboard::NetworkConfig network;
  double rate = 1;                            ///< of the scenario; the leader's counts
  Duration heartbeat = Duration::seconds(1);  ///< mission time; see steady_heartbeat()
  RadioCapacity capacity = {};
  ToldOfLinks told = ToldOfLinks::kAll;
  std::uint64_t seed = 0;
  /// Exactly one daemon of a system: the simulator; where no world is, the ground station.
  bool leads_clock = false;
  MissionTime time_limit = MissionTime::max();  ///< leader: the clock ends here at the latest
  std::vector<std::string> awaited;  ///< leader: the clock starts when all of these are ready
  /// Greater than those of all former incarnations; 0: of the clock [ns since 1970].
  std::uint64_t incarnation = 0;
  /// See HostConfig. Without it who does not lead takes mission time from what its peers say, and
  /// goes on by its own clock when it hears nobody; and is there until a signal stops it.
  bool world = true;
  /// What outlives the process, see HostConfig. A leader that comes back goes on with mission time
  /// where it is at the others.
  InputLog* memory = nullptr;
  bool forgets = false;  ///< see HostConfig
  /// Every record of this node, beside its way to the runner over the world channel; and lines of
  /// the middleware's own log. May be empty.
  std::function<void(const journal::Record&)> on_record;
  std::function<void(const std::string&)> on_middleware_log;
  /// After every turn of the daemon's loop, several times a second as long as it lives; the first
  /// time it takes part in the domain. For a service manager. May be empty.
  std::function<void(wire::ClockPhase)> on_turn;
  /// With keys, while the clock is not heard or holds: how long a handshake with another node may
  /// last on the steady clock, which takes milliseconds when it is not disturbed. A node whose name
  /// comes first in the alphabet waits twice as long as the other, so that one of them gives up.
  /// max(): for ever.
  Duration handshake_limit = Duration::max();
  Companion* companion = nullptr;  ///< outlives the daemon; null: nobody
};

enum class DaemonEnd {
  kFinished,  ///< the mission is over
  kStopped,   ///< SIGINT or SIGTERM
  kUnmet      ///< with keys: a handshake does not end; to be run anew, as after a restart
};

/// Runs the node until the mission is over or a signal asks it to stop. Mission time follows the
/// clock slot, or the peers; its records go out in the journal slot; jobs run in a second thread.
/// Blocks SIGINT and SIGTERM in the calling thread and those made after. Source: spec 1.4, 1.5.
Result<DaemonEnd, OpenFailure> run_daemon(const Roster& roster, const Member& self,
                                          std::unique_ptr<Node> node, const DaemonConfig& config);

}  // namespace skein::node
