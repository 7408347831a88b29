// SPDX-License-Identifier: Apache-2.0
// The daemons of a run.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "deaths.hpp"
#include "play_dds.hpp"
#include "process.hpp"

namespace skein::run_tool {

/// Starts, kills and watches skein-sim (one more for each functional layer of its own),
/// skein-ground and one skein-ddn per UAV. The destructor ends all of them.
class Fleet {
 public:
  struct Ended {
    std::string name;
    std::string program;
    std::string log;
    Process::Status status;
    bool killed = false;  ///< by kill(), for a fault of the scenario
    bool crashed() const { return status.signal != 0 || status.code != 0; }
  };

  Fleet(const scenario::Scenario& scenario, const DdsOptions& options, std::uint32_t domain);

  /// The nodes, in the order to start them.
  std::vector<std::string> names() const;
  Result<void, Failure> start(const std::string& name);
  void kill(const std::string& name);
  /// What outlives the daemon's process is gone, when it starts next; but for the vehicles and the
  /// world of one that plays them.
  void forget(const std::string& name);
  Deaths::Stage stage_of(const std::string& name) const;
  bool any_running() const { return !running_.empty(); }
  std::string running_names() const;
  /// Address of the operators' page, from the ground station's log; empty until it is logged.
  std::string console_url() const;
  void signal_all(int signal);
  void kill_all();
  /// Daemons that ended since the last call.
  std::vector<Ended> take_ended();

 private:
  std::string program_of(const std::string& name) const;
  std::string log_of(const std::string& name) const;
  std::string state() const;  ///< folder

  const scenario::Scenario& scenario_;
  const DdsOptions& options_;
  std::uint32_t domain_;
  std::string folder_;  ///< of the programs
  std::map<std::string, Process> running_;
  std::set<std::string> killed_;
  std::set<std::string> forgetful_;  ///< when they start next
};

}  // namespace skein::run_tool
