// SPDX-License-Identifier: Apache-2.0
// The DDS runtime: one node as a daemon on the wall clock.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/foundation/section_prints.hpp"
#include "skein/node/companion.hpp"
#include "skein/node/host.hpp"

namespace skein::node {

struct DaemonConfig {
  std::uint32_t domain = 0;  ///< DDS domain id, 0 to 100
  blackboard::NetworkConfig network;
  double rate = 1;  ///< mission seconds per second; the clock leader's is used by all
  Duration heartbeat = Duration::seconds(1);  ///< mission time; see steady_heartbeat()
  RadioCapacity capacity = {};
  ToldOfLinks told = ToldOfLinks::kAll;
  std::uint64_t seed = 0;
  /// True in exactly one daemon of a system: the simulator, or without a world channel the ground
  /// station.
  bool leads_clock = false;
  MissionTime time_limit = MissionTime::max();  ///< leader: the latest end of the mission
  std::vector<std::string> awaited;  ///< leader: the clock starts when all of these are ready
  /// Greater than those of all former incarnations; 0: taken from the clock [ns since 1970].
  std::uint64_t incarnation = 0;
  /// Nothing is known of a life before this one (see Started). With a world channel that is also
  /// known when the mission's clock has not begun.
  bool first_life = false;
  /// See HostConfig. Without a world channel a daemon that does not lead takes mission time from
  /// its peers' samples, continues by its own clock while it hears none, and runs until a signal
  /// stops it.
  bool world = true;
  /// See HostConfig. A restarted leader resumes mission time where its peers are.
  InputLog* memory = nullptr;
  bool forgets = false;  ///< see HostConfig
  /// Receive every record of this node (which is also sent to the runner over the world channel),
  /// and the lines of the middleware's log. May be empty.
  std::function<void(const journal::Record&, LineMark)> on_record;
  std::function<void(const std::string&)> on_middleware_log;
  /// Receives what the node waits for, as a sentence, when the mission does not start for five
  /// seconds, and when that has changed. May be empty.
  std::function<void(const std::string&)> on_waiting;
  /// Called after every turn of the daemon's loop, several times a second, the first time when the
  /// daemon has joined the domain. For a service manager. May be empty.
  std::function<void(wire::ClockPhase)> on_turn;
  /// With keys, while the clock is not heard or holds: longest duration of an authentication
  /// handshake with another node, in steady time (undisturbed it takes milliseconds). Of two nodes
  /// the one whose name is first in the alphabet waits twice as long, so that only one gives up.
  /// max(): no limit.
  Duration handshake_limit = Duration::max();
  Companion* companion = nullptr;  ///< must outlive the daemon; null: none
  /// The fingerprint of the scenario that this node flies; empty: of none, it agrees with all.
  SectionPrints scenario = {};
};

enum class DaemonEnd {
  kFinished,      ///< the mission is over
  kStopped,       ///< SIGINT or SIGTERM
  kUnmet,         ///< with keys: a handshake did not end in time; the daemon is to be restarted
  kOtherScenario  ///< a mission is under way whose scenario differs; this node has not begun to
                  ///< live
};

/// Runs the node until the mission is over or a signal asks it to stop. Mission time follows the
/// clock slot, or the peers; records are published in the journal slot; jobs run in a second
/// thread. Blocks SIGINT, SIGTERM and SIGHUP (which does not stop it) in the calling thread and in
/// threads that are made later.
/// Source: spec 1.4, 1.5.
Result<DaemonEnd, OpenFailure> run_daemon(const Roster& roster, const Member& self,
                                          std::unique_ptr<Node> node, const DaemonConfig& config);

}  // namespace skein::node
