// SPDX-License-Identifier: Apache-2.0
// Names on top of the incremental check.
#include "skein/temporal/live_network.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

LiveNetwork::LiveNetwork() : links_at_(1) { nodes_[kOrigin] = {0, 1}; }

// ---- nodes ----

NodeIndex LiveNetwork::add_node(const NodeName& name) {
  SKEIN_EXPECTS(nodes_.count(name) == 0);
  auto index = static_cast<NodeIndex>(links_at_.size());
  if (free_nodes_.empty()) {
    links_at_.emplace_back();
    if (check_) check_->add_node({});
  } else {
    index = free_nodes_.back();
    free_nodes_.pop_back();
  }
  nodes_[name] = {index, ++last_epoch_};
  return index;
}

void LiveNetwork::remove_node(const NodeName& name) {
  const auto found = nodes_.find(name);
  SKEIN_EXPECTS(found != nodes_.end() && found->second.index != 0);
  const NodeIndex index = found->second.index;
  const std::set<std::uint32_t> links = links_at_[index];
  for (const std::uint32_t slot : links) remove_link(slots_[slot].name);
  free_nodes_.push_back(index);
  nodes_.erase(found);
}

std::optional<NodeIndex> LiveNetwork::index(const NodeName& name) const {
  const auto found = nodes_.find(name);
  if (found == nodes_.end()) return std::nullopt;
  return found->second.index;
}

std::optional<std::uint32_t> LiveNetwork::epoch(const NodeName& name) const {
  const auto found = nodes_.find(name);
  if (found == nodes_.end()) return std::nullopt;
  return found->second.epoch;
}

// ---- links ----

std::uint32_t LiveNetwork::set_link(const LinkName& name, const LiveLink& link) {
  const auto from = index(link.from), to = index(link.to);
  SKEIN_EXPECTS(from && to && *from != *to);
  const auto known = by_name_.find(name);
  if (known != by_name_.end()) {
    Slot& slot = slots_[known->second];
    if (slot.link == link) return known->second;
    remove_link(name);
  }
  auto number = static_cast<std::uint32_t>(slots_.size());
  if (free_slots_.empty()) {
    slots_.emplace_back();
  } else {
    number = free_slots_.back();
    free_slots_.pop_back();
  }
  Slot& slot = slots_[number];
  slot = {name, link, true, std::nullopt, *from, *to, 0};
  by_name_[name] = number;
  links_at_[*from].insert(number);
  links_at_[*to].insert(number);
  touched_.insert(number);
  return number;
}

void LiveNetwork::remove_link(const LinkName& name) {
  const auto known = by_name_.find(name);
  if (known == by_name_.end()) return;
  Slot& slot = slots_[known->second];
  slot.there = false;
  links_at_[slot.from].erase(known->second);
  links_at_[slot.to].erase(known->second);
  touched_.insert(known->second);
  by_name_.erase(known);
}

const LiveLink& LiveNetwork::link(const LinkName& name) const {
  return slots_[by_name_.at(name)].link;
}

// ---- the verdict ----

const LiveVerdict& LiveNetwork::settle() {
  if (touched_.empty() && check_) return verdict_;
  constexpr std::size_t kFew = 16;
  const bool few = touched_.size() <= by_name_.size() / 4 + kFew;
  const bool done = few && check_ && check_->result().controllable && settle_locally();
  if (done) {
    ++local_;
    verdict_ = {};
  } else {
    settle_from_scratch();
  }
  free_slots();
  return verdict_;
}

void LiveNetwork::free_slots() {
  for (const std::uint32_t number : touched_) {
    if (!slots_[number].there) free_slots_.push_back(number);
  }
  touched_.clear();
}

// What goes first: less is asked meanwhile than before and after.
bool LiveNetwork::settle_locally() {
  for (const std::uint32_t number : touched_) {
    Slot& slot = slots_[number];
    if (!slot.there && slot.applied && !take_out(slot)) return false;
  }
  return std::all_of(touched_.begin(), touched_.end(), [this](std::uint32_t number) {
    Slot& slot = slots_[number];
    return !slot.there || slot.applied || put_in(slot, number);
  });
}

bool LiveNetwork::accept(const Result<DcResult, StnuError>& result) {
  return result && result->controllable;
}

bool LiveNetwork::take_out(Slot& slot) {
  const bool arc = is_arc(*slot.applied);
  slot.applied.reset();
  if (arc) return accept(check_->remove_arc(slot.position));
  const auto result = check_->remove_contingent(slot.position);
  contingent_[slot.position] = contingent_.back();
  slots_[contingent_[slot.position]].position = slot.position;
  contingent_.pop_back();
  return accept(result);
}

bool LiveNetwork::put_in(Slot& slot, std::uint32_t number) {
  const LiveLink& link = slot.link;
  slot.applied = link;
  if (!is_arc(link)) {
    slot.position = static_cast<std::uint32_t>(contingent_.size());
    contingent_.push_back(number);
    return accept(check_->add_contingent({slot.from, slot.to, link.min, link.max}));
  }
  const auto result = check_->add_arc({slot.from, slot.to, link.min, link.max});
  slot.position = check_->placed();
  if (arcs_.size() <= slot.position) arcs_.resize(slot.position + 1);
  arcs_[slot.position] = number;
  return accept(result);
}

void LiveNetwork::settle_from_scratch() {
  ++scratch_;
  Stnu all = network();
  arcs_.clear();
  contingent_.clear();
  for (std::uint32_t number = 0; number < slots_.size(); ++number) {
    Slot& slot = slots_[number];
    slot.applied.reset();
    if (!slot.there) continue;
    slot.applied = slot.link;
    std::vector<std::uint32_t>& places = is_arc(slot.link) ? arcs_ : contingent_;
    slot.position = static_cast<std::uint32_t>(places.size());
    places.push_back(number);
  }
  auto made = IncrementalDc::create(std::move(all));
  verdict_ = {};
  if (!made) {
    check_.reset();
    verdict_ = {false, false, {}, made.error().fault};
    return;
  }
  check_ = std::move(*made);
  const DcResult& result = check_->result();
  verdict_.consistent = result.consistent;
  verdict_.controllable = result.controllable;
  for (const ConflictTerm& term : result.conflict) {
    const bool arc = term.link.kind == LinkKind::kRequirement;
    const std::uint32_t number = (arc ? arcs_ : contingent_)[term.link.index];
    verdict_.conflict.push_back({slots_[number].name, term.bound});
  }
}

Stnu LiveNetwork::network() const {
  Stnu result;
  result.nodes.resize(links_at_.size());
  for (const Slot& slot : slots_) {
    if (!slot.there) continue;
    if (is_arc(slot.link)) {
      result.arcs.push_back({slot.from, slot.to, slot.link.min, slot.link.max});
    } else {
      result.contingent.push_back({slot.from, slot.to, slot.link.min, slot.link.max});
    }
  }
  return result;
}

std::vector<NamedWait> LiveNetwork::waits() const {
  std::vector<NamedWait> result;
  if (!check_) return result;
  for (const WaitEdge& wait : check_->waits()) {
    result.push_back({wait.node, slots_[contingent_[wait.link]].name, wait.delay});
  }
  return result;
}

std::vector<DistanceEdge> LiveNetwork::implied() const {
  return check_ ? check_->implied() : std::vector<DistanceEdge>();
}

}  // namespace skein::temporal
