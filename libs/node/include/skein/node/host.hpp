// SPDX-License-Identifier: Apache-2.0
// A node together with its blackboard: what both runtimes drive.
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

/// What radio links can carry, as far as it is known before anybody tells [bit/s of mission time];
/// 0: unlimited.
struct RadioCapacity {
  double of_all = 0;
  std::map<std::pair<std::string, std::string>, double> of_links = {};  ///< from, to: unlike those

  double of(const std::string& from, const std::string& to) const {
    const auto found = of_links.find({from, to});
    return found == of_links.end() ? of_all : found->second;
  }
};

/// What of the simulator's words on links counts; in flight there are none. What is not told a
/// node's own heartbeats find out.
enum class ToldOfLinks : std::uint8_t {
  kAll,
  kNotOfCuts,  ///< latency, loss and capacity do; that they are up or down does not
  kNothing
};

struct HostConfig {
  std::uint64_t incarnation = 1;
  Duration heartbeat_period = Duration::seconds(1);  ///< steady
  double rate = 1;  ///< mission seconds per steady second: turns the radio's latencies
  ToldOfLinks told = ToldOfLinks::kAll;
  RadioCapacity capacity = {};
  /// Of a radio's capacity, declared or told: the rest is for what the transport itself says.
  double share_of_samples = 1;
  std::uint64_t seed = 0;  ///< of the losses on streams
  /// Where the node's memory is; it outlives the host. If there is something in it, the host goes
  /// on where that ends, and `incarnation` is that of the first life. Null: nothing outlives the
  /// node.
  InputLog* memory = nullptr;
  bool leads_clock = false;
  /// Whether it takes part in the world channel, which is for simulation: clock, directory, links,
  /// truth, operators and runners elsewhere, the event log. Without it what is published reaches
  /// nobody but who is in this process.
  bool world = true;
  /// `incarnation` is of a clock that may be wrong (blackboard::Config). With a memory it is not.
  bool guesses_incarnation = false;
  /// The node comes back with nothing it knew, in a new incarnation. What is in the memory it is
  /// given all the same, before it starts: for who plays the world, that does not forget. Nothing
  /// follows from it.
  bool forgets = false;
};

/// Why a host could not be opened.
struct OpenFailure {
  std::string why;
  /// The memory, and nothing else, is in the way: the node, given it, does not do what it is known
  /// to have done, or it cannot be read. The node has been given some of it: it is of no use after.
  bool of_memory = false;
};

/// Where a host's output goes. All are called from step(), in the order of the effects.
struct HostPorts {
  std::function<void(const journal::Record&)> journal;
  std::function<void(StartJob)> start_job;
  std::function<void(StopJob)> stop_job;  ///< may be empty
  std::function<void()> finish;
  /// What comes over the world channel (clock, directory, mission state, link states, truth): for
  /// the runtime; of it the node gets the truth and what operators and the ground station tell each
  /// other. May be empty.
  std::function<void(const wire::Sample&)> world;
  /// What is given to the node, and what it sends and publishes. May be empty.
  std::function<void(const wire::Sample&)> witness;
};

/// Routes samples from the blackboard to the node and the node's effects back; applies the link
/// states of the radio to the channels; writes what happens on the channels to the event log.
/// Sans-IO like the node itself: a runtime calls step(). Thread rule: one thread.
///
/// With a memory, every input of the node is in it before anything that follows from it leaves. A
/// host opened on what a former life left there gives its node all of that first, sends nothing of
/// what follows from it, and then goes on as after a cut: peers get what they did not acknowledge,
/// jobs that had not ended begin again, lines of the event log that had not left are written.
/// Unless it forgets: then it is a new node to its peers.
class Host {
 public:
  /// The transport must outlive the host. The failure says what the transport could not open, or
  /// why the memory is not of this node.
  static Result<std::unique_ptr<Host>, OpenFailure> open(const Roster& roster, const Member& self,
                                                         std::unique_ptr<Node> node,
                                                         blackboard::Transport& transport,
                                                         const HostConfig& config, HostPorts ports);

  /// Gives the node its Started input, then what came before. Until then the blackboard works and
  /// peers are heard, but the node gets nothing and nothing is logged: a runtime starts it once it
  /// knows the mission time.
  void start(blackboard::Now now);
  bool started() const { return started_; }
  /// Of the last thing a former life was given; absent in the first.
  std::optional<MissionTime> resumed_from() const { return resumed_from_; }
  /// Takes what arrived, wakes the node if it is due, carries out effects. True if there was
  /// anything to do, so that a runtime can go on until all hosts are quiet.
  bool step(blackboard::Now now);
  /// A member of the roster in this process says something on the world channel: the node gets it
  /// as if it had come over that. Without effect before start(). A malformed sample is logged.
  void say(const Member& from, wire::Sample sample, blackboard::Now now);
  /// A job's result.
  void job_done(JobDone done, blackboard::Now now);
  /// The lines of the event log that were handed over so far have left.
  void lines_have_left();
  /// Publishes on the world channel what does not come from the node (clock, directory, journal). A
  /// refusal is logged.
  void publish(wire::Sample sample, blackboard::Now now);

  std::optional<MissionTime> next_mission_wakeup() const {
    return earliest(node_due_, blackboard_.next_expiry());
  }
  std::optional<Duration> next_steady_wakeup() const { return blackboard_.next_wakeup(); }
  /// As the peers see it: the latest that any of them wrote.
  MissionTime latest_heard() const { return blackboard_.latest_heard(); }
  /// True once every peer this node has a radio or onboard channel with, and whose channel the
  /// radio does not hold down, has been heard.
  bool all_peers_heard() const;
  const Member& self() const { return self_; }

 private:
  Host(const Roster& roster, const Member& self, std::unique_ptr<Node> node,
       blackboard::Blackboard blackboard, const HostConfig& config, HostPorts ports);
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
  void apply(const wire::LinkState& link, blackboard::Now now);
  void send(const Send& send, blackboard::Now now);
  void log_unsent(wire::Slot slot, const std::string& to, blackboard::Refusal why,
                  blackboard::Now now);
  void log_message(const wire::Sample& sample, const std::string& from, const std::string& to,
                   std::uint64_t sequence, const char* direction, blackboard::Now now);
  /// A line of the event log (skein/journal/lines/).
  template <class Line>
  void log(Line line, blackboard::Now now) const {
    ports_.journal(journal::record_of(now.mission, self_.name, std::move(line)));
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
  std::set<NodeNumber> peers_;  ///< with a radio or onboard channel
  std::set<NodeNumber> heard_;
  std::set<NodeNumber> down_;  ///< held down by the radio
  std::optional<MissionTime> resumed_from_;
  Effects left_;                         ///< to be done by former lives
  std::uint64_t said_ = 0;               ///< by members in this process, in this life
  std::uint64_t lines_ = 0, sends_ = 0;  ///< of the node, in all its lives
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
