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

/// What a memory is of, seen before anything is made of it.
struct Survey {
  std::uint64_t incarnation = 0;   ///< the last; 0: there is nothing in it
  std::uint32_t lives = 0;         ///< of it, that ended
  std::uint32_t births = 0;        ///< incarnations: the last one counts to the peers
  std::set<std::uint64_t> unsent;  ///< see Unsent; of the last incarnation
};
Result<Survey, Failure> survey(const InputLog& memory);

/// Gives the node what its former lives were given, tells the blackboard what they sent and
/// received, and keeps what is left to be done. A job's work is done again, here and now.
class Recollection {
 public:
  /// Without a blackboard nobody is told.
  Recollection(Node& node, blackboard::Blackboard* blackboard, Survey survey)
      : node_(node), blackboard_(blackboard), survey_(std::move(survey)) {}

  /// The failure says why this cannot be the memory of this node.
  Result<void, Failure> run(const InputLog& memory);

  MissionTime until() const { return until_; }
  std::uint64_t lines() const { return lines_; }
  std::uint64_t sends() const { return sends_; }
  const std::map<NodeNumber, bool>& reachable() const { return reachable_; }

  // To be done at the beginning of the next life.

  /// The last states, of which the wire forgot the writer; lines that had not left; jobs that had
  /// not ended, and which of them nobody wants; whether the node had finished.
  Effects left();
  /// Of that, what is said of the world: for an incarnation that forgot the rest.
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
