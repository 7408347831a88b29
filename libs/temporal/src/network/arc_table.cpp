// SPDX-License-Identifier: Apache-2.0
#include "arc_table.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

ArcId ArcTable::add(NodeIndex from, NodeIndex to) {
  auto id = static_cast<ArcId>(slots());
  if (free_.empty()) {
    ends_.resize(ends_.size() + 2);
    weights_.resize(weights_.size() + 2, kMinusInfinite);
  } else {
    id = free_.back();
    free_.pop_back();
  }
  link(2 * id, from);
  link(2 * id + 1, to);
  return id;
}

void ArcTable::remove(ArcId arc) {
  unlink(2 * arc);
  unlink(2 * arc + 1);
  free_.push_back(arc);
}

void ArcTable::put_back(ArcId arc, NodeIndex from, NodeIndex to) {
  SKEIN_ENSURES(!free_.empty() && free_.back() == arc);
  free_.pop_back();
  link(2 * arc, from);
  link(2 * arc + 1, to);
}

void ArcTable::link(std::uint32_t end, NodeIndex node) {
  ends_[end] = {node, first_[node], kNone};
  if (first_[node] != kNone) ends_[first_[node]].previous = end;
  first_[node] = end;
}

void ArcTable::unlink(std::uint32_t end) {
  const End old = ends_[end];
  (old.previous != kNone ? ends_[old.previous].next : first_[old.node]) = old.next;
  if (old.next != kNone) ends_[old.next].previous = old.previous;
  ends_[end] = {};
}

Arc ArcTable::arc(ArcId id) const {
  const Ticks minus_max = weights_[2 * id + 1];
  return {from(id), to(id), weights_[2 * id], minus_max == kMinusInfinite ? kInfinite : -minus_max};
}

std::optional<ArcId> ArcTable::find(NodeIndex from, NodeIndex to) const {
  std::uint32_t out = first_[from];
  std::uint32_t in = first_[to];
  for (; out != kNone && in != kNone; out = ends_[out].next, in = ends_[in].next) {
    if ((out & 1) == 0 && ends_[out ^ 1].node == to) return out / 2;
    if ((in & 1) == 1 && ends_[in ^ 1].node == from) return in / 2;
  }
  return std::nullopt;
}

std::size_t ArcTable::memory_bytes() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytes(first_) + bytes(ends_) + bytes(weights_) + bytes(free_);
}

void ArcTable::shrink() {
  first_.shrink_to_fit();
  ends_.shrink_to_fit();
  weights_.shrink_to_fit();
}

}  // namespace skein::temporal
