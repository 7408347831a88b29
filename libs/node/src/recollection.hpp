// SPDX-License-Identifier: Apache-2.0
// The former lives of a node, lived again without anybody noticing.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "skein/node/input_log.hpp"

namespace skein::node {

/// Summary of a memory, read before its inputs are replayed.
struct Survey {
  std::uint64_t incarnation = 0;   ///< the last incarnation; 0: the memory is empty
  std::uint32_t lives = 0;         ///< number of ended lives of the last incarnation
  std::uint32_t births = 0;        ///< number of incarnations; peers know the last one
  std::set<std::uint64_t> unsent;  ///< Unsent::send of the last incarnation
};
Result<Survey, Failure> survey(const InputLog& memory);

/// Replays the inputs of former lives to the node, restores the blackboard's sessions, and collects
/// the effects that are still to be carried out. The work of jobs is run again, synchronously.
class Recollection {
 public:
  /// `blackboard` may be null: then no sessions are restored.
  Recollection(Node& node, blackboard::Blackboard* blackboard, Survey survey)
      : node_(node), blackboard_(blackboard), survey_(std::move(survey)) {}

  /// The failure says why this cannot be the memory of this node.
  Result<void, Failure> run(const InputLog& memory);

  MissionTime until() const { return until_; }
  std::uint64_t lines() const { return lines_; }
  std::uint64_t sends() const { return sends_; }
  const std::map<NodeNumber, bool>& reachable() const { return reachable_; }

  // Effects to be carried out at the beginning of the next life.

  /// The last states sent and published (the former process's writers are gone), lines of the event
  /// log that had not left, jobs that had not ended with the StopJobs for them, and Finish if the
  /// node had finished.
  Effects left();
  /// The published ones of left(): for an incarnation that forgot the rest.
  Effects left_of_the_world();

 private:
  Result<void, Failure> take(const LogEntry& entry);
  Result<void, Failure> give(const Input& input, MissionTime at);
  Result<void, Failure> end(const JobEnded& ended, MissionTime at);
  void follow(Effects effects, MissionTime at);
  void sent(Send send, MissionTime at);
  void tell(const LogEntry& entry);
  void be_born();

  using StateKey = std::tuple<NodeNumber, wire::Slot, std::uint32_t>;
  Node& node_;
  blackboard::Blackboard* blackboard_;
  const Survey survey_;
  std::uint32_t births_ = 0;
  MissionTime until_;
  std::uint64_t told_ = 0, lines_ = 0, sends_ = 0;
  std::map<NodeNumber, bool> reachable_;
  std::map<StateKey, Send> states_;
  std::map<std::pair<wire::Slot, std::uint32_t>, Publish> world_states_;
  std::vector<Log> lines_left_;
  std::map<std::uint64_t, StartJob> jobs_;
  std::set<std::uint64_t> stopped_;
  bool finished_ = false;
};

}  // namespace skein::node
