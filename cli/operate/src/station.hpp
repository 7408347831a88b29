// SPDX-License-Identifier: Apache-2.0
// Connection of an operator at the shell to the ground station.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/foundation/result.hpp"
#include "skein/node/mission_clock.hpp"
#include "skein/node/waker.hpp"
#include "skein/operate_tool/operate.hpp"

namespace skein::operate_tool {

/// Said where nobody is heard on a domain.
inline constexpr const char* kWhichDomain =
    ": is a mission running there? `skein run` takes a free one without --domain, and says which";

/// The last of each board received from the ground station.
struct Boards {
  std::optional<wire::GroundBoard> ground;
  std::map<std::string, wire::UavBoard> uavs;
  std::map<std::string, wire::UavTasks> tasks;
  std::map<std::uint32_t, wire::LinkState> links;  ///< by instance

  /// Whether the ground station's board and those of all its UAVs were received.
  bool complete() const;
};

/// Takes part in the domain as an operator. Thread rule: one thread.
class Station {
 public:
  explicit Station(const StationOptions& options) : options_(options) {}

  Result<void, Failure> open();
  /// Listens until `done` returns true (called after each arrival), `seconds` have passed, or
  /// Ctrl-C; returns whether `done` did.
  bool listen(double seconds, const std::function<bool()>& done);
  void ask(const wire::OperatorRequest& request);

  const Boards& boards() const { return boards_; }
  /// Nothing: no answer to that request yet.
  std::optional<wire::OperatorReply> answer(const std::string& who, std::uint64_t number) const;
  MissionTime mission_time();
  /// Whether the mission clock was received; before that mission_time() is not valid.
  bool clock_heard() const { return clock_heard_; }
  wire::ClockPhase phase() const { return clock_.phase(); }
  bool interrupted() const { return waker_.stop_requested(); }

 private:
  void take();
  void take(const wire::Sample& sample);
  blackboard::Now now();

  StationOptions options_;
  node::Waker waker_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::optional<blackboard::Blackboard> board_;
  node::MissionClock clock_;
  bool clock_heard_ = false;
  Boards boards_;
  std::map<std::pair<std::string, std::uint64_t>, wire::OperatorReply> answers_;
  std::uint32_t instance_ = 0;
};

}  // namespace skein::operate_tool
