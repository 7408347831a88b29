// SPDX-License-Identifier: Apache-2.0
// Moves a controllable network to another one by changing the weight of one base edge
// at a time, or one contingent link.
#pragma once

#include <vector>

#include "dc_engine.hpp"

namespace skein::temporal {

/// Keeps the distances found by the last search of each link, and in the graph exactly the derived
/// edges that follow from them. A link depends only on links with a later activation in the
/// best-case schedule, so changes are propagated from the latest activation to the earliest.
class DcUpdater {
 public:
  enum class Outcome : std::uint8_t { kDone, kBroken, kOverflow };

  /// Precondition: engine.decide() said controllable, and the engine outlives this.
  explicit DcUpdater(DcEngine& engine);

  /// Lowers the weight of a base edge. After kBroken or kOverflow the network is unchanged; after
  /// kBroken `conflict` has the reason. Distances only shrink, so only nodes with a smaller
  /// distance are visited.
  Outcome tighten(std::uint32_t edge, Ticks weight);
  /// Raises the weight (kInfinite: no bound). Only nodes that had a shortest path on the edge are
  /// looked at. Precondition: the new weight is greater.
  void loosen(std::uint32_t edge, Ticks weight);

  void add_node();
  /// Activates a link of the graph. After any result but kDone this object and the engine must not
  /// be used any more.
  Outcome add_link(std::uint32_t link);
  /// Takes a link out of the graph, as if its duration had no bounds.
  void remove_link(std::uint32_t link);

  const std::vector<ConflictTerm>& conflict() const { return conflict_; }
  /// Distance of the node to the end of the link; kInfinite: not reached by the search.
  Ticks distance(std::uint32_t link, NodeIndex node) const { return distance_[link][node]; }
  /// Work done since the last call.
  DcCounters take_counters();

 private:
  struct Reach {
    NodeIndex node = 0;
    Ticks distance = 0;
  };
  struct Former {
    std::uint32_t link = 0;
    NodeIndex node = 0;
    Ticks distance = 0;
  };

  bool passes(std::uint32_t link, NodeIndex node) const;
  std::uint32_t take_latest();
  void want(std::uint32_t link);
  void work_out_losses();
  void reach_through(NodeIndex from, NodeIndex to, Ticks weight);
  Outcome carry_on();
  Outcome improve(std::uint32_t link);
  void come_closer(std::uint32_t link);
  void drain(std::uint32_t link);
  void pass(std::uint32_t link, NodeIndex node);
  std::vector<BestCaseSchedule::Seed> stronger_edges(std::uint32_t link,
                                                     std::size_t first_former) const;
  bool leaves_out_edges(std::uint32_t link, std::size_t first_former) const;
  void rebuild_derived(std::uint32_t link);
  Outcome break_off(BestCaseSchedule::Outcome outcome);
  void take_back(std::uint32_t edge, Ticks weight, std::vector<Ticks> dates);
  void find_new_ways(std::uint32_t link);
  void forget(std::uint32_t link, NodeIndex node);
  void forget_all_behind(std::uint32_t link);
  void look_ahead(std::uint32_t link, NodeIndex node);
  void look_at_derived(std::uint32_t link);
  void offer(std::uint32_t link, NodeIndex node, NodeIndex through, Ticks weight);
  void lose(NodeIndex from, NodeIndex to, Ticks weight);
  void pass_on_losses(std::uint32_t link);
  void end_change();

  DcEngine& engine_;
  LoGraph& graph_;
  BestCaseSchedule& schedule_;
  IndexedHeap<Ticks> queue_;
  std::vector<std::vector<Ticks>> distance_;  ///< of each link: of each node to its end
  std::vector<std::vector<Reach>> reached_;   ///< of each link: nodes that came closer by an edge
  std::vector<std::vector<NodeIndex>>
      lost_;                      ///< of each link: nodes a shortest path of which is gone
  std::vector<Reach> forgotten_;  ///< nodes looked at in a loosening, as they were
  std::vector<std::uint8_t> wanted_;
  std::vector<std::uint32_t> agenda_;
  std::vector<Former> former_;  ///< distances this change replaced, in order
  std::vector<std::pair<std::uint32_t, std::vector<LoGraph::Edge>>> former_derived_;
  std::vector<ConflictTerm> conflict_;
  DcCounters counters_;
  std::uint64_t relaxations_before_ = 0;
};

}  // namespace skein::temporal
