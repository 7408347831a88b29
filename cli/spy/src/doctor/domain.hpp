// SPDX-License-Identifier: Apache-2.0
// What is wrong in a domain.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "../graph.hpp"
#include "../listener.hpp"
#include "finding.hpp"

namespace skein::spy_tool {

/// What was heard while the doctor listened.
class Consultation {
 public:
  void hear(const Heard& heard, const Graph& graph);
  Findings judge(const Graph& graph, std::uint32_t domain) const;

 private:
  void judge_programs(const Graph& graph, Findings& findings) const;
  void judge_nodes(const Graph& graph, Findings& findings) const;
  void judge_types(const Graph& graph, Findings& findings) const;
  void judge_clocks(Findings& findings) const;

  /// Of samples that are no history, by owner: the least time from writing to coming [s].
  std::map<std::string, double> least_delay_;
  std::map<std::string, std::uint64_t> malformed_;  ///< "Clock of node 7: field"
  /// By name: the participants that say they are this node.
  std::map<std::string, std::set<std::string>> who_;
};

}  // namespace skein::spy_tool
