// SPDX-License-Identifier: Apache-2.0
// Diagnosis of a DDS domain.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "../graph.hpp"
#include "../listener.hpp"
#include "finding.hpp"

namespace skein::spy_tool {

/// Observations during the listening time of the doctor.
class Consultation {
 public:
  void hear(const Heard& heard, const Graph& graph);
  Findings judge(const Graph& graph, std::uint32_t domain) const;

 private:
  void judge_programs(const Graph& graph, Findings& findings) const;
  void judge_scenarios(const Graph& graph, Findings& findings) const;
  void judge_nodes(const Graph& graph, Findings& findings) const;
  void judge_names(const Graph& graph, Findings& findings) const;
  /// "process 4711 at 10.0.0.1:7411"
  std::string describe(const blackboard::Participant& participant) const;
  void judge_types(const Graph& graph, Findings& findings) const;
  void judge_clocks(Findings& findings) const;

  /// Least delay from writing to arrival [s], by owner, over samples that are no history.
  std::map<std::string, double> least_delay_;
  std::map<std::string, std::uint64_t> malformed_;  ///< "Clock of node 7: field"
  /// Participants that claim to be a node: by its name in a directory entry, by its number in
  /// heartbeats.
  std::map<std::string, std::set<std::string>> who_;
  std::map<std::uint32_t, std::set<std::string>> speakers_;
  std::map<std::string, std::uint64_t> processes_;  ///< by participant
};

}  // namespace skein::spy_tool
