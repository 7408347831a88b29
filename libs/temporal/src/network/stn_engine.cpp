// SPDX-License-Identifier: Apache-2.0
// The engine: checks what it is given, lets the propagation work, undoes what overflows.
#include "skein/temporal/stn_engine.hpp"

#include <algorithm>
#include <utility>

#include "propagation.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

std::string to_text(StnError error) {
  switch (error) {
    case StnError::kUnknownNode:
      return "unknown node";
    case StnError::kUnknownArc:
      return "unknown arc";
    case StnError::kArcGivenTwice:
      return "arc given twice";
    case StnError::kArcToItself:
      return "arc from a node to itself";
    case StnError::kEmptyInterval:
      return "empty interval";
    case StnError::kOverflow:
      return "time out of range";
  }
  return "unknown error";
}

StnEngine::StnEngine() : core_(std::make_unique<Propagation>()) {}
StnEngine::StnEngine(const StnEngine& other)
    : core_(std::make_unique<Propagation>(*other.core_)),
      origin_(other.origin_),
      changes_(other.changes_) {}
StnEngine::StnEngine(StnEngine&& other) noexcept = default;
StnEngine& StnEngine::operator=(const StnEngine& other) {
  if (this != &other) *this = StnEngine(other);
  return *this;
}
StnEngine& StnEngine::operator=(StnEngine&& other) noexcept = default;
StnEngine::~StnEngine() = default;

Result<StnEngine, StnRefusal> StnEngine::make(const Stn& network) {
  StnEngine engine;
  if (network.origin >= network.nodes.size()) {
    return tl::unexpected(StnRefusal{StnError::kUnknownNode, network.origin});
  }
  for (std::size_t i = 1; i < network.nodes.size(); ++i) engine.core_->add_node();
  engine.origin_ = network.origin;
  for (std::size_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    if (const auto error = engine.check(arc)) {
      return tl::unexpected(StnRefusal{*error, static_cast<std::uint32_t>(i)});
    }
    engine.core_->add_arc({engine.inner(arc.from), engine.inner(arc.to), arc.min, arc.max});
  }
  engine.core_->propagate();
  if (engine.core_->overflowed()) return tl::unexpected(StnRefusal{StnError::kOverflow, 0});
  engine.publish();
  engine.core_->shrink();
  return engine;
}

NodeIndex StnEngine::inner(NodeIndex node) const {
  if (node == origin_) return 0;
  return node == 0 ? origin_ : node;
}

std::optional<StnError> StnEngine::check(const Arc& arc) const {
  if (arc.from >= node_count() || arc.to >= node_count()) return StnError::kUnknownNode;
  if (arc.from == arc.to) return StnError::kArcToItself;
  if (const auto error = check_interval(arc.min, arc.max)) return error;
  if (find_arc(arc.from, arc.to)) return StnError::kArcGivenTwice;
  return std::nullopt;
}

NodeIndex StnEngine::add_node() {
  changes_.clear();
  return core_->add_node();
}

Result<ArcId, StnRefusal> StnEngine::add_arc(const Arc& arc) {
  if (const auto error = check(arc)) {
    const NodeIndex unknown = arc.from >= node_count() ? arc.from : arc.to;
    return tl::unexpected(
        StnRefusal{*error, *error == StnError::kUnknownNode ? unknown : NodeIndex{0}});
  }
  core_->mark();
  const ArcId id = core_->add_arc({inner(arc.from), inner(arc.to), arc.min, arc.max});
  if (const auto refusal = finish(id)) return tl::unexpected(*refusal);
  return id;
}

std::optional<StnRefusal> StnEngine::set_arc(const ArcBounds& bounds) {
  return set_arcs({&bounds, 1});
}

std::optional<StnRefusal> StnEngine::set_arcs(std::span<const ArcBounds> bounds) {
  for (const ArcBounds& b : bounds) {
    if (!core_->arcs().has(b.arc)) return StnRefusal{StnError::kUnknownArc, b.arc};
    if (const auto error = check_interval(b.min, b.max)) return StnRefusal{*error, b.arc};
  }
  core_->mark();
  for (const ArcBounds& b : bounds) core_->set_bounds(b);
  return finish(bounds.empty() ? 0 : bounds.front().arc);
}

std::optional<StnRefusal> StnEngine::remove_arc(ArcId arc) {
  if (!core_->arcs().has(arc)) return StnRefusal{StnError::kUnknownArc, arc};
  core_->mark();
  core_->set_bounds({arc, kMinusInfinite, kInfinite});
  if (const auto refusal = finish(arc)) return refusal;
  core_->remove_arc(arc);
  return std::nullopt;
}

/// Ends the change that began at the last mark: propagates, and undoes it all on an overflow.
std::optional<StnRefusal> StnEngine::finish(std::uint32_t where) {
  core_->relax();
  core_->forget_resets();
  core_->propagate();
  const bool refused = core_->overflowed();
  if (refused) core_->undo_to_mark();
  core_->drop_mark();
  if (refused) {
    std::vector<BoundChange> none;
    core_->take_changes(none);
    return StnRefusal{StnError::kOverflow, where};
  }
  publish();
  return std::nullopt;
}

void StnEngine::publish() {
  core_->take_changes(changes_);
  for (BoundChange& change : changes_) change.node = inner(change.node);
}

bool StnEngine::consistent() const { return core_->consistent(); }

Ticks StnEngine::earliest(NodeIndex node) const {
  SKEIN_EXPECTS(node < node_count());
  return core_->date(inner(node), Bound::kLower);
}

Ticks StnEngine::latest(NodeIndex node) const {
  SKEIN_EXPECTS(node < node_count());
  return core_->date(inner(node), Bound::kUpper);
}

const std::vector<BoundChange>& StnEngine::changes() const { return changes_; }
std::vector<ConflictArc> StnEngine::conflict() const { return find_conflict(*core_); }

std::optional<Arc> StnEngine::arc(ArcId id) const {
  if (!core_->arcs().has(id)) return std::nullopt;
  Arc arc = core_->arcs().arc(id);
  arc.from = inner(arc.from);
  arc.to = inner(arc.to);
  return arc;
}

std::optional<ArcId> StnEngine::find_arc(NodeIndex from, NodeIndex to) const {
  if (from >= node_count() || to >= node_count()) return std::nullopt;
  return core_->arcs().find(inner(from), inner(to));
}

std::size_t StnEngine::node_count() const { return core_->arcs().nodes(); }
std::size_t StnEngine::arc_count() const { return core_->arcs().count(); }

void StnEngine::checkpoint() { core_->mark(); }

void StnEngine::rollback() {
  core_->undo_to_mark();
  core_->drop_mark();
  publish();
}

void StnEngine::commit() { core_->drop_mark(); }

std::uint64_t StnEngine::checks() const { return core_->checks(); }
std::size_t StnEngine::memory_bytes() const { return sizeof(*this) + core_->memory_bytes(); }

}  // namespace skein::temporal
