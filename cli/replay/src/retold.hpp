// SPDX-License-Identifier: Apache-2.0
// Converts lines of an event log to samples for the page.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/journal/record.hpp"

namespace skein::replay_tool {

/// Gives for each line the samples that it changes; a line that says nothing the page shows gives
/// none. Nodes are numbered as in a roster: the ground station 1, UAVs from 10 in the order given.
/// Lines about UAVs that are not among them are passed over. Not safe to share between threads.
class Retold {
 public:
  explicit Retold(const std::vector<std::string>& uavs);

  std::vector<wire::Sample> see(const journal::Record& record);

 private:
  struct Uav {
    wire::UavBoard board;
    wire::UavTasks tasks;
    std::map<std::uint64_t, wire::PlanEntry> plan;
    std::map<std::string, wire::JointTaskState, std::less<>> joint;  ///< by subject
  };
  using Teller = std::vector<wire::Sample> (Retold::*)(const journal::Record&, Uav&);
  static const std::map<std::string, Teller, std::less<>>& tellers();

  std::vector<wire::Sample> take_telemetry(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_degree(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_hand(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_task(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_goal(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_plan(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_planned(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_joint(const journal::Record& record, Uav& uav);
  std::vector<wire::Sample> take_decision(const journal::Record& record, Uav& uav);
  /// Lines about no UAV; false: none of these.
  bool take_for_all(const journal::Record& record, std::vector<wire::Sample>& news);
  std::vector<wire::Sample> take_reach(const journal::Record& record);
  void take_owner(const journal::Record& record);
  void take_alarm(const journal::Record& record);
  void take_command(const journal::Record& record);
  wire::Sample link(const journal::Record& record) const;
  wire::Sample seen(const journal::Record& record);
  std::uint32_t number_of(std::string_view node) const;

  std::map<std::string, Uav, std::less<>> uavs_;
  wire::GroundBoard ground_;
  std::map<std::string, std::uint32_t, std::less<>> objects_;  ///< instances, by name
};

}  // namespace skein::replay_tool
