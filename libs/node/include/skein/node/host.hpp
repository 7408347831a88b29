// SPDX-License-Identifier: Apache-2.0
// A node together with its blackboard, as both runtimes (virtual and daemon) drive it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "skein/blackboard/blackboard.hpp"
#include "skein/journal/line.hpp"
#include "skein/node/input_log.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"

namespace skein::node {

struct Survey;

/// Capacities of the radio links [bit/s of mission time] as declared before the mission; 0:
/// unlimited.
struct RadioCapacity {
  double of_all = 0;
  std::map<std::pair<std::string, std::string>, double> of_links = {};  ///< exceptions: (from, to)

  double of(const std::string& from, const std::string& to) const {
    const auto found = of_links.find({from, to});
    return found == of_links.end() ? of_all : found->second;
  }
};

/// Which parts of the simulator's LinkState samples a node applies to its channels. In flight there
/// are no such samples. A node detects cuts that it is not told by its heartbeats.
enum class ToldOfLinks : std::uint8_t {
  kAll,
  kNotOfCuts,  ///< latency, loss and capacity, but not whether the link is up
  kNothing
};

struct HostConfig {
  std::uint64_t incarnation = 1;
  Duration heartbeat_period = Duration::seconds(1);  ///< steady
  double rate = 1;  ///< mission seconds per steady second; converts the radio's latencies
  ToldOfLinks told = ToldOfLinks::kAll;
  RadioCapacity capacity = {};
  /// UAVs keep nothing of others to which no link has come up, or nothing was sent: somebody says
  /// of each link when it does (see blackboard::Config::channels_with).
  bool meets_when_told = false;
  /// Fraction of a radio's capacity for samples, in (0, 1]; the rest is for the protocol of DDS.
  double share_of_samples = 1;
  std::uint64_t seed = 0;  ///< of the losses on streams
  /// The node's memory; must outlive the host. If it is not empty, the host resumes at its end, and
  /// `incarnation` is that of the first life. Null: the node keeps nothing over a restart.
  InputLog* memory = nullptr;
  bool leads_clock = false;
  /// Whether the node takes part in the world channel, which is for simulation: clock, directory,
  /// link states, truth, remote operators and runners, the event log. Without it, published samples
  /// stay in this process.
  bool world = true;
  /// `incarnation` is a guess from a clock that may be wrong (see blackboard::Config). Ignored with
  /// a memory.
  bool guesses_incarnation = false;
  /// The node restarts without memory, in a new incarnation. The inputs in `memory` are still given
  /// to it before it starts, but without effects: a node that simulates the world needs them, since
  /// the world does not forget.
  bool forgets = false;
};

/// Why a host could not be opened.
struct OpenFailure {
  std::string why;
  /// The memory is the only cause: it cannot be read, or the node, given its inputs, does not
  /// reproduce what it is known to have done. The node must not be used any more: it was given some
  /// of these inputs.
  bool of_memory = false;
};

/// Which line of a node's event log a record is.
struct LineMark {
  /// From 1, over all lives of one incarnation: what is given out again has the number it had.
  /// 0: not of the node but of its host, which is never given out again.
  std::uint64_t number = 0;
  bool again = false;  ///< a former life may have given it out too
};

/// Callbacks for a host's output. All are called from step(), in the order of the effects.
struct HostPorts {
  std::function<void(const journal::Record&, LineMark)> journal;
  std::function<void(StartJob)> start_job;
  std::function<void(StopJob)> stop_job;  ///< may be empty
  std::function<void()> finish;
  /// Samples of the world channel for the runtime (clock, directory, mission state, link states,
  /// truth); the node itself gets only the truth and the exchange between operators and ground
  /// station. May be empty.
  std::function<void(const wire::Sample&)> world;
  /// All samples that the node receives, sends and publishes. May be empty.
  std::function<void(const wire::Sample&)> witness;
};

/// Routes samples from the blackboard to the node and the node's effects back; applies the link
/// states of the radio to the channels; writes the traffic of the channels to the event log.
/// Sans-IO like the node itself: a runtime calls step(). Thread rule: one thread.
///
/// With a memory, every input of the node is stored before any effect of it leaves the host. A host
/// that is opened on the memory of a former life replays all its inputs to the node, suppresses the
/// effects, and then continues as after a cut: unacknowledged events are sent again, unfinished
/// jobs start again, lines of the event log that had not left are written. With
/// HostConfig::forgets it is a new node to its peers instead.
class Host {
 public:
  /// The transport must outlive the host. The failure says what the transport could not open, or
  /// why the memory cannot be that of this node.
  static Result<std::unique_ptr<Host>, OpenFailure> open(const Roster& roster, const Member& self,
                                                         std::unique_ptr<Node> node,
                                                         blackboard::Transport& transport,
                                                         const HostConfig& config, HostPorts ports);

  /// Gives the node its Started input (Restarted in a life with memory), then what arrived before
  /// this call. Until then the blackboard works and peers are heard, but the node gets no input,
  /// nothing is logged and no event is acknowledged: a runtime calls it once it knows the mission
  /// time. `first_life`: the runtime knows of no life before (see Started); a memory that is not
  /// empty knows better.
  void start(blackboard::Now now, bool first_life = false);
  bool started() const { return started_; }
  /// Mission time of the last input of former lives; absent in the first life.
  std::optional<MissionTime> resumed_from() const { return resumed_from_; }
  /// Processes arrivals, wakes the node if it is due, carries out effects. True if there was
  /// anything to do, so that a runtime can go on until all hosts are quiet.
  bool step(blackboard::Now now);
  /// Processes arrivals only: this node says nothing.
  void listen(blackboard::Now now);
  /// Gives the node a sample that a member of the roster in this process (see Companion) sends, as
  /// if it had come over the world channel. Without effect before start(). A malformed sample is
  /// logged.
  void say(const Member& from, wire::Sample sample, blackboard::Now now);
  /// A job's result.
  void job_done(JobDone done, blackboard::Now now);
  /// Notes that all lines of the event log handed over so far have left the process.
  void lines_have_left();
  /// Publishes a sample of the runtime (clock, directory, journal) on the world channel. A refusal
  /// is logged.
  void publish(wire::Sample sample, blackboard::Now now);

  std::optional<MissionTime> next_mission_wakeup() const {
    return earliest(node_due_, blackboard_.next_expiry());
  }
  std::optional<Duration> next_steady_wakeup() const { return blackboard_.next_wakeup(); }
  /// The latest mission time in the samples of each node that was heard.
  const std::map<NodeNumber, MissionTime>& latest_heard() const {
    return blackboard_.latest_heard();
  }
  /// True once every peer with a radio or onboard channel to this node has been heard, except peers
  /// whose radio link is down.
  bool all_peers_heard() const;
  const Member& self() const { return self_; }

 private:
  Host(const Roster& roster, const Member& self, std::unique_ptr<Node> node,
       blackboard::Blackboard blackboard, const HostConfig& config, HostPorts ports);
  /// Notes a life: it is heard from now on, and may end before it knows the time.
  Result<void, Failure> recall(Survey survey);
  Result<void, Failure> recall_the_world();
  void remember(LoggedInput input, blackboard::Now now);
  void note_settled(blackboard::Now now);
  void give(const Input& input, blackboard::Now now);
  void carry_out(Effects effects, blackboard::Now now);
  void take(blackboard::Incoming incoming, blackboard::Now now);
  void take_received(blackboard::Received received, blackboard::Now now);
  void log_route(const blackboard::RouteChanged& route, blackboard::Now now);
  void log_older(const blackboard::TakenForOlder& one, blackboard::Now now);
  /// What is known of the radio at this instant, before anything more is said over it.
  void apply_links(const std::vector<blackboard::Incoming>& incoming, blackboard::Now now);
  void apply(const wire::LinkState& link, blackboard::Now now);
  /// Of every link that nothing else is said of.
  void apply_to_others(const wire::LinkState& link, blackboard::Now now);
  blackboard::ChannelCondition condition_of(const wire::LinkState& link) const;
  void send(const Send& send, blackboard::Now now);
  void log_unsent(wire::Slot slot, const std::string& to, blackboard::Refusal why,
                  blackboard::Now now);
  void log_message(const wire::Sample& sample, const std::string& from, const std::string& to,
                   std::uint64_t sequence, const char* direction, blackboard::Now now);
  /// A line of the event log (skein/journal/lines/).
  template <class Line>
  void log(Line line, blackboard::Now now) const {
    ports_.journal(journal::record_of(now.mission, self_.name, std::move(line)), {});
  }

  const Roster roster_;
  const Member self_;
  std::unique_ptr<Node> node_;
  blackboard::Blackboard blackboard_;
  HostConfig config_;
  HostPorts ports_;
  std::optional<MissionTime> node_due_;  ///< asked of the node whenever it has handled something
  bool started_ = false;
  std::vector<blackboard::Incoming> before_start_;
  std::set<NodeNumber> heard_;
  std::set<std::pair<NodeNumber, NodeNumber>> told_;  ///< links that something was said of
  std::set<NodeNumber> down_;                         ///< held down by the radio
  bool others_are_down_ = false;                      ///< all of which nothing was said
  std::optional<MissionTime> resumed_from_;
  Effects left_;                         ///< to be done by former lives
  std::uint64_t said_ = 0;               ///< by members in this process, in this life
  std::uint64_t lines_ = 0, sends_ = 0;  ///< of the node, in all its lives
  bool gives_out_again_ = false;         ///< what a former life may have given out
  struct Unsettled {
    std::uint64_t noted = 0;  ///< as last remembered
    std::uint64_t last = 0;   ///< that was sent
  };
  using Session = std::pair<NodeNumber, bool>;  ///< with a peer; whether that of long events
  std::map<Session, Unsettled> unsettled_;      ///< where the peer has not all that it was sent
  std::vector<Undelivered> refused_;            ///< to be told once the effects are carried out
  bool forgetful_ = false;                      ///< the memory takes nothing at the moment
};

}  // namespace skein::node
