// SPDX-License-Identifier: Apache-2.0
// Decides dynamic controllability from scratch, with a conflict if the network is not controllable.
#pragma once

#include <optional>
#include <vector>

#include "link_search.hpp"

namespace skein::temporal {

/// Contingent links are processed one by one; each needs the links whose activation its search
/// passes. A cyclic dependency is a semi-reducible negative cycle, and so is a negative cycle among
/// base, lower and derived edges.
class DcEngine {
 public:
  DcEngine(const Stnu& network, LoGraph::OpenBounds open);

  Result<DcResult, StnuError> decide();

  void add_node();

  /// For changes of the network after `decide` has said controllable.
  LoGraph& graph() { return graph_; }
  BestCaseSchedule& schedule() { return schedule_; }
  LinkSearch& search() { return search_; }
  /// The bounds that a cycle consists of, with derived edges resolved to the bounds they follow
  /// from.
  std::vector<ConflictTerm> explain(const std::vector<PathStep>& cycle);
  /// Initial dates of a search for a schedule: none, or those of the current schedule.
  enum class Start : std::uint8_t { kNothing, kSchedule };
  /// A negative cycle if contingent links were requirements; no value: there is none.
  Result<std::optional<std::vector<ConflictTerm>>, StnuError> find_inconsistency(Start start) const;

 private:
  enum class Outcome : std::uint8_t { kDone, kBroken, kOverflow };

  Outcome resolve_all();
  Outcome resolve(std::uint32_t first);
  Outcome resolve_top();
  Outcome commit(std::uint32_t link);
  std::vector<std::uint32_t> latest_first() const;
  void blame_needs(std::uint32_t needed);
  Result<DcResult, StnuError> verdict(Outcome outcome);
  Result<DcResult, StnuError> judge_best_case(BestCaseSchedule::Outcome outcome);

  LoGraph graph_;
  BestCaseSchedule schedule_;
  LinkSearch search_;
  std::vector<std::uint8_t> ready_, under_way_;
  std::vector<std::uint32_t> stack_;
  std::vector<PathStep> cycle_;
  DcCounters counters_;
};

}  // namespace skein::temporal
