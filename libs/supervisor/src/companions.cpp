// SPDX-License-Identifier: Apache-2.0
#include "companions.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace skein::supervisor {

namespace {

using temporal::Arc;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::NodeIndex;
using temporal::Ticks;

// Everything that keeps a node from coming earlier, and what it keeps.
struct LowerBounds {
  std::vector<std::vector<NodeIndex>> before;    ///< of each node
  std::vector<std::vector<std::uint32_t>> arcs;  ///< of each node: positions in the network's arcs

  explicit LowerBounds(const PlanNetwork& plan)
      : before(plan.stnu.nodes.size()), arcs(plan.stnu.nodes.size()) {
    for (std::uint32_t i = 0; i < plan.stnu.arcs.size(); ++i) {
      const Arc& arc = plan.stnu.arcs[i];
      if (arc.min == kMinusInfinite) continue;
      before[arc.to].push_back(arc.from);
      arcs[arc.to].push_back(i);
    }
    for (const auto& link : plan.stnu.contingent) {
      before[link.contingent].push_back(link.activation);
    }
  }

  // Bounds between tasks are never negative, so what leads to a node never comes after it.
  bool leads_to(NodeIndex from, NodeIndex to) const {
    std::vector<bool> met(before.size(), false);
    std::vector<NodeIndex> open{to};
    met[to] = true;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (open[i] == from) return true;
      for (const NodeIndex one : before[open[i]]) {
        if (!met[one]) open.push_back(one);
        met[one] = true;
      }
    }
    return false;
  }
};

std::string beginning_of(const Cause& within) {
  const std::string other = "task " + to_text(within.other);
  return within.kind == BoundKind::kWithin ? "must start while " + other + " runs, but "
                                           : "must start before " + other + " stops it, but ";
}

std::string wait_of(const Cause& held) {
  const std::string other = " of task " + to_text(held.other) + ", which may come later";
  if (held.kind == BoundKind::kAfterEnd) return "waits for the end" + other;
  if (held.kind == BoundKind::kAfterStart) return "waits for the start" + other;
  return "may have to wait for its own time until that is past";
}

class Companions {
 public:
  Companions(const PlanNetwork& plan, const NodeDates& allowed, const NodeDates& foreseen,
             MissionTime now)
      : plan_(plan), bounds_(plan), allowed_(allowed), foreseen_(foreseen), now_(now.count()) {
    for (const Cause& cause : plan.arcs) {
      const bool waits = cause.kind == BoundKind::kStartAfter || cause.kind == BoundKind::kEndAfter;
      if (waits) held_.insert(cause.task);
    }
  }

  // Why the task of this bound from above may start too late for it.
  std::optional<std::string> lateness(std::size_t bound) const {
    const Cause& within = plan_.arcs[bound];
    const NodeIndex limit = plan_.stnu.arcs[bound].from, start = plan_.stnu.arcs[bound].to;
    if (bounds_.leads_to(start, limit)) return std::nullopt;
    if (held_.count(within.task) > 0 && !in_time(allowed_.earliest[start], limit)) {
      return beginning_of(within) + wait_of({within.task, BoundKind::kStartAfter, {}, {}});
    }
    const NodeIndex other_start = plan_.nodes.at(within.other).start;
    for (const std::uint32_t held : bounds_.arcs[start]) {
      const Arc& arc = plan_.stnu.arcs[held];
      const Ticks latest = foreseen_.latest[arc.from];
      if (latest != kInfinite && in_time(latest + arc.min, limit)) continue;
      const bool before = limit != other_start && arc.from != 0;
      if (before && bounds_.leads_to(arc.from, other_start)) continue;
      return beginning_of(within) + wait_of(plan_.arcs[held]);
    }
    return std::nullopt;
  }

 private:
  // At one instant the executive may see the limit first.
  bool in_time(Ticks latest, NodeIndex limit) const {
    return latest <= now_ || latest < foreseen_.earliest[limit];
  }

  const PlanNetwork& plan_;
  LowerBounds bounds_;
  const NodeDates& allowed_;
  const NodeDates& foreseen_;
  Ticks now_;
  std::set<executive::TaskId> held_;
};

}  // namespace

std::vector<Conflict> late_companions(const PlanNetwork& plan, const NodeDates& allowed,
                                      const NodeDates& foreseen, MissionTime now) {
  const Companions companions(plan, allowed, foreseen, now);
  std::vector<Conflict> conflicts;
  for (std::size_t i = 0; i < plan.arcs.size(); ++i) {
    const BoundKind kind = plan.arcs[i].kind;
    if (kind != BoundKind::kWithin && kind != BoundKind::kBeforeStop) continue;
    if (auto why = companions.lateness(i)) conflicts.push_back({plan.arcs[i].task, *why});
  }
  return conflicts;
}

}  // namespace skein::supervisor
