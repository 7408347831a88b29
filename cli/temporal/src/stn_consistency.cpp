// SPDX-License-Identifier: Apache-2.0
// Consistency by the STN engine, which wants at most one arc for each pair of nodes.
#include <map>
#include <utility>

#include "skein/temporal/stn_engine.hpp"
#include "stn_analysis.hpp"

namespace skein::temporal_tool {

namespace {

using temporal::Arc;
using temporal::LinkKind;
using temporal::LinkRef;
using temporal::NodeIndex;
using temporal::Stnu;
using temporal::Ticks;

/// The tightest bounds that links between two nodes give, and which bounds of which links they are.
struct Merged {
  Arc arc;
  ConflictPart min_from;
  ConflictPart max_from;
};

class MergedArcs {
 public:
  explicit MergedArcs(const Stnu& network) {
    for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
      add(network.arcs[i], {LinkKind::kRequirement, i});
    }
    for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
      const temporal::ContingentLink& link = network.contingent[i];
      add({link.activation, link.contingent, link.min, link.max}, {LinkKind::kContingent, i});
    }
  }

  const std::vector<Merged>& all() const { return merged_; }

  // The two bounds of the first pair of nodes that leave no room; empty when there is none.
  std::vector<ConflictPart> empty_interval() const {
    for (const Merged& one : merged_) {
      if (one.arc.min > one.arc.max) return {one.min_from, one.max_from};
    }
    return {};
  }

 private:
  void add(const Arc& arc, LinkRef link) {
    const bool turned = place_of_.count({arc.to, arc.from}) > 0;
    const Arc oriented = turned ? Arc{arc.to, arc.from, -arc.max, -arc.min} : arc;
    const ConflictPart min{link, turned ? LinkBound::kMax : LinkBound::kMin};
    const ConflictPart max{link, turned ? LinkBound::kMin : LinkBound::kMax};
    const auto [found, added] =
        place_of_.emplace(std::pair(oriented.from, oriented.to), merged_.size());
    if (added) {
      merged_.push_back({oriented, min, max});
      return;
    }
    Merged& one = merged_[found->second];
    if (oriented.min > one.arc.min)
      std::tie(one.arc.min, one.min_from) = std::pair(oriented.min, min);
    if (oriented.max < one.arc.max)
      std::tie(one.arc.max, one.max_from) = std::pair(oriented.max, max);
  }

  std::map<std::pair<NodeIndex, NodeIndex>, std::size_t> place_of_;
  std::vector<Merged> merged_;
};

}  // namespace

Result<Consistency, Failure> analyse_consistency(const Stnu& network) {
  const MergedArcs merged(network);
  Consistency answer;
  answer.conflict = merged.empty_interval();
  if (!answer.conflict.empty()) return answer;
  temporal::Stn stn{network.nodes, network.origin, {}};
  for (const Merged& one : merged.all()) stn.arcs.push_back(one.arc);
  const auto engine = temporal::StnEngine::make(stn);
  if (!engine) return failure(temporal::to_text(engine.error().error));
  answer.consistent = engine->consistent();
  for (const temporal::ConflictArc& one : engine->conflict()) {
    const Merged& arc = merged.all()[one.arc];
    answer.conflict.push_back(one.bound == decltype(one.bound)::kLower ? arc.min_from
                                                                       : arc.max_from);
  }
  for (NodeIndex node = 0; answer.consistent && node < network.nodes.size(); ++node) {
    answer.windows.push_back({engine->earliest(node), engine->latest(node)});
  }
  return answer;
}

}  // namespace skein::temporal_tool
