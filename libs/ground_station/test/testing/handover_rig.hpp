// SPDX-License-Identifier: Apache-2.0
// A ground station and one UAV whose degree changes in mid-mission: executives on both sides, a
// scripted functional layer, events in order with random latencies, plan boards that overtake them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "skein/executive/executive.hpp"
#include "skein/foundation/random.hpp"
#include "skein/ground_station/ground_control.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station::testing {

struct RigTask {
  std::uint64_t id = 0;
  std::vector<std::uint64_t> after;  ///< must have ended
  double seconds = 0;                ///< it takes; 0: it goes on until `until` has ended
  std::uint64_t until = 0;
  double asked_at = 0;
};

class HandoverRig {
 public:
  HandoverRig(Random random, Degree degree);

  void plan(const std::vector<RigTask>& tasks);
  void change_degree(double when, Degree degree);
  void play(double until);

  /// What went wrong, in sentences.
  std::vector<std::string> faults() const;
  Degree degree_on_board() const { return degree_; }

 private:
  using Deed = std::function<void()>;
  /// In order, each message with a latency of its own.
  struct Channel {
    MissionTime last;
  };

  void at_time(MissionTime when, Deed deed);
  void in_order(Channel& channel, double most, Deed deed);
  void tell_ground(const GroundControl::Input& input);
  void to_uav(const SendRequest& request);
  void to_uav(const SendFunctional& request);
  void to_ground(const GroundControl::Input& input);
  void send_board();
  void change(const SendRequest& request, const mission::ChangeDegree& change);
  void to_mle(const executive::Input& input, CommandNumber command = {});
  void to_vehicle(executive::TaskId task, bool interrupt);
  void from_vehicle(const executive::FunctionalStatus& status);
  void work(executive::TaskId task);
  void finish(executive::TaskId task, executive::TaskState state);
  void make_mle();

  Random random_;
  Degree degree_;
  MissionTime now_;
  std::unique_ptr<GroundControl> ground_;
  std::unique_ptr<executive::Executive> mle_;
  std::map<std::pair<MissionTime, std::uint64_t>, Deed> queue_;
  std::uint64_t sequence_ = 0;
  Channel up_, down_, to_vehicle_, from_vehicle_;
  std::map<executive::TaskId, RigTask> tasks_;
  std::map<executive::TaskId, executive::TaskState> statuses_;  ///< as the vehicle told last
  std::map<executive::TaskId, int> begun_;
  std::map<executive::TaskId, int> ended_;
  std::vector<std::string> violations_;
};

}  // namespace skein::ground_station::testing
