// SPDX-License-Identifier: Apache-2.0
// A ground station with UAVs of any degree around it, in one event queue: MLEs of their own from
// degree 2 up, functional layers that need a fixed time per task, a radio with a latency and cuts.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "skein/executive/executive.hpp"
#include "skein/ground_station/ground_control.hpp"
#include "testing/builders.hpp"

namespace skein::ground_station::testing {

class Team {
 public:
  struct Member {
    std::string name;
    Degree degree = 3;
    double slowness = 1;  ///< factor on the duration of its tasks
  };

  Team(const std::vector<Member>& members, Script script, double latency);

  /// Plays until the mission is finished or the time is over; false in that case.
  bool play(double until);
  void tell_ground(const GroundControl::Input& input) { from_ground(ground_->handle(input, now_)); }
  /// No message between the UAV and the ground in [from, until); they come when it is over.
  void cut(const std::string& uav, double from, double until);
  /// Its decision node loses its plan at the instant.
  void restart(const std::string& uav, double at);

  MissionTime now() const { return now_; }
  const GroundControl& ground() const { return *ground_; }
  /// "2 running" …, as each UAV's MLE, wherever it is, had them.
  const std::vector<std::string>& history(const std::string& uav) { return history_[uav]; }
  /// When a task of a UAV was in a state first; -1: never.
  double instant(const std::string& uav, std::uint64_t task, executive::TaskState state) const;
  const std::vector<CommandChanged>& commands() const { return commands_; }
  const std::vector<std::string>& phases() const { return phases_; }
  const std::vector<std::string>& anomalies() const { return anomalies_; }

 private:
  struct Uav {
    Member member;
    std::unique_ptr<executive::Executive> mle;  ///< null at degree 1
    std::set<executive::TaskId> busy;           ///< functional tasks not over
    MissionTime cut_from, cut_until;
    std::set<CommandNumber> handled;
  };
  using Deed = std::function<void()>;

  void after(Duration delay, Deed deed);
  void by_radio(const std::string& uav, Deed deed);
  void from_ground(const std::vector<GroundControl::Effect>& effects);
  void take(const SendRequest& request);
  void take(const SendFunctional& request);
  void take(const SendSync& sync);
  void take(const CommandChanged& change) { commands_.push_back(change); }
  void take(const PhaseEntered& phase) { phases_.push_back(phase.name); }
  void take(const LocalTaskEvent& event) { record(event.uav, event.event.id, event.event.state); }
  void take(const Anomaly& anomaly) { anomalies_.push_back(anomaly.why); }
  template <class Other>
  void take(const Other&) {}
  void to_mle(const std::string& uav, const executive::Input& input, CommandNumber command = {});
  void from_mle(const std::string& uav, const executive::Effect& effect, CommandNumber command);
  void vehicle(const std::string& uav, executive::TaskId task, const std::string& type,
               functional::Verb verb);
  void report(const std::string& uav, executive::TaskId task, executive::TaskState state);
  void record(const std::string& uav, executive::TaskId task, executive::TaskState state);
  void sync(std::uint64_t sync_id, const std::string& from, const std::string& to);
  std::optional<MissionTime> next_instant() const;
  void make_mle(Uav& uav);

  MissionTime now_;
  Duration latency_;
  std::unique_ptr<GroundControl> ground_;
  std::map<std::string, Uav> uavs_;
  std::map<std::pair<MissionTime, std::uint64_t>, Deed> queue_;
  std::uint64_t sequence_ = 0;
  std::map<std::string, std::vector<std::string>> history_;
  std::map<std::tuple<std::string, executive::TaskId, executive::TaskState>, MissionTime> instants_;
  std::vector<CommandChanged> commands_;
  std::vector<std::string> phases_;
  std::vector<std::string> anomalies_;
};

}  // namespace skein::ground_station::testing
