// SPDX-License-Identifier: Apache-2.0
// What is asked of a propagated network, and the undo log.
#include <utility>

#include "propagation.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

Propagation::Propagation(bool literal_upper_test) : literal_upper_test_(literal_upper_test) {
  add_node();
  for (const Bound bound : kBounds) trees_.at(0, bound).value = 0;
}

NodeIndex Propagation::add_node(bool imported) {
  const auto node = static_cast<NodeIndex>(arcs_.nodes());
  arcs_.add_node();
  imported_.push_back(imported);
  trees_.add_node();
  if (imported) trails_.resize(2 * arcs_.nodes());
  log_.add({.write = Undo::Write::kNodeAdded, .id = node});
  return node;
}

ArcId Propagation::add_arc(const Arc& arc) {
  const ArcId id = arcs_.add(arc.from, arc.to);
  pending_.resize(2 * arcs_.slots());
  log_.add({.write = Undo::Write::kArcAdded, .id = id});
  for (const Constraint k : {2 * id, 2 * id + 1}) {
    arcs_.set_weight(k, k == 2 * id ? weight_of_min(arc.min) : weight_of_max(arc.max));
    for (const Bound bound : kBounds) queue_constraint(k, bound);
  }
  return id;
}

void Propagation::remove_arc(ArcId id) {
  log_.add(
      {.write = Undo::Write::kArcRemoved, .id = id, .cause = arcs_.from(id), .root = arcs_.to(id)});
  arcs_.remove(id);
}

std::vector<Propagation::BoundRef> Propagation::take_resets() { return std::exchange(resets_, {}); }

void Propagation::shrink() {
  arcs_.shrink();
  trees_.shrink();
  pending_.shrink();
  queue_.shrink();
  deferred_.shrink();
}

void Propagation::undo_to_mark() {
  SKEIN_EXPECTS(queue_.empty() && deferred_.empty());
  log_.undo_to_mark([this](const Undo& one) { undo(one); });
}

void Propagation::undo(const Undo& undo) {
  switch (undo.write) {
    case Undo::Write::kState:
      return trees_.undo(arcs_, undo, log_);
    case Undo::Write::kStale:
      trees_.at(undo.id, undo.bound).stale = false;
      return;
    case Undo::Write::kWeight:
      arcs_.set_weight(undo.id, undo.value);
      return;
    case Undo::Write::kPendingAdded:
      return pending_.remove(undo.id, undo.bound, log_);
    case Undo::Write::kPendingRemoved:
      return pending_.add(undo.id, undo.bound, log_);
    case Undo::Write::kNodeAdded:
      arcs_.drop_node();
      imported_.pop_back();
      trees_.drop_node();
      return;
    case Undo::Write::kArcAdded:
      for (const Constraint k : {2 * undo.id, 2 * undo.id + 1}) arcs_.set_weight(k, kMinusInfinite);
      arcs_.remove(undo.id);
      return;
    case Undo::Write::kArcRemoved:
      arcs_.put_back(undo.id, undo.cause, undo.root);
      return;
  }
}

std::size_t Propagation::memory_bytes() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t trails = trails_.capacity() * sizeof(trails_[0]);
  for (const auto& trail : trails_) trails += bytes(trail);
  return sizeof(*this) + arcs_.memory_bytes() + imported_.capacity() / 8 + trees_.memory_bytes() +
         pending_.memory_bytes() + trails + queue_.memory_bytes() + deferred_.memory_bytes() +
         bytes(weakened_) + bytes(resets_) + log_.memory_bytes();
}

}  // namespace skein::temporal
